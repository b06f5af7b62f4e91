//! Half vectors whose slopes follow a Gaussian, whether they are visible or not: what Ward's lobe is sampled by.

use super::cosine_power::azimuth;
use crate::math::{Real, Vec3};
use crate::microfacet::Normals;
use crate::microfacet::beckmann::Beckmann;

/// Slopes of density exp(-(x/`alpha_x`)^2 - (y/`alpha_y`)^2) / (pi `alpha_x` `alpha_y`).
#[derive(Clone, Copy, Debug)]
pub struct GaussianSlopes<R> {
    alpha_x: R,
    alpha_y: R,
    beckmann: Beckmann<R>,
}

impl<R: Real> GaussianSlopes<R> {
    /// The distribution with these widths along s and t, both above 0.
    pub fn new(alpha_x: R, alpha_y: R) -> Self {
        Self {
            alpha_x,
            alpha_y,
            beckmann: Beckmann::new(alpha_x, alpha_y),
        }
    }

    /// The density of microfacets with the normal `wh` (unit, above the surface) per area of the surface, in 1/sr:
    /// Beckmann's D. It is 0 near the horizon, so that a value above 0 may be divided by `wh.z`.
    #[inline(always)]
    pub fn d(&self, wh: Vec3<R>) -> R {
        self.beckmann.d(wh)
    }

    /// The density per solid angle of [`Self::sample`], in 1/sr: D cos.
    #[inline(always)]
    pub fn normal_pdf(&self, wh: Vec3<R>) -> R {
        self.d(wh) * wh.z
    }

    /// A normal whose slopes follow the distribution.
    #[inline(always)]
    pub fn sample(&self, u: [R; 2]) -> Option<Vec3<R>> {
        let radius = (-(-u[0]).ln_1p()).sqrt_clamped();
        let (cos, sin) = azimuth(u[1]);
        let slopes = Vec3::new(
            self.alpha_x * radius * cos,
            self.alpha_y * radius * sin,
            R::one(),
        );
        slopes.unit_and_length().map(|(wh, _)| wh)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn samples_have_the_mean_square_of_the_widths() {
        let slopes = GaussianSlopes::new(0.2_f64, 0.7);
        let n = 400;
        let (mut xx, mut yy) = (0.0, 0.0);
        for i in 0..n {
            for j in 0..n {
                let [u, v] = [i, j].map(|k| (f64::from(k) + 0.5) / f64::from(n));
                let wh = slopes.sample([u, v]).unwrap();
                xx += (wh.x / wh.z).powi(2);
                yy += (wh.y / wh.z).powi(2);
            }
        }
        // The mean of x^2 is alpha_x^2 / 2; midpoint rule over a logarithmic singularity, error of order 1 / n.
        let mean = |sum: f64| 2.0 * sum / f64::from(n * n);
        assert!((mean(xx) / 0.04 - 1.0).abs() < 2e-3 && (mean(yy) / 0.49 - 1.0).abs() < 2e-3);
    }

    #[test]
    fn all_normals_sum_to_one() {
        let slopes = GaussianSlopes::new(0.5_f64, 0.5);
        let steps = 4000;
        let width = std::f64::consts::FRAC_PI_2 / f64::from(steps);
        let sum: f64 = (0..steps)
            .map(|i| {
                let (sin, cos) = ((f64::from(i) + 0.5) * width).sin_cos();
                slopes.normal_pdf(Vec3::new(sin, 0.0, cos)) * sin * std::f64::consts::TAU * width
            })
            .sum();
        // Midpoint rule, error of order width^2.
        assert!((sum - 1.0).abs() < 1e-6, "{sum}");
    }
}
