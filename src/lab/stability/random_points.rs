//! Many random points, in f32 and f64 alone: whether all is finite and not negative.

use super::ExtremeKind;
use super::directions::random_pair;
use super::extreme_tally::{Finding, Tally};
use super::parameters::random_set;
use super::samples::is_unit;
use crate::analysis::statistics::Random;
use bxdf::Precision;
use bxdf::batch::Columns;
use bxdf::math::{Real, Vec3};
use bxdf::param::ParamSet;
use bxdf::{ModelSpec, Scatterer};
use glam::DVec3;

/// Points at one set of parameters: a batch.
const BATCH: usize = 4096;

/// Values, densities and samples at `count` random points of `model`, in f32 and in f64 each; `seed` tells parts of one
/// search apart.
pub(super) fn random_points(model: &ModelSpec, count: u64, seed: u64, tally: &mut Tally) {
    let mut random = Random::new(seed);
    let mut done = 0;
    while done < count {
        let Some(params) = random_set(model, &mut random) else {
            continue;
        };
        let size = BATCH.min((count - done) as usize);
        let points: Vec<Point> = (0..size).map(|_| Point::new(&mut random)).collect();
        in_precision::<f32>(model, &params, &points, tally);
        in_precision::<f64>(model, &params, &points, tally);
        done += size as u64;
    }
}

/// A pair, and the numbers of a sample of its first direction.
struct Point {
    wo: DVec3,
    wi: DVec3,
    u: [f64; 3],
}

impl Point {
    fn new(random: &mut Random) -> Self {
        let (wo, wi) = random_pair(random);
        let u = [random.unit(), random.unit(), random.unit()];
        Self { wo, wi, u }
    }
}

fn in_precision<R: Precision>(
    model: &ModelSpec,
    params: &ParamSet,
    points: &[Point],
    tally: &mut Tally,
) {
    let bxdf: Box<dyn Scatterer<R>> = model.build(params);
    let wo = Columns::directions(points.iter().map(|point| point.wo));
    let wi = Columns::directions(points.iter().map(|point| point.wi));
    let last = R::one() - R::of(R::UNIT_ROUNDOFF);
    let numbers = points
        .iter()
        .map(|point| point.u.map(|u| R::of(u).min(last)));
    let numbers = Columns::from_rows(numbers);
    let values = bxdf.values_and_densities(&wo, &wi);
    let mut add = |point: &Point, finding: Finding| count(tally, params, point, finding, R::NAME);
    for (point, values) in points.iter().zip(values.rows()) {
        add(point, found(&values, false));
    }
    let samples = bxdf.samples(&wo, &numbers);
    for (point, [x, y, z, r, g, b, pdf, _]) in points.iter().zip(samples.rows()) {
        // No density is no sample.
        let is_long = pdf > R::zero() && !is_unit(Vec3::new(x, y, z));
        add(point, found(&[r, g, b, pdf], is_long));
    }
}

fn found<R: Real>(values: &[R], is_misplaced: bool) -> Finding {
    Finding {
        is_not_finite: values.iter().any(|x| !x.is_finite()),
        is_negative: values.iter().any(|x| *x < R::zero()),
        is_misplaced,
        ..Finding::default()
    }
}

fn count(
    tally: &mut Tally,
    params: &ParamSet,
    point: &Point,
    finding: Finding,
    precision: &'static str,
) {
    tally.add(&[ExtremeKind::Crowd], precision, finding, || {
        (params.component(), point.wo, point.wi)
    });
}
