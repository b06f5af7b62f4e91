//! Builders for what a lobe stands on, and for the plane that cuts it.

use core::f32::consts::{FRAC_PI_2, TAU};

use glam::{Vec2, Vec3};

use super::geometry::{Rgba, Scene, Vertex};
use super::shapes::{ROUND_STEPS, fractions, grid, on_sphere};

/// Rings of a table top: fine enough for the soft edges of what lies on it.
const TABLE_RINGS: u16 = 40;
/// How far the top lies below the plane z = 0, in world units: lines in the plane and lobes that end there lie clear of it.
const TABLE_DROP: f32 = 0.006;
/// Its thickness, in world units.
const TABLE_THICKNESS: f32 = 0.05;
/// The edge between top and side is rounded by this much, in world units.
const TABLE_ROUNDING: f32 = 0.012;

impl Scene {
    /// Adds a disc of some thickness below the surface plane, with the unit circle as its edge. `shade` is the share of the
    /// light that is kept from it, 0 to 1, at places of the unit disc.
    pub fn add_table(&mut self, color: Rgba, shade: impl Fn(Vec2) -> f32) {
        let flat = 1.0 - TABLE_ROUNDING;
        let top: Vec<(f32, f32, f32)> = fractions(TABLE_RINGS)
            .map(|f| (f * flat, -TABLE_DROP, 0.0))
            .collect();
        // From the top over the rounded edge down the side: radius, height, and how far the normal is turned outwards.
        let edge = [0.5, 1.0].map(|f| {
            let (sin, cos) = (f * FRAC_PI_2).sin_cos();
            let height = -TABLE_DROP - TABLE_ROUNDING * (1.0 - cos);
            (flat + TABLE_ROUNDING * sin, height, f)
        });
        let foot = (1.0, -TABLE_DROP - TABLE_THICKNESS, 1.0);
        let profile: Vec<_> = top.into_iter().chain(edge).chain([foot]).collect();
        let mut vertices = Vec::new();
        for (radius, height, outward) in &profile {
            for azimuth in fractions(ROUND_STEPS) {
                let around = on_sphere(FRAC_PI_2, azimuth * TAU, 1.0);
                let place = radius * around;
                let light = 1.0 - shade(place.truncate());
                vertices.push(Vertex {
                    position: (place + height * Vec3::Z).into(),
                    normal: (Vec3::Z * (1.0 - outward) + around * *outward).into(),
                    color: dimmed(color, light),
                });
            }
        }
        let bands = u32::from(TABLE_RINGS) + 3;
        self.ground.append(&vertices, grid(bands, true));
    }

    /// Adds the translucent unit disc below the surface plane: what is seen of a table from below, and all of it where one
    /// sees through it from above, too.
    pub fn add_ground_disc(&mut self, color: Rgba) {
        let vertex = |p: Vec3| Vertex {
            position: (p - 2.0 * TABLE_DROP * Vec3::Z).into(),
            normal: Vec3::Z.into(),
            color,
        };
        let mut vertices = vec![vertex(Vec3::ZERO)];
        vertices.extend(fractions(ROUND_STEPS).map(|f| vertex(on_sphere(FRAC_PI_2, f * TAU, 1.0))));
        let triangles = (1..=u32::from(ROUND_STEPS)).flat_map(|i| [0, i, i + 1]);
        self.translucent.append(&vertices, triangles);
    }

    /// Adds the translucent half disc that the plane at azimuth `phi`, in radians, cuts out of the upper unit ball; of the
    /// whole one if not `is_half`. It is `middle` in the centre and `rim` at the dome.
    pub fn add_fan(&mut self, phi: f32, is_half: bool, [middle, rim]: [Rgba; 2]) {
        let (sin, cos) = phi.sin_cos();
        let normal = Vec3::new(-sin, cos, 0.0);
        let vertex = |p: Vec3, color: Rgba| Vertex {
            position: p.into(),
            normal: normal.into(),
            color,
        };
        let sweep = if is_half { FRAC_PI_2 } else { 2.0 * FRAC_PI_2 };
        let mut vertices = vec![vertex(Vec3::ZERO, middle)];
        vertices.extend(fractions(ROUND_STEPS).map(|f| {
            let (sin_polar, cos_polar) = ((2.0 * f - 1.0) * sweep).sin_cos();
            let place = Vec3::new(sin_polar * cos, sin_polar * sin, cos_polar);
            vertex(place, rim)
        }));
        let triangles = (1..=u32::from(ROUND_STEPS)).flat_map(|i| [0, i, i + 1]);
        self.translucent.append(&vertices, triangles);
    }
}

/// `color` with this share of its brightness.
fn dimmed([r, g, b, alpha]: Rgba, share: f32) -> Rgba {
    let dim = |channel: u8| (f32::from(channel) * share).round() as u8;
    [dim(r), dim(g), dim(b), alpha]
}

#[cfg(test)]
mod tests {
    use super::*;

    const INK: Rgba = [200, 100, 50, 255];

    #[test]
    fn a_table_is_seen_from_outside_and_stays_below_its_plane() {
        let mut scene = Scene::default();
        scene.add_table(INK, |place| 0.5 * f32::from(u8::from(place.x > 0.5)));
        let corner = |index: u32| scene.ground.vertices[index as usize];
        for triangle in scene.ground.indices.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|i| Vec3::from(corner(triangle[i]).position));
            let outward = Vec3::from(corner(triangle[1]).normal);
            assert!((b - a).cross(c - a).dot(outward) >= -1e-7);
        }
        for vertex in &scene.ground.vertices {
            let place = Vec3::from(vertex.position);
            assert!(place.z < 0.0 && place.truncate().length() <= 1.0 + 1e-6);
            let is_top = vertex.normal == [0.0, 0.0, 1.0];
            if is_top {
                assert_eq!(vertex.color[0], if place.x > 0.5 { 100 } else { 200 });
            }
        }
    }

    #[test]
    fn a_fan_lies_in_its_plane_and_reaches_the_dome() {
        for (is_half, least) in [(true, -1e-6), (false, -1.0)] {
            let mut scene = Scene::default();
            scene.add_fan(0.7, is_half, [INK; 2]);
            let places = scene.translucent.vertices.iter();
            for place in places.map(|vertex| Vec3::from(vertex.position)).skip(1) {
                assert!((place.length() - 1.0).abs() < 1e-6 && place.z >= least - 1e-6);
                assert!((place.y * 0.7_f32.cos() - place.x * 0.7_f32.sin()).abs() < 1e-6);
            }
        }
    }
}
