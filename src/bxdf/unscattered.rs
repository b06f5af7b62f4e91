//! A surface that is none: both of its sides are the same medium.

use super::math::{Real, Vec3};
use super::optics::Spectrum;
use super::{Bxdf, Delta, Deltas, Sample, Side, sample_deltas};

/// All light goes straight on: what a rough interface is where its index of refraction is 1, however rough.
#[derive(Clone, Copy, Debug)]
pub struct Unscattered;

impl<R: Real> Bxdf<R> for Unscattered {
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
        sample_deltas(self.deltas(wo), uc)
    }

    fn deltas(&self, w: Vec3<R>) -> Deltas<R> {
        let straight = Delta {
            direction: -w,
            flux: Spectrum::grey(R::one()),
            weight: Spectrum::grey(R::one()),
            probability: R::one(),
            side: Side::Transmission,
        };
        [(w.z != R::zero()).then_some(straight), None]
    }
}
