//! A small picture of a material: a sphere under a light and a sky, as linear radiance.
//!
//! The sphere is seen from far away; s runs along its circles of latitude. A light of some degrees stands to the upper
//! left before it, and a sky of two tones all around, bright above and dark below. Light that crosses the surface comes
//! from the same sky; its radiance is taken as n^2 times as high below the surface, as inside a body that it has entered.
//!
//! # Source
//! Each lobe is met by a few directions of the light and a few of its own, weighted by the power heuristic
//! (`veach1997`): broad lobes and narrow ones come out smooth alike. Dirac deltas see light and sky as a mirror does.

use std::f64::consts::TAU;

use glam::DVec3;

use super::Raster;
use crate::bxdf::math::Vec3;
use crate::bxdf::{Bxdf, Side};

/// Where the light stands: x to the right, y up, z to the viewer. Not quite a unit vector.
const LIGHT: DVec3 = DVec3::new(-0.48, 0.60, 0.64);

/// The cosine of the angle between the light's middle and its edge, 9 degrees.
const LIGHT_COS: f64 = 0.9877;

/// The radiance of the light's middle: a white diffuse surface that faces it gives back about twice the sky.
const LIGHT_RADIANCE: f64 = 70.0;

/// The radiance of the sky above.
const SKY: [f64; 3] = [0.52, 0.55, 0.60];

/// The radiance from below.
const GROUND: [f64; 3] = [0.11, 0.10, 0.09];

/// Half the height of the band in which the ground turns to sky.
const HAZE: f64 = 0.2;

/// Directions of the light, and directions of each lobe.
const LIGHT_SAMPLES: usize = 5;
const LOBE_SAMPLES: usize = 9;

/// The part of the picture's half width that the sphere takes.
const RADIUS: f64 = 0.96;

/// The golden ratio's fractional part: its multiples spread evenly over [0, 1).
const GOLDEN: f64 = 0.618_033_988_749_895;

/// A square picture: linear R, G, B, and the share of the pixel that the sphere covers, 0..1.
pub type Picture = Raster<[f64; 4]>;

/// The picture of a sphere of `bxdf`, `side` pixels wide; `relative_index`: that below the surface over that above.
#[must_use]
pub fn sphere(bxdf: &dyn Bxdf<f64>, relative_index: f64, side: usize) -> Picture {
    let scene = Scene {
        bxdf,
        // Radiance is n^2 times as high inside: light that comes from there is worth as much more.
        inside: relative_index * relative_index,
        light: light_samples(),
    };
    let place = |index: usize| (2.0 * (index as f64 + 0.5) / side as f64 - 1.0) / RADIUS;
    let pixel_width = 2.0 / (RADIUS * side as f64);
    let pixels = (0..side * side).map(|index| {
        let (x, y) = (place(index % side), -place(index / side));
        let radius = x.hypot(y);
        let coverage = (0.5 + (1.0 - radius) / pixel_width).clamp(0.0, 1.0);
        if coverage == 0.0 {
            return [0.0; 4];
        }
        // A pixel on the edge shows what is just inside.
        let inward = (1.0 - 0.5 * pixel_width).min(radius) / radius.max(f64::MIN_POSITIVE);
        let (x, y) = (x * inward, y * inward);
        let normal = DVec3::new(x, y, (1.0 - x * x - y * y).max(0.0).sqrt());
        let [r, g, b] = scene.radiance(normal);
        [r, g, b, coverage]
    });
    Picture {
        width: side,
        height: side,
        pixels: pixels.collect(),
    }
}

struct Scene<'a> {
    bxdf: &'a dyn Bxdf<f64>,
    inside: f64,
    light: [DVec3; LIGHT_SAMPLES],
}

/// A point of the sphere: the axes of its shading frame.
struct Frame {
    s: DVec3,
    t: DVec3,
    n: DVec3,
}

impl Frame {
    fn at(n: DVec3) -> Self {
        // At the poles of the latitudes any direction will do.
        let s = DVec3::Y.cross(n).try_normalize().unwrap_or(DVec3::X);
        Self {
            s,
            t: n.cross(s),
            n,
        }
    }

    fn local(&self, w: DVec3) -> Vec3<f64> {
        Vec3::new(w.dot(self.s), w.dot(self.t), w.dot(self.n))
    }

    fn world(&self, w: Vec3<f64>) -> DVec3 {
        self.s * w.x + self.t * w.y + self.n * w.z
    }
}

