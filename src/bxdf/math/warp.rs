//! Warps of the unit square to directions.

use num_traits::Float;

use super::{Real, Vec3};

/// Uniform points of the unit square to the cosine-weighted hemisphere about +z, density cos(theta) / pi per solid
/// angle (Malley's method over the concentric disc map).
///
/// # Source
/// Shirley & Chiu 1997, "A Low Distortion Map Between Disk and Square", `doi:10.1080/10867651.1997.10487479`
#[inline(always)]
pub fn cosine_hemisphere<R: Real>(u: [R; 2]) -> Vec3<R> {
    let a = R::of(2.0) * u[0] - R::one();
    let b = R::of(2.0) * u[1] - R::one();
    let quarter_pi = R::FRAC_PI_4();
    let (radius, angle) = if a.abs() > b.abs() {
        (a, quarter_pi * (b / a))
    } else if b == R::zero() {
        (R::zero(), R::zero())
    } else {
        (b, R::FRAC_PI_2() - quarter_pi * (a / b))
    };
    let (sin, cos) = Float::sin_cos(angle);
    let z = ((R::one() - radius) * (R::one() + radius)).sqrt_clamped();
    Vec3::new(radius * cos, radius * sin, z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_cosine_is_two_thirds() {
        let n = 256;
        let mut sum = 0.0_f64;
        for i in 0..n {
            for j in 0..n {
                let w = cosine_hemisphere([
                    (f64::from(i) + 0.5) / f64::from(n),
                    (f64::from(j) + 0.5) / f64::from(n),
                ]);
                assert!((w.length_squared() - 1.0).abs() < 1e-14);
                sum += w.z;
            }
        }
        // Midpoint rule of a function with infinite slope at the rim: the error is of order n^-1.5.
        assert!((sum / f64::from(n * n) - 2.0 / 3.0).abs() < 1e-3);
    }

    #[test]
    fn corners_and_centre_stay_on_the_hemisphere() {
        for u in [
            [0.0, 0.0],
            [0.0, 0.5],
            [0.5, 0.5],
            [1.0 - f32::EPSILON / 2.0; 2],
        ] {
            let w = cosine_hemisphere(u);
            assert!(
                (w.length_squared() - 1.0).abs() < 1e-6 && w.z >= 0.0,
                "{w:?}"
            );
        }
    }
}
