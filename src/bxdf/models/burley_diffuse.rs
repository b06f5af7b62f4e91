//! The diffuse lobe of a measured-material survey: darker at grazing angles when smooth, brighter when rough.
//!
//! # Source
//! Burley 2012, "Physically-Based Shading at Disney", section 5.3 (`burley2012`): two Schlick factors about f90 =
//! 1/2 + 2 roughness cos^2(theta_d).
//!
//! # Departures
//! None; cos^2(theta_d) is |wi + wo|^2 / 4, which needs no half vector.
//!
//! # Validity
//! A fit by eye to the MERL materials, not derived from energy: at roughness 1 and reflectance 1 it reflects up to 1.55
//! times what it receives at grazing incidence (declared below). Samples follow the cosine: weights are up to
//! 6.25 times the reflectance where both directions graze at roughness 1.

use super::lambertian_reflection::LAMBERT;
use crate::common::*;
use crate::math::warp;
use crate::optics::Spectrum;
use crate::optics::fresnel::schlick_weight;
use crate::param::ParamSet;
use crate::{both_above, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "burley_diffuse",
    title: "Burley diffuse",
    source: "Burley 2012, Physically-Based Shading at Disney, section 5.3",
    summary: "Matt materials as measured: smooth ones darken towards grazing angles, rough ones brighten back towards the \
              light",
    lobes: &[Lobe::reflection(Category::Diffuse)],
    parameters: &[
        REFLECTANCE,
        ParamSpec::number(
            "roughness",
            0.5,
            "Roughness as in the paper: 0 halves the reflection at grazing angles, 1 multiplies it by up to 2.5",
        )
        .role(Role::Width),
    ],
    properties: Properties {
        declarations: &[Declaration {
            law: Law::Energy,
            parameters: "reflectance=1,roughness=1",
            theta_deg: 89.9,
            note: "rho_dh reaches 1.55 at grazing incidence: the retro-reflective rise is a fit, without an energy bound",
            when: Declaration::always,
        }],
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[LAMBERT],
};

struct BurleyDiffuse<R> {
    reflectance: Spectrum<R>,
    roughness: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(BurleyDiffuse {
        reflectance: Spectrum::of(params.rgb("reflectance")),
        roughness: R::of(params.number("roughness")),
    })
}

impl<R: Real> Bxdf<R> for BurleyDiffuse<R> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let cos2_d = ((wo + wi).length_squared() * R::of(0.25)).min(R::one());
        let f90_minus_1 = R::of(2.0) * self.roughness * cos2_d - R::of(0.5);
        let factor_o = R::one() + f90_minus_1 * schlick_weight(wo.z);
        let factor_i = R::one() + f90_minus_1 * schlick_weight(wi.z);
        self.reflectance * (factor_o * factor_i * R::frac_1_pi())
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

impl<R: Real> Lobes<R> for BurleyDiffuse<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for BurleyDiffuse<R> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::Vec3;
    use crate::math::frame::direction_from_degrees;

    fn f(roughness: f64, theta_o: f64, theta_i: f64) -> f64 {
        let material: Material = format!("burley_diffuse:reflectance=1,roughness={roughness}")
            .parse()
            .unwrap();
        let direction = |theta| direction_from_degrees(theta, 0.0).into();
        material
            .build::<f64>()
            .f(direction(theta_o), direction(theta_i))
            .0[0]
            * std::f64::consts::PI
    }

    #[test]
    fn the_grazing_response_is_that_of_the_paper() {
        // "Reduces the diffuse reflectance by 0.5 at grazing angles for smooth surfaces and increases it by up to 2.5 for
        // rough": each of the two factors, towards the light (theta_d = 0).
        let horizon = 90.0 - 1e-9;
        assert!((f(0.0, horizon, horizon) - 0.25).abs() < 1e-9);
        assert!((f(1.0, horizon, horizon) - 6.25).abs() < 1e-9);
        // Seen from above, theta_d is 45 degrees and f90 = 1/2 + roughness; the other factor is 1.
        assert!((f(0.0, 0.0, horizon) - 0.5).abs() < 1e-9);
        assert!((f(1.0, 0.0, horizon) - 1.5).abs() < 1e-9);
    }

    #[test]
    fn light_from_above_sees_a_lambertian_surface() {
        for roughness in [0.0, 0.5, 1.0] {
            assert!((f(roughness, 0.0, 0.0) - 1.0).abs() < 1e-15);
        }
    }

    #[test]
    fn a_cosine_just_above_one_is_no_harm() {
        let model = "burley_diffuse".parse::<Material>().unwrap().build::<f32>();
        let up = Vec3::new(0.0, 0.0, 1.0 + f32::EPSILON);
        assert!((model.f(up, up).0[0] * std::f32::consts::PI - 0.8).abs() < 1e-6);
    }
}
