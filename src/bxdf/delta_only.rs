//! Surfaces whose light is all in Dirac deltas.

use super::batch::{Job, Path, Scatterer, one_by_one};
use super::lobe::Side;
use super::lobes::Lobes;
use super::math::{Real, Vec3};
use super::optics::Spectrum;
use super::sample::{Delta, Deltas, Sample, sample_deltas};
use super::scattering::Bxdf;

/// Says where the deltas of such a surface are.
pub trait DeltaLobes<R: Real>: Send + Sync {
    /// The deltas of `w`, which is not in the horizon plane; see [`Bxdf::deltas`].
    fn deltas(&self, w: Vec3<R>) -> Deltas<R>;
}

/// A surface of deltas as a scattering model: it has no values, and is sampled from its list of deltas.
#[derive(Clone, Copy, Debug)]
pub struct DeltaOnly<L>(pub L);

impl<R: Real, L: DeltaLobes<R>> Bxdf<R> for DeltaOnly<L> {
    #[inline(always)]
    fn f(&self, _wo: Vec3<R>, _wi: Vec3<R>) -> Spectrum<R> {
        Spectrum::black()
    }

    #[inline(always)]
    fn pdf(&self, _wo: Vec3<R>, _wi: Vec3<R>) -> R {
        R::zero()
    }

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, _u: [R; 2]) -> Option<Sample<R>> {
        sample_deltas(Bxdf::deltas(self, wo), uc)
    }

    #[inline(always)]
    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        if w.z == R::zero() {
            return [None, None];
        }
        self.0.deltas(w)
    }
}

impl<R: Real, L: DeltaLobes<R>> Lobes<R> for DeltaOnly<L> {}

impl<R: Real, L: DeltaLobes<R>> Scatterer<R> for DeltaOnly<L> {
    fn batch(&self, _path: Path, job: Job<'_, R>) {
        one_by_one(self, job);
    }
}

/// No surface at all: light goes straight on. What a rough interface is where its index is 1, however rough.
#[derive(Clone, Copy, Debug)]
pub struct Unscattered;

impl<R: Real> DeltaLobes<R> for Unscattered {
    #[inline(always)]
    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let straight = Delta {
            direction: -w,
            flux: Spectrum::grey(R::one()),
            weight: Spectrum::grey(R::one()),
            probability: R::one(),
            side: Side::Transmission,
        };
        [Some(straight), None]
    }
}
