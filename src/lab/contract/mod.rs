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

mod cause;
mod chart;
mod declared;
mod deltas;
mod energy;
mod finite;
mod integrals;
mod law;
mod law_tally;
mod limits;
mod lobes;
mod needle_partition;
mod order;
mod partition;
mod physics;
mod plan;
mod pointwise;
mod precision;
mod sampling;
mod statistics;
pub(super) mod sweep;

use rayon::prelude::*;

pub use cause::weight_that_keeps_energy;
pub use law::{LawId, LawReport, Status};
pub use law_tally::Tallies;
pub use limits::{CONE, LIMITS, Limit, Relation, compare};
pub use physics::{PHYSICAL, PhysicalLaws, check_energy, check_physical};
pub use plan::{Effort, Plan};
pub use sweep::{directions, parameter_sets};

pub use super::specimen::{Specimen, Witness};

use bxdf::param::ParamSet;
use bxdf::{Material, ModelSpec};

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

/// Runs every law for `material`, at its parameters only: the deviations are its own, whatever its models declare. Where
/// models agree with one another ([`LawId::Limits`]) is no matter of a material, and is not compared.
///
/// A break is [`Status::Declared`] where each lobe that breaks the law by itself declares it at its parameters; what the
/// weights add to it is not excused.
#[must_use]
pub fn check_material(material: &Material, effort: Effort) -> Vec<LawReport> {
    let plan = Plan {
        effort,
        tests: directions().len(),
    };
    let specimen = Specimen::at(material);
    let mut tallies = Tallies::default();
    laws(&specimen, &plan, &mut tallies);
    for wi in energy::directions_between(material.components().iter()) {
        energy::energy_by_lobes(&specimen, wi, &mut tallies);
    }
    tallies
        .into_reports()
        .map(|report| cause::judged(material, report))
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
        laws(&Specimen::new(model, params), &plan, &mut tallies);
    }
    limits::limits(model, &plan, &mut tallies);
    tallies
        .into_reports()
        .map(|report| declared::judged(model, report))
        .collect()
}

/// Runs the laws of one specimen and adds to `tallies`.
pub fn laws(specimen: &Specimen, plan: &Plan, tallies: &mut Tallies) {
    sampling::sampling(specimen, plan, tallies);
    pointwise::support(specimen, plan, tallies);
    lobes::values(specimen, plan, tallies);
    pointwise::reciprocity(specimen, plan, tallies);
    pointwise::isotropy(specimen, plan, tallies);
    deltas::deltas(specimen, tallies);
    finite::finite(specimen, plan, tallies);
    precision::precision(specimen, plan, tallies);
}
