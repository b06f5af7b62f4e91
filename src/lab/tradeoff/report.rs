//! What was measured: the points of each family, with their costs and errors.

use glam::DVec3;
use serde::Serialize;

use super::errors::{Errors, Pair};
use crate::timing::Timing;
use bxdf::Material;

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

/// What is to be chosen. Choices that answer one question have costs of one thing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Question {
    /// By which formula, in which numbers f is computed.
    Evaluate,
    /// How f is summed or sampled over directions.
    Integrate,
}

impl Question {
    /// All of them, in the order of reports.
    pub const ALL: [Self; 2] = [Self::Evaluate, Self::Integrate];

    /// The question at the screen.
    #[must_use]
    pub const fn title(self) -> &'static str {
        match self {
            Self::Evaluate => "How to evaluate f",
            Self::Integrate => "How to integrate it",
        }
    }
}

impl CostUnit {
    /// The question that choices with such a cost answer.
    #[must_use]
    pub const fn question(self) -> Question {
        match self {
            Self::Evaluation => Question::Evaluate,
            Self::Estimate | Self::Build => Question::Integrate,
        }
    }
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

/// Whether there is no material, or one of which a line of text says not all.
#[expect(
    clippy::ref_option,
    reason = "serde asks with a reference to the field"
)]
pub(super) fn is_no_text(material: &Option<Material>) -> bool {
    material.as_ref().is_none_or(Material::has_data)
}

impl Point {
    /// A choice of which nothing is known yet.
    pub(super) fn new(choice: impl Into<String>) -> Self {
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

    pub(super) fn costing(self, cost: Timing) -> Self {
        Self {
            cost_ns: cost.ns,
            cost_spread_ns: cost.spread,
            ..self
        }
    }

    pub(super) fn with_errors(self, errors: Errors) -> Self {
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
    /// See [`Family::is_of_material`](super::Family::is_of_material).
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
    /// The direction from which it was seen where reflectances were estimated, a unit vector.
    pub held: DVec3,
    /// The families asked for.
    pub families: Vec<FamilyReport>,
}
