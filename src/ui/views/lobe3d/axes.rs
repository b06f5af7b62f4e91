//! The axes as lines over the picture of the scene, as drawings have them: sharp at every size, and left out where something
//! solid stands before them.

use egui::{Painter, Pos2, Rect};
use glam::Vec3;

use super::sizes::AXIS_LENGTH;
use super::surface::Lobes;
use crate::scene3d::{Projection as _, Ray};
use crate::theme::Palette;
use crate::widgets::deltas;
use bxdf_study::session::OrbitCamera;

/// Into how many pieces an axis is cut, each of which is seen or hidden.
const PIECES: u8 = 96;

/// The width of an axis and the length of its head, in points.
const WIDTH: f32 = 1.5;
const HEAD: f32 = 9.0;

/// What stands before a place by less than this, as a share of the way from the eye, does not hide it.
const SLACK: f32 = 2e-3;

/// What hides axes.
pub(super) struct Solids<'a> {
    pub(super) lobes: &'a Lobes,
    /// Whether nothing is seen through the disc of the surface.
    pub(super) has_table: bool,
}

impl Solids<'_> {
    /// Whether `place` is seen from `eye`.
    fn show(&self, eye: Vec3, place: Vec3) -> bool {
        let sight = Ray {
            origin: eye,
            direction: place - eye,
        };
        let is_before = |share: f32| (0.0..1.0 - SLACK).contains(&share);
        let hit = self.lobes.hit(&sight).map(|(share, _)| share);
        !hit.is_some_and(is_before) && !self.is_behind_table(eye, place)
    }

    /// Whether the disc stands between them; seen from below it hides what lies on it.
    fn is_behind_table(&self, eye: Vec3, place: Vec3) -> bool {
        let is_across = eye.z < 0.0 && place.z >= 0.0;
        let share = eye.z / (eye.z - place.z);
        let crossing = eye + share * (place - eye);
        self.has_table && is_across && crossing.length() < 1.0
    }
}

/// Draws the axes into `rect`.
pub(super) fn draw(
    painter: &Painter,
    rect: Rect,
    camera: &OrbitCamera,
    solids: &Solids<'_>,
    palette: &Palette,
) {
    let eye = camera.eye();
    for (axis, color) in [
        (Vec3::X, palette.axis),
        (Vec3::Y, palette.axis),
        (Vec3::Z, palette.ink),
    ] {
        let at = |piece: u8| axis * (AXIS_LENGTH * f32::from(piece) / f32::from(PIECES));
        let mut line: Vec<Pos2> = Vec::new();
        for piece in 0..PIECES {
            let (from, to) = (at(piece), at(piece + 1));
            let ends = [from, to].map(|place| camera.project(place, rect));
            if let [Some(from), Some(end)] = ends
                && solids.show(eye, 0.5 * (at(piece) + to))
            {
                if line.is_empty() {
                    line.push(from);
                }
                line.push(end);
            } else if !line.is_empty() {
                painter.line(std::mem::take(&mut line), (WIDTH, color));
            }
        }
        if let [.., before, tip] = line[..] {
            let base = tip - HEAD * (tip - before).normalized();
            deltas::head(painter, [base, tip], HEAD, color);
            painter.line(line, (WIDTH, color));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_hides_what_stands_on_it_from_below_only() {
        let lobes = Lobes::default();
        let solids = |has_table| Solids {
            lobes: &lobes,
            has_table,
        };
        let (above, below) = (Vec3::new(2.0, 0.5, 1.0), Vec3::new(2.0, 0.5, -1.0));
        for place in [Vec3::new(0.0, 0.0, 0.6), Vec3::new(0.4, 0.0, 0.0)] {
            assert!(solids(true).show(above, place), "{place}");
            assert!(!solids(true).show(below, place), "{place}");
            assert!(solids(false).show(below, place), "{place}");
        }
        let beyond = Vec3::new(1.1, 0.0, 0.0);
        assert!(solids(true).show(below, beyond), "beside the disc");
    }
}
