//! What a sphere stands in: a soft light and a sky of two tones, and how its surface looks there.
//!
//! The sky is bright above and dark below, all around. Light that crosses the surface comes from the same sky; its
//! radiance is taken as n^2 times as high below the surface, as inside a body that it has entered.
//!
//! # Source
//! Each lobe is met by a few directions of the light and a few of its own, weighted by the power heuristic
//! (`veach1997`): broad lobes and narrow ones come out smooth alike. The directions are the same for every point, so what
//! error is left is no noise. Dirac deltas see light and sky as a mirror does.

use std::f64::consts::TAU;

use glam::DVec3;

use bxdf::math::Vec3;
use bxdf::{Scatterer, Side};

/// The cosine of the angle between the light's middle and its edge, 9 degrees.
pub(in crate::analysis) const LIGHT_COS: f64 = 0.9877;

/// The radiance of the light's middle: a white diffuse surface that faces it gives back about twice the sky.
pub(in crate::analysis) const LIGHT_RADIANCE: f64 = 70.0;

/// The radiance of the sky above.
pub(in crate::analysis) const SKY: [f64; 3] = [0.52, 0.55, 0.60];

/// The radiance from below.
const GROUND: [f64; 3] = [0.11, 0.10, 0.09];

/// Half the height of the band in which the ground turns to sky.
const HAZE: f64 = 0.2;

/// The golden ratio's fractional part: its multiples spread evenly over [0, 1).
const GOLDEN: f64 = 0.618_033_988_749_895;

/// A surface under light and sky.
pub(in crate::analysis) struct Scene<'a> {
    bxdf: &'a dyn Scatterer<f64>,
    inside: f64,
    /// The middle of the light; need not be a unit vector.
    middle: DVec3,
    light: Vec<DVec3>,
    lobe_samples: usize,
}

/// A point of the sphere: the axes of its shading frame, in the frame of the picture.
pub(in crate::analysis) struct Frame {
    s: DVec3,
    t: DVec3,
    n: DVec3,
}

impl Frame {
    /// That of the point where the normal is `n`: s runs along the circle of latitude.
    pub(in crate::analysis) fn at(n: DVec3) -> Self {
        // At the poles of the latitudes any direction will do.
        let s = DVec3::Y.cross(n).try_normalize().unwrap_or(DVec3::X);
        Self {
            s,
            t: n.cross(s),
            n,
        }
    }

    /// The direction `w` of the picture in the shading frame.
    pub(in crate::analysis) fn local(&self, w: DVec3) -> Vec3<f64> {
        Vec3::new(w.dot(self.s), w.dot(self.t), w.dot(self.n))
    }

    /// The direction `w` of the shading frame in that of the picture.
    pub(in crate::analysis) fn world(&self, w: Vec3<f64>) -> DVec3 {
        self.s * w.x + self.t * w.y + self.n * w.z
    }
}

impl<'a> Scene<'a> {
    /// `bxdf` under a light that stands towards `light`; `relative_index`: that below the surface over that above.
    /// `light_samples`, `lobe_samples`: how many directions of the light and of each lobe are looked at.
    pub(in crate::analysis) fn new(
        bxdf: &'a dyn Scatterer<f64>,
        relative_index: f64,
        light: DVec3,
        [light_samples, lobe_samples]: [usize; 2],
    ) -> Self {
        Self {
            bxdf,
            // Radiance is n^2 times as high inside: light that comes from there is worth as much more.
            inside: relative_index * relative_index,
            middle: light,
            light: spread_over_light(light, light_samples),
            lobe_samples,
        }
    }

