//! The sheen of cloth: a microfacet lobe whose facets stand upright, as the fibres of fabric do.
//!
//! # Source
//! Estevez & Kulla 2017, "Production Friendly Microfacet Sheen BRDF" (`estevez2017`): the exponentiated sinusoidal
//! distribution D = (2 + 1/r) sin^(1/r)(theta_h) / (2 pi), and Smith's masking G = 1 / (1 + Lambda_i + Lambda_o) with the
//! paper's fit of Lambda.
//!
//! # Departures
//! The paper's softening of the terminator, a power on the light's own Lambda, is left out: it breaks reciprocity. There
//! is no Fresnel factor, the lobe is scaled by `reflectance`. `roughness` is the paper's r, not squared.
//!
//! # Validity
//! Lambda is a fit. From roughness .1 up, its 1 / (1 + Lambda) is within .045 of Smith's; at .01 it is up to .33 too
//! large, and light from 89.9 degrees leaves with 2.13 times its energy at reflectance 1. It stays finite at the horizon
//! (3e7 to 8e8) where the exact one grows as 1/mu: below mu of 1e-6 it is less than two thirds of it, and energy breaks at
//! every roughness (both declared below). Samples are uniform over the hemisphere, which the authors found better than
//! sampling D: f mu_i is at most D / (4 mu_o (1 + Lambda_o)), so that down to mu_o of 1e-6 no weight exceeds 26 times the
//! reflectance at roughness .01, and 1.8 times at 1.

use super::*;
use crate::bxdf::math::warp;
use crate::bxdf::microfacet::half_vector;
use crate::bxdf::optics::Spectrum;
use crate::bxdf::param::{ParamSet, Scale};
use crate::bxdf::{both_above, sample_reflection};

