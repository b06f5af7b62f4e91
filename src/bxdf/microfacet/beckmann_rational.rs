//! The Beckmann distribution with the popular fit of its masking: no error function, no exponential but that of D.
//!
//! # Source
//! Walter et al. 2007, eq. 27 (`walter2007`): G1 = (3.535 A + 2.181 A^2) / (1 + 2.276 A + 2.577 A^2) for A below 1.6, else 1,
//! with A = cot(theta) / alpha.
//!
//! # Departures
//! Between 1.549 and 1.6 the fit exceeds 1, by up to 6e-5: here it does not. With s = sqrt(alpha_x^2 x^2 + alpha_y^2 y^2), so that
//! A = z / s, z (1 + 2 Lambda) = 2 z / G1 - z is z + 2 (s^2 - 1.259 s z + .396 z^2) / (3.535 s + 2.181 z): no tangent, and
//! the fit is approached from the horizon without loss.
//!
//! # Validity
//! G1 is off by .313 % at most, at A = 1.336. Visible normals are drawn by the exact masking, and their density is that:
//! the fit is in the value alone, and saves its time there.

use super::beckmann::Beckmann;
use super::{Masked, Masking, Normals, Pair};
use crate::math::{Real, Vec3};

/// From this A on nothing is masked.
const UNMASKED: f64 = 1.6;

/// [`Beckmann`], its masking fitted.
#[derive(Clone, Copy, Debug)]
pub struct BeckmannRational<R>(pub Beckmann<R>);

impl<R: Real> Normals<R> for BeckmannRational<R> {
    const VECTORISES: bool = R::FUNCTIONS_VECTORISE;

    #[inline(always)]
    fn d(&self, wh: Vec3<R>) -> R {
        self.0.d(wh)
    }

    #[inline(always)]
    fn masked(&self, w: Vec3<R>) -> Masked<R> {
        let mu = w.z.abs();
        Masked {
            mu,
            t: mu + self.masking_excess(w),
        }
    }

    #[inline(always)]
    fn masking_excess(&self, w: Vec3<R>) -> R {
        /// The coefficients of the fit, and those of its denominator less its numerator, in thousandths.
        const NUMERATOR: [f64; 2] = [3535.0, 2181.0];
        const REST: [f64; 3] = [1000.0, -1259.0, 396.0];
        let (z, s) = self.0.cosine_and_spread(w);
        let [p1, p2] = NUMERATOR.map(R::of);
        let [r0, r1, r2] = REST.map(R::of);
        let rest = r0 * s * s + r1 * s * z + r2 * z * z;
        let excess = R::of(2.0) * rest / (p1 * s + p2 * z);
        let zero = R::zero();
        if z < R::of(UNMASKED) * s {
            excess.at_least(zero)
        } else {
            zero
        }
    }

    #[inline(always)]
    fn sample_visible_normal(&self, wo: Vec3<R>, u: [R; 2]) -> Option<Vec3<R>> {
        self.0.sample_visible_normal(wo, u)
    }

    /// Of the exact masking, by which normals are drawn.
    #[inline(always)]
    fn reflection_pdf(&self, pair: &Pair<R>) -> R {
        self.0.reflection_pdf(pair)
    }

    #[inline(always)]
    fn stretched_lobe(&self, pair: &Pair<R>, masking: Masking, factor: R) -> R {
        let inverse = self.inverse_visibility(pair.wo, pair.wi, masking);
        (self.0.d_times(pair.wh, factor) / inverse).saturated()
    }

    #[inline(always)]
    fn stretched_pdf(&self, pair: &Pair<R>, factor: R) -> R {
        self.0.stretched_pdf(pair, factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// G1 of the direction whose cotangent over alpha is `a`.
    fn g1(normals: impl Normals<f64>, a: f64) -> f64 {
        let (cot, alpha) = (a * 0.5, 0.5);
        assert_eq!(alpha, 0.5, "the width of the tests");
        let length = (1.0 + cot * cot).sqrt();
        let Masked { mu, t } = normals.masked(Vec3::new(1.0 / length, 0.0, cot / length));
        2.0 * mu / (mu + t)
    }

    #[test]
    fn the_fit_is_the_printed_one() {
        let fitted = BeckmannRational(Beckmann::new(0.5, 0.5));
        for a in [1e-6, 0.1, 0.56, 1.0, 1.336, 1.548] {
            let printed = (3.535 * a + 2.181 * a * a) / (1.0 + 2.276 * a + 2.577 * a * a);
            assert!((g1(fitted, a) / printed - 1.0).abs() < 1e-14, "{a}");
        }
        assert_eq!(g1(fitted, 1.59), 1.0, "printed: 1.000_061");
        assert_eq!(fitted.masking_excess(Vec3::new(0.0, 0.0, 1.0)), 0.0);
    }

    #[test]
    fn the_largest_error_is_the_known_one() {
        let exact = Beckmann::new(0.5, 0.5);
        let error = |a: f64| (g1(BeckmannRational(exact), a) / g1(exact, a) - 1.0).abs();
        let (mut largest, mut at) = (0.0, 0.0);
        for step in 1..=40_000 {
            let a = f64::from(step) * 1e-4;
            if error(a) > largest {
                (largest, at) = (error(a), a);
            }
        }
        assert!((largest - 0.003_127).abs() < 1e-6, "{largest}");
        assert!((at - 1.336).abs() < 1e-3, "{at}");
    }
}
