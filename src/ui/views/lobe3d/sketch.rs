//! What is painted over the scene: names, angles and the scale.

use std::cell::RefCell;

use egui::{Align2, Color32, FontId, Pos2, Rect, Ui, Vec2, vec2};
use glam::Vec3;

use super::super::context::Named;
use super::isolines::Isoline;
use super::scene::Drawing;
use super::sizes::{ARC_RADIUS, AXIS_LENGTH, FLAT};
use super::surface::Lobes;
use crate::scene3d::{Projection as _, Ray};
use crate::theme::Palette;
use crate::widgets::labels::{Labels, Place, Reach};
use crate::widgets::{deltas, draw, still, things};
use bxdf::math::frame;
use bxdf_lab::analysis::Channel;
use bxdf_study::format;
use bxdf_study::lessons::Thing;
use bxdf_study::session::OrbitCamera;
use bxdf_study::session::Session;

/// Spacing of the labels of the degree grid.
const GRID_STEP_DEG: f64 = 30.0;

/// The most characters of a name at a tip; the legend has more of it.
const LONGEST_TITLE: usize = 24;

/// Directions nearer than this share one name.
const NAME_SPACING: f32 = 0.2;

/// The room about a text on its patch, in points.
const PATCH: Vec2 = vec2(6.0, 2.0);

/// The room about a text in its pill, in points.
const PILL: Vec2 = vec2(12.0, 4.0);

/// What is painted over the scene.
pub(super) struct Sketch<'a> {
    pub(super) ui: &'a Ui,
    pub(super) rect: Rect,
    pub(super) camera: &'a OrbitCamera,
    pub(super) palette: &'a Palette,
    /// Where labels stand already.
    pub(super) labels: RefCell<Labels>,
}

