//! Materials: weighted sums of models, by name, as text and as files.

mod assignments;
mod component;
pub mod data;
pub(crate) mod embedded;
pub mod file;
mod form;
pub mod library;
mod mixed_batch;
mod mixed_samples;
mod mixed_values;
mod mixture;
#[cfg(feature = "files")]
mod open;
mod printed;

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use crate::batch::Scatterer;
use crate::error::{Error, Result};
use crate::lobe::{Category, Side};
use crate::param::ParamSpec;
use crate::resource::Resource;
use crate::spec::{ModelSpec, Precision};

pub use component::{Component, MAX_COMPONENTS, WEIGHT};
use mixture::Mixture;

/// A weighted sum of models of the catalogue, at least one, with what is said of it.
///
/// Its text form is that of its only component; as TOML it can say everything (see [`mod@file`]).
///
/// ```
/// use bxdf::{Category, Material};
///
/// # fn main() -> bxdf::Result<()> {
/// let metal: Material = "rough_conductor:alpha=0.2".parse()?;
/// assert_eq!(metal.category(), Category::GlossySpecular);
/// assert!(metal.is_isotropic());
/// let line = "rough_conductor:alpa=0.2".parse::<Material>().unwrap_err().to_string();
/// assert!(line.contains("nearest: alpha"), "{line}");
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The name at the screen; empty for a bare model.
    pub name: String,
    /// What to see in it; may be empty.
    pub note: String,
    /// Where its numbers come from; may be empty.
    pub source: String,
    components: Vec<Component>,
}

impl Material {
    /// `model` at its default parameters.
    #[must_use]
    pub fn of(model: &'static ModelSpec) -> Self {
        Self::from(Component::of(model))
    }

    /// The material of these components, without a name.
    ///
    /// # Errors
    /// [`Error::Parse`] where there is none or there are more than [`MAX_COMPONENTS`], and where two of those that light
    /// crosses disagree on the index of refraction below the surface.
    pub fn new(components: Vec<Component>) -> Result<Self> {
        let refused = |problem: String| Err(Error::parse("material", problem));
        if components.is_empty() || components.len() > MAX_COMPONENTS {
            let n = components.len();
            return refused(format!("{n} lobes; allowed are 1 to {MAX_COMPONENTS}"));
        }
        let mut crossed = components.iter().filter(|c| c.model().transmits());
        if let Some(first) = crossed.next()
            && let Some(other) = crossed.find(|c| c.relative_index() != first.relative_index())
        {
            return refused(format!(
                "{} and {} disagree on the index of refraction below the surface: {} and {}",
                first.model().id,
                other.model().id,
                first.relative_index(),
                other.relative_index()
            ));
        }
        Ok(Self {
            name: String::new(),
            note: String::new(),
            source: String::new(),
            components,
        })
    }

    /// Its components, at least one.
    #[must_use]
    pub fn components(&self) -> &[Component] {
        &self.components
    }

