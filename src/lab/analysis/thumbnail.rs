//! A small picture of a material: a sphere under a light and a sky, as linear radiance.
//!
//! The sphere is that of [`super::sphere`] under its sky, met by so few directions that a list of such pictures is made in
//! no time. The light stands to the upper left before it.

use glam::DVec3;

use super::sphere::{Disc, scene::Scene};
use super::{Basis, Detail, IsWanted, Pace, Query, Raster, Subject};
use bxdf::Scatterer;

/// Where the light stands: x to the right, y up, z to the viewer. Not quite a unit vector.
const LIGHT: DVec3 = DVec3::new(-0.48, 0.60, 0.64);

/// Directions of the light, and directions of each lobe.
const SAMPLES: [usize; 2] = [5, 9];

/// A square picture: linear R, G, B, and the share of the pixel that the sphere covers, 0..1.
pub type Picture = Raster<[f64; 4]>;

/// What a picture is asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Request {
    /// Pixels along each side.
    pub side: usize,
}

impl Query for Request {
    type Answer = Picture;

    // However the surface is turned: a picture that tells materials apart need not be made anew for that.
    const BASIS: Basis = Basis::Material;

    const PACE: Pace = Pace::Background;

    fn answer(&self, subject: &Subject<'_>, _: Detail, _: IsWanted<'_>) -> Option<Picture> {
        let material = subject.material?;
        Some(sphere(
            &*material.build(),
            material.relative_index(),
            self.side,
        ))
    }
}

/// The picture of a sphere of `bxdf`, `side` pixels wide; `relative_index`: that below the surface over that above.
#[must_use]
pub fn sphere(bxdf: &dyn Scatterer<f64>, relative_index: f64, side: usize) -> Picture {
    let scene = Scene::new(bxdf, relative_index, LIGHT, SAMPLES);
    let disc = Disc { side };
    let pixel = |index: usize| {
        let Some((normal, coverage)) = disc.pixel(index % side, index / side) else {
            return [0.0; 4];
        };
        let [r, g, b] = scene.radiance(normal);
        [r, g, b, coverage]
    };
    Raster {
        width: side,
        height: side,
        pixels: (0..side * side).map(pixel).collect(),
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::analysis::sphere::RADIUS;
    use crate::analysis::sphere::scene::{LIGHT_COS, LIGHT_RADIANCE, SKY};
    use bxdf::Material;
    use bxdf::material::library;

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
