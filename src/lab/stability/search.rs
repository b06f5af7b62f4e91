//! Points by chance, and the way uphill from the worst.

use glam::DVec3;

use super::ExtremeKind;
use super::directions::{Pair, random_pair};
use super::extreme_tally::Tally;
use super::parameters::random_set;
use super::point::{self, Tested};
use super::samples;
use crate::analysis::statistics::Random;
use crate::specimen::{Specimen, seed_of};
use bxdf::math::Real;
use bxdf::param::{Kind, ParamSet, Value};
use bxdf::{Component, ModelSpec};

/// Random pairs at one set of parameters.
const PAIRS_OF_SET: u64 = 256;

/// Starts of a climb in each precision.
const STARTS: usize = 4;

/// Steps tried from each start.
const STEPS: usize = 128;

/// Compares at `count` random points of `model`.
pub(super) fn random(model: &ModelSpec, count: u64, tally: &mut Tally) {
    let mut random = Random::new(seed_of(model.id));
    let cases = [ExtremeKind::Random];
    let mut done = 0;
    while done < count {
        let Some(params) = random_set(model, &mut random) else {
            continue;
        };
        let specimen = Specimen::new(model, &params);
        let pairs = PAIRS_OF_SET.min(count - done);
        for _ in 0..pairs {
            at_random(&specimen, &cases, &mut random, tally);
        }
        done += pairs;
    }
}

/// Compares at one random pair, and draws one random sample.
fn at_random(specimen: &Specimen, cases: &[ExtremeKind], random: &mut Random, tally: &mut Tally) {
    let pair = random_pair(random);
    let u = [random.unit(), random.unit(), random.unit()];
    point::measure(specimen, cases, pair, tally);
    let (wo, _) = pair;
    samples::sample(&point::single(specimen), cases, wo, u, tally);
    samples::sample(&point::double(specimen), cases, wo, u, tally);
    samples::sample(&point::reference(specimen), cases, wo, u, tally);
}

/// Goes uphill from the worst points so far, in parameters and directions, each time to where the error uses up more of its
/// bound.
pub(super) fn climb(model: &ModelSpec, tally: &mut Tally) {
    let mut random = Random::new(seed_of(model.id) ^ 1);
    for (precision, worst) in starts(tally) {
        // What lies inside the core alone is no material.
        let Ok(start) = worst.params.parse::<Component>() else {
            continue;
        };
        let mut at = (start.params().clone(), (worst.wo, worst.wi));
        let mut specimen = Specimen::new(model, &at.0);
        let mut highest = 0.0;
        for step in 0..STEPS {
            let reach = 10.0_f64.powf(-8.0 * random.unit());
            let params = (step % 3 == 1).then(|| moved_params(&at.0, reach, &mut random));
            let pair = moved_pair(at.1, reach, &mut random);
            let moved = params
                .filter(|params| (model.validate)(params).is_ok())
                .map(|params| (Specimen::new(model, &params), params));
            let other = moved.as_ref().map_or(&specimen, |(specimen, _)| specimen);
            let ratio = measured(other, precision, pair, tally);
            if ratio > highest {
                highest = ratio;
                at.1 = pair;
                if let Some((other, params)) = moved {
                    (specimen, at.0) = (other, params);
                }
            }
        }
    }
}

/// [`climb`] in directions alone.
pub(super) fn climb_at(specimen: &Specimen, tally: &mut Tally) {
    let mut random = Random::new(specimen.seed() ^ 1);
    for (precision, worst) in starts(tally) {
        let (mut at, mut highest) = ((worst.wo, worst.wi), 0.0);
        for _ in 0..STEPS {
            let reach = 10.0_f64.powf(-8.0 * random.unit());
            let pair = moved_pair(at, reach, &mut random);
            let ratio = measured(specimen, precision, pair, tally);
            if ratio > highest {
                (highest, at) = (ratio, pair);
            }
        }
    }
}

/// The worst points so far in each precision, the worst first, one of each case.
fn starts(tally: &Tally) -> Vec<(&'static str, super::Worst)> {
    let of_precision = |precision: &'static str| {
        let mut found: Vec<_> = tally
            .extremes()
            .filter(|extreme| extreme.precision == precision && extreme.case.is_of_values())
            .filter_map(|extreme| Some((extreme.max_bound_ratio, extreme.worst.clone()?)))
            .collect();
        found.sort_by(|a, b| b.0.total_cmp(&a.0));
        found.dedup_by(|a, b| a.1 == b.1);
        found.truncate(STARTS);
        found.into_iter().map(move |(_, worst)| (precision, worst))
    };
    [f32::NAME, f64::NAME]
        .into_iter()
        .flat_map(of_precision)
        .collect()
}

/// The ratio at a pair in the precision of this name, exact if it is above what the climb has found so far.
fn measured(specimen: &Specimen, precision: &str, pair: Pair, tally: &mut Tally) -> f64 {
    if precision == f32::NAME {
        followed(&point::single(specimen), pair, tally)
    } else {
        followed(&point::double(specimen), pair, tally)
    }
}

fn followed<R: Real>(at: &Tested<'_, R>, pair: Pair, tally: &mut Tally) -> f64 {
    let finding = at.compare(pair, 0.0);
    tally.add(&[ExtremeKind::Climb], R::NAME, finding, || at.at(pair));
    finding.ratio
}

/// `params` with one number moved by about `reach` of itself, within its range.
fn moved_params(params: &ParamSet, reach: f64, random: &mut Random) -> ParamSet {
    let numbers: Vec<_> = params
        .iter()
        .filter(|(spec, _)| {
            matches!(spec.kind, Kind::Number | Kind::Rgb) && params.is_relevant(spec)
        })
        .collect();
    let index = (random.unit() * numbers.len() as f64) as usize;
    let Some((spec, value)) = numbers.get(index) else {
        return params.clone();
    };
    let [min, max] = spec.hard;
    let factor = 1.0 + reach * (2.0 * random.unit() - 1.0);
    let moved = |x: f64| (x * factor).clamp(min, max);
    let value = match *value {
        Value::Number(x) => Value::Number(moved(x)),
        Value::Rgb(rgb) => Value::Rgb(rgb.map(moved)),
        other => other,
    };
    params
        .with(&[(spec.name, value)])
        .unwrap_or_else(|| params.clone())
}

/// `pair` with one of the directions moved by about `reach`, or nearer to the horizon or farther by that share.
fn moved_pair((wo, wi): Pair, reach: f64, random: &mut Random) -> Pair {
    let [which, how] = random.pair();
    let mut moved = |w: DVec3| {
        let to = if how < 0.5 {
            w + random.direction() * reach
        } else {
            DVec3::new(w.x, w.y, w.z * (1.0 + reach * (2.0 * random.unit() - 1.0)))
        };
        to.try_normalize().unwrap_or(w)
    };
    if which < 0.5 {
        (moved(wo), wi)
    } else {
        (wo, moved(wi))
    }
}