    /// The same material with other components.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn with_components(&self, components: Vec<Component>) -> Result<Self> {
        let Self {
            name, note, source, ..
        } = self.clone();
        Ok(Self {
            name,
            note,
            source,
            ..Self::new(components)?
        })
    }

    /// The same material with every weight over `divisor`.
    ///
    /// # Errors
    /// [`Error::Parameter`] where a weight would leave its range.
    pub fn with_weights_over(&self, divisor: f64) -> Result<Self> {
        let mut scaled = self.clone();
        for component in &mut scaled.components {
            component.set_weight(component.weight() / divisor)?;
        }
        Ok(scaled)
    }

    /// The one component, where it is taken as it is.
    #[must_use]
    pub fn only(&self) -> Option<&Component> {
        match self.components.as_slice() {
            [only] if only.weight() == 1.0 => Some(only),
            _ => None,
        }
    }

    /// The material as a scattering function in precision `R`: `f32`, `f64` or xprec's `Df64`, the reference.
    ///
    /// ```
    /// use bxdf::{Material, Vec3};
    ///
    /// # fn main() -> bxdf::Result<()> {
    /// let chalk = Material::open("chalk")?;
    /// let (fast, exact) = (chalk.build::<f32>(), chalk.build::<f64>());
    /// let single = fast.f(Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.6, 0.0, 0.8)).to_f64();
    /// let double = exact.f(Vec3::new(0.0, 0.0, 1.0), Vec3::new(0.6, 0.0, 0.8)).to_f64();
    /// assert!((single[0] / double[0] - 1.0).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn build<R: Precision>(&self) -> Box<dyn Scatterer<R>> {
        match self.only() {
            Some(only) => only.build(),
            None => Box::new(Mixture::new(&self.components, Component::build)),
        }
    }

    /// Whether its lobe is declared to stay as it is when the surface turns about n.
    #[must_use]
    pub fn is_isotropic(&self) -> bool {
        self.components.iter().all(Component::is_isotropic)
    }

    /// The index of refraction below the surface over the one above.
    #[must_use]
    pub fn relative_index(&self) -> f64 {
        self.components
            .iter()
            .find(|component| component.model().transmits())
            .map_or(1.0, Component::relative_index)
    }

    /// The category under which it is listed: its first component's.
    #[must_use]
    pub fn category(&self) -> Category {
        self.components
            .first()
            .map_or(Category::Diffuse, |component| component.model().category())
    }

    /// Whether one of its lobes goes to `side`.
    #[must_use]
    pub fn has_side(&self, side: Side) -> bool {
        self.components.iter().any(|component| match side {
            Side::Reflection => component.model().reflects(),
            Side::Transmission => component.model().transmits(),
        })
    }

    /// The data of its components, each with the spec of its parameter.
    pub fn resources(&self) -> impl Iterator<Item = (&'static ParamSpec, &Resource)> {
        let components = self.components.iter();
        components.flat_map(|component| component.params().resources())
    }

    /// Changes the data of its components.
    pub fn map_resources(&mut self, change: &mut dyn FnMut(&'static ParamSpec, &mut Resource)) {
        for component in &mut self.components {
            component.map_resources(change);
        }
    }

    /// Whether it has data: values from a file, or baked.
    #[must_use]
    pub fn has_data(&self) -> bool {
        self.resources().next().is_some()
    }

    /// Whether all its data is here.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        let mut resources = self.resources();
        resources.all(|(_, resource)| resource.decoded().is_some())
    }

    /// Why it is not complete, as a phrase about the first data that is not here.
    #[must_use]
    pub fn lack(&self) -> Option<String> {
        let mut resources = self.resources();
        let lacking = resources.find(|(_, resource)| resource.decoded().is_none());
        lacking.and_then(|(_, resource)| resource.problem())
    }

    /// The material with all data that is here in its text, which then needs no file.
    #[must_use]
    pub fn with_data(&self) -> Self {
        let mut whole = self.clone();
        whole.map_resources(&mut |_, resource| resource.embed());
        whole
    }

    /// Names files from the root on that are named from `folder` on.
    pub fn rooted_at(&mut self, folder: &Path) {
        self.map_resources(&mut |_, resource| {
            resource.map_path(|path| path.is_relative().then(|| folder.join(path)));
        });
    }

    /// Names files from `folder` on, where they lie in it.
    pub fn relative_to(&mut self, folder: &Path) {
        self.map_resources(&mut |_, resource| {
            resource.map_path(|path| path.strip_prefix(folder).ok().map(Path::to_owned));
        });
    }

    /// Whether all its lobes are Dirac deltas, so that `f` and `pdf` are 0 everywhere.
    #[must_use]
    pub fn is_delta_only(&self) -> bool {
        self.components
            .iter()
            .all(|component| component.model().is_delta_only())
    }

    /// The name at the screen: its own, or that of its models.
    #[must_use]
    pub fn title(&self) -> String {
        if self.name.is_empty() {
            let titles: Vec<&str> = self.components.iter().map(|c| c.model().title).collect();
            titles.join(" + ")
        } else {
            self.name.clone()
        }
    }
}

impl From<Component> for Material {
    fn from(component: Component) -> Self {
        Self {
            name: String::new(),
            note: String::new(),
            source: String::new(),
            components: vec![component],
        }
    }
}

impl FromStr for Material {
    type Err = Error;

    /// Reads `id` or `id:name=value,name=value`.
    fn from_str(text: &str) -> Result<Self> {
        Ok(Self::from(text.parse::<Component>()?))
    }
}

/// The text form where there is one component, else the components with their weights: `0.5 * id:.. + id`.
impl fmt::Display for Material {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, component) in self.components.iter().enumerate() {
            if index > 0 {
                f.write_str(" + ")?;
            }
            if component.weight() != 1.0 {
                write!(f, "{} * ", component.weight())?;
            }
            write!(f, "{component}")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_indices_below_one_surface_are_refused() {
        let components = |texts: &[&str]| texts.iter().map(|text| text.parse().unwrap()).collect();
        let line = Material::new(components(&[
            "fresnel_specular:eta=1.33",
            "rough_dielectric",
        ]))
        .unwrap_err()
        .to_string();
        assert!(
            line.contains("disagree on the index of refraction"),
            "{line}"
        );
        assert!(Material::new(components(&["plastic:eta=1.33", "rough_dielectric"])).is_ok());
        assert!(Material::new(Vec::new()).is_err());
    }

    #[test]
    fn the_text_of_a_mixture_names_its_weights() {
        let mut half: Component = "phong:exponent=8".parse().unwrap();
        half.set_weight(0.5).unwrap();
        assert!(half.set_weight(-0.5).is_err() && half.set_weight(f64::NAN).is_err());
        let material = Material::new(vec![half, "oren_nayar".parse().unwrap()]).unwrap();
        assert_eq!(material.to_string(), "0.5 * phong:exponent=8 + oren_nayar");
        let halved = material.with_weights_over(2.0).unwrap();
        assert_eq!(
            halved.to_string(),
            "0.25 * phong:exponent=8 + 0.5 * oren_nayar"
        );
        assert!(material.with_weights_over(0.0).is_err());
        assert_eq!(material.title(), "Phong + Oren-Nayar");
        assert!(material.has_side(Side::Reflection) && !material.has_side(Side::Transmission));
    }
}
