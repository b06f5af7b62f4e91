//! The ideal diffuse transmitter: light that crosses leaves with the same radiance in every direction.
//!
//! # Source
//! Lambert's law for the far side; the same index of refraction is taken on both sides: f = tau / pi.
//!
//! # Departures
//! None.
//!
//! # Validity
//! Exact for every direction and transmittance.

use crate::are_across;
use crate::common::*;
use crate::math::warp;
use crate::optics::Spectrum;
use crate::param::ParamSet;

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "lambertian_transmission",
    title: "Lambertian transmission",
    source: "Lambert 1760, Photometria, for the far side",
    summary: "Light crosses and leaves in every direction alike: paper held against a lamp, a leaf against the sun",
    lobes: &[Lobe::transmission(Category::Diffuse)],
    parameters: &[ParamSpec::rgb(
        "transmittance",
        [0.8; 3],
        "Share of the light that is transmitted, per channel; black absorbs all",
    )],
    properties: Properties::PLAIN,
    validate: ModelSpec::any,
    builders: builders!(build),
    // Nothing is cheaper.
    stand_ins: &[],
};

struct LambertianTransmission<R> {
    transmittance: Spectrum<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(LambertianTransmission {
        transmittance: Spectrum::of(params.rgb("transmittance")),
    })
}

impl<R: Real> Bxdf<R> for LambertianTransmission<R> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        if are_across(wo, wi) {
            self.transmittance * R::frac_1_pi()
        } else {
            Spectrum::black()
        }
    }

    #[inline(always)]
    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        if are_across(wo, wi) {
            wi.z.abs() * R::frac_1_pi()
        } else {
            R::zero()
        }
    }

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
        let above = warp::cosine_hemisphere(u);
        let wi = if wo.z > R::zero() {
            above.mirrored_in_surface()
        } else {
            above
        };
        are_across(wo, wi).then(|| Sample {
            wi,
            f: self.f(wo, wi),
            pdf: self.pdf(wo, wi),
            is_delta: false,
        })
    }
}

impl<R: Real> Lobes<R> for LambertianTransmission<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for LambertianTransmission<R> {
    loops!(R, if true);
}
