//! Warps of the unit square to directions.

use super::{Real, Vec3};

/// Uniform points of the unit square to the cosine-weighted hemisphere about +z, density cos(theta) / pi per solid
/// angle: Malley's method over the polar map of the disc.
///
/// u\[0\] is sin^2(theta), u\[1\] the azimuth over 2 pi. The map is smooth and periodic in the azimuth, so that a
/// quadrature over the square converges as over the hemisphere, and has no branch; the concentric map of Shirley & Chiu
/// distorts less but has creases along the diagonals.
#[inline(always)]
pub fn cosine_hemisphere<R: Real>(u: [R; 2]) -> Vec3<R> {
    let (radius, z) = (u[0].sqrt(), (R::one() - u[0]).sqrt());
    let (sin, cos) = u[1].sin_cos_turn();
    Vec3::new(radius * cos, radius * sin, z)
}

/// The density of [`cosine_hemisphere`] at a direction of cosine `mu`, in 1/sr.
#[inline(always)]
pub fn cosine_hemisphere_pdf<R: Real>(mu: R) -> R {
    mu * R::frac_1_pi()
}

/// Uniform points of the unit square to the hemisphere about +z, density 1 / (2 pi) per solid angle; never the horizon.
///
/// u\[0\] is 1 - cos(theta), so that neither the pole nor the horizon loses digits.
#[inline(always)]
pub fn uniform_hemisphere<R: Real>(u: [R; 2]) -> Vec3<R> {
    let (z, radius) = (R::one() - u[0], (u[0] * (R::of(2.0) - u[0])).sqrt_clamped());
    let (sin, cos) = u[1].sin_cos_turn();
    Vec3::new(radius * cos, radius * sin, z)
}

/// The density of [`uniform_hemisphere`], in 1/sr.
#[must_use]
#[inline(always)]
pub fn uniform_hemisphere_pdf<R: Real>() -> R {
    R::of(0.5) * R::frac_1_pi()
}

/// A mixture of [`cosine_hemisphere`], which has the share `cosine_share` and is chosen where `uc` is below it, and
/// [`uniform_hemisphere`]: the shape of lobes that lose their cosine where the other direction grazes.
#[inline(always)]
pub fn mixed_hemisphere<R: Real>(cosine_share: R, uc: R, u: [R; 2]) -> Vec3<R> {
    if uc < cosine_share {
        cosine_hemisphere(u)
    } else {
        uniform_hemisphere(u)
    }
}

/// The density of [`mixed_hemisphere`] at a direction of cosine `mu`, in 1/sr.
#[inline(always)]
pub fn mixed_hemisphere_pdf<R: Real>(cosine_share: R, mu: R) -> R {
    (cosine_share * mu + (R::one() - cosine_share) * R::of(0.5)) * R::frac_1_pi()
}

/// Uniform points of the unit square to the directions about `w`, a unit vector above the surface, that the phase function of
/// Henyey & Greenstein 1941 (`henyey1941`) gives them: about `w` itself where its mean cosine `g` is positive, about the
/// opposite of it where that is negative. u\[0\] is the angle, u\[1\] the azimuth over 2 pi.
///
/// Their inversion, with 1 - cos and 1 + cos written as products, so that neither cancels.
#[inline(always)]
pub fn henyey_greenstein<R: Real>(w: Vec3<R>, g: R, u: [R; 2]) -> Vec3<R> {
    let (one, two, x) = (R::one(), R::of(2.0), g.abs());
    let (above, below) = (two * u[0], two * (one - u[0]));
    let q = one - x + two * x * u[0];
    let scale = one / (two * q * q);
    let one_minus_cos = (one - x).sqr() * below * (two + x * above) * scale;
    let one_plus_cos = (one + x).sqr() * above * (two - x * below) * scale;
    let sin = (one_minus_cos * one_plus_cos).sqrt_clamped();
    let cos = if one_minus_cos < one_plus_cos {
        one - one_minus_cos
    } else {
        one_plus_cos - one
    };
    let along = if g > R::zero() { cos } else { -cos };
    let (sin_phi, cos_phi) = u[1].sin_cos_turn();
    // A basis about w without a root (`duff2017`), for z above 0.
    let a = -one / (one + w.z);
    let b = w.x * w.y * a;
    let side = Vec3::new(one + w.x * w.x * a, b, -w.x);
    let other = Vec3::new(b, one + w.y * w.y * a, -w.y);
    w * along + side * (sin * cos_phi) + other * (sin * sin_phi)
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

    #[test]
    fn uniform_directions_have_a_uniform_cosine_and_stay_off_the_horizon() {
        for (u0, z) in [
            (0.0, 1.0),
            (0.25, 0.75),
            (1.0 - f64::EPSILON / 2.0, f64::EPSILON / 2.0),
        ] {
            let w = uniform_hemisphere([u0, 0.3]);
            assert!(
                w.z == z && (w.length_squared() - 1.0).abs() < 1e-15,
                "{w:?}"
            );
        }
        let grazing: Vec3<f64> = mixed_hemisphere(0.25, 0.25, [0.9, 0.5]);
        assert!((grazing.z - 0.1).abs() < 1e-15);
        // Both shares integrate to 1: 2 pi int (c mu + (1 - c)/2)/pi dmu = c + (1 - c).
        let density: f64 = mixed_hemisphere_pdf(0.25, 0.5);
        assert!((density * std::f64::consts::PI - 0.5).abs() < 1e-15);
    }
}
