//! What a model says of itself: everything that lists, documents, draws or tests models follows from a [`ModelSpec`].

use std::fmt;

use xprec::Df64;

use super::batch::Scatterer;
use super::lobe::{Category, Lobe, Side};
use super::math::Real;
use super::math::library::Libm;
use super::param::{ParamSet, ParamSpec, Value};
use crate::error::Result;

/// A law every model is tested against, unless it declares where it breaks it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// `rho_dh` <= 1: no more flux leaves than arrives.
    Energy,
    /// `n_i^2` f(wo, wi) = `n_o^2` f(wi, wo).
    Reciprocity,
}

impl Law {
    /// The word for it in reports.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Energy => "energy",
            Self::Reciprocity => "reciprocity",
        }
    }
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.id())
    }
}

/// A law that a model, as published, does not keep, and a witness: where it can be seen.
#[derive(Clone, Copy, Debug)]
pub struct Declaration {
    /// The law.
    pub law: Law,
    /// The parameters of the witness, as `name=value,name=value`.
    pub parameters: &'static str,
    /// The polar angle of incidence of the witness, in degrees.
    pub theta_deg: f64,
    /// By how much, and why the model is kept as it is.
    pub note: &'static str,
    /// The parameters that it speaks of: at others the law is not broken for this reason.
    pub when: fn(&ParamSet) -> bool,
}

impl Declaration {
    /// For [`Self::when`]: whatever the parameters.
    #[must_use]
    pub const fn always(_: &ParamSet) -> bool {
        true
    }
}

/// What holds for a model whatever its parameters, less its declarations.
#[derive(Clone, Copy, Debug)]
pub struct Properties {
    /// Whether the lobe stays as it is when the surface turns about n, at these parameters.
    pub is_isotropic: fn(&ParamSet) -> bool,
    /// The index of refraction below the surface over the one above, at these parameters; 1 without transmission.
    pub relative_index: fn(&ParamSet) -> f64,
    /// The laws it breaks as published.
    pub declarations: &'static [Declaration],
    /// By what factor errors exceed what the stability law allows: 1 for models that keep it; else the reason stands in their
    /// `# Validity`.
    pub stability_ratio: f64,
}

impl Properties {
    /// Isotropic, one medium, no law broken.
    pub const PLAIN: Self = Self {
        is_isotropic: |_| true,
        relative_index: |_| 1.0,
        declarations: &[],
        stability_ratio: 1.0,
    };

    /// Isotropic where the widths along s and t are equal, else as [`Self::PLAIN`].
    pub const TWO_WIDTHS: Self = Self {
        is_isotropic: |params| {
            let widths = params
                .widths()
                .map(|names| names.map(|name| params.number(name)));
            widths.is_none_or(|[x, y]| x == y)
        },
        ..Self::PLAIN
    };
}

/// What may stand in for a model, or for one of its terms: cheaper, and not quite the same.
pub struct StandIn {
    /// What replaces what, at the screen: `Schlick for exact Fresnel`.
    pub name: &'static str,
    /// What is lost, one sentence without a full stop.
    pub lost: &'static str,
    /// The stand-in of the model at these parameters, as the text form of a component; `None` where it changes nothing
    /// there. [`ParamSet::replaced`] writes it for a term, [`ModelSpec::text_at`] for the whole model.
    pub replace: fn(&ParamSet) -> Option<String>,
}

/// The constructors of a model, one per precision: the same generic function each time.
#[derive(Clone, Copy)]
pub struct Builders {
    /// In `f32`.
    pub f32: fn(&ParamSet) -> Box<dyn Scatterer<f32>>,
    /// In `f32` with the elementary functions of the system's library: to measure what the polynomials change.
    pub library: fn(&ParamSet) -> Box<dyn Scatterer<Libm>>,
    /// In `f64`.
    pub f64: fn(&ParamSet) -> Box<dyn Scatterer<f64>>,
    /// In the reference precision.
    pub reference: fn(&ParamSet) -> Box<dyn Scatterer<Df64>>,
}

