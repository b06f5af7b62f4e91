//! Where floating point gives out: every model at its extremes, in f32 and f64 against the reference precision.
//!
//! [`examine`] takes a model to each [`ExtremeKind`] and returns an [`Extreme`] for each precision: how many results are not
//! finite, negative or misplaced, the largest error, and how much of what the stability law allows
//! ([`rounding`](super::rounding)) it uses up. The extremes of parameters and those of directions are combined:
//! the usual parameters with every pair of directions, the others in twos with every second. Where the error is worst a
//! search goes on uphill. Everything is the same in every run.
//!
//! # The worst of each model
//! Written by `check --all --extremes --markdown`; a test holds it against what is measured. An error of 1 is one next to an
//! edge, where rounding decides on which side a pair lies: it is the share of its bound that counts. Widths inside the core,
//! which no material has, and points by chance are left out.
//!
#![doc = include_str!("table.md")]

mod directions;
mod extreme_kind;
mod extreme_tally;
mod jumps;
pub mod map;
mod parameters;
pub(crate) mod point;
mod random_points;
mod samples;
mod search;
pub mod table;

use rayon::prelude::*;

pub use extreme_kind::ExtremeKind;
pub use extreme_tally::{Extreme, Worst};
pub(crate) use samples::{is_good, is_good_number, is_unit};

use crate::analysis::{Basis, Detail, IsWanted, Query, Subject as Asked};
use crate::specimen::Specimen;
use bxdf::{Component, Law, Material, ModelSpec};

use directions::Pair;
use extreme_tally::Tally;
use samples::CHOICES;

/// Random points that are drawn by one seed.
const CROWD_OF_PART: u64 = 1 << 18;

/// So many sets of parameters share the pairs of directions among them, in turns; the usual ones have all for themselves.
const SHARED_BY: usize = 2;

/// How far an examination goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// One in so many of the sets of parameters at their extremes is examined.
    pub stride: usize,
    /// Random points over all models, in every precision.
    pub random: u64,
    /// More of them in f32 and in f64 alone, without the reference.
    pub random_points: u64,
}

impl Extent {
    /// The whole grid, and a million random points over all models.
    pub const FULL: Self = Self {
        stride: 1,
        random: 1_000_000,
        random_points: 0,
    };
}

/// Takes `model` to its extremes; `random` is the number of random points for it alone.
#[must_use]
pub fn examine(model: &ModelSpec, stride: usize, random: u64) -> Vec<Extreme> {
    let pairs = directions::pairs();
    let sets = parameters::parameter_sets(model);
    let examined: Vec<_> = sets.into_iter().step_by(stride.max(1)).collect();
    let is_reciprocal = is_reciprocal(model);
    let mut tally = examined
        .par_iter()
        .enumerate()
        .fold(Tally::default, |mut tally, (index, (case, params))| {
            let specimen = Specimen::new(model, params);
            let about = directions::about(&specimen);
            let step = if *case == ExtremeKind::Usual {
                1
            } else {
                SHARED_BY
            };
            let pairs = pairs.iter().skip(index % step).step_by(step);
            let pairs = pairs.chain(&about);
            at_pairs(&specimen, Some(*case), pairs, is_reciprocal, &mut tally);
            at_samples(&specimen, &mut tally);
            if *case == ExtremeKind::Usual {
                jumps::jumps(&specimen, &mut tally);
            }
            tally
        })
        .reduce(Tally::default, Tally::with);
    for (case, params) in &examined {
        if *case == ExtremeKind::Usual {
            jumps::along_parameters(model, params, &mut tally);
        }
    }
    search::random(model, random, &mut tally);
    search::climb(model, &mut tally);
    tally.into_extremes(model.properties.stability_ratio)
}

/// [`examine`] for each of `models`, in their order, the random points shared among them.
#[must_use]
pub fn examine_all(models: &[&ModelSpec], extent: Extent) -> Vec<Vec<Extreme>> {
    let share = |points: u64| points.div_ceil(models.len().max(1) as u64);
    models
        .par_iter()
        .map(|model| {
            let mut extremes = examine(model, extent.stride, share(extent.random));
            extremes.extend(examine_random_points(model, share(extent.random_points)));
            extremes
        })
        .collect()
}

