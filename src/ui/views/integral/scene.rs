//! Where the dome, its disc and their patches lie in a picture: seen from one side, a little from above, without perspective.

use egui::epaint::{Mesh, Vertex, WHITE_UV};
use egui::{Color32, Pos2, Rect, pos2, vec2};
use glam::DVec3;

use bxdf_lab::analysis::integral::Patch;

/// From where one looks: the azimuth from s and the elevation, in degrees.
const AZIMUTH_DEG: f64 = -62.0;
const ELEVATION_DEG: f64 = 24.0;

/// Between the dome and the disc below it, in radii.
const GAP: f64 = 0.2;

/// Room around both for names, in radii.
const MARGIN: f64 = 0.16;

/// Edges of patches are bent: a piece of one leaves the arc by no more than this, in points.
const SAGITTA: f64 = 0.2;

/// However small the picture, no piece of an edge is longer than this, in radians.
const LONGEST_STEP: f64 = 0.3;

/// A half of the sphere above the disc on which it throws its shadow.
pub(super) struct Scene {
    centre: Pos2,
    radius: f32,
    /// How far below the plane of the surface the disc is drawn, in radii.
    drop: f64,
    /// Which half it is.
    pub(super) is_upper: bool,
    right: DVec3,
    up: DVec3,
    /// Towards the eye.
    pub(super) eye: DVec3,
}

impl Scene {
    /// Width over height of a picture with so many halves side by side.
    pub(super) fn aspect(halves: usize) -> f32 {
        let [width, height] = Self::extent();
        (halves as f64 * width / height) as f32
    }

    /// Width and height in radii.
    fn extent() -> [f64; 2] {
        let tilt = ELEVATION_DEG.to_radians().sin();
        [2.0 + 2.0 * MARGIN, 1.0 + 3.0 * tilt + GAP + 2.0 * MARGIN]
    }

    /// A half as large as `rect` holds it.
    pub(super) fn new(rect: Rect, is_upper: bool) -> Self {
        let [width, height] = Self::extent();
        let radius = (f64::from(rect.width()) / width).min(f64::from(rect.height()) / height);
        let (sin_phi, cos_phi) = AZIMUTH_DEG.to_radians().sin_cos();
        let (sin, cos) = ELEVATION_DEG.to_radians().sin_cos();
        // A dome reaches up a radius, a bowl down one; their discs stand side by side.
        let (above, drop) = if is_upper {
            (1.0, 2.0 * sin + GAP)
        } else {
            (sin, 1.0 + sin + GAP)
        };
        let top = f64::from(rect.center().y) - 0.5 * radius * height;
        Self {
            centre: pos2(rect.center().x, (top + radius * (MARGIN + above)) as f32),
            radius: radius as f32,
            drop,
            is_upper,
            right: DVec3::new(-sin_phi, cos_phi, 0.0),
            up: DVec3::new(-sin * cos_phi, -sin * sin_phi, cos),
            eye: DVec3::new(cos * cos_phi, cos * sin_phi, sin),
        }
    }

    /// The radius in points.
    pub(super) fn radius(&self) -> f32 {
        self.radius
    }

    /// Where a place of the half lies.
    pub(super) fn place(&self, w: DVec3) -> Pos2 {
        self.centre + self.radius * vec2(w.dot(self.right) as f32, -(w.dot(self.up) as f32))
    }

    /// Where it lies once it has fallen this far, 0..1.
    pub(super) fn fallen(&self, w: DVec3, share: f64) -> Pos2 {
        let plane = self.place(DVec3::new(w.x, w.y, 0.0)) + self.down();
        self.place(w).lerp(plane, share as f32)
    }

    /// Where its shadow on the disc lies.
    pub(super) fn shadow(&self, w: DVec3) -> Pos2 {
        self.fallen(w, 1.0)
    }

    /// A place beside the disc on which nothing is drawn.
    pub(super) fn corner(&self) -> Pos2 {
        let tilt = ELEVATION_DEG.to_radians().sin() as f32;
        self.centre + self.down() + self.radius * vec2(-0.85, 0.95 * tilt)
    }

    fn down(&self) -> egui::Vec2 {
        vec2(0.0, self.radius * self.drop as f32)
    }

    /// The direction of this half that is pointed at: on its disc, or where the eye sees the sphere.
    pub(super) fn direction(&self, pointer: Pos2) -> Option<DVec3> {
        let from = |centre: Pos2| {
            let place = (pointer - centre) / self.radius;
            [f64::from(place.x), -f64::from(place.y)]
        };
        let [x, y] = from(self.centre + self.down());
        let tilt = ELEVATION_DEG.to_radians().sin();
        let flat = self.right * x + DVec3::new(self.up.x, self.up.y, 0.0) * (y / (tilt * tilt));
        if flat.length() <= 1.0 {
            let z = (1.0 - flat.length_squared()).max(0.0).sqrt();
            let z = if self.is_upper { z } else { -z };
            return Some(DVec3::new(flat.x, flat.y, z));
        }
        let [x, y] = from(self.centre);
        let depth = (1.0 - x * x - y * y).max(0.0).sqrt();
        let w = self.right * x + self.up * y + self.eye * depth;
        let is_there = x.hypot(y) <= 1.0 && (w.z > 0.0) == self.is_upper;
        is_there.then_some(w)
    }

