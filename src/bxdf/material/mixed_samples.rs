//! Samples of mixtures in batches: sorted by the component that each chooses, drawn by that component's own batch, and
//! valued by all.

use super::mixed_values::{STRETCH, evaluate};
use super::mixture::Mixture;
use crate::batch::{Columns, Job, Path};
use crate::lobe::Side;
use crate::math::{Real, Vec3};
use crate::scattering::Bxdf;

/// What samples are drawn by: the components of wo, the number that chooses, and two for the direction.
pub(super) type Given<'a, S> = [&'a [S]; 6];

/// Where they go: the components of wi, the channels of f, pdf, and whether it is a delta.
pub(super) type Drawn<'a, S> = [&'a mut [S]; 8];

/// Draws the first `n` samples, each as `sample_f` draws it.
pub(super) fn samples<R: Real>(
    mixture: &Mixture<R>,
    path: Path,
    given: Given<'_, R>,
    mut drawn: Drawn<'_, R>,
    n: usize,
) {
    for start in (0..n).step_by(STRETCH) {
        let end = n.min(start + STRETCH);
        let given = given.map(|slice| slice.get(start..end).unwrap_or_default());
        let drawn = drawn
            .each_mut()
            .map(|slice| slice.get_mut(start..end).unwrap_or_default());
        samples_at_once(mixture, path, given, drawn);
    }
}

fn samples_at_once<R: Real>(
    mixture: &Mixture<R>,
    path: Path,
    given: Given<'_, R>,
    drawn: Drawn<'_, R>,
) {
    let [ox, oy, oz, uc, u, v] = given;
    let [ix, iy, iz, r, g, b, pdf, delta] = drawn;
    let zero = R::zero();
    let direction = |x: &R, y: &R, z: &R| Vec3::new(*x, *y, *z);
    // Which component each sample chooses, and the number that is left to choose among its lobes.
    let numbers = ox.iter().zip(oy).zip(oz).zip(uc);
    let chosen: Vec<Option<(usize, R)>> = numbers
        .map(|(((x, y), z), uc)| mixture.choose(direction(x, y, z), *uc))
        .collect();
    for slice in [&mut *ix, &mut *iy, &mut *iz, &mut *pdf, &mut *delta] {
        slice.fill(zero);
    }
    for (index, part) in mixture.parts().iter().enumerate() {
        let own: Vec<(usize, R)> = chosen
            .iter()
            .enumerate()
            .filter_map(|(place, choice)| {
                choice.and_then(|(chosen, rest)| (chosen == index).then_some((place, rest)))
            })
            .collect();
        if own.is_empty() {
            continue;
        }
        let picked = Columns::from_rows(own.iter().map(|(place, rest)| {
            let at = |slice: &[R]| slice.get(*place).copied().unwrap_or(zero);
            [at(ox), at(oy), at(oz), *rest, at(u), at(v)]
        }));
        let [own_x, own_y, own_z, own_uc, own_u, own_v] = picked.slices();
        let mut room = Columns::filled(zero, own.len());
        let [x, y, z, fr, fg, fb, density, is_delta] = room.slices_mut();
        let job = Job::Sample {
            wo: [own_x, own_y, own_z],
            uc: own_uc,
            u: [own_u, own_v],
            wi: [x, y, z],
            f: [fr, fg, fb],
            pdf: density,
            delta: is_delta,
        };
        part.bxdf.batch(path, job);
        let [x, y, z, .., density, is_delta] = room.slices();
        let to = [&mut *ix, &mut *iy, &mut *iz, &mut *pdf, &mut *delta];
        for (axis, from) in to.into_iter().zip([x, y, z, density, is_delta]) {
            for ((place, _), value) in own.iter().zip(from) {
                if let Some(slot) = axis.get_mut(*place) {
                    *slot = *value;
                }
            }
        }
    }
    // Whatever drew it, a direction has the value and the density of the whole.
    let wi = [&*ix, &*iy, &*iz];
    let mut density = vec![zero; pdf.len()];
    let n = density.len();
    let f = [&mut *r, &mut *g, &mut *b];
    evaluate(
        mixture,
        path,
        [[ox, oy, oz], wi],
        Some(f),
        Some(&mut density),
        n,
    );
    let given = ox.iter().zip(oy).zip(oz).zip(&density);
    let directions = ix.iter_mut().zip(iy).zip(iz);
    let values = r.iter_mut().zip(g).zip(b);
    let results = directions.zip(values).zip(pdf.iter_mut().zip(delta));
    for ((((x, y), z), density), ((((ix, iy), iz), ((r, g), b)), (pdf, delta))) in
        given.zip(results)
    {
        let mut sample = None;
        if *delta > R::zero() {
            let wo = direction(x, y, z);
            let side = Side::between(wo, direction(ix, iy, iz));
            let mut deltas = mixture.deltas(wo).into_iter().flatten();
            sample = deltas
                .find(|delta| delta.side == side)
                .map(|delta| delta.sample());
        } else if *pdf > R::zero() && *density >= R::min_positive_value() {
            // The direction and the values stand there already.
            *pdf = *density;
            continue;
        }
        let [wi, f] = sample.map_or([[R::zero(); 3]; 2], |sample| {
            [[sample.wi.x, sample.wi.y, sample.wi.z], sample.f.0]
        });
        let is_there = sample.is_some();
        for (slot, x) in [ix, iy, iz, r, g, b]
            .into_iter()
            .zip([wi, f].as_flattened())
        {
            *slot = *x;
        }
        *pdf = sample.map_or(R::zero(), |sample| sample.pdf);
        *delta = if is_there { R::one() } else { R::zero() };
    }
}
