//! A model at its parameters, with its weight in a material; its text form is `id:name=value,name=value`.

use std::fmt;

use crate::batch::Scatterer;
use crate::error::{Error, Result};
use crate::param::{ParamSet, ParamSpec, Value};
use crate::resource::Resource;
use crate::spec::{ModelSpec, Precision, StandIn};

/// The most components a material may have.
pub const MAX_COMPONENTS: usize = 8;

/// The factor on all values of a component, as a parameter: files, sessions, sliders and the command line take the range from
/// here.
///
/// A factor beyond 1 gives a faint lobe its due. The largest one keeps what it multiplies, and the sum of as many lobes as a
/// material may have, far within the numbers of every precision.
pub static WEIGHT: ParamSpec = ParamSpec::number(
    "weight",
    1.0,
    "Factor on all values of this lobe; weights need not sum to 1",
)
.hard(0.0, 1000.0)
.soft(0.0, 1.0);

/// A model of the catalogue at validated parameters, and the factor with which a material takes it.
#[derive(Clone)]
pub struct Component {
    model: &'static ModelSpec,
    params: ParamSet,
    weight: f64,
}

impl Component {
    /// `model` at its default parameters.
    #[must_use]
    pub fn of(model: &'static ModelSpec) -> Self {
        Self {
            model,
            params: model.defaults(),
            weight: 1.0,
        }
    }

    /// `model` at these parameters.
    ///
    /// # Errors
    /// Where the model refuses the combination.
    pub(super) fn at(model: &'static ModelSpec, params: ParamSet) -> Result<Self> {
        (model.validate)(&params)?;
        Ok(Self {
            model,
            params,
            weight: 1.0,
        })
    }

    /// The factor on its value, within the range of [`WEIGHT`]; 1 at first.
    #[must_use]
    pub fn weight(&self) -> f64 {
        self.weight
    }

    /// Sets the factor on its value.
    ///
    /// # Errors
    /// [`Error::Parameter`] unless it lies in the range of [`WEIGHT`]; the component is then unchanged.
    pub fn set_weight(&mut self, weight: f64) -> Result<()> {
        if !WEIGHT.allows(Value::Number(weight)) {
            return Err(Error::Parameter {
                model: self.model.id.to_owned(),
                name: WEIGHT.name.to_owned(),
                value: weight.to_string(),
                allowed: WEIGHT.allowed(),
            });
        }
        self.weight = weight;
        Ok(())
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &'static ModelSpec {
        self.model
    }

    /// Its parameters.
    #[must_use]
    pub fn params(&self) -> &ParamSet {
        &self.params
    }

    /// Sets a parameter.
    ///
    /// ```
    /// use bxdf::{Component, Value};
    ///
    /// # fn main() -> bxdf::Result<()> {
    /// let mut metal: Component = "rough_conductor:alpha=0.2".parse()?;
    /// metal.set("alpha_y", Value::Number(0.4))?;
    /// assert_eq!(metal.params().number("alpha_x"), 0.2);
    /// let line = metal.set("alpha_y", Value::Number(7.0)).unwrap_err().to_string();
    /// assert_eq!(line, "rough_conductor: alpha_y = 7: allowed is a number from 0.0001 to 1");
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// As [`ParamSet::set`], and where the model refuses the combination; the component is then unchanged.
    pub fn set(&mut self, name: &str, value: Value) -> Result<()> {
        self.change(|params| params.set(name, value))
    }

    /// Sets a parameter from its text.
    ///
    /// # Errors
    /// As [`ParamSet::set_text`], and where the model refuses the combination; the component is then unchanged.
    pub fn set_text(&mut self, name: &str, text: &str) -> Result<()> {
        self.change(|params| params.set_text(name, text))
    }

    /// Sets all parameters at once.
    ///
    /// # Errors
    /// Where the model refuses the combination; the component is then unchanged.
    pub fn set_all(&mut self, params: &ParamSet) -> Result<()> {
        self.change(|own| {
            own.clone_from(params);
            Ok(())
        })
    }

    /// Sets the data of a parameter.
    ///
    /// # Errors
    /// As [`ParamSet::set_resource`], and where the model refuses the combination; the component is then unchanged.
    pub fn set_resource(&mut self, name: &str, resource: Resource) -> Result<()> {
        self.change(|params| params.set_resource(name, resource))
    }

    /// Changes the data of all its parameters.
    pub fn map_resources(&mut self, change: &mut dyn FnMut(&'static ParamSpec, &mut Resource)) {
        self.params.map_resources(change);
    }

    fn change(&mut self, change: impl FnOnce(&mut ParamSet) -> Result<()>) -> Result<()> {
        let mut params = self.params.clone();
        change(&mut params)?;
        (self.model.validate)(&params)?;
        self.params = params;
        Ok(())
    }

    /// The model at its parameters as a scattering function in precision `R`, without the weight.
    #[must_use]
    pub fn build<R: Precision>(&self) -> Box<dyn Scatterer<R>> {
        self.model.build(&self.params)
    }

    /// Whether its lobe is declared to stay as it is when the surface turns about n.
    #[must_use]
    pub fn is_isotropic(&self) -> bool {
        (self.model.properties.is_isotropic)(&self.params)
    }

    /// The index of refraction below the surface over the one above.
    #[must_use]
    pub fn relative_index(&self) -> f64 {
        (self.model.properties.relative_index)(&self.params)
    }

    /// What may stand in for it at its parameters, each with the component that does, of the same weight.
    pub fn stand_ins(&self) -> impl Iterator<Item = (&'static StandIn, Self)> {
        self.model.stand_ins.iter().filter_map(|stand_in| {
            let text = (stand_in.replace)(&self.params)?;
            let replacement: Self = text.parse().ok()?;
            Some((
                stand_in,
                Self {
                    weight: self.weight,
                    ..replacement
                },
            ))
        })
    }
}

impl PartialEq for Component {
    fn eq(&self, other: &Self) -> bool {
        self.params == other.params && self.weight == other.weight
    }
}

impl fmt::Debug for Component {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} * {self}", self.weight)
    }
}

