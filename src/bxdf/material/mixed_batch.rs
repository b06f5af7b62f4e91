//! Batches of mixtures: each component's own batch, stretch by stretch, and their weighted sum.

use super::mixed_samples;
use super::mixed_values::evaluate;
use super::mixture::Mixture;
use crate::batch::{Job, Path, Scatterer, TripleMut};
use crate::math::Real;

impl<R: Real> Scatterer<R> for Mixture<R> {
    fn batch(&self, path: Path, job: Job<'_, R>) {
        run(self, path, job);
    }
}

fn run<R: Real>(mixture: &Mixture<R>, path: Path, job: Job<'_, R>) {
    let n = job.len();
    match job {
        Job::F { wo, wi, f } => evaluate(mixture, path, [wo, wi], Some(f), None, n),
        Job::Pdf { wo, wi, pdf } => evaluate(mixture, path, [wo, wi], None, Some(pdf), n),
        Job::FPdf { wo, wi, f, pdf } => {
            evaluate(mixture, path, [wo, wi], Some(f), Some(pdf), n);
        }
        Job::Sample {
            wo: [x, y, z],
            uc,
            u: [u, v],
            wi: [ix, iy, iz],
            f: [r, g, b],
            pdf,
            delta,
        } => {
            let drawn = [ix, iy, iz, r, g, b, pdf, delta];
            mixed_samples::samples(mixture, path, [x, y, z, uc, u, v], drawn, n);
        }
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
fn scale<R: Real>(channels: TripleMut<'_, R>, n: usize, weight: R) {
    for value in channels.into_iter().flat_map(|c| c.iter_mut().take(n)) {
        *value = *value * weight;
    }
}
