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
//! reflectance at roughness .01, and 1.8 times at 1. Lambda is the exponential of up to 20, whose rounding shows
//! twentyfold: errors reach 1.3 times their bound.

use crate::common::*;
use crate::math::warp;
use crate::microfacet::half_vector;
use crate::optics::Spectrum;
use crate::param::{ParamSet, Scale};
use crate::{both_above, sample_reflection};

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
        .role(Role::Width)
        .hard(0.01, 1.0)
        .scale(Scale::Logarithmic),
    ],
    properties: Properties {
        stability_ratio: 1.5,
        declarations: &[
            Declaration {
                law: Law::Energy,
                parameters: "reflectance=1,roughness=.01",
                theta_deg: 89.9,
                note: "rho_dh reaches 2.13: the fitted Lambda masks less than half of what the upright fibres would",
                when: Declaration::always,
            },
            Declaration {
                law: Law::Energy,
                parameters: "reflectance=1,roughness=1",
                theta_deg: 89.9999,
                note: "rho_dh reaches 1.28: the fitted Lambda stays finite at the horizon",
                when: Declaration::always,
            },
        ],
        ..Properties::PLAIN
    },
    validate: ModelSpec::any,
    builders: builders!(build),
    // A fit as it stands: no model here has its rim for less.
    stand_ins: &[],
};

/// The fit's coefficients are whole numbers of this part of 1: as decimals they would be rounded before they are mixed.
const UNIT: f64 = 1e5;

/// The paper's fit L(x) = a / (1 + b x^c) + d x + e at roughness 0, in units of 1e-5: a, b, c, d, e.
const FIT_AT_ROUGHNESS_0: [f64; 5] = [2_532_450.0, 332_435.0, 16_801.0, -127_393.0, -485_967.0];

/// The same at roughness 1.
const FIT_AT_ROUGHNESS_1: [f64; 5] = [2_154_730.0, 382_987.0, 19_823.0, -197_760.0, -432_054.0];

struct CharlieSheen<R> {
    reflectance: Spectrum<R>,
    inverse_roughness: R,
    /// a + e, a, b, c and d of L at this roughness; b and c as they are, the others in units of 1e-5.
    fit: [R; 5],
    /// What raising a small sine adds to the logarithm of its square.
    ln_raised: R,
}

fn build<R: Real>(params: &ParamSet) -> Box<dyn Scatterer<R>> {
    let reflectance = Spectrum::of(params.rgb("reflectance"));
    let roughness = R::of(params.number("roughness"));
    Box::new(CharlieSheen::new(reflectance, roughness))
}

impl<R: Real> CharlieSheen<R> {
    fn new(reflectance: Spectrum<R>, roughness: R) -> Self {
        let (two, unit) = (R::of(2.0), R::of(UNIT));
        let smooth = (R::one() - roughness).sqr();
        let mixed = |(smoothest, roughest): (f64, f64)| {
            R::of(roughest) + smooth * R::of(smoothest - roughest)
        };
        let ends = FIT_AT_ROUGHNESS_0.into_iter().zip(FIT_AT_ROUGHNESS_1);
        let mut mixes = ends.map(mixed);
        let [a, b, c, d, e] = [(); 5].map(|()| mixes.next().unwrap_or(R::zero()));
        Self {
            reflectance,
            inverse_roughness: R::one() / roughness,
            fit: [a + e, a, b / unit, c / unit, d],
            ln_raised: two * R::of(R::RESCALE).ln(),
        }
    }

    /// The density of fibre normals, in 1/sr, over the power of the sine in it.
    #[inline(always)]
    fn d_per_power(&self) -> R {
        (R::of(2.0) + self.inverse_roughness) / R::tau()
    }

    /// The root of the power sin^(1/r) in the density of fibre normals at the unit half vector `wh`: where the power
    /// underflows, the value need not.
    ///
    /// It is the exponential of ln(sin^2) / (4 r); the logarithm is taken of the smaller of sin^2 and cos^2.
    #[inline(always)]
    fn root_of_power(&self, wh: Vec3<R>) -> R {
        let half = R::of(0.5);
        // Next to the normal the square of the sine would underflow.
        let (scale, _) = wh.x.abs().at_least(wh.y.abs()).raising();
        let (x, y, cos2) = (wh.x * scale, wh.y * scale, wh.z * wh.z);
        let sin2 = x * x + y * y;
        let ln_sin2 = if cos2 < half {
            (-cos2).ln_1p()
        } else if scale > R::one() {
            sin2.at_least(R::min_positive_value()).ln() - self.ln_raised
        } else {
            sin2.ln()
        };
        if sin2 > R::zero() {
            (half * half * self.inverse_roughness * ln_sin2).exp()
        } else {
            R::zero()
        }
    }