impl Scene<'_> {
    /// The radiance that leaves to the viewer where the normal is `n`.
    fn radiance(&self, n: DVec3) -> [f64; 3] {
        let frame = Frame::at(n);
        let wo = frame.local(DVec3::Z);
        let mut sum = [0.0; 3];
        for delta in self.bxdf.deltas(wo).into_iter().flatten() {
            let w = frame.world(delta.direction);
            let light = light(w);
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

    /// What the lobe at `index` adds.
    fn lobe(&self, index: usize, frame: &Frame, wo: Vec3<f64>) -> [f64; 3] {
        let mut sum = [0.0; 3];
        let value = |wi: Vec3<f64>| {
            let f = self.bxdf.lobe_f(index, wo, wi).to_f64();
            f.map(|f| f * wi.z.abs())
        };
        let light_density = LIGHT_SAMPLES as f64 / (TAU * (1.0 - LIGHT_COS));
        let lobe_density = |wi| LOBE_SAMPLES as f64 * self.bxdf.lobe_pdf(index, wo, wi);
        for w in self.light {
            let wi = frame.local(w);
            let value = value(wi);
            if value != [0.0; 3] {
                let weight = weight(light_density, lobe_density(wi));
                add(&mut sum, value, [light(w) * weight; 3]);
            }
        }
        for sample in 0..LOBE_SAMPLES {
            let row = (sample as f64 + 0.5) / LOBE_SAMPLES as f64;
            let column = (sample as f64 * GOLDEN).fract();
            let Some(wi) = self.bxdf.sample_lobe(index, wo, [row, column]) else {
                continue;
            };
            let density = lobe_density(wi);
            if density > 0.0 {
                let w = frame.world(wi);
                let light = light(w) * weight(density, light_density);
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

/// The radiance of the light in the direction `w`: it fades towards its edge.
fn light(w: DVec3) -> f64 {
    LIGHT_RADIANCE * smooth_step(LIGHT_COS, 1.0, w.dot(LIGHT) / LIGHT.length())
}

/// Directions spread evenly over the light, as on a sunflower.
fn light_samples() -> [DVec3; LIGHT_SAMPLES] {
    let frame = Frame::at(LIGHT / LIGHT.length());
    std::array::from_fn(|index| {
        let part = (index as f64 + 0.5) / LIGHT_SAMPLES as f64;
        let cos = 1.0 - part * (1.0 - LIGHT_COS);
        let sin = (1.0 - cos * cos).sqrt();
        let angle = TAU * GOLDEN * index as f64;
        frame.world(Vec3::new(sin * angle.cos(), sin * angle.sin(), cos))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bxdf::Material;
    use crate::bxdf::material::library;

    const SIDE: usize = 24;

    fn picture(text: &str) -> Picture {
        let material: Material = text.parse().unwrap();
        sphere(&*material.build(), material.relative_index(), SIDE)
    }

    /// The green channel at a point of the sphere, x to the right and y up, in radii.
    fn at(picture: &Picture, x: f64, y: f64) -> f64 {
        let index = |place: f64| ((0.5 + 0.5 * RADIUS * place) * SIDE as f64) as usize;
        picture.pixels[index(-y) * SIDE + index(x)][1]
    }

    #[test]
    fn a_diffuse_sphere_is_lit_from_the_upper_left() {
        let chalk = picture("lambertian_reflection:reflectance=1");
        assert!(at(&chalk, -0.4, 0.5) > 2.0 * at(&chalk, 0.6, -0.6));
        // Facing the light: the light's part by its flux, the sky's by at most its radiance.
        let flux = LIGHT_RADIANCE * TAU * (1.0 - LIGHT_COS) * 0.5;
        let lit = at(&chalk, LIGHT.x, LIGHT.y);
        let direct = flux / std::f64::consts::PI;
        assert!(
            lit > direct && lit < direct + 1.1 * SKY[1],
            "{lit} {direct}"
        );
    }

    #[test]
    fn a_narrow_lobe_comes_near_the_mirror() {
        let mirror = picture("specular_reflection:reflectance=1");
        let narrow = picture("rough_conductor:fresnel=one,alpha=0.003");
        for (a, b) in mirror.pixels.iter().zip(&narrow.pixels) {
            // The edge of the light is steep: a lobe of some width blurs it.
            assert!((a[1] - b[1]).abs() < 0.05 * a[1] + 1.0, "{a:?} {b:?}");
        }
    }

    #[test]
    fn a_retro_reflector_shows_no_shape() {
        let flat = picture("retro_reflector:reflectance=0.5,alpha=0.05");
        let (middle, side) = (at(&flat, 0.0, 0.0), at(&flat, 0.5, 0.0));
        assert!((middle - side).abs() < 0.05 * middle, "{middle} {side}");
    }

    #[test]
    fn every_material_has_a_picture_of_finite_values() {
        for named in library::all() {
            let material = &named.material;
            let picture = sphere(&*material.build(), material.relative_index(), SIDE);
            assert_eq!(picture.pixels.len(), SIDE * SIDE);
            assert_eq!(picture.pixels[0], [0.0; 4]);
            let is_sane = |x: f64| (0.0..=1e3).contains(&x);
            assert!(
                picture.pixels.iter().flatten().all(|x| is_sane(*x)),
                "{}",
                named.id
            );
            assert!(at(&picture, -0.2, 0.2) > 0.0, "{}", named.id);
        }
    }
}