/// The [`Builders`] of a model: one generic function in every precision.
#[macro_export]
macro_rules! builders {
    ($build:expr) => {
        $crate::Builders {
            f32: $build,
            library: $build,
            f64: $build,
            reference: $build,
        }
    };
}

/// A precision that models can be built in.
pub trait Precision: Real {
    /// The model of these constructors at `params`.
    fn build(builders: &Builders, params: &ParamSet) -> Box<dyn Scatterer<Self>>;
}

impl Precision for f32 {
    fn build(builders: &Builders, params: &ParamSet) -> Box<dyn Scatterer<Self>> {
        (builders.f32)(params)
    }
}

impl Precision for Libm {
    fn build(builders: &Builders, params: &ParamSet) -> Box<dyn Scatterer<Self>> {
        (builders.library)(params)
    }
}

impl Precision for f64 {
    fn build(builders: &Builders, params: &ParamSet) -> Box<dyn Scatterer<Self>> {
        (builders.f64)(params)
    }
}

impl Precision for Df64 {
    fn build(builders: &Builders, params: &ParamSet) -> Box<dyn Scatterer<Self>> {
        (builders.reference)(params)
    }
}

/// A model of the catalogue.
pub struct ModelSpec {
    /// The id: file name, list entry and command-line word.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// The paper it comes from.
    pub source: &'static str,
    /// One or two sentences on what to see in it.
    pub summary: &'static str,
    /// Its lobes; the first gives the category under which the model is listed.
    pub lobes: &'static [Lobe],
    /// Its parameters, in the order of the sliders.
    pub parameters: &'static [ParamSpec],
    /// What holds for it.
    pub properties: Properties,
    /// Refuses combinations of parameters that each lie in their range.
    pub validate: fn(&ParamSet) -> Result<()>,
    /// Its constructors.
    pub builders: Builders,
    /// What may replace it, or a term of it.
    pub stand_ins: &'static [StandIn],
}

impl ModelSpec {
    /// For [`Self::validate`]: every combination is allowed.
    ///
    /// # Errors
    /// None.
    pub const fn any(_: &ParamSet) -> Result<()> {
        Ok(())
    }

    /// The default parameters.
    #[must_use]
    pub fn defaults(&self) -> ParamSet {
        ParamSet::defaults(self.id, self.parameters)
    }

    /// The model as the text form of a component, with these values and otherwise its defaults. `None` where it has no
    /// such parameter, or a range that does not include the value.
    #[must_use]
    pub fn text_at(&self, values: &[(&str, Value)]) -> Option<String> {
        Some(self.defaults().with(values)?.component())
    }

    /// The model at `params`, in precision `R`.
    #[must_use]
    pub fn build<R: Precision>(&self, params: &ParamSet) -> Box<dyn Scatterer<R>> {
        R::build(&self.builders, params)
    }

    /// Whether one of its lobes crosses the surface.
    #[must_use]
    pub fn transmits(&self) -> bool {
        self.lobes
            .iter()
            .any(|lobe| lobe.side == Side::Transmission)
    }

    /// Whether one of its lobes stays on the side of the light.
    #[must_use]
    pub fn reflects(&self) -> bool {
        self.lobes.iter().any(|lobe| lobe.side == Side::Reflection)
    }

    /// Whether all its lobes are Dirac deltas, so that `f` and `pdf` are 0 everywhere.
    #[must_use]
    pub fn is_delta_only(&self) -> bool {
        self.lobes
            .iter()
            .all(|lobe| lobe.category == Category::PerfectSpecular)
    }

    /// The category under which it is listed.
    #[must_use]
    pub fn category(&self) -> Category {
        self.lobes
            .first()
            .map_or(Category::Diffuse, |lobe| lobe.category)
    }
}
