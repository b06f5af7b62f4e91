//! The laws every scattering model keeps, written once and run for every model of the list.
//!
//! [`check`] runs them over a sweep of parameters and directions and returns one [`LawReport`] per law. A law is a
//! measured deviation held against what numerical error and chance account for; a model that breaks a law as published
//! declares it, with a witness that must break it.
//!
//! # Source
//! The statistical laws follow Subr & Arvo 2007, "Statistical Hypothesis Testing for Assessing Monte Carlo
//! Estimators" (`subr2007`), with the correction of Sidak 1967 (`sidak1967`) for the number of tests. A chi-square test
//! of the samples alone passes a density wrong by .2 % and sees neither the value nor the frame: the other laws do.

mod cells;
mod chart;
mod deltas;
mod energy;
mod families;
mod finite;
mod limits;
mod lobes;
mod pointwise;
mod precision;
mod sampling;
mod statistics;
mod subject;
mod sweep;
mod tally;

use rayon::prelude::*;
use serde::Serialize;

pub use limits::{CONE, LIMITS, Limit, Relation, compare};
pub use subject::Subject;
pub use sweep::{directions, parameter_sets};
pub use tally::Tallies;

use crate::bxdf::param::ParamSet;
use crate::bxdf::{Component, Law, Material, ModelSpec};

/// A law of the contract.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LawId {
    /// The integral of `pdf` over the sphere is the rate of samples that are no deltas.
    PdfIntegral,
    /// The samples are distributed as `pdf` and the deltas' probabilities say.
    Sampling,
    /// `f` and `pdf` are 0 where no lobe goes, and there is a density wherever there is a value or a sample.
    Support,
    /// A sample carries the very `f` and `pdf` of its direction, and the direction is a unit vector.
    Weight,
    /// The mean sample weight is the integral of f |cos|, deltas included.
    MeanWeight,
    /// The inner lobes sum to f, and the maps of the square that follow them integrate to the same.
    Lobes,
    /// `n_i^2` f(wo, wi) = `n_o^2` f(wi, wo), and each delta has its way back.
    Reciprocity,
    /// A delta's flux, weight, side and probability agree with one another.
    Deltas,
    /// No more flux leaves than arrives.
    Energy,
    /// Every result is finite and not negative, in every precision and at every extreme.
    Finite,
    /// The lobe turns with the surface exactly where it is declared to.
    Isotropy,
    /// Models agree where one becomes another.
    Limits,
    /// f32 and f64 agree with the reference precision as far as rounding allows.
    Precision,
}

impl LawId {
    /// All laws, in the order of the reports.
    pub const ALL: [Self; 13] = [
        Self::PdfIntegral,
        Self::Sampling,
        Self::Support,
        Self::Weight,
        Self::MeanWeight,
        Self::Lobes,
        Self::Reciprocity,
        Self::Deltas,
        Self::Energy,
        Self::Finite,
        Self::Isotropy,
        Self::Limits,
        Self::Precision,
    ];

    /// The word for it in reports.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::PdfIntegral => "pdf_integral",
            Self::Sampling => "sampling",
            Self::Support => "support",
            Self::Weight => "weight",
            Self::MeanWeight => "mean_weight",
            Self::Lobes => "lobes",
            Self::Reciprocity => "reciprocity",
            Self::Deltas => "deltas",
            Self::Energy => "energy",
            Self::Finite => "finite",
            Self::Isotropy => "isotropy",
            Self::Limits => "limits",
            Self::Precision => "precision",
        }
    }

    /// What [`LawReport::worst`] counts for this law.
    #[must_use]
    pub const fn measure(self) -> &'static str {
        match self {
            Self::PdfIntegral => "absolute difference of the integral and the rate",
            Self::Sampling => "minus the decimal logarithm of the smallest p-value",
            Self::Support => "value or density where none belongs, in 1/sr",
            Self::Weight => "relative difference of a sample's numbers from the model's",
            Self::MeanWeight => "absolute difference of the mean weight and the integral",
            Self::Lobes => {
                "relative difference of the sum and f, or absolute difference of the integrals"
            }
            Self::Reciprocity => "relative difference of the two ways",
            Self::Deltas => "absolute disagreement of a delta's numbers",
            Self::Energy => "share of the flux created",
            Self::Finite => "1 where a result is not finite, negative or no unit vector",
            Self::Isotropy => "relative difference of the lobe and the turned lobe",
            Self::Limits => "relative difference of the two models",
            Self::Precision => "relative error against the reference precision",
        }
    }

    const fn declared_as(self) -> Option<Law> {
        match self {
            Self::Energy => Some(Law::Energy),
            Self::Reciprocity => Some(Law::Reciprocity),
            _ => None,
        }
    }
}

/// What became of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// It holds.
    Ok,
    /// It breaks as the model declares.
    Declared,
    /// It breaks, and the model does not declare it, or declares a far smaller break.
    Violated,
    /// The model declares a break that its witness does not show.
    Misdeclared,
}

impl Status {
    /// Whether the check passes.
    #[must_use]
    pub const fn is_pass(self) -> bool {
        matches!(self, Self::Ok | Self::Declared)
    }

    /// The word for it in reports.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Declared => "declared",
            Self::Violated => "violated",
            Self::Misdeclared => "misdeclared",
        }
    }
}

