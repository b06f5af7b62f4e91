//! Tables of values over half vector and difference: what a measured or a baked surface is.
//!
//! # Source
//! Rusinkiewicz 1998 (`rusinkiewicz1998`): half vector and difference; Matusik et al. 2003 (`matusik2003`): places along
//! the half vector's angle by its square root, closest where highlights are. Angles are measured without trigonometry, by
//! coordinates that are all but in proportion to them.
//!
//! # Departures
//! A table holds f times the sum of both cosines, which is bounded and smooth towards the horizon where f rises without
//! bound (a mean error some ten times smaller for rough surfaces than that of f itself). It is read linearly between nodes. A
//! node whose directions are not both above the horizon, as half of all are, holds the value of the pair lifted to just
//! above it, so that a cell which the horizon cuts is read like any other. What
//! a table holds is reciprocal, and what it holds without turns is symmetric about the plane of incidence, whatever it was
//! made of.

mod coordinates;
mod shape;
mod text;

use crate::batch::{Columns, Scatterer};
use crate::error::Result;
use crate::math::{Real, Vec3};
use crate::optics::Spectrum;
use coordinates::{Cell, Place};
pub use shape::Shape;
pub use text::TABLE;

/// The width of a lobe is where its density of normals, less 1/cos^4, has fallen to this part of the one at theta_h = 0: for
/// GGX there tan(theta_h) = alpha.
const FALLEN: f64 = 0.25;

/// The smallest width that is made out: below it samples are drawn more widely than the lobe is.
const NARROWEST: f64 = 1e-3;

/// Values over half vector and difference, per channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    shape: Shape,
    /// f (cos(theta_o) + cos(theta_i)) in 1/sr, R, G and B of each node; the turn varies slowest, then half, difference,
    /// azimuth.
    values: Vec<[f32; 3]>,
    alpha: f64,
}

impl Table {
    /// The table of `shape` with these values in 1/sr, node by node in the order of [`Shape::places`]; what is no number,
    /// or below 0, becomes 0.
    fn new(shape: Shape, mut values: Vec<[f32; 3]>) -> Self {
        for value in values.as_flattened_mut() {
            // Not max(): that is a number too where the value is none, but not for infinity.
            *value = if *value >= 0.0 {
                value.min(f32::MAX)
            } else {
                0.0
            };
        }
        let alpha = width(shape, &values);
        Self {
            shape,
            values,
            alpha,
        }
    }

    /// f = `value` / (cos(theta_o) + cos(theta_i)) in 1/sr: the law of Lommel and Seeliger.
    #[must_use]
    pub fn even(value: f32) -> Self {
        let shape = Shape::SMALLEST;
        Self::new(shape, vec![[value; 3]; shape.nodes()])
    }

    /// The reflected light of `bxdf` from above. `max_bytes`: the most memory it may take.
    ///
    /// # Errors
    /// [`Error::Limit`](crate::error::Error::Limit) where the table would take more: then nothing is allocated.
    pub fn bake(bxdf: &dyn Scatterer<f64>, shape: Shape, max_bytes: u64) -> Result<Self> {
        shape.within(max_bytes)?;
        let pairs: Vec<_> = shape.places().map(|place| place.directions()).collect();
        let wo = Columns::from_rows(pairs.iter().map(|(wo, _)| [wo.x, wo.y, wo.z]));
        let wi = Columns::from_rows(pairs.iter().map(|(_, wi)| [wi.x, wi.y, wi.z]));
        let f = bxdf.values(&wo, &wi);
        let values = f.rows().zip(&pairs);
        let values = values.map(|(f, (wo, wi))| f.map(|f| (f * (wo.z + wi.z)) as f32));
        Ok(Self::new(shape, values.collect()))
    }

    /// How many nodes it has along each coordinate.
    #[must_use]
    pub fn shape(&self) -> Shape {
        self.shape
    }

    /// The width of the lobe as that of the GGX lobe that falls as fast from theta_h = 0, at most 1.
    #[must_use]
    pub fn alpha(&self) -> f64 {
        self.alpha
    }

    /// f in 1/sr for two unit directions above the surface with the half vector `wh`.
    #[inline(always)]
    pub fn value<R: Real>(&self, wo: Vec3<R>, wi: Vec3<R>, wh: Vec3<R>) -> Spectrum<R> {
        let place = Place::of(wo, wi, wh);
        let [turns, halves, differences, azimuths] = self.shape.cells(&place);
        let mut sum = Spectrum::black();
        for (turn, a) in turns.ends() {
            for (half, b) in halves.ends() {
                for (difference, c) in differences.ends() {
                    for (azimuth, d) in azimuths.ends() {
                        let index = self.shape.index([turn, half, difference, azimuth]);
                        let value = self.values.get(index).copied().unwrap_or_default();
                        let value = Spectrum(value.map(|x| R::of(f64::from(x))));
                        sum = sum + value * (a * b * c * d);
                    }
                }
            }
        }
        sum.map(|value| (value / (wo.z + wi.z)).saturated())
    }
}

/// The width of the lobe that falls from its value at theta_h = 0 as these values do where the directions are closest.
fn width(shape: Shape, values: &[[f32; 3]]) -> f64 {
    let [turns, halves, _, azimuths] = shape.counts();
    let ring = |half: usize| -> f64 {
        let nodes = (0..turns).flat_map(|turn| (0..azimuths).map(move |azimuth| (turn, azimuth)));
        let sums = nodes.map(|(turn, azimuth)| {
            let value = values.get(shape.index([turn, half, 0, azimuth]));
            value.map_or(0.0, |rgb| rgb.iter().copied().map(f64::from).sum())
        });
        // At theta_d = 0 what a table holds is D F G / (2 cos(theta_h)).
        sums.sum::<f64>() * shape.cos_half(half).powi(5)
    };
    let peak = ring(0);
    let mut before = (0.0, peak);
    for half in 1..halves {
        let cos = shape.cos_half(half);
        let tan = ((1.0 - cos) * (1.0 + cos)).sqrt() / cos.max(f64::MIN_POSITIVE);
        let here = ring(half);
        if here <= FALLEN * peak {
            let (tan_before, value_before) = before;
            let t = (value_before - FALLEN * peak) / (value_before - here).max(f64::MIN_POSITIVE);
            let alpha: f64 = tan_before + t * (tan.min(1.0) - tan_before);
            return alpha.clamp(NARROWEST, 1.0);
        }
        before = (tan.min(1.0), here);
    }
    1.0
}

impl<R: Real> Cell<R> {
    /// Both ends with their weights.
    #[inline(always)]
    fn ends(&self) -> [(usize, R); 2] {
        [(self.first, R::one() - self.t), (self.second, self.t)]
    }
}

#[cfg(test)]
mod tests;
