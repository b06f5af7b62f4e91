//! A rough diffuse surface that loses no energy: Oren-Nayar with the light of repeated bounces added.
//!
//! # Source
//! Portsmouth, Kutz, Hill 2025, "EON: A practical energy-preserving rough diffuse BRDF", JCGT 14(1), arXiv 2410.18026
//! (`portsmouth2025`): Fujii's Oren-Nayar model for one bounce, plus a lobe for all others whose albedo is what the
//! first leaves. The paper's r is `roughness`, rho is `reflectance`.
//!
//! # Departures
//! None in value; the paper's exact albedo is used, not its polynomial fit. Its 1 - E is rearranged: as printed it is a
//! difference of numbers near 1 that loses all digits where a direction grazes, and where r goes to 0.
//!
//! # Validity
//! rho_dh is 1 at reflectance 1, for every roughness and direction. Where both directions graze, the first bounce grows
//! without bound, as published; it saturates at the largest number. Samples follow the cosine: their weights are of the
//! order of the reflectance, and grow as 1/mu where both directions graze towards the same side (the paper offers a sampler
//! of its own against that, which this model does without).

use super::lambertian_reflection::LAMBERT;
use super::oren_nayar;
use crate::common::*;
use crate::math::warp;
use crate::optics::Spectrum;
use crate::param::ParamSet;
use crate::{both_above, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "eon",
    title: "Energy-preserving Oren-Nayar",
    source: "Portsmouth, Kutz, Hill 2025, EON: A practical energy-preserving rough diffuse BRDF, arXiv 2410.18026",
    summary: "A rough matt surface that neither loses nor creates light: the lobe bulges back as in Oren-Nayar, and colours \
              grow richer with roughness",
    lobes: &[Lobe::reflection(Category::Diffuse)],
    parameters: &[
        REFLECTANCE,
        ParamSpec::number(
            "roughness",
            0.5,
            "Roughness of the surface; 0 is Lambertian, 1 the roughest",
        )
        .role(Role::Width),
    ],
    properties: Properties::PLAIN,
    validate: ModelSpec::any,
    builders: builders!(build),
    stand_ins: &[
        StandIn {
            name: "Oren-Nayar for the energy-preserving form",
            lost: "Light that bounces among the facets is left out: the surface is darker and its colours are paler, the more so \
                   the rougher it is",
            replace: |params| {
                let sigma = sigma_of(params.number("roughness"));
                oren_nayar::SPEC.text_at(&[
                    ("reflectance", Value::Rgb(params.rgb("reflectance"))),
                    ("sigma", Value::Number(sigma)),
                ])
            },
        },
        LAMBERT,
    ],
};

/// The spread of slope angles, in degrees, at which the terms of `oren_nayar` are in the ratio of this roughness; 90 where
/// none are.
///
/// With x the square of the angle in radians the terms are A = 1 - .5 x / (x + .33) and B = .45 x / (x + .09): B = r A is a
/// quadratic equation in x.
fn sigma_of(roughness: f64) -> f64 {
    let (square, linear, constant) = (
        0.45 - 0.5 * roughness,
        0.1485 - 0.375 * roughness,
        0.0297 * roughness,
    );
    let x = 2.0 * constant / (linear + (linear * linear + 4.0 * square * constant).sqrt());
    // Beyond the largest ratio of all the root is negative, infinite or none.
    let sigma = x.sqrt().to_degrees();
    if sigma <= 90.0 { sigma } else { 90.0 }
}

struct Eon<R> {
    reflectance: Spectrum<R>,
    roughness: R,
    /// The factor of the first bounce, A_F / pi.
    single: R,
    /// The factor of all others, per channel: rho_ms / pi times A_F r / (pi^2 (c1 - c2)).
    multiple: Spectrum<R>,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let (one, pi) = (R::one(), R::pi());
    let reflectance = Spectrum::of(params.rgb("reflectance"));
    let roughness = R::of(params.number("roughness"));
    // The paper's constants: c1 = 1/2 - 2/(3 pi), and c1 - c2 with c2 = 2/3 - 28/(15 pi).
    let c1 = R::of(0.5) - R::of(2.0) / (R::of(3.0) * pi);
    let c1_minus_c2 = R::of(6.0) / (R::of(5.0) * pi) - one / R::of(6.0);
    let a_f = one / (one + c1 * roughness);
    let lost_by_one_bounce = a_f * roughness * c1_minus_c2;
    let mean_albedo = one - lost_by_one_bounce;
    let multiple = reflectance.map(|rho| {
        let rho_ms = rho * rho * mean_albedo / (one - rho * lost_by_one_bounce);
        rho_ms * a_f * roughness / (c1_minus_c2 * pi * pi * pi)
    });
    Box::new(Eon {
        reflectance,
        roughness,
        single: a_f / pi,
        multiple,
    })
}

