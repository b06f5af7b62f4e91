//! Values and densities of mixtures in batches: each component's own batch, stretch by stretch, and their weighted sum.

use super::mixture::{Mixture, weighed};
use crate::batch::{Directions, Job, Path, TripleMut};
use crate::math::{Real, Vec3};

/// Pairs that are worked on at a time: the components' results stay in the fastest cache.
pub(super) const STRETCH: usize = 256;

/// The value and the density of the first `n` pairs, of each what there is room for.
pub(super) fn evaluate<R: Real>(
    mixture: &Mixture<R>,
    path: Path,
    [wo, wi]: [Directions<'_, R>; 2],
    mut f: Option<TripleMut<'_, R>>,
    mut pdf: Option<&mut [R]>,
    n: usize,
) {
    let zero = R::zero();
    let mut scratch = [[zero; STRETCH]; 4];
    for start in (0..n).step_by(STRETCH) {
        let here = start..n.min(start + STRETCH);
        let [wo, wi] =
            [wo, wi].map(|axes| axes.map(|axis| axis.get(here.clone()).unwrap_or_default()));
        let [x, y, z] = wo;
        let shares: Vec<_> = if pdf.is_some() {
            let components = x.iter().zip(y).zip(z);
            let direction = |((x, y), z): ((&R, &R), &R)| Vec3::new(*x, *y, *z);
            components
                .map(|components| mixture.shares(direction(components)))
                .collect()
        } else {
            Vec::new()
        };
        let mut sums = [[R::zero(); STRETCH]; 4];
        let [value_sums @ .., density_sums] = &mut sums;
        for (index, part) in mixture.parts().iter().enumerate() {
            let own = scratch
                .each_mut()
                .map(|axis| axis.get_mut(..here.len()).unwrap_or_default());
            let [r, g, b, density] = own;
            let job = match (f.is_some(), pdf.is_some()) {
                (true, true) => Job::FPdf {
                    wo,
                    wi,
                    f: [r, g, b],
                    pdf: density,
                },
                (true, false) => Job::F {
                    wo,
                    wi,
                    f: [r, g, b],
                },
                _ => Job::Pdf {
                    wo,
                    wi,
                    pdf: density,
                },
            };
            part.bxdf.batch(path, job);
            let [values @ .., densities] = &scratch;
            if f.is_some() {
                for (sum, values) in value_sums.iter_mut().zip(values) {
                    for (sum, value) in sum.iter_mut().zip(values) {
                        *sum = *sum + *value * part.weight;
                    }
                }
            }
            for ((sum, value), shares) in density_sums.iter_mut().zip(densities).zip(&shares) {
                let share = shares.get(index).copied().unwrap_or_else(R::zero);
                *sum = *sum + weighed(share, *value);
            }
        }
        let write = |out: &mut [R], sums: &[R; STRETCH]| {
            let room = out.get_mut(here.clone()).unwrap_or_default();
            for (out, sum) in room.iter_mut().zip(sums) {
                *out = sum.saturated();
            }
        };
        if let Some(channels) = &mut f {
            for (channel, sums) in channels.iter_mut().zip(&*value_sums) {
                write(channel, sums);
            }
        }
        if let Some(pdf) = &mut pdf {
            write(pdf, density_sums);
        }
    }
}
