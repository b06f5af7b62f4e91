//! Many random points, in f32 and f64 alone: whether all is finite and not negative.

use super::Case;
use super::directions::random_pair;
use super::parameters::random_set;
use super::samples::is_unit;
use super::tally::{Finding, Tally};
use crate::analysis::statistics::Random;
use crate::bxdf::batch::{Job, Path};
use crate::bxdf::math::{Real, Vec3};
use crate::bxdf::param::ParamSet;
use crate::bxdf::spec::Precision;
use crate::bxdf::{Bxdf, ModelSpec};
use glam::DVec3;

/// Points at one set of parameters: a batch.
const BATCH: usize = 4096;

/// Values, densities and samples at `count` random points of `model`, in f32 and in f64 each; `seed` tells parts of one
/// search apart.
pub(super) fn crowd(model: &ModelSpec, count: u64, seed: u64, tally: &mut Tally) {
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

/// Slices of columns, as batches have them.
fn columns<R: Copy, const N: usize>(
    points: &[Point],
    of: impl Fn(&Point) -> [R; N],
) -> [Vec<R>; N] {
    let mut columns = [(); N].map(|()| Vec::with_capacity(points.len()));
    for point in points {
        for (column, x) in columns.iter_mut().zip(of(point)) {
            column.push(x);
        }
    }
    columns
}

fn in_precision<R: Precision + Real<Stored = R>>(
    model: &ModelSpec,
    params: &ParamSet,
    points: &[Point],
    tally: &mut Tally,
) {
    let bxdf: Box<dyn Bxdf<R>> = model.build(params);
    let of = |w: DVec3| [R::of(w.x), R::of(w.y), R::of(w.z)];
    let wo = columns(points, |point| of(point.wo));
    let wi = columns(points, |point| of(point.wi));
    let last = R::one() - R::of(R::UNIT_ROUNDOFF);
    let [uc, u, v] = columns(points, |point| point.u.map(|u| R::of(u).min(last)));
    let zeros = || vec![R::zero(); points.len()];
    let [mut r, mut g, mut b, mut pdf] = [(); 4].map(|()| zeros());
    let wo_slices = wo.each_ref().map(Vec::as_slice);
    let pairs = Job::FPdf {
        wo: wo_slices,
        wi: wi.each_ref().map(Vec::as_slice),
        f: [&mut r, &mut g, &mut b],
        pdf: &mut pdf,
    };
    bxdf.batch(Path::Dispatched, pairs);
    let values = r.iter().zip(&g).zip(&b).zip(&pdf);
    for (point, (((r, g), b), pdf)) in points.iter().zip(values) {
        count(
            tally,
            params,
            point,
            found(&[*r, *g, *b, *pdf], false),
            R::NAME,
        );
    }
    let [mut x, mut y, mut z, mut delta] = [(); 4].map(|()| zeros());
    let samples = Job::Sample {
        wo: wo_slices,
        uc: &uc,
        u: [&u, &v],
        wi: [&mut x, &mut y, &mut z],
        f: [&mut r, &mut g, &mut b],
        pdf: &mut pdf,
        delta: &mut delta,
    };
    bxdf.batch(Path::Dispatched, samples);
    let directions = x.iter().zip(&y).zip(&z);
    let values = r.iter().zip(&g).zip(&b).zip(&pdf);
    for ((point, ((x, y), z)), (((r, g), b), pdf)) in points.iter().zip(directions).zip(values) {
        // No density is no sample.
        let is_long = *pdf > R::zero() && !is_unit(Vec3::new(*x, *y, *z));
        count(
            tally,
            params,
            point,
            found(&[*r, *g, *b, *pdf], is_long),
            R::NAME,
        );
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
    tally.add(&[Case::Crowd], precision, finding, || {
        (params.component(), point.wo, point.wi)
    });
}