impl fmt::Display for Component {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.params.component())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::param::Kind;

    #[test]
    fn text_round_trips() {
        for text in [
            "lambertian_reflection",
            "rough_conductor:eta=0.2/0.9/1.1,k=3.9/2.4/2.2,alpha_x=0.05,alpha_y=0.4",
        ] {
            assert_eq!(text.parse::<Component>().unwrap().to_string(), text);
        }
        let spaced: Component = " oren_nayar : sigma = 30 , reflectance = .5"
            .parse()
            .unwrap();
        assert_eq!(spaced.to_string(), "oren_nayar:reflectance=0.5,sigma=30");
    }

    #[test]
    fn bad_text_is_refused_in_one_line() {
        for (text, expected) in [
            ("lambert", "unknown model 'lambert'; nearest: lambertian_"),
            ("oren_nayar:sigma", "'sigma' is not name=value"),
            ("oren_nayar:sigma=20,sigma=30", "sigma is given twice"),
            (
                "rough_conductor:alpha=0.1,alpha_y=0.2",
                "alpha and alpha_y both set alpha_y",
            ),
            (
                "rough_conductor:alpha_x=0.1,alpha=0.2",
                "alpha_x and alpha both set alpha_x",
            ),
            (
                "phong:exponent=32=8",
                "exponent = 32=8: allowed is a number",
            ),
            ("oren_nayar:sigma=91", "from 0 to 90 degrees"),
            ("rough_conductor:eta=0,k=0", "eta and k may not both be 0"),
        ] {
            let line = text.parse::<Component>().unwrap_err().to_string();
            assert!(line.contains(expected) && !line.contains('\n'), "{line}");
        }
    }

    /// The model at its defaults, and with each word, flag, end of a slider, and colour of three channels.
    fn at_many_parameters(model: &'static ModelSpec) -> Vec<Component> {
        let mut all = vec![Component::of(model)];
        for spec in model.parameters {
            let [low, high] = spec.soft;
            let values = match spec.kind {
                Kind::Number => vec![Value::Number(low), Value::Number(high)],
                Kind::Rgb => vec![Value::Rgb([low, 0.3, high])],
                Kind::Choice => spec
                    .choices
                    .iter()
                    .map(|word| Value::Choice(word))
                    .collect(),
                Kind::Bool => vec![Value::Bool(false), Value::Bool(true)],
                Kind::Data => vec![Value::Data(false)],
            };
            for value in values {
                let mut changed = Component::of(model);
                if changed.set(spec.name, value).is_ok() {
                    all.push(changed);
                }
            }
        }
        all
    }

    #[test]
    fn stand_ins_are_components_of_their_own_and_replace_once() {
        for model in crate::models::MODELS {
            let found: BTreeSet<&str> = at_many_parameters(model)
                .iter()
                .flat_map(Component::stand_ins)
                .map(|(stand_in, _)| stand_in.name)
                .collect();
            let listed: BTreeSet<&str> = model.stand_ins.iter().map(|one| one.name).collect();
            assert_eq!(found, listed, "{}", model.id);
            assert_eq!(listed.len(), model.stand_ins.len(), "{}", model.id);
            for component in at_many_parameters(model) {
                for stand_in in model.stand_ins {
                    let case = format!("{component}: {}", stand_in.name);
                    assert!(
                        !stand_in.lost.is_empty() && !stand_in.lost.ends_with('.'),
                        "{case}"
                    );
                    let Some(text) = (stand_in.replace)(component.params()) else {
                        continue;
                    };
                    assert_ne!(text, component.to_string(), "{case}");
                    let replacement: Component = text.parse().unwrap();
                    assert_eq!(replacement.to_string(), text, "{case}");
                    let _ = replacement.build::<f64>();
                    let again = replacement.model().id == model.id
                        && (stand_in.replace)(replacement.params()).is_some();
                    assert!(!again, "{case}");
                }
            }
        }
    }

    #[test]
    fn stand_ins_are_those_of_the_parameters() {
        let names = |text: &str| -> Vec<&str> {
            let component: Component = text.parse().unwrap();
            component.stand_ins().map(|(one, _)| one.name).collect()
        };
        let cheap = "rough_conductor:fresnel=schlick,masking=separable";
        assert_eq!(names(cheap), [""; 0]);
        assert_eq!(names("principled:sheen=.1"), ["Without sheen"]);
        let mut chalk: Component = "oren_nayar:reflectance=.7/.6/.5".parse().unwrap();
        chalk.set_weight(0.25).unwrap();
        let (_, lambert) = chalk.stand_ins().next().unwrap();
        assert_eq!(
            (lambert.to_string().as_str(), lambert.weight()),
            ("lambertian_reflection:reflectance=0.7/0.6/0.5", 0.25)
        );
    }
}