/// The random points of `model`, on all processors.
fn examine_random_points(model: &ModelSpec, count: u64) -> Vec<Extreme> {
    let parts = count.div_ceil(CROWD_OF_PART);
    let tally = (0..parts)
        .into_par_iter()
        .fold(Tally::default, |mut tally, part| {
            let size = CROWD_OF_PART.min(count - part * CROWD_OF_PART);
            random_points::random_points(model, size, part, &mut tally);
            tally
        })
        .reduce(Tally::default, Tally::with);
    tally.into_extremes(model.properties.stability_ratio)
}

/// Takes `material`, at its parameters, to the extremes of directions.
#[must_use]
pub fn examine_material(material: &Material) -> Vec<Extreme> {
    examine_while(material, &|| true).unwrap_or_default()
}

/// What [`examine_material`] finds, asked as a query.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ranking;

impl Query for Ranking {
    type Answer = Vec<Extreme>;

    const BASIS: Basis = Basis::Material;

    fn answer(&self, of: &Asked<'_>, _: Detail, is_wanted: IsWanted<'_>) -> Option<Vec<Extreme>> {
        examine_while(of.material?, is_wanted)
    }
}

/// [`examine_material`]; `None` where it was not wanted to the end.
fn examine_while(material: &Material, is_wanted: IsWanted<'_>) -> Option<Vec<Extreme>> {
    let mut models = material.components().iter().map(Component::model);
    let is_reciprocal = models.all(is_reciprocal);
    let specimen = Specimen::of_material(material);
    let mut tally = Tally::default();
    let about = directions::about(&specimen);
    let all = directions::pairs()
        .into_iter()
        .chain(about)
        .collect::<Vec<_>>();
    for some in all.chunks(PAIRS_AT_A_TIME) {
        is_wanted().then_some(())?;
        at_pairs(&specimen, None, some, is_reciprocal, &mut tally);
    }
    is_wanted().then_some(())?;
    at_samples(&specimen, &mut tally);
    is_wanted().then_some(())?;
    jumps::jumps(&specimen, &mut tally);
    is_wanted().then_some(())?;
    search::climb_at(&specimen, &mut tally);
    let models = material.components().iter().map(Component::model);
    let ratios = models.map(|model| model.properties.stability_ratio);
    Some(tally.into_extremes(ratios.fold(1.0, f64::max)))
}

/// So many pairs are compared before it is asked again whether the answer is wanted.
const PAIRS_AT_A_TIME: usize = 256;

/// Whether the model is said to keep reciprocity.
fn is_reciprocal(model: &ModelSpec) -> bool {
    let declarations = model.properties.declarations;
    declarations
        .iter()
        .all(|declaration| declaration.law != Law::Reciprocity)
}

/// Compares at every pair, in every precision, under the cases of the directions and that of the parameters; what lies inside
/// the core, which no material has, is counted for itself alone.
fn at_pairs<'a>(
    specimen: &Specimen,
    of_parameters: Option<ExtremeKind>,
    pairs: impl IntoIterator<Item = &'a (ExtremeKind, Pair)>,
    is_reciprocal: bool,
    tally: &mut Tally,
) {
    let (single, double) = (point::single(specimen), point::double(specimen));
    for (case, pair) in pairs {
        let of_directions = (of_parameters != Some(ExtremeKind::Core)).then_some(*case);
        let cases: Vec<ExtremeKind> = of_parameters.into_iter().chain(of_directions).collect();
        point::measure(specimen, &cases, *pair, tally);
        if is_reciprocal && *case != ExtremeKind::Ladder {
            single.two_ways(*pair, tally);
            double.two_ways(*pair, tally);
        }
    }
}

/// Draws samples at the ends of the unit cube, in every precision.
fn at_samples(specimen: &Specimen, tally: &mut Tally) {
    let cases = [ExtremeKind::SamplerEnds];
    samples::samples(&point::single(specimen), &cases, &CHOICES, tally);
    samples::samples(&point::double(specimen), &cases, &CHOICES, tally);
    // Of the reference, which nothing is held against, it is enough to see each sampler once.
    let [_, middle, _] = CHOICES;
    samples::samples(&point::reference(specimen), &cases, &[middle], tally);
}
