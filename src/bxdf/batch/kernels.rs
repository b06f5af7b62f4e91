//! What a batch computes for a block of elements.

use crate::lobes::Lobes;
use crate::math::{Real, Vec3};
use crate::optics::Spectrum;
use crate::sample::Sample;

/// Elements that are worked on at a time: the results stay in the fastest cache.
pub(super) const BLOCK: usize = 64;

/// A block of one component.
pub(super) type Block<R> = [R; BLOCK];

/// What a block's numbers are turned into. A type rather than a closure: the call of its function is always inlined.
pub(super) trait Kernel<R: Real, const M: usize, const N: usize> {
    /// Computes a block.
    fn block<B: Lobes<R> + ?Sized>(&self, bxdf: &B, given: [&Block<R>; M], out: [&mut Block<R>; N]);
}

/// The value of each pair.
pub(super) struct Values;

impl<R: Real> Kernel<R, 6, 3> for Values {
    #[inline(always)]
    fn block<B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R>; 6],
        [r, g, b]: [&mut Block<R>; 3],
    ) {
        // Inlined, or the loop is one of calls.
        values(
            #[inline(always)]
            |wo, wi| bxdf.f(wo, wi),
            [ox, oy, oz],
            [ix, iy, iz],
            r,
            g,
            b,
        );
    }
}

/// The value of one lobe, that at this index, for each pair.
pub(super) struct LobeValues(pub(super) usize);

impl<R: Real> Kernel<R, 6, 3> for LobeValues {
    #[inline(always)]
    fn block<B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R>; 6],
        [r, g, b]: [&mut Block<R>; 3],
    ) {
        // Inlined, or the loop is one of calls.
        values(
            #[inline(always)]
            |wo, wi| bxdf.lobe_f(self.0, wo, wi),
            [ox, oy, oz],
            [ix, iy, iz],
            r,
            g,
            b,
        );
    }
}

/// Each block that is written is an argument of its own: so the compiler knows that no two of them overlap.
#[inline(always)]
fn values<R: Real>(
    f: impl Fn(Vec3<R>, Vec3<R>) -> Spectrum<R>,
    wo: [&Block<R>; 3],
    wi: [&Block<R>; 3],
    r: &mut Block<R>,
    g: &mut Block<R>,
    b: &mut Block<R>,
) {
    let out = r.iter_mut().zip(g).zip(b);
    for ((wo, wi), ((r, g), b)) in directions(wo).zip(directions(wi)).zip(out) {
        let Spectrum(f) = f(wo, wi);
        [*r, *g, *b] = f;
    }
}

/// The density of each pair.
pub(super) struct Densities;

impl<R: Real> Kernel<R, 6, 1> for Densities {
    #[inline(always)]
    fn block<B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R>; 6],
        [pdf]: [&mut Block<R>; 1],
    ) {
        let (wo, wi) = (directions([ox, oy, oz]), directions([ix, iy, iz]));
        for ((wo, wi), pdf) in wo.zip(wi).zip(pdf) {
            *pdf = bxdf.pdf(wo, wi);
        }
    }
}

/// The value and the density of each pair.
pub(super) struct ValuesAndDensities;

impl<R: Real> Kernel<R, 6, 4> for ValuesAndDensities {
    #[inline(always)]
    fn block<B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        [ox, oy, oz, ix, iy, iz]: [&Block<R>; 6],
        [r, g, b, pdf]: [&mut Block<R>; 4],
    ) {
        values_and_densities(bxdf, [ox, oy, oz], [ix, iy, iz], r, g, b, pdf);
    }
}

/// As for [`values`].
#[inline(always)]
fn values_and_densities<R: Real, B: Lobes<R> + ?Sized>(
    bxdf: &B,
    wo: [&Block<R>; 3],
    wi: [&Block<R>; 3],
    r: &mut Block<R>,
    g: &mut Block<R>,
    b: &mut Block<R>,
    pdf: &mut Block<R>,
) {
    let out = r.iter_mut().zip(g).zip(b).zip(pdf);
    for ((wo, wi), (((r, g), b), pdf)) in directions(wo).zip(directions(wi)).zip(out) {
        let (Spectrum(f), density) = bxdf.f_pdf(wo, wi);
        [*r, *g, *b] = f;
        *pdf = density;
    }
}

/// A sample for each direction.
pub(super) struct Samples;

