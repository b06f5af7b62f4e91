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

use crate::common::*;
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

/// What may replace a rough diffuse surface of [`REFLECTANCE`].
pub(super) const LAMBERT: StandIn = StandIn {
    name: "Lambert for the rough diffuse lobe",
    lost: "The lobe is round: no brightening back towards the light, no change towards the horizon",
    replace: |params| {
        let reflectance = Value::Rgb(params.rgb("reflectance"));
        SPEC.text_at(&[("reflectance", reflectance)])
    },
};

struct LambertianReflection<R> {
    reflectance: Spectrum<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(LambertianReflection {
        reflectance: Spectrum::of(params.rgb("reflectance")),
    })
}

impl<R: Real> Bxdf<R> for LambertianReflection<R> {
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
}

impl<R: Real> Lobes<R> for LambertianReflection<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for LambertianReflection<R> {
    loops!(R, if true);
}
