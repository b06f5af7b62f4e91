//! Batches of mixtures: each component's own batch, stretch by stretch, and their weighted sum.

use super::mixture::Mixture;
use crate::bxdf::batch::{Directions, Job, Path, TripleMut, run};
use crate::bxdf::math::{Real, Vec3};

/// Pairs that are worked on at a time: the components' results stay in the fastest cache.
const STRETCH: usize = 256;

/// Runs `job` on `mixture`. Samples are drawn one by one: each chooses a component.
pub(super) fn run_mixture<R: Real>(mixture: &Mixture<R>, path: Path, job: Job<'_, R::Stored>) {
    let n = job.len();
    match job {
        Job::F { wo, wi, f } => values(mixture, path, wo, wi, f),
        Job::Pdf { wo, wi, pdf } => densities(mixture, path, wo, wi, pdf),
        Job::FPdf { wo, wi, f, pdf } => {
            values(mixture, path, wo, wi, f);
            densities(mixture, path, wo, wi, pdf);
        }
        sample @ Job::Sample { .. } => run(mixture, Path::Plain, sample),
        Job::Lobe {
            index,
            is_incident,
            held,
            u,
            free,
            weight,
        } => {
            let Some((part, index)) = mixture.lobe(index) else {
                return;
            };
            let [r, g, b] = weight;
            let inner = Job::Lobe {
                index,
                is_incident,
                held,
                u,
                free,
                weight: [&mut *r, &mut *g, &mut *b],
            };
            part.bxdf.batch(path, inner);
            scale([r, g, b], n, part.weight);
        }
        Job::LobeF { index, wo, wi, f } => {
            let Some((part, index)) = mixture.lobe(index) else {
                return;
            };
            let [r, g, b] = f;
            let inner = Job::LobeF {
                index,
                wo,
                wi,
                f: [&mut *r, &mut *g, &mut *b],
            };
            part.bxdf.batch(path, inner);
            scale([r, g, b], n, part.weight);
        }
    }
}

/// The first `n` of each channel times `weight`.
fn scale<R: Real>(channels: TripleMut<'_, R::Stored>, n: usize, weight: R) {
    for value in channels.into_iter().flat_map(|c| c.iter_mut().take(n)) {
        *value = (R::load(*value) * weight).store();
    }
}

fn values<R: Real>(
    mixture: &Mixture<R>,
    path: Path,
    wo: Directions<'_, R::Stored>,
    wi: Directions<'_, R::Stored>,
    f: TripleMut<'_, R::Stored>,
) {
    let [r, g, b] = f;
    let mut part_of = [[R::zero().store(); STRETCH]; 3];
    let stretches = r
        .chunks_mut(STRETCH)
        .zip(g.chunks_mut(STRETCH))
        .zip(b.chunks_mut(STRETCH));
    for (number, ((r, g), b)) in stretches.enumerate() {
        let start = number * STRETCH;
        let (wo, wi) = (stretch(wo, start), stretch(wi, start));
        let n = written([&wo, &wi], r.len().min(g.len()).min(b.len()));
        let mut sums = [[R::zero(); STRETCH]; 3];
        for part in mixture.parts() {
            let [x, y, z] = part_of
                .each_mut()
                .map(|axis| axis.get_mut(..n).unwrap_or_default());
            part.bxdf.batch(
                path,
                Job::F {
                    wo,
                    wi,
                    f: [x, y, z],
                },
            );
            for (sum, values) in sums.iter_mut().zip(&part_of) {
                for (sum, value) in sum.iter_mut().zip(values) {
                    *sum = *sum + R::load(*value) * part.weight;
                }
            }
        }
        for (out, sum) in [r, g, b].into_iter().zip(&sums) {
            let written = out.iter_mut().zip(sum).take(n);
            written.for_each(|(out, sum)| *out = sum.saturated().store());
        }
    }
}

fn densities<R: Real>(
    mixture: &Mixture<R>,
    path: Path,
    wo: Directions<'_, R::Stored>,
    wi: Directions<'_, R::Stored>,
    pdf: &mut [R::Stored],
) {
    let mut part_of = [R::zero().store(); STRETCH];
    for (number, pdf) in pdf.chunks_mut(STRETCH).enumerate() {
        let start = number * STRETCH;
        let (wo, wi) = (stretch(wo, start), stretch(wi, start));
        let n = written([&wo, &wi], pdf.len());
        let [x, y, z] = wo;
        let shares: Vec<_> = x
            .iter()
            .zip(y)
            .zip(z)
            .take(n)
            .map(|((x, y), z)| mixture.shares(Vec3::new(R::load(*x), R::load(*y), R::load(*z))))
            .collect();
        let mut sums = [R::zero(); STRETCH];
        for (index, part) in mixture.parts().iter().enumerate() {
            let pdf = part_of.get_mut(..n).unwrap_or_default();
            part.bxdf.batch(path, Job::Pdf { wo, wi, pdf });
            for ((sum, value), shares) in sums.iter_mut().zip(&part_of).zip(&shares) {
                let share = shares.get(index).copied().unwrap_or_else(R::zero);
                *sum = *sum + weighed(share, R::load(*value));
            }
        }
        let written = pdf.iter_mut().zip(&sums).take(n);
        written.for_each(|(out, sum)| *out = sum.saturated().store());
    }
}

/// `share` times `density`. A component that is never chosen may have an infinite density: 0 times it is no number.
#[inline(always)]
pub(super) fn weighed<R: Real>(share: R, density: R) -> R {
    if share > R::zero() {
        share * density
    } else {
        R::zero()
    }
}

/// The directions from `start` on, [`STRETCH`] of them or as many as are left.
fn stretch<S>(directions: Directions<'_, S>, start: usize) -> Directions<'_, S> {
    directions.map(|axis| {
        let end = axis.len().min(start + STRETCH);
        axis.get(start..end).unwrap_or_default()
    })
}

/// How many of `n` results there are directions for.
fn written<S>(directions: [&Directions<'_, S>; 2], n: usize) -> usize {
    let axes = directions.into_iter().flatten();
    axes.map(|axis| axis.len()).fold(n, usize::min)
}
