//! The trade-off of speed against accuracy, measured for one material on this machine.
//!
//! Families of choices are each held against the most accurate of their kind: ways to estimate a reflectance, number
//! formats, stand-ins for terms and lobes, resolutions of what is drawn. Every choice has a cost, measured, and an error,
//! measured; from both follow the Pareto front and the cheapest choice within a tolerance.

mod advice;
mod bench;
mod channels;
mod errors;
mod estimators;
mod front;
mod mesh;
mod precision;
mod probe;
mod stand_ins;
pub mod table;
mod tables;

use glam::DVec3;
use serde::Serialize;

use super::timing::Timing;
use bxdf::math::frame::direction_from_degrees;
use bxdf::{Bxdf, Material};

pub use advice::{Advice, DEFAULT_TOLERANCES, WHOLE, advise};
pub use bench::{Bench, measure};
pub use errors::{Errors, Pair, colour_difference};
pub use probe::LIGHT;

use probe::Probe;

/// What a cost is the cost of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CostUnit {
    /// One value of f.
    Evaluation,
    /// One estimate of a reflectance.
    Estimate,
    /// Making what is drawn.
    Build,
}

/// A family of choices.
pub trait Family: Sync {
    /// The word for it at the command line and in reports.
    fn id(&self) -> &'static str;

    /// The name at the screen.
    fn title(&self) -> &'static str;

    /// What its costs are of.
    fn cost_unit(&self) -> CostUnit;

    /// Whether its choices are ways to evaluate the material as it is given, held against that: advice for the material as a
    /// whole is chosen among them.
    fn is_of_material(&self) -> bool {
        false
    }

    /// How long it takes to measure, in any unit common to all: for the progress.
    fn share(&self) -> f64;

    /// Measures every choice for the material of `study` and hands the points to `bench`.
    ///
    /// # Errors
    /// [`Stop`], where the family does not apply, or is not wanted any more.
    fn measure(&self, study: &Study<'_>, bench: &mut Bench<'_>) -> Result<(), Stop>;
}

/// Every family, in the order in which they are measured and shown.
pub static FAMILIES: [&dyn Family; 6] = [
    &estimators::Estimators,
    &precision::Precisions,
    &stand_ins::StandIns,
    &tables::Tables,
    &channels::Channels,
    &mesh::Resolutions,
];

/// Why a family has no (more) points.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// It does not apply to this material, with the reason: a sentence's end after "because".
    NotApplicable(String),
    /// Nobody wants it any more.
    Unwanted,
}

/// A choice with what it costs and how far it is off.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Point {
    /// What is chosen.
    pub choice: String,
    /// How many samples, nodes or vertices, where it is a number of such.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub n: Option<u64>,
    /// Nanoseconds for one unit of cost, the median of repetitions.
    pub cost_ns: f64,
    /// Their first and third quartile.
    pub cost_spread_ns: [f64; 2],
    /// Memory taken, where it is a matter of memory.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bytes: Option<u64>,
    /// The relative error: of values, root mean square over pairs of directions weighted by both cosines; of estimates,
    /// root mean square over seeds.
    pub error_rms: f64,
    /// The same of the choice evaluated in f32, where its cost is that in f32 and its error that of the formula.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_rms_f32: Option<f64>,
    /// The largest relative error.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error_max: Option<f64>,
    /// Where it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub worst: Option<Pair>,
    /// The largest difference of a reflectance.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub albedo_error: Option<f64>,
    /// The largest colour difference (CIEDE2000) on the lit sphere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub delta_e: Option<f64>,
    /// Whether no choice of the family is both cheaper and nearer.
    pub pareto: bool,
    /// What is lost with it, where that can be said.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost: Option<String>,
    /// The material that it is, where it is one.
    #[serde(skip_serializing_if = "is_no_text")]
    pub material: Option<Material>,
}