    /// The rim of the half, or of its disc.
    pub(super) fn rim(&self, is_disc: bool) -> Vec<Pos2> {
        let at = |step: u32| {
            let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 96.0).sin_cos();
            self.fallen(DVec3::new(cos, sin, 0.0), f64::from(u8::from(is_disc)))
        };
        (0..96).map(at).collect()
    }

    /// The outline of the half against what is behind it.
    pub(super) fn outline(&self) -> Vec<Pos2> {
        let sign = if self.is_upper { 1.0 } else { -1.0 };
        let at = |step: u32| {
            let (sin, cos) = (f64::from(step) * std::f64::consts::PI / 64.0).sin_cos();
            self.right * cos + self.up * (sign * sin)
        };
        let points = (0..=64).map(at).filter(|w| w.z * sign >= 0.0);
        points.map(|w| self.place(w)).collect()
    }

    /// The edges of a patch that has fallen this far: that on the horizon's side, the one of least azimuth, the other two.
    pub(super) fn edges(&self, patch: &Patch, share: f64) -> [Vec<Pos2>; 4] {
        let [columns, rows] = self.steps(patch);
        let line = |steps: u32, place: &dyn Fn(f64) -> [f64; 2]| {
            let at = |step: u32| patch.direction(place(f64::from(step) / f64::from(steps)));
            let points = (0..=steps).map(|step| self.fallen(at(step), share));
            points.collect()
        };
        [
            line(columns, &|v| [0.0, v]),
            line(rows, &|u| [u, 0.0]),
            line(columns, &|v| [1.0, v]),
            line(rows, &|u| [u, 1.0]),
        ]
    }

    /// Adds the area of a patch that has fallen this far to `mesh`. Its sides along meridians are bent as well, on the sphere.
    pub(super) fn add_area(&self, mesh: &mut Mesh, patch: &Patch, share: f64, color: Color32) {
        let [steps, rows] = self.steps(patch);
        let first = mesh.vertices.len() as u32;
        for row in 0..=rows {
            for step in 0..=steps {
                let part = [row, step].map(f64::from);
                let [u, v] = [part[0] / f64::from(rows), part[1] / f64::from(steps)];
                mesh.vertices.push(Vertex {
                    pos: self.fallen(patch.direction([u, v]), share),
                    uv: WHITE_UV,
                    color,
                });
            }
        }
        for row in 0..rows {
            for step in 0..steps {
                let corner = first + row * (steps + 1) + step;
                let beyond = corner + steps + 1;
                mesh.add_triangle(corner, corner + 1, beyond);
                mesh.add_triangle(corner + 1, beyond + 1, beyond);
            }
        }
    }

    /// Into how many pieces a patch is cut along its parallels and along its meridians: both are bent.
    fn steps(&self, patch: &Patch) -> [u32; 2] {
        let step = (8.0 * SAGITTA / f64::from(self.radius.max(1.0))).sqrt();
        let pieces = |length: f64| (length / step.min(LONGEST_STEP)).ceil().max(1.0) as u32;
        let [from, to] = patch.phi;
        let [low, high] = patch.height;
        let radius = |height: f64| (1.0 - height * height).max(0.0).sqrt();
        [
            pieces(to - from),
            pieces(radius(low) - radius(high) + high - low),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use bxdf::math::frame::direction_from_degrees;

    #[test]
    fn what_is_pointed_at_is_what_is_drawn_there() {
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(400.0, 500.0));
        for is_upper in [true, false] {
            let scene = Scene::new(rect, is_upper);
            for (theta, phi) in [(30.0, -60.0), (70.0, 10.0), (10.0, 170.0), (60.0, 120.0)] {
                let theta = if is_upper { theta } else { 180.0 - theta };
                let w = direction_from_degrees(theta, phi);
                let shadow = scene.direction(scene.shadow(w)).unwrap();
                assert!(shadow.distance(w) < 1e-4, "{theta} {phi}");
                if w.dot(scene.eye) > 0.0 {
                    let seen = scene.direction(scene.place(w)).unwrap();
                    assert!(seen.distance(w) < 1e-2, "{theta} {phi} {seen}");
                }
            }
            assert_eq!(scene.direction(Pos2::ZERO), None);
        }
    }

    #[test]
    fn both_halves_stay_in_the_picture_and_their_discs_side_by_side() {
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(400.0, 500.0));
        let [upper, lower] = [true, false].map(|is_upper| Scene::new(rect, is_upper));
        for scene in [&upper, &lower] {
            let points = [scene.rim(true), scene.rim(false), scene.outline()].concat();
            assert!(points.iter().all(|point| rect.contains(*point)));
        }
        let gap = upper.shadow(DVec3::X).distance(lower.shadow(DVec3::X));
        assert!(gap < 1e-3, "{gap}");
    }
}
