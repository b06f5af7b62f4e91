//! Number formats: what the digits of a material's values cost.

use glam::DVec3;
use rayon::prelude::*;
use xprec::Df64;

use super::bench::{Bench, Family, Measuring};
use super::errors::Values;
use super::report::{CostUnit, Point};
use super::study::Study;
use bxdf::batch::{Columns, Job, Path};
use bxdf::internals::Libm;
use bxdf::math::Real;
use bxdf::{Precision, Scatterer};

/// The family.
pub(super) struct Precisions;

impl Family for Precisions {
    fn id(&self) -> &'static str {
        "precision"
    }

    fn title(&self) -> &'static str {
        "Precision"
    }

    fn cost_unit(&self) -> CostUnit {
        CostUnit::Evaluation
    }

    fn is_of_material(&self) -> bool {
        true
    }

    fn has_quick_errors(&self) -> bool {
        true
    }

    fn share(&self) -> f64 {
        1.0
    }

    fn measure<'a>(&'a self, study: &'a Study<'_>, bench: &'a mut Bench<'_>) -> Measuring<'a> {
        Box::pin(async move {
            let reference = study.material.build::<Df64>();
            let exact = |pairs: &[(DVec3, DVec3)]| pair_by_pair(&*reference, pairs);
            let baseline = study.baseline(&exact)?;
            bench.reference("double-double numbers of 32 digits".to_owned());
            let pairs = &study.probe.pairs;
            let n = pairs.len() as f64;
            let add = |bench: &mut Bench<'_>, name: &str, values: Values<'_>, cost| {
                let point = Point::new(name).with_errors(baseline.errors(values));
                bench.point(point.costing(cost));
            };
            bench.wanted().await?;
            let single = study.material.build::<f32>();
            for (name, path) in [
                ("f32, polynomials, widest registers", Path::Dispatched),
                ("f32, polynomials, plain", Path::Plain),
            ] {
                let mut batch = Batch::<f32>::new(pairs);
                let cost = bench.time(n, &mut || batch.run(&*single, path)).over(n);
                let values = |pairs: &[(DVec3, DVec3)]| values_in(&*single, path, pairs);
                add(bench, name, &values, cost);
            }
            let library = study.material.build::<Libm>();
            let mut batch = Batch::<Libm>::new(pairs);
            let cost = bench
                .time(1.5 * n, &mut || batch.run(&*library, Path::Plain))
                .over(n);
            let values = |pairs: &[(DVec3, DVec3)]| values_in(&*library, Path::Plain, pairs);
            add(bench, "f32, library functions, plain", &values, cost);
            bench.at(0.2).await?;
            for (name, path) in [
                ("f64, library functions, widest registers", Path::Dispatched),
                ("f64, library functions, plain", Path::Plain),
            ] {
                let mut batch = Batch::<f64>::new(pairs);
                let cost = bench
                    .time(2.0 * n, &mut || batch.run(study.bxdf(), path))
                    .over(n);
                let values = |pairs: &[(DVec3, DVec3)]| values_in(study.bxdf(), path, pairs);
                add(bench, name, &values, cost);
            }
            bench.at(0.4).await?;
            let some = pairs
                .get(..pairs.len().min(TIMED_PAIRS))
                .unwrap_or_default();
            let count = some.len() as f64;
            let cost = bench.time(100.0 * count, &mut || {
                let values = some.iter().map(|pair| value(&*reference, pair)[0]);
                std::hint::black_box(values.sum::<f64>());
            });
            add(bench, "double-double (reference)", &exact, cost.over(count));
            Ok(())
        })
    }
}

/// Pairs at which the slow reference is timed.
const TIMED_PAIRS: usize = 512;

fn value(bxdf: &dyn Scatterer<Df64>, (wo, wi): &(DVec3, DVec3)) -> [f64; 3] {
    bxdf.f((*wo).into(), (*wi).into()).to_f64()
}

fn pair_by_pair(bxdf: &dyn Scatterer<Df64>, pairs: &[(DVec3, DVec3)]) -> Vec<[f64; 3]> {
    pairs.par_iter().map(|pair| value(bxdf, pair)).collect()
}

/// Pairs of directions and room for their values, component by component.
pub(super) struct Batch<R> {
    wo: Columns<R, 3>,
    wi: Columns<R, 3>,
    f: Columns<R, 3>,
}

impl<R: Precision> Batch<R> {
    /// Of these pairs (wo, wi).
    pub(super) fn new(pairs: &[(DVec3, DVec3)]) -> Self {
        Self {
            wo: Columns::directions(pairs.iter().map(|(wo, _)| *wo)),
            wi: Columns::directions(pairs.iter().map(|(_, wi)| *wi)),
            f: Columns::filled(R::zero(), pairs.len()),
        }
    }

    /// Evaluates f of all pairs.
    pub(super) fn run(&mut self, bxdf: &dyn Scatterer<R>, path: Path) {
        let job = Job::F {
            wo: self.wo.slices(),
            wi: self.wi.slices(),
            f: self.f.slices_mut(),
        };
        bxdf.batch(path, job);
        std::hint::black_box(&self.f);
    }

    /// What [`Self::run`] found last, channel by channel.
    pub(super) fn values(&self) -> &Columns<R, 3> {
        &self.f
    }
}

/// f of `bxdf` in 1/sr at `pairs`, evaluated in `R`.
pub(super) fn values_in<R: Precision>(
    bxdf: &dyn Scatterer<R>,
    path: Path,
    pairs: &[(DVec3, DVec3)],
) -> Vec<[f64; 3]> {
    let mut batch = Batch::new(pairs);
    batch.run(bxdf, path);
    by_pair(batch.values())
}

/// Values by channel as values by pair.
pub(super) fn by_pair<R: Real>(channels: &Columns<R, 3>) -> Vec<[f64; 3]> {
    channels.rows().map(|f| f.map(R::as_f64)).collect()
}
