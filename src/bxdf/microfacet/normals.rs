//! What every distribution of microfacet normals offers.

use super::{Masked, Masking, Pair};
use crate::math::{Real, Vec3};

/// A distribution of microfacet normals with its masking: what the microfacet models are written over, so that the common
/// choices are compiled for each distribution and their loops carry no choice.
pub trait Normals<R: Real>: Copy + Send + Sync + 'static {
    /// Whether loops over it can be compiled for wide registers.
    const VECTORISES: bool;

    /// The density of microfacet normals at the unit normal `wh`, in 1/sr.
    fn d(&self, wh: Vec3<R>) -> R;

    /// What masks `w`.
    fn masked(&self, w: Vec3<R>) -> Masked<R>;

    /// 2 |cos| Lambda(w), without cancellation.
    fn masking_excess(&self, w: Vec3<R>) -> R;

    /// A visible normal of `wo` (on the upper side).
    fn sample_visible_normal(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>>;

    /// D(wh) G2 / (4 mu_o mu_i), whether the directions lie on one side or on two: the reflected lobe less its Fresnel
    /// factor. Saturates.
    #[inline(always)]
    fn lobe(&self, pair: &Pair<R>, masking: Masking) -> R {
        let inverse = self.inverse_visibility(pair.wo, pair.wi, masking);
        (self.d(pair.wh) / inverse).saturated()
    }

    /// 4 mu_o mu_i / G2, above 0.
    #[inline(always)]
    fn inverse_visibility(&self, wo: Vec3<R>, wi: Vec3<R>, masking: Masking) -> R {
        self.masked(wo).inverse_visibility(self.masked(wi), masking)
    }

    /// Masking and shadowing together, 0..1.
    #[inline(always)]
    fn g2(&self, wo: Vec3<R>, wi: Vec3<R>, masking: Masking) -> R {
        self.masked(wo).g2(self.masked(wi), masking)
    }

    /// The density per solid angle of `wi` when `wo` is reflected at a visible normal, that of `pair`. Saturates.
    #[inline(always)]
    fn reflection_pdf(&self, pair: &Pair<R>) -> R {
        (self.d(pair.wh) / self.masked(pair.wo).normals_per_direction()).saturated()
    }

    /// [`Self::lobe`] times `factor`, which may be so large that the product does not underflow where D does: what facets
    /// that refract make of it. Saturates.
    #[inline(always)]
    fn stretched_lobe(&self, pair: &Pair<R>, masking: Masking, factor: R) -> R {
        (self.lobe(pair, masking) * factor).saturated()
    }

    /// [`Self::reflection_pdf`] times such a `factor`. Saturates.
    #[inline(always)]
    fn stretched_pdf(&self, pair: &Pair<R>, factor: R) -> R {
        (self.reflection_pdf(pair) * factor).saturated()
    }

    /// `wo` (on the upper side) reflected at a visible normal; it may leave below the horizon.
    #[inline(always)]
    fn sample_reflection(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        let wh = self.sample_visible_normal(wo, u)?;
        Some(wh * (R::of(2.0) * wo.dot(wh)) - wo)
    }
}
