//! A rough diffuse surface: Lambertian facets that mask, shadow and light one another.
//!
//! # Source
//! Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model", the qualitative model, eq. 30 (`oren1994`),
//! `doi:10.1145/192161.192213`. The paper's sin(alpha) tan(beta) cos(phi) is written without trigonometry:
//! s / max(mu_i, mu_o), s = wi.wo - mu_i mu_o, which is the dot product of the projections onto the s-t plane.
//!
//! # Departures
//! None: the qualitative model leaves interreflection out, as published.
//!
//! # Validity
//! The fit to the full model is stated by its authors for sigma up to about 40 degrees. At reflectance 1 it reflects up
//! to 1.5 % more than it receives at grazing incidence, for sigma near 11 degrees (declared below). Where both
//! directions graze, the value grows without bound, as published; it saturates at the largest number.

use super::lambertian_reflection::LAMBERT;
use crate::common::*;
use crate::math::warp;
use crate::optics::Spectrum;
use crate::param::ParamSet;
use crate::{both_above, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "oren_nayar",
    title: "Oren-Nayar",
    source: "Oren & Nayar 1994, Generalization of Lambert's Reflectance Model, eq. 30",
    summary: "A rough matt surface is brighter towards the light: the lobe bulges back, and the full moon looks flat",
    lobes: &[Lobe::reflection(Category::Diffuse)],
    parameters: &[
        REFLECTANCE,
        ParamSpec::number(
            "sigma",
            20.0,
            "Standard deviation of the slope angle of the facets; 0 is Lambertian",
        )
        .hard(0.0, 90.0)
        .unit("degrees"),
    ],
    properties: Properties {
        declarations: &[Declaration {
            law: Law::Energy,
            parameters: "reflectance=1,sigma=11",
            theta_deg: 89.5,
            note: "rho_dh reaches 1.015 at grazing incidence: the qualitative model approximates the full one",
            when: Declaration::always,
        }],
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[LAMBERT],
};

struct OrenNayar<R> {
    reflectance: Spectrum<R>,
    a: R,
    b: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let sigma = R::of(params.number("sigma")) * R::pi() / R::of(180.0);
    let sigma2 = sigma * sigma;
    // The paper's decimals, formed in the precision of the model.
    let hundredths = |n: f64| R::of(n) / R::of(100.0);
    Box::new(OrenNayar {
        reflectance: Spectrum::of(params.rgb("reflectance")),
        a: R::one() - hundredths(50.0) * sigma2 / (sigma2 + hundredths(33.0)),
        b: hundredths(45.0) * sigma2 / (sigma2 + hundredths(9.0)),
    })
}

impl<R: Real> Bxdf<R> for OrenNayar<R> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let s = wi.x * wo.x + wi.y * wo.y;
        let bulge = s.max(R::zero()) / wi.z.max(wo.z);
        let shape = (self.a + self.b * bulge).saturated() * R::frac_1_pi();
        self.reflectance * shape
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

impl<R: Real> Lobes<R> for OrenNayar<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for OrenNayar<R> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::frame::direction_from_degrees;

    fn f(material: &str, theta_o: f64, theta_i: f64) -> f64 {
        let material: Material = material.parse().unwrap();
        let direction = |theta| direction_from_degrees(theta, 0.0).into();
        material
            .build::<f64>()
            .f(direction(theta_o), direction(theta_i))
            .0[0]
    }

    #[test]
    fn smooth_facets_are_lambertian() {
        assert!(
            (f("oren_nayar:sigma=0,reflectance=1", 50.0, 30.0) * std::f64::consts::PI - 1.0).abs()
                < 1e-15
        );
    }

    #[test]
    fn light_returns_towards_its_source() {
        let towards = f("oren_nayar:sigma=30", 60.0, 60.0);
        let away = f("oren_nayar:sigma=30", -60.0, 60.0);
        // A + B sin(60) tan(60) over A, with A and B of sigma = 30 degrees.
        let sigma2 = 30_f64.to_radians().powi(2);
        let (a, b) = (
            1.0 - 0.5 * sigma2 / (sigma2 + 0.33),
            0.45 * sigma2 / (sigma2 + 0.09),
        );
        assert!((towards / away - (a + 1.5 * b) / a).abs() < 1e-13);
    }
}
