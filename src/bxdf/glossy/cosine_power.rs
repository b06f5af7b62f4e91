//! Powers of cosines that keep their digits up to the exponent 1e4, and directions distributed as they are.
//!
//! In f32 a cosine near 1 knows its distance from 1 to 6e-8 only, and the 1e4th power turns that into 6e-4. The distance
//! itself is at hand: as half the square of the difference of two unit vectors, or by the square of a sine.

use crate::math::{Real, Vec3};

/// cos^n of the angle between the unit vectors `a` and `b`; 0 from a right angle on.
///
/// Up to 60 degrees the cosine comes from the distance of the two, beyond from their product: there 1 less the distance
/// would lose what is left of it.
#[inline(always)]
pub fn between<R: Real>(a: Vec3<R>, b: Vec3<R>, n: R) -> R {
    let half = R::of(0.5);
    let one_minus_cos = (a - b).length_squared() * half;
    let cos = a.dot(b);
    let ln_cos = if one_minus_cos < half {
        (-one_minus_cos).ln_1p()
    } else {
        cos.max(least()).ln()
    };
    if cos >= least() {
        (n * ln_cos).exp()
    } else {
        R::zero()
    }
}

/// The smallest cosine whose logarithm is taken; a smaller one counts as underflow. xprec gives NaN for the logarithm of a
/// subnormal number, while its own `min_positive_value`, 1e-292, would cut off what f64 can hold.
#[inline(always)]
fn least<R: Real>() -> R {
    let double = R::of(f64::MIN_POSITIVE);
    if double > R::zero() {
        double
    } else {
        R::min_positive_value()
    }
}

/// The natural logarithm of the cosine `wh.z` of the unit vector `wh` above the surface, over its squared sine, which is
/// given too. The quotient tends to -1/2 along the normal.
///
/// Near the normal the logarithm comes from the sine, near the horizon from the cosine: each time from the smaller one.
#[inline(always)]
pub fn ln_cos_over_sin2<R: Real>(wh: Vec3<R>) -> (R, R) {
    let half = R::of(0.5);
    let sin2 = wh.x * wh.x + wh.y * wh.y;
    let ln_cos = if sin2 < half {
        half * (-sin2).ln_1p()
    } else {
        // A cosine of 0 is one that underflowed: its logarithm would be infinite, and times 0 no number.
        wh.z.max(least()).ln()
    };
    // The quotient is -(1 + sin2 / 2 ..) / 2: below the spacing of the numbers its limit is exact, and the division by a
    // subnormal number is spared.
    let quotient = if sin2 > R::epsilon() {
        ln_cos / sin2
    } else {
        -half
    };
    (quotient, sin2)
}

/// (`wh.z`)^n of the unit vector `wh` above the surface.
#[inline(always)]
pub fn of_normal<R: Real>(wh: Vec3<R>, n: R) -> R {
    let (ln_cos_over_sin2, sin2) = ln_cos_over_sin2(wh);
    (n * sin2 * ln_cos_over_sin2).exp()
}

/// A direction about +z with a density in proportion to cos^n on the upper hemisphere, that is (n + 1) / (2 pi) cos^n.
///
/// cos = (1 - `u_theta`)^(1 / (n + 1)); `cos_phi`, `sin_phi` give the azimuth.
#[inline(always)]
pub fn sample_about_z<R: Real>(n: R, u_theta: R, (cos_phi, sin_phi): (R, R)) -> Vec3<R> {
    let ln_cos = (-u_theta).ln_1p() / (n + R::one());
    // 1 - cos^2, without the cancellation.
    let sin = (-(R::of(2.0) * ln_cos).exp_m1()).sqrt_clamped();
    Vec3::new(sin * cos_phi, sin * sin_phi, ln_cos.exp())
}

/// The cosine and sine of the azimuth 2 pi `u`.
#[inline(always)]
pub fn azimuth<R: Real>(u: R) -> (R, R) {
    let (sin, cos) = u.sin_cos_turn();
    (cos, sin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use xprec::Df64;

    #[test]
    fn the_largest_exponent_keeps_its_digits_in_f32() {
        for angle in [0.0_f32, 1e-4, 3e-3, 0.01, 0.03] {
            let (sin, cos) = angle.sin_cos();
            let wh = Vec3::new(0.6 * sin, 0.8 * sin, cos);
            let exact = Vec3::new(Df64::of(wh.x.into()), Df64::of(wh.y.into()), Df64::of(0.0));
            let power = (Df64::of(5e3) * (-exact.length_squared()).ln_1p()).exp();
            let found = f64::from(of_normal(wh, 1e4));
            // The exponent is at most 4.5 here and carries four roundings: 4.5 * 4 * 6e-8; one for the exponential.
            assert!((found / power.as_f64() - 1.0).abs() < 1.2e-6, "{angle}");
        }
    }

    #[test]
    fn both_forms_agree_with_the_plain_power() {
        for degrees in [1e-3_f64, 10.0, 44.9, 45.1, 80.0, 89.99] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let wh = Vec3::new(sin, 0.0, cos);
            let up = Vec3::new(0.0, 0.0, 1.0);
            for n in [1.0, 2.5, 30.0] {
                let plain = cos.powf(n);
                // The exponent carries a few roundings.
                let error = (of_normal(wh, n) / plain - 1.0).abs();
                assert!(
                    error < 1e-15 * (1.0 - n * cos.ln()),
                    "{degrees} {n}: {error}"
                );
                let error = (between(wh, up, n) / plain - 1.0).abs();
                assert!(
                    error < 1e-15 * (1.0 - n * cos.ln()),
                    "{degrees} {n}: {error}"
                );
            }
        }
    }

    #[test]
    fn powers_end_at_the_horizon() {
        let up = Vec3::new(0.0_f64, 0.0, 1.0);
        assert_eq!(of_normal(up, 1e4), 1.0);
        assert_eq!(between(up, up, 1e4), 1.0);
        assert_eq!(between(up, -up, 1.0), 0.0);
        let low = Vec3::new(1.0, 0.0, 1e-23);
        assert!((between(up, low, 1.0) / 1e-23 - 1.0).abs() < 1e-14);
        assert_eq!(of_normal(Vec3::new(1.0_f32, 0.0, 0.0), 2.0), 0.0);
        assert_eq!(
            of_normal(
                Vec3::new(Df64::of(1.0), Df64::of(0.0), Df64::of(0.0)),
                Df64::of(2.0)
            ),
            Df64::of(0.0)
        );
    }

    #[test]
    fn samples_have_the_mean_cosine_of_their_density() {
        let steps = 20_000;
        for n in [1.0, 10.0, 1e4] {
            let mut sum = 0.0_f64;
            for i in 0..steps {
                let u = (f64::from(i) + 0.5) / f64::from(steps);
                let w = sample_about_z(n, u, azimuth(0.3));
                assert!((w.length_squared() - 1.0).abs() < 1e-14 && w.z > 0.0);
                sum += w.z;
            }
            // The mean of cos under (n + 1) / (2 pi) cos^n; midpoint rule over a root singularity.
            let mean = (n + 1.0) / (n + 2.0);
            assert!((sum / f64::from(steps) - mean).abs() < 1e-5, "{n}");
        }
    }
}
