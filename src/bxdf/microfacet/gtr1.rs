//! The generalised Trowbridge-Reitz distribution of exponent 1: the long tail of a clear coat.
//!
//! # Source
//! Burley 2012, "Physically Based Shading at Disney", appendix B.2 (`burley2012`), normalised:
//! (a^2 - 1) / (pi ln(a^2) (a^2 + (1 - a^2) sin^2)).

use crate::math::{Real, Vec3};

/// GTR1 of one width, above 0 and below 1.
#[derive(Clone, Copy, Debug)]
pub struct Gtr1<R> {
    alpha: R,
    one_minus_alpha2: R,
    ln_alpha: R,
}

impl<R: Real> Gtr1<R> {
    /// The distribution of width `alpha`, above 0 and below 1.
    pub fn new(alpha: R) -> Self {
        Self {
            alpha,
            one_minus_alpha2: (R::one() - alpha) * (R::one() + alpha),
            ln_alpha: alpha.ln(),
        }
    }

    /// The density of microfacet normals at the unit normal `wh`, in 1/sr.
    #[inline(always)]
    pub fn d(&self, wh: Vec3<R>) -> R {
        let sin2 = wh.x * wh.x + wh.y * wh.y;
        let spread = self.alpha * self.alpha + self.one_minus_alpha2 * sin2;
        self.one_minus_alpha2 / (-R::pi() * R::of(2.0) * self.ln_alpha * spread)
    }

    /// A normal with density [`Self::d`] times its cosine.
    #[inline(always)]
    pub fn sample_normal(&self, u: [R; 2]) -> Vec3<R> {
        // cos^2 = (1 - a^(2 - 2 u)) / (1 - a^2), of which this is 1 less.
        let growth = (-R::of(2.0) * u[0] * self.ln_alpha).exp_m1();
        let sin2 = self.alpha * self.alpha * growth / self.one_minus_alpha2;
        let sin2 = sin2.at_least(R::zero()).at_most(R::one());
        let (sin_phi, cos_phi) = u[1].sin_cos_turn();
        let sin = sin2.sqrt();
        Vec3::new(
            sin * cos_phi,
            sin * sin_phi,
            (R::one() - sin2).sqrt_clamped(),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cosine_weighted_normals_fill_the_hemisphere() {
        for alpha in [0.001, 0.1, 0.9] {
            let coat = Gtr1::new(alpha);
            // The integral of D cos over the hemisphere is one over sin^2 = x: pi int D dx; x = e^-t for the narrow peak.
            let steps = 20_000;
            let width = 40.0 / f64::from(steps);
            let sum: f64 = (0..steps)
                .map(|i| {
                    let x = (-(f64::from(i) + 0.5) * width).exp();
                    let normal = Vec3::new(x.sqrt(), 0.0, (1.0 - x).sqrt());
                    std::f64::consts::PI * coat.d(normal) * x * width
                })
                .sum();
            // Midpoint rule, error of order width^2.
            assert!((sum - 1.0).abs() < 1e-5, "{alpha}: {sum}");
            let last = coat.sample_normal([1.0 - f64::EPSILON, 0.25]);
            assert!(last.z < 1e-6 && (last.length_squared() - 1.0).abs() < 1e-14);
        }
    }
}
