//! The distribution of microfacet normals over their angle from n.

use std::f64::consts::{FRAC_PI_2, TAU};

use glam::DVec3;

use super::facet::factors;
use super::scene::Scene;
use bxdf::Scatterer;
use bxdf::internals::gauss_legendre;

/// Angles among which the largest density is looked for, from the least one on.
const PILOTS: usize = 512;
const LEAST: f64 = 1e-7;

/// Below the mode by this factor of the angle there is nothing left to integrate: the density per angle falls as the angle.
const REACH: f64 = 1e-7;

/// Panels of the logarithm of the angle, and points of each.
const PANELS: usize = 128;
const POINTS: usize = 8;

/// Steps of a bisection and of a search for the mode: to the last digit but some.
const STEPS: usize = 60;

/// D cos, as a density of the angle theta_m between normal and n.
pub(super) struct Normals<'a> {
    surface: &'a dyn Scatterer<f64>,
    /// The angle at which the density per angle is largest, in radians.
    pub(super) mode: f64,
    /// Panel by panel: the logarithms of the angles between which it lies, and the integral up to its end.
    panels: Vec<([f64; 2], f64)>,
    rule: Vec<(f64, f64)>,
}

impl<'a> Normals<'a> {
    /// Those of the scene.
    ///
    /// # Errors
    /// A phrase where the material is no microfacet model, or is not the same all around.
    pub(super) fn of(scene: &'a Scene) -> Result<Self, String> {
        factors(scene, DVec3::Z, DVec3::Z)?;
        if !scene.material().is_isotropic() {
            return Err("the microfacets of the material lie not evenly around n".to_owned());
        }
        let mut normals = Self {
            surface: scene.surface(),
            mode: FRAC_PI_2,
            panels: Vec::new(),
            rule: gauss_legendre(POINTS),
        };
        normals.mode = normals.found_mode();
        let [low, high] = [(normals.mode * REACH).ln(), FRAC_PI_2.ln()];
        let edge = |index: usize| low + (high - low) * index as f64 / PANELS as f64;
        let mut sum = 0.0;
        for index in 0..PANELS {
            let panel = [edge(index), edge(index + 1)];
            sum += normals.panel(panel, &|_| 1.0);
            normals.panels.push((panel, sum));
        }
        Ok(normals)
    }

    /// D at the angle `theta` from n, in 1/sr.
    fn d(&self, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        let h = DVec3::new(sin, 0.0, cos).into();
        self.surface
            .microfacet(h, h)
            .map_or(0.0, |factors| factors.d)
    }

    /// The density of the angle, D cos sin 2 pi, in 1/radian.
    pub(super) fn density(&self, theta: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        TAU * self.d(theta) * cos.max(0.0) * sin
    }

    /// The angle at which the density is largest.
    fn found_mode(&self) -> f64 {
        let [low, high] = [LEAST.ln(), FRAC_PI_2.ln()];
        let step = (high - low) / PILOTS as f64;
        let at = |index: usize| low + step * index as f64;
        let density = |log: f64| self.density(log.exp());
        let larger = |a: &usize, b: &usize| density(at(*a)).total_cmp(&density(at(*b)));
        let best = (0..=PILOTS).max_by(larger).unwrap_or(PILOTS);
        let (mut a, mut b) = (at(best) - step, at(best) + step);
        for _ in 0..STEPS {
            let [left, right] = [a + (b - a) / 3.0, b - (b - a) / 3.0];
            if density(left) < density(right) {
                a = left;
            } else {
                b = right;
            }
        }
        (0.5 * (a + b)).exp()
    }

    /// The integral of the density by `factor` over a panel of the logarithm of the angle.
    fn panel(&self, [a, b]: [f64; 2], factor: &dyn Fn(f64) -> f64) -> f64 {
        let points = self.rule.iter().map(|(x, weight)| {
            let theta = (0.5 * (a + b) + 0.5 * (b - a) * x).exp();
            0.5 * (b - a) * weight * theta * self.density(theta) * factor(theta)
        });
        points.sum()
    }

    /// The integral of D cos over all normals: 1 for a distribution of facets.
    pub(super) fn total(&self) -> f64 {
        self.panels.last().map_or(0.0, |(_, sum)| *sum)
    }

    /// The mean of `factor` over the angles, which are as frequent as D cos has it.
    pub(super) fn mean(&self, factor: &dyn Fn(f64) -> f64) -> f64 {
        let panels = self.panels.iter();
        let sum: f64 = panels.map(|(panel, _)| self.panel(*panel, factor)).sum();
        sum / self.total()
    }

    /// The angle below which the share `u` of the normals lies, in radians.
    pub(super) fn quantile(&self, u: f64) -> f64 {
        let wanted = u * self.total();
        let mut below = 0.0;
        for ([a, b], sum) in &self.panels {
            if *sum >= wanted {
                return self.within([*a, *b], wanted - below);
            }
            below = *sum;
        }
        FRAC_PI_2
    }

    /// The angle in a panel below which so much of the integral of the panel lies.
    fn within(&self, [a, b]: [f64; 2], wanted: f64) -> f64 {
        let (mut low, mut high) = (a, b);
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            if self.panel([a, middle], &|_| 1.0) < wanted {
                low = middle;
            } else {
                high = middle;
            }
        }
        (0.5 * (low + high)).exp()
    }
}
