//! The ideal diffuse reflector: the same radiance in every direction.
//!
//! # Source
//! Lambert 1760, "Photometria" (`lambert1760`): f = rho / pi.
//!
//! # Departures
//! None.
//!
//! # Validity
//! Exact for every direction and reflectance.

use super::*;
use crate::math::warp;
use crate::optics::Spectrum;
use crate::param::ParamSet;
use crate::{both_above, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "lambertian_reflection",
    title: "Lambertian reflection",
    source: "Lambert 1760, Photometria",
    summary: "The same radiance in every direction: a half circle in the polar plot, wherever the light stands",
    lobes: &[Lobe::reflection(Category::Diffuse)],
    parameters: &[REFLECTANCE],
    properties: Properties::PLAIN,
    validate: ModelSpec::any,
    builders: builders!(build),
    // Nothing is cheaper.
    stand_ins: &[],
};

struct LambertianReflection<R> {
    reflectance: Spectrum<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Bxdf<R>> {
    Box::new(LambertianReflection {
        reflectance: Spectrum::of(params.rgb("reflectance")),
    })
}

impl<R: Real> Bxdf<R> for LambertianReflection<R> {
    loops!(R, if true);

    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        match both_above(wo, wi) {
            Some(_) => self.reflectance * R::frac_1_pi(),
            None => Spectrum::black(),
        }
    }

    #[inline(always)]
    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some((_, wi)) = both_above(wo, wi) else {
            return R::zero();
        };
        warp::cosine_hemisphere_pdf(wi.z)
    }

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |_| Some(warp::cosine_hemisphere(u)),
        )
    }

    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}