impl Sketch<'_> {
    /// Everything, what is worth most first: what comes later stands where there is room.
    pub(super) fn draw(&self, session: &Session, directions: &[Named], drawing: &Drawing) {
        let lobes = &drawing.lobes;
        self.keep_off_arrows(lobes);
        self.scale(lobes, session);
        if session.show_geometry {
            self.trigonometry(session);
        }
        for one in directions.iter().rev() {
            let place = one.direction.as_vec3() * 1.1;
            self.name(place, one.name, one.color, Reach::Far);
        }
        self.name_deltas(lobes);
        if session.show_geometry {
            self.label_geometry(session);
        }
        self.name_axes(lobes);
        self.name_mirror(session);
        self.name_lobes(lobes);
        if let Some(axis) = lobes.axis(session) {
            self.label_isolines(&drawing.isolines, axis);
        }
        if session.show_geometry {
            self.label_grid();
        }
    }

    /// Keeps labels off the arrows of deltas: a small cell has little room beside them.
    fn keep_off_arrows(&self, lobes: &Lobes) {
        for (_, arrow) in lobes.arrows() {
            let share = Channel::Luminance.of(arrow.flux);
            let tip = self.project((arrow.direction * share).as_vec3());
            if let Some((tip, foot)) = tip.zip(self.project(Vec3::ZERO)) {
                self.labels.borrow_mut().keep_off_line([foot, tip]);
            }
        }
    }

    fn project(&self, place: Vec3) -> Option<Pos2> {
        self.camera.project(place, self.rect)
    }

    /// The place for a label of this size at a point of the scene, on the side that points away from the middle of the scene.
    fn place(&self, point: Vec3, size: Vec2, reach: Reach) -> Option<Place> {
        let (at, origin) = (self.project(point)?, self.project(Vec3::ZERO)?);
        let outwards = at - origin;
        let towards = if outwards.length() > 1.0 {
            outwards
        } else {
            Vec2::UP
        };
        self.labels.borrow_mut().place(at, size, towards, reach)
    }

    /// Writes `text` beside a point of the scene.
    fn name(&self, point: Vec3, text: &str, color: Color32, reach: Reach) {
        let painter = self.ui.painter_at(self.rect);
        let font = draw::body_font(self.ui);
        let size = self.size(text, &font) + PATCH;
        if let Some(Place { rect, leader }) = self.place(point, size, reach) {
            if let Some(ends) = leader {
                painter.line_segment(ends, (1.0, color));
            }
            let (middle, anchor) = (rect.center(), Align2::CENTER_CENTER);
            let ink = self.palette.text_in(color);
            draw::haloed_text(&painter, middle, anchor, text, font, ink, self.palette);
            if let Some(thing) = Thing::named(text) {
                things::frame(self.ui, rect, &thing, self.palette);
            }
        }
    }

    fn size(&self, text: &str, font: &FontId) -> Vec2 {
        let painter = self.ui.painter();
        let galley = painter.layout_no_wrap(text.to_owned(), font.clone(), self.palette.ink);
        galley.size()
    }

    fn name_mirror(&self, session: &Session) {
        let held = session.held().as_vec3();
        let mirror = Vec3::new(-held.x, -held.y, held.z);
        let other = session.other().as_vec3();
        // Near n the names would overlap, where the held direction is its own mirror direction; and where the other direction
        // is, it has that name.
        if held.distance(mirror) > NAME_SPACING && other.distance(mirror) > NAME_SPACING {
            self.name(mirror * 1.02, "mirror", self.palette.mirror, Reach::Near);
        }
    }

    /// The names of the axes, where the lobe does not stand before them.
    fn name_axes(&self, lobes: &Lobes) {
        for (axis, name) in [(Vec3::X, "s"), (Vec3::Y, "t"), (Vec3::Z, "n")] {
            let place = axis * AXIS_LENGTH;
            let eye = self.camera.eye();
            let sight = Ray {
                origin: eye,
                direction: place - eye,
            };
            if lobes.hit(&sight).is_none_or(|(distance, _)| distance > 1.0) {
                self.name(place, name, self.palette.ink, Reach::Near);
            }
        }
    }

    /// The share of each delta in a pill at its tip.
    fn name_deltas(&self, lobes: &Lobes) {
        let painter = self.ui.painter_at(self.rect);
        let font = draw::small_font(self.ui);
        for (color, arrow) in lobes.arrows() {
            let share = Channel::Luminance.of(arrow.flux);
            let text = deltas::label(share);
            let size = self.size(&text, &font) + PILL;
            let tip = (arrow.direction * share).as_vec3();
            if let Some(Place { rect, leader }) = self.place(tip, size, Reach::Far) {
                if let Some(ends) = leader {
                    painter.line_segment(ends, (1.0, color));
                }
                deltas::pill(&painter, rect, &text, font.clone(), (color, self.palette));
            }
        }
    }

    /// The names of the longer lobes at their tips, where there are several.
    fn name_lobes(&self, lobes: &Lobes) {
        for (title, color, tip) in lobes.names() {
            let title = draw::clipped(title, LONGEST_TITLE);
            self.name(tip, &title, color, Reach::Near);
        }
    }

    /// The values of the lines on the lobe, each where its line is furthest from the lobe's axis, on the right or below.
    fn label_isolines(&self, lines: &[Isoline], axis: Vec3) {
        let painter = self.ui.painter_at(self.rect);
        let (font, color) = (draw::small_font(self.ui), self.palette.ink);
        let (Some(foot), Some(tip)) = (self.project(Vec3::ZERO), self.project(axis)) else {
            return;
        };
        let across = (tip - foot).normalized().rot90();
        let aside = if across.x + 0.5 * across.y >= 0.0 {
            across
        } else {
            -across
        };
        for line in lines.iter().filter(|line| !line.is_minor) {
            let places = line.pieces.iter().flatten();
            let seen = places.filter_map(|place| self.project(*place));
            let along = |place: &Pos2| (*place - foot).dot(aside);
            let Some(end) = seen.max_by(|a, b| along(a).total_cmp(&along(b))) else {
                continue;
            };
            let text = format::value(line.value);
            let size = self.size(&text, &font) + PATCH;
            let place = self
                .labels
                .borrow_mut()
                .place(end, size, aside, Reach::There);
            if let Some(Place { rect, .. }) = place {
                let (middle, anchor) = (rect.center(), Align2::CENTER_CENTER);
                draw::haloed_text(
                    &painter,
                    middle,
                    anchor,
                    &text,
                    font.clone(),
                    color,
                    self.palette,
                );
            }
        }
    }

    /// The degrees of the grid: phi along the horizon, theta along the meridian that faces the viewer.
    fn label_grid(&self) {
        let place = |theta_deg: f64, phi_deg: f64, radius: f64| {
            (frame::direction_from_degrees(theta_deg, phi_deg) * radius).as_vec3()
        };
        let eye = self.camera.eye().as_dvec3();
        let facing = (frame::phi(eye).to_degrees() / GRID_STEP_DEG).round() * GRID_STEP_DEG;
        let (painter, font) = (self.ui.painter_at(self.rect), draw::small_font(self.ui));
        let label = |place: Vec3, degrees: f64| {
            let Some(position) = self.project(place) else {
                return;
            };
            let (text, color) = (format::degrees(degrees), self.palette.faint_ink);
            let size = self.size(&text, &font);
            // A name is worth more than one of many numbers.
            let place = self
                .labels
                .borrow_mut()
                .place(position, size, Vec2::ZERO, Reach::There);
            if let Some(Place { rect, .. }) = place {
                painter.text(
                    rect.center(),
                    Align2::CENTER_CENTER,
                    text,
                    font.clone(),
                    color,
                );
            }
        };
        for step in 0..12 {
            let phi = GRID_STEP_DEG * f64::from(step) - 150.0;
            label(place(90.0, phi, 1.09), phi);
        }
        for theta in [GRID_STEP_DEG, 2.0 * GRID_STEP_DEG] {
            label(place(theta, facing, 1.03), theta);
        }
    }

    fn label_geometry(&self, session: &Session) {
        let held = session.held().as_vec3();
        let flat = Vec3::new(held.x, held.y, 0.0);
        let name =
            |place: Vec3, text: String| self.name(place, &text, self.palette.geometry, Reach::Far);
        let between = (Vec3::Z + held).normalize_or_zero();
        name(
            between * ARC_RADIUS,
            format!("θ {}", format::degrees(session.theta_deg)),
        );
        if flat.length() > FLAT {
            let (sin, cos) = (0.5 * session.phi_deg).to_radians().sin_cos();
            let middle = Vec3::new(cos as f32, sin as f32, 0.0);
            name(
                middle * ARC_RADIUS,
                format!("φ {}", format::degrees(session.phi_deg)),
            );
            name(flat * 0.6, format!("sin θ {:.3}", flat.length()));
        }
    }

    /// Cosine, sine and tangent of the angles, in a corner.
    fn trigonometry(&self, session: &Session) {
        let line = |name: &str, angle_deg: f64| {
            let [cos, sin, tan] = cos_sin_tan(angle_deg);
            format!("cos {name} {cos}   sin {name} {sin}   tan {name} {tan}")
        };
        let lines = [line("θ", session.theta_deg), line("φ", session.phi_deg)];
        let place = self.rect.left_bottom() + vec2(8.0, -6.0);
        let (font, color) = (draw::small_font(self.ui), self.palette.geometry);
        let painter = self.ui.painter_at(self.rect);
        let covered = painter.text(place, Align2::LEFT_BOTTOM, lines.join("\n"), font, color);
        self.labels
            .borrow_mut()
            .keep_off(covered.expand2(0.5 * PATCH));
    }

    /// The scale: the value of the longest radius.
    fn scale(&self, lobes: &Lobes, session: &Session) {
        if lobes.radii().all(|(_, radius)| radius <= 0.0) {
            return;
        }
        let quantity = if session.with_cosine { "f cos θ" } else { "f" };
        let place = self.rect.right_top() + vec2(-8.0, 6.0);
        let is_overlay = session.materials.is_overlay();
        let text = match lobes.full() {
            Some(full) => format!("radius = {quantity} {} 1/sr", format::value(full)),
            // The title above it has its scale.
            None if is_overlay && lobes.all.len() == 1 => return,
            None if is_overlay => format!("each its own scale: radius = {quantity} over its peak"),
            None => format!("radius = {quantity} over its peak"),
        };
        let (font, color) = (draw::small_font(self.ui), self.palette.faint_ink);
        let painter = self.ui.painter_at(self.rect);
        let covered = painter.text(place, Align2::RIGHT_TOP, text, font, color);
        still::follows_room(self.ui, covered);
        self.labels
            .borrow_mut()
            .keep_off(covered.expand2(0.5 * PATCH));
    }
}

/// Cosine, sine and tangent as text; the tangent of a right angle is infinite.
fn cos_sin_tan(angle_deg: f64) -> [String; 3] {
    let (cos, sin) = frame::cos_sin_deg(angle_deg);
    let number = |x: f64| format!("{:.3}", x + 0.0);
    let tangent = if cos == 0.0 {
        "∞".to_owned()
    } else {
        number(sin / cos)
    };
    [number(cos), number(sin), tangent]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_angles_are_exact() {
        assert_eq!(cos_sin_tan(90.0), ["0.000", "1.000", "∞"]);
        assert_eq!(cos_sin_tan(180.0), ["-1.000", "0.000", "0.000"]);
        assert_eq!(cos_sin_tan(45.0)[2], "1.000");
    }
}
