//! The anisotropic Beckmann distribution, slopes of a Gaussian, with Smith masking by the exact error function.
//!
//! # Source
//! Beckmann & Spizzichino 1963 (`beckmann1963`), Walter et al. 2007, eqs. 25 to 29 (`walter2007`), Heitz 2014 for Lambda
//! and the distribution of visible slopes (`heitz2014`).
//!
//! # Departures
//! None in value: masking uses erf itself, not the popular rational fit (`beckmann_rational`), so that sampling and density
//! agree. With A = cot(theta) / alpha and s = sqrt(alpha_x^2 x^2 + alpha_y^2 y^2), so that A = z / s,
//! z (1 + 2 Lambda) = z + s (exp(-A^2) / sqrt(pi) - A erfc(A)): a sum of positive terms, the second of which is at most
//! the rounding of the first where its own difference cancels; and no tangent.

use super::visible_slope::{central_slope, visible_slope};
use super::{Masked, Masking, Normals, Pair};
use crate::math::{Real, Vec3};

/// Below this cos^2 the exponent of D is beyond 1 / 1e-3 - 1 = 999 for every width to 1: exp underflows to 0 in every
/// precision, and the division by cos^4 must not get the chance to make that 0 / 0.
const SMALLEST_COS_SQUARED: f64 = 1e-3;

/// Where A stops to matter: erf(30) = 1 and exp(-900) = 0 in every precision. Caps A = z / 0 at normal incidence.
const LARGEST_A: f64 = 30.0;

/// Beckmann with widths `alpha_x`, `alpha_y` along s and t, both above 0.
#[derive(Clone, Copy, Debug)]
pub struct Beckmann<R> {
    alpha_x: R,
    alpha_y: R,
    /// Their reciprocals.
    per_alpha: [R; 2],
    /// 1 / (pi alpha_x alpha_y), D at the pole.
    peak: R,
    /// By how much exponents far below 0 are raised where a large factor may bring the product back from underflow.
    raise: R,
}

/// Where a normal is in the distribution: D is the peak times exp(`exponent`) times `per_cos4`, or 0.
struct Place<R> {
    exponent: R,
    per_cos4: R,
    is_level: bool,
}

impl<R: Real> Beckmann<R> {
    /// The distribution with these widths, used as given.
    pub fn new(alpha_x: R, alpha_y: R) -> Self {
        let one = R::one();
        Self {
            alpha_x,
            alpha_y,
            per_alpha: [one / alpha_x, one / alpha_y],
            peak: one / (R::pi() * (alpha_x * alpha_y)),
            raise: R::of(R::RESCALE).ln(),
        }
    }

    #[inline(always)]
    fn place(&self, wh: Vec3<R>) -> Place<R> {
        let z2 = wh.z * wh.z;
        let safe_z2 = z2.max(R::of(SMALLEST_COS_SQUARED));
        let [per_x, per_y] = self.per_alpha;
        let (x, y) = (wh.x * per_x, wh.y * per_y);
        let per_z2 = R::one() / safe_z2;
        Place {
            exponent: -(x * x + y * y) * per_z2,
            per_cos4: per_z2 * per_z2,
            is_level: z2 < safe_z2,
        }
    }

    /// D at `wh` times `factor`, also where D alone underflows.
    #[inline(always)]
    pub(super) fn d_times(&self, wh: Vec3<R>, factor: R) -> R {
        let (zero, one) = (R::zero(), R::one());
        let place = self.place(wh);
        let (raise, lower) = if place.exponent < -self.raise {
            (self.raise, R::of(1.0 / R::RESCALE))
        } else {
            (zero, one)
        };
        let bell = (place.exponent + raise).exp();
        let density = (self.peak * (factor * lower)) * bell * place.per_cos4;
        if place.is_level { zero } else { density }
    }

    /// |z| (1 + 2 Lambda(w)): what `Ggx::stretched_length` is for GGX.
    #[inline(always)]
    pub fn masking_length(&self, w: Vec3<R>) -> R {
        let (z, s, a) = self.z_s_a(w);
        z + s * a.ierfc()
    }

    /// |z| and s: A is their quotient.
    #[inline(always)]
    pub(super) fn cosine_and_spread(&self, w: Vec3<R>) -> (R, R) {
        let (x, y) = (self.alpha_x * w.x, self.alpha_y * w.y);
        (w.z.abs(), (x * x + y * y).sqrt())
    }

    #[inline(always)]
    fn z_s_a(&self, w: Vec3<R>) -> (R, R, R) {
        let (z, s) = self.cosine_and_spread(w);
        let largest = R::of(LARGEST_A);
        let a = if largest * s > z { z / s } else { largest };
        (z, s, a)
    }
}

impl<R: Real> Normals<R> for Beckmann<R> {
    const VECTORISES: bool = R::FUNCTIONS_VECTORISE;

    /// The density of microfacet normals at the unit normal `wh`, in 1/sr; the same on both sides. It may underflow to 0.
    #[inline(always)]
    fn d(&self, wh: Vec3<R>) -> R {
        let place = self.place(wh);
        let density = self.peak * place.exponent.exp() * place.per_cos4;
        if place.is_level { R::zero() } else { density }
    }

