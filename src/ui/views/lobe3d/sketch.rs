//! What is painted over the scene: names, angles and the legend of the colours.

use std::cell::RefCell;

use egui::{Align2, Color32, Pos2, Rect, Ui, vec2};
use glam::Vec3;

use super::sizes::{ARC_RADIUS, AXIS_LENGTH, FLAT};
use super::surface::Lobes;
use crate::scene3d::{Projection as _, Ray};
use crate::theme::{self, Palette};
use crate::widgets::{deltas, draw};
use bxdf::math::frame;
use bxdf_lab::analysis::{Channel, RadialScale};
use bxdf_study::format;
use bxdf_study::session::OrbitCamera;
use bxdf_study::session::Session;
use bxdf_study::views::Scale;

/// Spacing of the labels of the degree grid.
const GRID_STEP_DEG: f64 = 30.0;

/// The most characters of a name at a tip; the legend has more of it.
const LONGEST_TITLE: usize = 24;

/// How far beyond the tip of a lobe its name stands, in lengths of the lobe.
const NAME_BEYOND_TIP: f32 = 1.06;

/// Directions nearer than this share one name.
const NAME_SPACING: f32 = 0.2;

/// What is painted over the scene.
pub(super) struct Sketch<'a> {
    pub(super) ui: &'a Ui,
    pub(super) rect: Rect,
    pub(super) camera: &'a OrbitCamera,
    pub(super) palette: &'a Palette,
    /// Where names stand already.
    pub(super) taken: RefCell<Vec<Rect>>,
}