/// The outcome of one law for one model.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct LawReport {
    /// The law.
    pub law: LawId,
    /// What became of it.
    pub status: Status,
    /// The deviation at the witness, in [`LawId::measure`]: where it exceeds `error` by the largest factor. Infinite
    /// where the deviation is no number.
    pub worst: f64,
    /// What numerical error and chance account for there; the law holds while no deviation exceeds its error.
    pub error: f64,
    /// Number of comparisons made.
    pub n: usize,
    /// Where the worst deviation is found: parameters and directions as (theta, phi) in degrees.
    pub witness: String,
}

/// How much work a check may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effort {
    /// Some 10^4 samples and 10^5 evaluations per direction: catches a density wrong by 1 %.
    Quick,
    /// 10^6 samples per direction: catches a density wrong by .1 %.
    Thorough,
}

impl Effort {
    /// Strata along each axis of the unit square, two samples in each.
    const fn strata(self) -> u32 {
        match self {
            Self::Quick => 48,
            Self::Thorough => 708,
        }
    }

    /// Independent samples of a chi-square test.
    const fn samples(self) -> u32 {
        match self {
            Self::Quick => 8192,
            Self::Thorough => 131_072,
        }
    }

    /// Random pairs of directions per law and parameter set.
    const fn pairs(self) -> u32 {
        match self {
            Self::Quick => 64,
            Self::Thorough => 1024,
        }
    }
}

/// What a run of the laws shares.
#[derive(Clone, Copy, Debug)]
pub struct Plan {
    /// How much work it may take.
    pub effort: Effort,
    /// Number of chi-square tests of the run, for Sidak's correction.
    pub tests: usize,
}

/// A sweep may exceed the break that a witness shows by this factor: a witness stands for the worst break, and the
/// directions of the sweep need not be its own. A larger break is another one.
const WITNESS_MARGIN: f64 = 1.05;

/// Runs every law for `model` over its sweep of parameters, in the order of [`LawId::ALL`].
#[must_use]
pub fn check(model: &ModelSpec, effort: Effort) -> Vec<LawReport> {
    check_at(model, &parameter_sets(model), effort)
}

/// [`check`] for each of `models`, in their order, on all processors.
#[must_use]
pub fn check_all(models: &[&ModelSpec], effort: Effort) -> Vec<Vec<LawReport>> {
    models
        .par_iter()
        .map(|model| check(model, effort))
        .collect()
}

/// Runs every law for `material`, at its parameters only.
///
/// A mixture is excused where one of its models declares the law broken; energy that its weights create is not.
#[must_use]
pub fn check_material(material: &Material, effort: Effort) -> Vec<LawReport> {
    if let Some(only) = material.only() {
        return check_at(only.model(), std::slice::from_ref(only.params()), effort);
    }
    let plan = Plan {
        effort,
        tests: directions().len(),
    };
    let mut tallies = Tallies::default();
    laws(&Subject::of_material(material), &plan, &mut tallies);
    let declared = |law: LawId| {
        let models = material.components().iter().map(Component::model);
        let mut declarations = models.flat_map(|model| model.properties.declarations);
        declarations.any(|declaration| Some(declaration.law) == law.declared_as())
    };
    tallies
        .into_reports()
        .map(|mut report| {
            if report.status == Status::Violated && declared(report.law) {
                report.status = Status::Declared;
            }
            report
        })
        .collect()
}

/// Runs every law for `model` at these parameters.
#[must_use]
pub fn check_at(model: &ModelSpec, sets: &[ParamSet], effort: Effort) -> Vec<LawReport> {
    let plan = Plan {
        effort,
        tests: sets.len() * directions().len(),
    };
    let mut tallies = Tallies::default();
    for params in sets {
        laws(&Subject::new(model, params), &plan, &mut tallies);
    }
    limits::limits(model, &plan, &mut tallies);
    tallies
        .into_reports()
        .map(|report| judged(model, report))
        .collect()
}

/// Runs the laws of one subject and adds to `tallies`.
pub fn laws(subject: &Subject, plan: &Plan, tallies: &mut Tallies) {
    sampling::sampling(subject, plan, tallies);
    pointwise::support(subject, plan, tallies);
    lobes::values(subject, plan, tallies);
    pointwise::reciprocity(subject, plan, tallies);
    pointwise::isotropy(subject, plan, tallies);
    deltas::deltas(subject, tallies);
    finite::finite(subject, plan, tallies);
    precision::precision(subject, plan, tallies);
}

/// `report` with the model's declarations of its law taken into account.
fn judged(model: &ModelSpec, mut report: LawReport) -> LawReport {
    let declared_breaks = model
        .properties
        .declarations
        .iter()
        .filter(|declaration| Some(declaration.law) == report.law.declared_as())
        .map(|declaration| match declaration.law {
            Law::Energy => energy::declared_break(model, declaration),
            Law::Reciprocity => pointwise::declared_break(model, declaration),
        });
    let mut allowed: Option<f64> = None;
    for shown in declared_breaks {
        report.n += 1;
        match shown {
            Ok(deviation) => allowed = Some(allowed.unwrap_or(0.0).max(deviation)),
            Err(problem) => {
                report.status = Status::Misdeclared;
                report.witness = problem;
                return report;
            }
        }
    }
    if let Some(deviation) = allowed {
        if report.worst <= WITNESS_MARGIN * deviation {
            report.status = Status::Declared;
        }
        if report.worst < deviation {
            report.worst = deviation;
            "the declared witness".clone_into(&mut report.witness);
        }
    }
    report
}
