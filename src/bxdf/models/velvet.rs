//! Velvet: fibres that stand upright light up where they are seen or lit along the surface.
//!
//! # Source
//! Ashikhmin & Premoze 2007, "Distribution-based BRDFs" (`ashikhmin2007`): an inverted Gaussian of the half vector's angle
//! to the normal, and a denominator mu_i + mu_o - mu_i mu_o in place of masking. The normalisation of the distribution and
//! the factor 1/4 are those of Neubelt & Pettineo 2013 (`neubelt2013`).
//!
//! # Departures
//! None from the later paper. There is no Fresnel factor, the lobe is scaled by `reflectance`.
//!
//! # Validity
//! A shape, not derived from energy; yet at reflectance 1 at most 86.6 % of the light leaves (alpha .3, grazing), and 10 to
//! 25 % of light from above. Samples mix cosine and uniform directions as the denominator asks: mu_i / (mu_i + mu_o -
//! mu_i mu_o) is the harmonic mean of 1 and mu_i with weights 1 - mu_o and mu_o, the density is in proportion to their
//! arithmetic mean, and the distribution at most 5 / (pi (1 + 4 alpha^2)): no weight exceeds 2.5 times the reflectance.

use crate::common::*;
use crate::math::warp;
use crate::microfacet::half_vector;
use crate::optics::Spectrum;
use crate::param::{ParamSet, Scale};
use crate::{both_above, reflected_direction, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "velvet",
    title: "Velvet",
    source: "Ashikhmin & Premoze 2007, Distribution-based BRDFs; Neubelt & Pettineo 2013",
    summary: "A cloth of upright fibres: dark seen from above, with a bright rim along grazing directions, back towards the \
              light too",
    lobes: &[Lobe::reflection(Category::RetroReflective)],
    parameters: &[
        ParamSpec::rgb(
            "reflectance",
            [0.5; 3],
            "Factor on the reflected light, per channel",
        ),
        ParamSpec::number(
            "alpha",
            0.3,
            "Spread of the fibres about upright: how far the bright rim reaches from the horizon",
        )
        .role(Role::Width)
        .hard(1e-4, 1.0)
        .soft(0.01, 1.0)
        .scale(Scale::Logarithmic),
    ],
    properties: Properties::PLAIN,
    validate: ModelSpec::any,
    builders: builders!(build),
    // One exponential and one quotient: no model here makes a rim for less.
    stand_ins: &[],
};

struct Velvet<R> {
    reflectance: Spectrum<R>,
    alpha: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    Box::new(Velvet {
        reflectance: Spectrum::of(params.rgb("reflectance")),
        alpha: R::of(params.number("alpha")),
    })
}

impl<R: Real> Velvet<R> {
    /// The density of fibre normals at the unit half vector `wh`.
    #[inline(always)]
    fn d(&self, wh: Vec3<R>) -> R {
        let (one, four) = (R::one(), R::of(4.0));
        let sin2 = wh.x * wh.x + wh.y * wh.y;
        // At normal incidence cot is infinite and the exponential 0; it is 0 long before the quotient by sin^4 overflows.
        let cot_over_alpha = wh.z / (self.alpha * sin2.sqrt());
        let bump = (-(cot_over_alpha * cot_over_alpha)).exp();
        let rise = if bump > R::zero() {
            bump / (sin2 * sin2)
        } else {
            R::zero()
        };
        (one + four * rise) / (R::pi() * (one + four * self.alpha * self.alpha))
    }

    /// The share of samples about the normal: see the file's notes on validity.
    #[inline(always)]
    fn cosine_share(mu_o: R) -> R {
        mu_o / (R::of(2.0) - mu_o)
    }
}

impl<R: Real> Bxdf<R> for Velvet<R> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let Some((wh, _)) = half_vector(wo, wi) else {
            return Spectrum::black();
        };
        let denominator = R::of(4.0) * (wi.z + wo.z - wi.z * wo.z);
        self.reflectance * (self.d(wh) / denominator).saturated()
    }

    #[inline(always)]
    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return R::zero();
        };
        warp::mixed_hemisphere_pdf(Self::cosine_share(wo.z), wi.z)
    }

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |wo| Some(warp::mixed_hemisphere(Self::cosine_share(wo.z), uc, u)),
        )
    }
}

impl<R: Real> Lobes<R> for Velvet<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }

    #[inline(always)]
    fn lobe_pdf(&self, _index: usize, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(_) = both_above(wo, wi) else {
            return R::zero();
        };
        warp::uniform_hemisphere_pdf()
    }

    #[inline(always)]
    fn sample_lobe(&self, _index: usize, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        reflected_direction(
            wo,
            #[inline(always)]
            |_| Some(warp::uniform_hemisphere(u)),
        )
    }
}

impl<R: Real> Scatterer<R> for Velvet<R> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use crate::Material;
    use crate::math::Vec3;
    use crate::math::frame::direction_from_degrees;
    use std::f64::consts::PI;

    #[test]
    fn from_above_only_the_constant_is_left() {
        let cloth: Material = "velvet:reflectance=1,alpha=.3".parse().unwrap();
        let up = Vec3::new(0.0, 0.0, 1.0);
        let f = cloth.build::<f64>().f(up, up).0[0];
        assert!((f - 1.0 / (4.0 * PI * 1.36)).abs() < 1e-16);
    }

    #[test]
    fn the_distribution_rises_fivefold_to_the_horizon() {
        let cloth: Material = "velvet:reflectance=1,alpha=.5".parse().unwrap();
        let model = cloth.build::<f64>();
        let mu = 1e-9;
        let low = Vec3::new(1.0, 0.0, mu);
        // The half vector is `low` itself.
        let f = model.f(low, low).0[0];
        assert!((f * 8.0 * mu * PI * 2.0 / 5.0 - 1.0).abs() < 1e-8, "{f}");
    }

    #[test]
    fn no_weight_exceeds_two_and_a_half() {
        for alpha in ["0.0001", "0.01", "0.1", "1"] {
            let cloth: Material = format!("velvet:reflectance=1,alpha={alpha}")
                .parse()
                .unwrap();
            let model = cloth.build::<f64>();
            for theta in [0.0, 30.0, 60.0, 85.0, 89.9, 89.9999] {
                let wo = direction_from_degrees(theta, 0.0).into();
                for i in 0..64 {
                    let u = [f64::from(i % 8) / 8.0, f64::from(i / 8) / 8.0];
                    for uc in [0.0, 0.99] {
                        let weight = model.sample_f(wo, uc, u).map_or(0.0, |s| s.weight().0[0]);
                        assert!(weight <= 2.5, "{alpha} {theta} {weight}");
                    }
                }
            }
        }
    }
}