impl Sketch<'_> {
    /// Writes `text` at `place`, or a line or two above or below where other names stand already.
    fn name(&self, place: Vec3, text: &str, color: Color32) {
        let Some(position) = self.camera.project(place, self.rect) else {
            return;
        };
        let painter = self.ui.painter_at(self.rect);
        let font = draw::body_font(self.ui);
        let size = painter
            .layout_no_wrap(text.to_owned(), font.clone(), color)
            .size()
            + vec2(6.0, 2.0);
        let wanted = Rect::from_center_size(position, size);
        let rect = draw::free_place(&mut self.taken.borrow_mut(), wanted);
        draw::haloed_text(
            &painter,
            rect.center(),
            Align2::CENTER_CENTER,
            text,
            font,
            color,
            self.palette,
        );
    }

    /// The names of the axes, where the lobe does not stand before them.
    pub(super) fn name_axes(&self, lobes: &Lobes) {
        for (axis, name) in [(Vec3::X, "s"), (Vec3::Y, "t"), (Vec3::Z, "n")] {
            let place = axis * (AXIS_LENGTH + 0.08);
            let eye = self.camera.eye();
            let sight = Ray {
                origin: eye,
                direction: place - eye,
            };
            if lobes.hit(&sight).is_none_or(|(distance, _)| distance > 1.0) {
                self.name(place, name, self.palette.ink);
            }
        }
    }

    pub(super) fn label(&self, session: &Session, lobes: &Lobes) {
        let held = session.held().as_vec3();
        let mirror = Vec3::new(-held.x, -held.y, held.z);
        for (color, arrow) in lobes.arrows() {
            let share = Channel::Luminance.of(arrow.flux);
            let place = (arrow.direction * share.max(0.3) * 0.62).as_vec3();
            self.name(place, &deltas::label(share), color);
        }
        for (title, color, tip) in lobes.names() {
            let title = draw::clipped(title, LONGEST_TITLE);
            self.name(tip * NAME_BEYOND_TIP, &title, color);
        }
        // Near n the two names would overlap, and the held direction is its own mirror direction.
        if held.distance(mirror) > NAME_SPACING {
            self.name(mirror * 1.12, "mirror", self.palette.mirror);
        }
        self.name(
            held * 1.17,
            session.held_name(),
            self.palette.held(session.hold),
        );
        if session.show_geometry {
            self.label_geometry(session);
            self.label_grid();
        }
    }

    /// The degrees of the grid: phi along the horizon, theta along the meridian that faces the viewer.
    fn label_grid(&self) {
        let place = |theta_deg: f64, phi_deg: f64, radius: f64| {
            (frame::direction_from_degrees(theta_deg, phi_deg) * radius).as_vec3()
        };
        let eye = self.camera.eye().as_dvec3();
        let facing = (frame::phi(eye).to_degrees() / GRID_STEP_DEG).round() * GRID_STEP_DEG;
        let label = |place: Vec3, degrees: f64| {
            let Some(position) = self.camera.project(place, self.rect) else {
                return;
            };
            let painter = self.ui.painter_at(self.rect);
            let text = format::degrees(degrees);
            let galley =
                painter.layout_no_wrap(text, draw::small_font(self.ui), self.palette.faint_ink);
            let rect = Align2::CENTER_CENTER.anchor_size(position, galley.size());
            // A name is worth more than one of many numbers.
            if self
                .taken
                .borrow()
                .iter()
                .all(|other| !other.intersects(rect))
            {
                painter.galley(rect.min, galley, self.palette.faint_ink);
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
        let color = self.palette.geometry;
        let between = (Vec3::Z + held).normalize_or_zero();
        self.name(
            between * (ARC_RADIUS + 0.1),
            &format!("θ {}", format::degrees(session.theta_deg)),
            color,
        );
        if flat.length() > FLAT {
            let (sin, cos) = (0.5 * session.phi_deg).to_radians().sin_cos();
            let middle = Vec3::new(cos as f32, sin as f32, 0.0);
            self.name(
                middle * (ARC_RADIUS + 0.12),
                &format!("φ {}", format::degrees(session.phi_deg)),
                color,
            );
            let below = Vec3::new(0.0, 0.0, -0.09);
            self.name(
                flat * 0.6 + below,
                &format!("sin θ {:.3}", flat.length()),
                color,
            );
        }
    }

    /// The scale: the value of the longest radius, and where one lobe is shown the colours with their values.
    pub(super) fn scale(&self, lobes: &Lobes, session: &Session, scale: Scale) {
        let quantity = if session.with_cosine { "f cos θ" } else { "f" };
        let painter = self.ui.painter_at(self.rect);
        let font = draw::small_font(self.ui);
        let Some(peak) = lobes.full() else {
            if lobes.radii().any(|(_, radius)| radius > 0.0) {
                let place = self.rect.right_top() + vec2(-8.0, 6.0);
                let text = format!("radius = {quantity} over its peak");
                let color = self.palette.faint_ink;
                painter.text(place, Align2::RIGHT_TOP, text, font, color);
            }
            return;
        };
        if session.materials.is_overlay() {
            let place = self.rect.right_top() + vec2(-8.0, 6.0);
            let text = format!("radius = {quantity} {} 1/sr", format::value(peak));
            let color = self.palette.faint_ink;
            painter.text(place, Align2::RIGHT_TOP, text, font, color);
            return;
        }
        let (width, height) = (10.0, (0.2 * self.rect.height()).clamp(50.0, 120.0));
        let corner = self.rect.right_top() + vec2(-width - 8.0, 12.0);
        let bar = Rect::from_min_size(corner, vec2(width, height));
        let mut strip = egui::Mesh::default();
        let steps = 24_u32;
        for step in 0..=steps {
            let t = step as f32 / steps as f32;
            let color = theme::viridis_color(f64::from(1.0 - t));
            let y = bar.top() + t * bar.height();
            strip.colored_vertex(Pos2::new(bar.left(), y), color);
            strip.colored_vertex(Pos2::new(bar.right(), y), color);
            if step > 0 {
                let first = 2 * (step - 1);
                strip.add_triangle(first, first + 1, first + 2);
                strip.add_triangle(first + 1, first + 2, first + 3);
            }
        }
        painter.add(strip);
        let text = |y: f32, anchor: Align2, text: String| {
            let place = Pos2::new(bar.left() - 5.0, y);
            painter.text(place, anchor, text, font.clone(), self.palette.faint_ink);
        };
        text(
            bar.top(),
            Align2::RIGHT_CENTER,
            format!("{quantity} {} 1/sr", format::value(peak)),
        );
        let low = match scale.lengths {
            RadialScale::Linear => "0".to_owned(),
            RadialScale::Logarithmic { .. } => format::value(scale.lengths.value(0.0, peak)),
        };
        text(bar.bottom(), Align2::RIGHT_CENTER, low);
    }
}