/// pi (1 - E) / (A_F r) of the unit direction `w` above the surface, E being the albedo of the first bounce at
/// reflectance 1: the paper's pi c1 - G(mu).
///
/// pi/2 - S acos(mu) is pi/2 (1 - S) + S asin(mu), and 1 - S = mu^2 / (1 + S): all is of the order of mu, as the value.
#[inline(always)]
pub(crate) fn loss<R: Real>(w: Vec3<R>) -> R {
    let (one, two, three) = (R::one(), R::of(2.0), R::of(3.0));
    let mu = w.z;
    let s2 = w.x * w.x + w.y * w.y;
    let s = s2.sqrt();
    let elevation = mu.atan2(s);
    let one_plus_s = one + s;
    (R::frac_pi_2() - two / three) * mu * mu / one_plus_s + s * elevation + s2 * mu
        - two / three * s * mu * (one + s + s2) / one_plus_s
}

impl<R: Real> Bxdf<R> for Eon<R> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let s = wi.x * wo.x + wi.y * wo.y;
        let s_over_tau = if s > R::zero() { s / wi.z.max(wo.z) } else { s };
        // At roughness 1 it is 0 where the directions are opposed at grazing, and rounding must not make it less.
        let single = (R::one() + self.roughness * s_over_tau).max(R::zero()) * self.single;
        let both_lost = (loss(wo) * loss(wi)).max(R::zero());
        (self.reflectance * single + self.multiple * both_lost).saturated()
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

impl<R: Real> Lobes<R> for Eon<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for Eon<R> {
    loops!(R, if R::FUNCTIONS_VECTORISE);
}

#[cfg(test)]
mod tests {
    use super::{loss, sigma_of};
    use crate::Material;
    use crate::math::Vec3;
    use crate::math::frame::direction_from_degrees;
    use std::f64::consts::PI;

    /// The paper's G(mu), as printed.
    fn printed_g(mu: f64) -> f64 {
        let s = (1.0 - mu * mu).sqrt();
        s * (s.atan2(mu) - s * mu) + 2.0 / 3.0 * ((s / mu) * (1.0 - s.powi(3)) - s)
    }

    #[test]
    fn the_loss_is_the_papers_and_keeps_its_digits() {
        let at = |mu: f64| loss(Vec3::new((1.0 - mu * mu).sqrt(), 0.0, mu));
        for mu in [0.1, 0.3, 0.5, 0.9, 0.999] {
            let printed = PI * (0.5 - 2.0 / (3.0 * PI)) - printed_g(mu);
            assert!((at(mu) - printed).abs() < 1e-14, "{mu}");
        }
        // It grows as mu near the horizon: the derivative of -G there is 1 + 1 - 1.
        assert!((at(1e-9) / 1e-9 - 1.0).abs() < 1e-8);
    }

    #[test]
    fn the_stand_in_has_its_terms_in_the_ratio_of_the_roughness() {
        let ratio = |sigma: f64| {
            let x = sigma.to_radians().powi(2);
            0.45 * x / (x + 0.09) / (1.0 - 0.5 * x / (x + 0.33))
        };
        for roughness in [1e-3, 0.1, 0.395, 0.397, 0.5, 0.77] {
            let found = ratio(sigma_of(roughness));
            assert!((found / roughness - 1.0).abs() < 1e-12, "{roughness}");
        }
        assert_eq!(sigma_of(0.0), 0.0);
        for roughness in [0.78, 0.9, 0.99, 1.0] {
            assert_eq!(sigma_of(roughness), 90.0, "at most {}", ratio(90.0));
        }
    }

    /// rho_dh by the midpoint rule in theta and phi.
    fn albedo(material: &str, theta_i: f64) -> f64 {
        let bxdf = material.parse::<Material>().unwrap().build::<f64>();
        let wi = direction_from_degrees(theta_i, 0.0).into();
        let n = 400;
        let mut sum = 0.0;
        for i in 0..n {
            for j in 0..n {
                let theta = (f64::from(i) + 0.5) / f64::from(n) * 90.0;
                let phi = (f64::from(j) + 0.5) / f64::from(n) * 360.0;
                let (sin, cos) = theta.to_radians().sin_cos();
                sum += bxdf.f(direction_from_degrees(theta, phi).into(), wi).0[0] * sin * cos;
            }
        }
        sum * PI * PI / f64::from(n * n)
    }

    #[test]
    fn all_light_leaves_at_reflectance_one() {
        for roughness in ["0", "0.5", "1"] {
            for theta in [0.0, 45.0, 80.0] {
                let rho = albedo(&format!("eon:reflectance=1,roughness={roughness}"), theta);
                // The midpoint rule's error is (pi/800)^2 times a second derivative of order 1.
                assert!((rho - 1.0).abs() < 5e-5, "{roughness} {theta}: {rho}");
            }
        }
    }

    #[test]
    fn roughness_deepens_colours() {
        let rho = albedo("eon:reflectance=.5,roughness=1", 30.0);
        assert!(rho < 0.49, "{rho}");
    }
}