    /// The radiance that leaves to the viewer where the normal is `n`.
    pub(in crate::analysis) fn radiance(&self, n: DVec3) -> [f64; 3] {
        let frame = Frame::at(n);
        let wo = frame.local(DVec3::Z);
        let mut sum = [0.0; 3];
        for delta in self.bxdf.deltas(wo).into_iter().flatten() {
            let w = frame.world(delta.direction);
            let light = self.light(w);
            let seen = sky(w).map(|sky| sky + light);
            // The share of the flux is the factor on radiance, times n^2 where it comes from inside.
            add(&mut sum, delta.flux.to_f64(), seen);
        }
        for (index, lobe) in self.bxdf.lobes().iter().enumerate() {
            let gain = match lobe.side {
                Side::Reflection => 1.0,
                Side::Transmission => self.inside,
            };
            let seen = self.lobe(index, &frame, wo);
            add(&mut sum, [gain; 3], seen);
        }
        sum
    }

    /// The radiance of the light in the direction `w`: it fades towards its edge.
    fn light(&self, w: DVec3) -> f64 {
        LIGHT_RADIANCE * smooth_step(LIGHT_COS, 1.0, w.dot(self.middle) / self.middle.length())
    }

    /// What the lobe at `index` adds.
    fn lobe(&self, index: usize, frame: &Frame, wo: Vec3<f64>) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let value = |wi: Vec3<f64>| {
            let f = self.bxdf.lobe_f(index, wo, wi).to_f64();
            f.map(|f| f * wi.z.abs())
        };
        let light_density = self.light.len() as f64 / (TAU * (1.0 - LIGHT_COS));
        let lobe_density = |wi| self.lobe_samples as f64 * self.bxdf.lobe_pdf(index, wo, wi);
        for w in &self.light {
            let wi = frame.local(*w);
            let value = value(wi);
            if value != [0.0; 3] {
                let weight = weight(light_density, lobe_density(wi));
                add(&mut sum, value, [self.light(*w) * weight; 3]);
            }
        }
        for sample in 0..self.lobe_samples {
            let row = (sample as f64 + 0.5) / self.lobe_samples as f64;
            let column = (sample as f64 * GOLDEN).fract();
            let Some(wi) = self.bxdf.sample_lobe(index, wo, [row, column]) else {
                continue;
            };
            let density = lobe_density(wi);
            if density > 0.0 {
                let w = frame.world(wi);
                let light = self.light(w) * weight(density, light_density);
                let seen = sky(w).map(|sky| sky / density + light);
                add(&mut sum, value(wi), seen);
            }
        }
        sum
    }
}

/// The weight of a sample of density `own` where the other kind has density `other`, over `own`: by the power heuristic.
fn weight(own: f64, other: f64) -> f64 {
    // In a form that does not overflow.
    if own > other {
        1.0 / (own * (1.0 + (other / own).powi(2)))
    } else {
        let ratio = own / other;
        ratio / (other * (1.0 + ratio * ratio))
    }
}

fn add(sum: &mut [f64; 3], factor: [f64; 3], radiance: [f64; 3]) {
    for (sum, (factor, radiance)) in sum.iter_mut().zip(factor.into_iter().zip(radiance)) {
        *sum += factor * radiance;
    }
}

/// 0 at `low` and below, 1 at `high` and above, smooth between.
fn smooth_step(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// The radiance of the sky in the direction `w`.
fn sky(w: DVec3) -> [f64; 3] {
    let above = smooth_step(-HAZE, HAZE, w.y);
    let mut sum = [0.0; 3];
    add(&mut sum, [above; 3], SKY);
    add(&mut sum, [1.0 - above; 3], GROUND);
    sum
}

/// `count` directions spread evenly over the light, as on a sunflower.
fn spread_over_light(middle: DVec3, count: usize) -> Vec<DVec3> {
    let frame = Frame::at(middle / middle.length());
    let direction = |index: usize| {
        let part = (index as f64 + 0.5) / count as f64;
        let cos = 1.0 - part * (1.0 - LIGHT_COS);
        let sin = (1.0 - cos * cos).sqrt();
        let angle = TAU * GOLDEN * index as f64;
        frame.world(Vec3::new(sin * angle.cos(), sin * angle.sin(), cos))
    };
    (0..count).map(direction).collect()
}
