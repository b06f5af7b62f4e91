//! What views and integrals ask of a scattering model besides: its lobes, one by one, and the factors of a microfacet's.

use crate::lobe::Lobe;
use crate::math::{Real, Vec3};
use crate::optics::Spectrum;
use crate::scattering::Bxdf;

/// A scattering model that knows its lobes.
///
/// A model of one lobe says which, and no more: a lobe's value, density and samples are those of the whole unless it says
/// otherwise. What it leaves out is seen by no integral.
pub trait Lobes<R: Real>: Bxdf<R> {
    /// The lobes that have a value at these parameters, each of which can be evaluated, drawn and integrated by itself
    /// under its index. Dirac deltas are not among them.
    fn lobes(&self) -> &[Lobe] {
        &[]
    }

    /// The part of `f` that belongs to the lobe at `index` of [`Self::lobes`], in 1/sr; the parts sum to `f`.
    ///
    /// Models with one lobe need not say more than `f`. `index` must be within [`Self::lobes`].
    #[inline(always)]
    fn lobe_f(&self, _index: usize, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        self.f(wo, wi)
    }

    /// The density per solid angle of [`Self::sample_lobe`], in 1/sr.
    ///
    /// Models whose `sample_f` needs no choice need not say more than `pdf`.
    #[inline(always)]
    fn lobe_pdf(&self, _index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        self.pdf(wo, wi)
    }

    /// A direction of incidence for `wo` that follows the lobe at `index` alone: a smooth map of the unit square, so that
    /// integrals over the lobe are integrals over `u`. `None` where the direction drawn is lost.
    #[inline(always)]
    fn sample_lobe(&self, _index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        Some(self.sample_f(wo, R::zero(), u)?.wi)
    }

    /// The factors of a microfacet model at a pair of directions. `None` for other models, and where there is no
    /// half vector.
    fn microfacet(&self, _wo: Vec3<R>, _wi: Vec3<R>) -> Option<Microfacet<R>> {
        None
    }
}

/// The factors of a microfacet lobe: its value is F D G over 4 |cos(theta_o) cos(theta_i)| in reflection.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Microfacet<R> {
    /// The density of microfacet normals at the half vector, in 1/sr.
    pub d: R,
    /// Masking and shadowing together, 0..1.
    pub g: R,
    /// The Fresnel factor of a facet: reflectance, or transmittance where the directions are across the surface.
    pub fresnel: Spectrum<R>,
}