    #[inline(always)]
    fn stretched_lobe(&self, pair: &Pair<R>, masking: Masking, factor: R) -> R {
        let inverse = self.inverse_visibility(pair.wo, pair.wi, masking);
        (self.d_times(pair.wh, factor) / inverse).saturated()
    }

    #[inline(always)]
    fn stretched_pdf(&self, pair: &Pair<R>, factor: R) -> R {
        let inverse = self.masked(pair.wo).normals_per_direction();
        (self.d_times(pair.wh, factor) / inverse).saturated()
    }

    #[inline(always)]
    fn masked(&self, w: Vec3<R>) -> Masked<R> {
        Masked {
            mu: w.z.abs(),
            t: self.masking_length(w),
        }
    }

    /// 2 |z| Lambda(w): [`Self::masking_length`] less |z|, without their difference.
    #[inline(always)]
    fn masking_excess(&self, w: Vec3<R>) -> R {
        let (z, s, a) = self.z_s_a(w);
        let excess = s * (-(a * a)).exp() * R::frac_2_sqrt_pi() * R::of(0.5) - z * a.erfc();
        excess.max(R::zero())
    }

    /// A visible normal of `wo` (on the upper side): visible slopes of the surface stretched to unit width, turned to
    /// the azimuth of `wo` and stretched back.
    #[inline(always)]
    fn sample_visible_normal(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        let (v, _) =
            Vec3::new(self.alpha_x * wo.x, self.alpha_y * wo.y, wo.z).unit_and_length_of_short()?;
        let sin = (v.x * v.x + v.y * v.y).sqrt();
        let (cos_phi, sin_phi) = if sin > R::zero() {
            (v.x / sin, v.y / sin)
        } else {
            (R::one(), R::zero())
        };
        let along = visible_slope(v.z, sin, u[0]);
        let across = if R::FUNCTIONS_VECTORISE {
            central_slope(u[1])
        } else {
            visible_slope(R::one(), R::zero(), u[1])
        };
        let x = cos_phi * along - sin_phi * across;
        let y = sin_phi * along + cos_phi * across;
        let (wh, _) =
            Vec3::new(-self.alpha_x * x, -self.alpha_y * y, R::one()).unit_and_length_of_short()?;
        Some(wh)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_is_the_published_one_and_the_horizon_is_empty() {
        let normal = Vec3::new(0.0, 0.0, 1.0);
        let peak = Beckmann::new(0.1, 0.4).d(normal);
        assert!((peak * std::f64::consts::PI * 0.04 - 1.0).abs() < 1e-15);
        for z in [0.0, 1e-30, 1e-3, 0.03] {
            assert_eq!(Beckmann::new(1.0_f32, 1.0).d(Vec3::new(1.0, 0.0, z)), 0.0);
        }
    }

    #[test]
    fn lambda_is_the_published_one() {
        // Lambda = exp(-A^2)/(2 A sqrt(pi)) - erfc(A)/2, at A = 1: .025126..; and its excess form at every A.
        let beckmann = Beckmann::new(0.5, 0.5);
        for cos in [1e-3, 0.1, 0.447_213_6, 0.7, 0.99, 1.0] {
            let sin = f64::sqrt((1.0 - cos) * (1.0 + cos));
            let w = Vec3::new(sin, 0.0, cos);
            let a = cos / (0.5 * sin);
            let lambda =
                (-a * a).exp() / (2.0 * a * std::f64::consts::PI.sqrt()) - 0.5 * Real::erfc(a);
            let length = beckmann.masking_length(w);
            assert!((length / (cos * (1.0 + 2.0 * lambda)) - 1.0).abs() < 1e-14);
            assert!((beckmann.masking_excess(w) - 2.0 * cos * lambda).abs() < 1e-16);
        }
    }

    #[test]
    fn a_large_factor_brings_back_what_underflows() {
        // Exponents from -60 to -120: in f32 the exponential loses digits from -87 on, and from -104 on it is 0.
        let (alpha, factor) = (1e-3_f32, 1e14_f32);
        let (single, double) = (
            Beckmann::new(alpha, alpha),
            Beckmann::new(f64::from(alpha), f64::from(alpha)),
        );
        for step in 0..=60_u8 {
            let exponent = 60.0 + f32::from(step);
            let slope = alpha * exponent.sqrt();
            let (wh, _) = Vec3::new(slope, 0.0, 1.0).unit_and_length().unwrap();
            let exact =
                double.d(Vec3::new(wh.x.into(), wh.y.into(), wh.z.into())) * f64::from(factor);
            let error = |d: f32| (f64::from(d) / exact - 1.0).abs();
            let off = error(single.d_times(wh, factor));
            // The rounding of the exponent, and of a dozen operations.
            let bound = (4.0 * f64::from(exponent) + 12.0) * f32::UNIT_ROUNDOFF;
            assert!(off < bound, "{exponent}: {off}");
            let plain = error(single.d(wh) * factor);
            assert!(exponent < 105.0 || plain == 1.0, "{exponent}: {plain}");
        }
    }
}