/// The list entry.
pub(super) static SPEC: ModelSpec = ModelSpec {
    id: "charlie_sheen",
    title: "Charlie sheen",
    source: "Estevez & Kulla 2017, Production Friendly Microfacet Sheen BRDF",
    summary: "The soft shine of fabric along its outline: upright fibres catch grazing light, the narrower the smoother",
    lobes: &[Lobe::reflection(Category::RetroReflective)],
    parameters: &[
        ParamSpec::rgb(
            "reflectance",
            [0.5; 3],
            "Factor on the reflected light, per channel",
        ),
        ParamSpec::number(
            "roughness",
            0.5,
            "How much the fibres lean from upright: small values leave a thin rim, 1 a soft glow all over",
        )
        .hard(0.01, 1.0)
        .scale(Scale::Logarithmic),
    ],
    properties: Properties {
        declarations: &[
            Declaration {
                law: Law::Energy,
                parameters: "reflectance=1,roughness=.01",
                theta_deg: 89.9,
                note: "rho_dh reaches 2.13: the fitted Lambda masks less than half of what the upright fibres would",
            },
            Declaration {
                law: Law::Energy,
                parameters: "reflectance=1,roughness=1",
                theta_deg: 89.9999,
                note: "rho_dh reaches 1.28: the fitted Lambda stays finite at the horizon",
            },
        ],
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: Builders {
        f32: build,
        library: build,
        f64: build,
        reference: build,
    },
    // A fit as it stands: no model here has its rim for less.
    stand_ins: &[],
};

/// The paper's fit L(x) = a / (1 + b x^c) + d x + e at roughness 0, in units of 1e-5: a, b, c, d, e.
const FIT_AT_ROUGHNESS_0: [f64; 5] = [2_532_450.0, 332_435.0, 16_801.0, -127_393.0, -485_967.0];

/// The same at roughness 1.
const FIT_AT_ROUGHNESS_1: [f64; 5] = [2_154_730.0, 382_987.0, 19_823.0, -197_760.0, -432_054.0];

struct CharlieSheen<R> {
    reflectance: Spectrum<R>,
    inverse_roughness: R,
    /// a, b, c, d, e of L at this roughness.
    fit: [R; 5],
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Bxdf<R>> {
    let roughness = R::of(params.number("roughness"));
    let smooth = (R::one() - roughness).sqr();
    let fit = |at: usize| {
        let coefficient = |set: [f64; 5]| R::of(set.into_iter().nth(at).unwrap_or(0.0));
        let mixed = smooth * coefficient(FIT_AT_ROUGHNESS_0)
            + (R::one() - smooth) * coefficient(FIT_AT_ROUGHNESS_1);
        // The paper's decimals, formed in the precision of the model.
        mixed / R::of(1e5)
    };
    Box::new(CharlieSheen {
        reflectance: Spectrum::of(params.rgb("reflectance")),
        inverse_roughness: R::one() / roughness,
        fit: [0, 1, 2, 3, 4].map(fit),
    })
}

impl<R: Real> CharlieSheen<R> {
    /// The density of fibre normals at the unit half vector `wh`, in 1/sr.
    ///
    /// The power is the exponential of ln(sin^2) / (2 r); the logarithm is taken of the smaller of sin^2 and cos^2.
    #[inline(always)]
    fn d(&self, wh: Vec3<R>) -> R {
        let (half, two) = (R::of(0.5), R::of(2.0));
        let (sin2, cos2) = (wh.x * wh.x + wh.y * wh.y, wh.z * wh.z);
        let ln_sin2 = if cos2 < half {
            (-cos2).ln_1p()
        } else {
            sin2.ln()
        };
        let power = if sin2 > R::zero() {
            (half * self.inverse_roughness * ln_sin2).exp()
        } else {
            R::zero()
        };
        (two + self.inverse_roughness) * power / R::TAU()
    }

    /// The paper's L(x), x in 0..1.
    #[inline(always)]
    fn l(&self, x: R) -> R {
        let [a, b, c, d, e] = self.fit;
        let power = if x > R::zero() { x.powf(c) } else { R::zero() };
        a / (R::one() + b * power) + d * x + e
    }

    /// The paper's Lambda of a direction of cosine `mu`.
    #[inline(always)]
    fn lambda(&self, mu: R) -> R {
        let half = R::of(0.5);
        let exponent = if mu < half {
            self.l(mu)
        } else {
            R::of(2.0) * self.l(half) - self.l(R::one() - mu)
        };
        exponent.exp()
    }
}

impl<R: Real> Bxdf<R> for CharlieSheen<R> {
    #[inline(always)]
    fn f(&self, wo: Vec3<R>, wi: Vec3<R>) -> Spectrum<R> {
        let Some((wo, wi)) = both_above(wo, wi) else {
            return Spectrum::black();
        };
        let Some((wh, _)) = half_vector(wo, wi) else {
            return Spectrum::black();
        };
        let masking = R::one() + (self.lambda(wi.z) + self.lambda(wo.z));
        // One after the other: their product may underflow where the distribution is 0.
        let (low, high) = (wi.z.min(wo.z), wi.z.max(wo.z));
        let shape = self.d(wh) / (R::of(4.0) * masking) / high / low;
        self.reflectance * shape.saturated()
    }

    #[inline(always)]
    fn pdf(&self, wo: Vec3<R>, wi: Vec3<R>) -> R {
        let Some(_) = both_above(wo, wi) else {
            return R::zero();
        };
        warp::uniform_hemisphere_pdf()
    }

    #[inline(always)]
    fn sample_f(&self, wo: Vec3<R>, _uc: R, u: [R; 2]) -> Option<Sample<R>> {
        sample_reflection(
            self,
            wo,
            #[inline(always)]
            |_| Some(warp::uniform_hemisphere(u)),
        )
    }

    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};

    fn model(roughness: f64) -> CharlieSheen<f64> {
        let smooth = (1.0 - roughness) * (1.0 - roughness);
        CharlieSheen {
            reflectance: Spectrum::grey(1.0),
            inverse_roughness: 1.0 / roughness,
            fit: [0, 1, 2, 3, 4].map(|i| {
                1e-5 * (smooth * FIT_AT_ROUGHNESS_0[i] + (1.0 - smooth) * FIT_AT_ROUGHNESS_1[i])
            }),
        }
    }

    fn at_sine(sin: f64) -> Vec3<f64> {
        Vec3::new(sin, 0.0, ((1.0 - sin) * (1.0 + sin)).sqrt())
    }

    #[test]
    fn projected_facets_cover_the_surface_once() {
        for roughness in [0.05, 0.3, 1.0] {
            let model = model(roughness);
            let n = 20_000;
            // The integral of D cos over the hemisphere is that of 2 pi D s ds.
            let covered: f64 = (0..n)
                .map(|i| (f64::from(i) + 0.5) / f64::from(n))
                .map(|s| TAU * model.d(at_sine(s)) * s / f64::from(n))
                .sum();
            // The midpoint rule: second derivative / (24 n^2).
            assert!((covered - 1.0).abs() < 1e-6, "{roughness}: {covered}");
        }
    }

    #[test]
    fn at_roughness_one_the_distribution_is_a_sine() {
        let sheen = model(1.0);
        for sin in [0.0, 1e-9, 0.2, 0.7, 0.71, 1.0] {
            assert!((sheen.d(at_sine(sin)) - 3.0 * sin / TAU).abs() < 1e-15);
        }
    }

    /// Smith's Lambda of the distribution: the integral over the slopes that hide the direction, over the cosine.
    fn exact_lambda(sheen: &CharlieSheen<f64>, mu: f64) -> f64 {
        let w = at_sine((1.0 - mu * mu).sqrt());
        let n = 600;
        let (mut visible, mut area) = (0.0, 0.0);
        for i in 0..n {
            let theta = (f64::from(i) + 0.5) / f64::from(n) * PI / 2.0;
            let (sin, cos) = theta.sin_cos();
            let density = sheen.d(at_sine(sin)) * sin;
            for j in 0..n {
                let phi = (f64::from(j) + 0.5) / f64::from(n) * TAU;
                let facing = w.x * sin * phi.cos() + w.z * cos;
                visible += density * facing.max(0.0);
                area += density * facing;
            }
        }
        // The projected area of all that faces, over that of the surface, is 1 + Lambda.
        visible / area - 1.0
    }

    #[test]
    fn the_fit_follows_the_exact_masking() {
        for roughness in [0.1, 0.26, 0.5, 1.0] {
            let sheen = model(roughness);
            for mu in [0.1, 0.3, 0.5, 0.7] {
                let (fit, exact) = (sheen.lambda(mu), exact_lambda(&sheen, mu));
                let g1 = [fit, exact].map(|lambda| 1.0 / (1.0 + lambda));
                // The fit's own error: at most .0448, at roughness .26 and mu .62.
                assert!(
                    (g1[0] - g1[1]).abs() < 0.0449,
                    "{roughness} {mu}: {fit} {exact}"
                );
            }
        }
    }

    #[test]
    fn the_fit_is_continuous_and_survives_its_ends() {
        for roughness in [0.01, 0.5, 1.0] {
            let sheen = model(roughness);
            let jump = sheen.lambda(0.5) / sheen.lambda(0.5 - 1e-12) - 1.0;
            assert!(jump.abs() < 1e-10);
            for mu in [0.0, 1e-300, 1.0, 1.0 + 1e-15] {
                assert!(sheen.lambda(mu).is_finite());
            }
        }
    }
}