/// Whether there is no material, or one whose text is as long as the table it holds.
#[expect(
    clippy::ref_option,
    reason = "serde asks with a reference to the field"
)]
fn is_no_text(material: &Option<Material>) -> bool {
    material.as_ref().is_none_or(Material::holds_table)
}

impl Point {
    /// A choice of which nothing is known yet.
    fn new(choice: impl Into<String>) -> Self {
        Self {
            choice: choice.into(),
            n: None,
            cost_ns: f64::NAN,
            cost_spread_ns: [f64::NAN; 2],
            bytes: None,
            error_rms: 0.0,
            error_rms_f32: None,
            error_max: None,
            worst: None,
            albedo_error: None,
            delta_e: None,
            pareto: false,
            lost: None,
            material: None,
        }
    }

    fn costing(self, cost: Timing) -> Self {
        Self {
            cost_ns: cost.ns,
            cost_spread_ns: cost.spread,
            ..self
        }
    }

    fn with_errors(self, errors: Errors) -> Self {
        Self {
            error_rms: errors.rms,
            error_max: Some(errors.max),
            // There is no worst pair among equals.
            worst: (errors.max > 0.0).then_some(errors.worst),
            albedo_error: Some(errors.albedo),
            delta_e: Some(errors.delta_e),
            ..self
        }
    }

    /// The choice with its number, as it is named at the screen.
    #[must_use]
    pub fn name(&self) -> String {
        match self.n {
            Some(n) => format!("{}, {n}", self.choice),
            None => self.choice.clone(),
        }
    }
}

/// A family's points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FamilyReport {
    /// Its id.
    pub id: &'static str,
    /// Its name at the screen.
    #[serde(skip)]
    pub title: &'static str,
    /// What its choices are held against.
    pub reference: String,
    /// Why it has no points, where it has none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub not_applicable: Option<String>,
    /// What its costs are of.
    pub cost_unit: CostUnit,
    /// See [`Family::is_of_material`].
    #[serde(skip)]
    pub is_of_material: bool,
    /// The points, choice by choice.
    pub points: Vec<Point>,
    /// The exponent of the number of samples with which the error of each choice falls; none where it has no number, or no
    /// error.
    pub slopes: Slopes,
}

/// Slopes by choice, in the order of the choices.
pub type Slopes = std::collections::BTreeMap<String, Option<f64>>;

/// All that was measured of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The material.
    pub material: Material,
    /// The families asked for.
    pub families: Vec<FamilyReport>,
}

/// The direction of view at which reflectances are estimated unless another one is given: polar angle and azimuth, degrees.
pub const DIRECTION_DEG: [f64; 2] = [45.0, 30.0];

/// A material with what every family needs of it.
pub struct Study<'a> {
    /// The material.
    pub material: &'a Material,
    /// The direction of view at which reflectances are estimated, a unit vector.
    pub held: DVec3,
    bxdf: Box<dyn Bxdf<f64>>,
    probe: Probe,
}

impl<'a> Study<'a> {
    /// `material` seen along `held`, a unit vector; `None` for [`DIRECTION_DEG`].
    #[must_use]
    pub fn new(material: &'a Material, held: Option<DVec3>) -> Self {
        let bxdf = material.build();
        let [theta, phi] = DIRECTION_DEG;
        Self {
            probe: Probe::new(material, &*bxdf),
            held: held.unwrap_or_else(|| direction_from_degrees(theta, phi)),
            bxdf,
            material,
        }
    }

    fn bxdf(&self) -> &dyn Bxdf<f64> {
        &*self.bxdf
    }

    /// # Errors
    /// [`Stop::NotApplicable`] where there are no values to be compared.
    fn baseline<'b>(&'b self, exact: errors::Values<'b>) -> Result<errors::Baseline<'b>, Stop> {
        let baseline = errors::Baseline::new(&self.probe, exact);
        if baseline.is_black() {
            let reason = "its light is all in Dirac deltas, which have no values to be off";
            return Err(Stop::NotApplicable(reason.to_owned()));
        }
        Ok(baseline)
    }
}

#[cfg(test)]
mod tests;