impl<R: Real> Kernel<R, 6, 8> for Samples {
    #[inline(always)]
    fn block<B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        [ox, oy, oz, uc, u, v]: [&Block<R>; 6],
        [x, y, z, r, g, b, pdf, delta]: [&mut Block<R>; 8],
    ) {
        samples(bxdf, [ox, oy, oz], [uc, u, v], x, y, z, r, g, b, pdf, delta);
    }
}

/// As for [`values`].
#[allow(clippy::too_many_arguments)]
#[inline(always)]
fn samples<R: Real, B: Lobes<R> + ?Sized>(
    bxdf: &B,
    wo: [&Block<R>; 3],
    [uc, u, v]: [&Block<R>; 3],
    x: &mut Block<R>,
    y: &mut Block<R>,
    z: &mut Block<R>,
    r: &mut Block<R>,
    g: &mut Block<R>,
    b: &mut Block<R>,
    pdf: &mut Block<R>,
    delta: &mut Block<R>,
) {
    let numbers = uc.iter().zip(u).zip(v);
    let values = r.iter_mut().zip(g).zip(b);
    let out = x
        .iter_mut()
        .zip(y)
        .zip(z)
        .zip(values)
        .zip(pdf.iter_mut().zip(delta));
    for ((wo, ((uc, u), v)), out) in directions::<R>(wo).zip(numbers).zip(out) {
        let ((((x, y), z), ((r, g), b)), (pdf, delta)) = out;
        let zero = R::zero();
        // No sample is a sample of nothing: every element is written, whatever was drawn.
        let sample = match bxdf.sample_f(wo, *uc, [*u, *v]) {
            Some(sample) => sample,
            None => Sample {
                wi: Vec3::new(zero, zero, zero),
                f: Spectrum::black(),
                pdf: zero,
                is_delta: false,
            },
        };
        (*x, *y, *z) = (sample.wi.x, sample.wi.y, sample.wi.z);
        [*r, *g, *b] = sample.f.0;
        *pdf = sample.pdf;
        *delta = if sample.is_delta { R::one() } else { zero };
    }
}

/// A direction of one lobe for each that is held, with its weight.
pub(super) struct LobeSamples {
    pub(super) index: usize,
    pub(super) is_incident: bool,
}

impl<R: Real> Kernel<R, 5, 6> for LobeSamples {
    #[inline(always)]
    fn block<B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        [hx, hy, hz, u, v]: [&Block<R>; 5],
        [x, y, z, r, g, b]: [&mut Block<R>; 6],
    ) {
        self.weights(bxdf, [hx, hy, hz], [u, v], x, y, z, r, g, b);
    }
}

impl LobeSamples {
    /// As for [`values`].
    #[allow(clippy::too_many_arguments)]
    #[inline(always)]
    fn weights<R: Real, B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        held: [&Block<R>; 3],
        [u, v]: [&Block<R>; 2],
        x: &mut Block<R>,
        y: &mut Block<R>,
        z: &mut Block<R>,
        r: &mut Block<R>,
        g: &mut Block<R>,
        b: &mut Block<R>,
    ) {
        let out = x.iter_mut().zip(y).zip(z).zip(r.iter_mut().zip(g).zip(b));
        for ((held, (u, v)), out) in directions::<R>(held).zip(u.iter().zip(v)).zip(out) {
            let (((x, y), z), ((r, g), b)) = out;
            let (free, Spectrum(weight)) = self.drawn(bxdf, held, [*u, *v]);
            (*x, *y, *z) = (free.x, free.y, free.z);
            [*r, *g, *b] = weight;
        }
    }

    #[inline(always)]
    fn drawn<R: Real, B: Lobes<R> + ?Sized>(
        &self,
        bxdf: &B,
        held: Vec3<R>,
        u: [R; 2],
    ) -> (Vec3<R>, Spectrum<R>) {
        let zero = R::zero();
        let nothing = (Vec3::new(zero, zero, zero), Spectrum::black());
        let Some(free) = bxdf.sample_lobe(self.index, held, u) else {
            return nothing;
        };
        let pdf = bxdf.lobe_pdf(self.index, held, free);
        let (wo, wi) = if self.is_incident {
            (free, held)
        } else {
            (held, free)
        };
        let f = bxdf.lobe_f(self.index, wo, wi);
        if pdf > zero {
            (free, f * (free.z.abs() / pdf))
        } else {
            nothing
        }
    }
}

/// The directions of a block.
#[inline(always)]
fn directions<R: Real>([x, y, z]: [&Block<R>; 3]) -> impl Iterator<Item = Vec3<R>> {
    x.iter()
        .zip(y)
        .zip(z)
        .map(|((x, y), z)| Vec3::new(*x, *y, *z))
}