    /// The paper's L(x), x in 0..1, in units of 1e-5.
    #[inline(always)]
    fn l(&self, x: R) -> R {
        let [a_plus_e, a, b, c, d] = self.fit;
        let power = if x > R::zero() { x.powf(c) } else { R::zero() };
        // a / (1 + b x^c) is a less this share of it, which is small where x is: there L is the exponent of a huge Lambda.
        let share = b * power / (R::one() + b * power);
        a_plus_e - a * share + d * x
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
        (exponent / R::of(UNIT)).exp()
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
        // One after the other: their products may underflow where the value does not. Towards the horizon masking is 3e7 at
        // least, so that the quotient by the lower cosine does not overflow.
        let (low, high) = (wi.z.min(wo.z), wi.z.max(wo.z));
        let root = self.root_of_power(wh);
        let shape = root / (R::of(4.0) * masking) / low * (root * self.d_per_power() / high);
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
}

impl<R: Real> Lobes<R> for CharlieSheen<R> {
    fn lobes(&self) -> &[Lobe] {
        SPEC.lobes
    }
}

impl<R: Real> Scatterer<R> for CharlieSheen<R> {
    loops!(R, if true);
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{PI, TAU};
    use xprec::Df64;

    fn model(roughness: f64) -> CharlieSheen<f64> {
        CharlieSheen::new(Spectrum::grey(1.0), roughness)
    }

    fn d<R: Real>(sheen: &CharlieSheen<R>, wh: Vec3<R>) -> R {
        let root = sheen.root_of_power(wh);
        sheen.d_per_power() * root * root
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
                .map(|s| TAU * d(&model, at_sine(s)) * s / f64::from(n))
                .sum();
            // The midpoint rule: second derivative / (24 n^2).
            assert!((covered - 1.0).abs() < 1e-6, "{roughness}: {covered}");
        }
    }

    #[test]
    fn at_roughness_one_the_distribution_is_a_sine() {
        let sheen = model(1.0);
        for sin in [0.0, 1e-9, 0.2, 0.7, 0.71, 1.0] {
            assert!((d(&sheen, at_sine(sin)) - 3.0 * sin / TAU).abs() < 1e-15);
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
            let density = d(sheen, at_sine(sin)) * sin;
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

    #[test]
    fn the_distribution_keeps_its_digits_next_to_the_normal() {
        // The squares of these sines underflow. At roughness 1 the distribution is 3 sin / (2 pi).
        let single = CharlieSheen::new(Spectrum::grey(1.0_f32), 1.0);
        let found = d(&single, Vec3::new(1e-25, 0.0, 1.0));
        assert!(
            (f64::from(found) * TAU / 3e-25 - 1.0).abs() < 2e-5,
            "{found}"
        );
        let double = d(&model(1.0), Vec3::new(0.0, 1e-160, 1.0));
        assert!((double * TAU / 3e-160 - 1.0).abs() < 1e-12, "{double}");
    }

    #[test]
    fn lambda_is_off_by_no_more_than_its_exponent_must() {
        // The exponent is up to 20; with its terms added as they stand in the paper it is 90 roundings.
        let mut worst = 0.0_f64;
        for i in 0..64 {
            let roughness = 0.01 + 0.99 * f64::from(i) / 64.0;
            let reference = CharlieSheen::new(Spectrum::grey(Df64::of(1.0)), Df64::of(roughness));
            for j in 0..64 {
                let mu = 10.0_f64.powf(-9.0 + 8.6 * f64::from(j) / 64.0);
                let exact = reference.lambda(Df64::of(mu)).as_f64();
                worst = worst.max((model(roughness).lambda(mu) / exact - 1.0).abs());
            }
        }
        assert!(worst < 75.0 * f64::UNIT_ROUNDOFF, "{worst:e}");
    }
}
