//! What samples are worth: the spread of estimates of one integral.

use super::points::Point;
use crate::analysis::HeldLobe;
use crate::analysis::statistics::Random;
use bxdf::Side;
use bxdf::math::Vec3;
use bxdf::math::warp;
use bxdf::optics::spectrum::luminance;
use glam::DVec3;

/// An estimate of the luminance of the integral of f |cos(theta)| over the sphere, deltas left out, as directions that do
/// not know them never meet one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimator {
    /// How its directions are drawn.
    pub name: &'static str,
    /// The mean of its samples.
    pub mean: f64,
    /// The variance of a single sample.
    pub variance: f64,
    /// The standard error of the mean: the square root of the variance over the number of samples.
    pub standard_error: f64,
}

impl Estimator {
    /// That of samples of these values among `count`, the others being 0.
    fn new(name: &'static str, values: &[f64], count: usize) -> Self {
        let n = count.max(1) as f64;
        let mean = values.iter().sum::<f64>() / n;
        // About the mean: no digits are lost where the spread is small.
        let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
        let unseen = count.saturating_sub(values.len()) as f64 * mean * mean;
        let variance = (squares + unseen) / (n - 1.0).max(1.0);
        Self {
            name,
            mean,
            variance,
            standard_error: (variance / n).sqrt(),
        }
    }
}

/// The estimators at equal count: the samples `points` of `count` draws, directions by the cosine, and uniform ones, those
/// over the sides to which the lobes send light.
pub(super) fn all(
    lobe: &HeldLobe<'_>,
    points: &[Point],
    count: usize,
    seed: u64,
) -> [Estimator; 3] {
    let weight = |point: &Point| {
        if point.is_delta {
            0.0
        } else {
            luminance(point.weight)
        }
    };
    let drawn: Vec<f64> = points.iter().map(weight).collect();
    let cosine = Hemispheres {
        warp: warp::cosine_hemisphere,
        pdf: warp::cosine_hemisphere_pdf,
    };
    let uniform = Hemispheres {
        warp: warp::uniform_hemisphere,
        pdf: |_| warp::uniform_hemisphere_pdf(),
    };
    [
        Estimator::new("Importance", &drawn, count),
        Estimator::new("Cosine", &cosine.values(lobe, count, seed ^ 1), count),
        Estimator::new("Uniform", &uniform.values(lobe, count, seed ^ 2), count),
    ]
}

/// A way to draw directions that knows only on which sides light is.
struct Hemispheres {
    warp: fn([f64; 2]) -> Vec3<f64>,
    /// The density by the cosine.
    pdf: fn(f64) -> f64,
}

impl Hemispheres {
    /// f |cos(theta)| / pdf of `count` directions.
    fn values(&self, lobe: &HeldLobe<'_>, count: usize, seed: u64) -> Vec<f64> {
        let has = |side| lobe.lobes().iter().any(|lobe| lobe.side == side);
        let is_above = lobe.held().z > 0.0;
        let (reflects, transmits) = (has(Side::Reflection), has(Side::Transmission));
        let mut random = Random::new(seed);
        let mut draw = || {
            let w: DVec3 = (self.warp)(random.pair()).into();
            let is_reflected = match (reflects, transmits) {
                (true, true) => random.unit() < 0.5,
                (reflects, _) => reflects,
            };
            if is_reflected == is_above { w } else { -w }
        };
        let directions: Vec<DVec3> = (0..count).map(|_| draw()).collect();
        let share = if reflects && transmits { 0.5 } else { 1.0 };
        let value = |(f, w): ([f64; 3], &DVec3)| {
            let pdf = share * (self.pdf)(w.z.abs());
            if pdf > 0.0 {
                luminance(f) * w.z.abs() / pdf
            } else {
                0.0
            }
        };
        let values = lobe.values_or_limits(&directions, is_above);
        values.into_iter().zip(&directions).map(value).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mean_variance_and_error_are_those_of_the_textbook() {
        // 1, 2, 3 and a lost sample: mean 1.5, squares .25 + .25 + 2.25 + 2.25.
        let found = Estimator::new("", &[1.0, 2.0, 3.0], 4);
        assert_eq!(found.mean, 1.5);
        assert!((found.variance - 5.0 / 3.0).abs() < 1e-15);
        assert!((found.standard_error - (5.0_f64 / 12.0).sqrt()).abs() < 1e-15);
        assert_eq!(Estimator::new("", &[], 0).variance, 0.0);
    }
}
