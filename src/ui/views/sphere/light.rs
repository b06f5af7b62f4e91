//! The handle of the light that the sphere stands in.

use egui::{Rect, Ui};
use glam::DVec3;

use super::super::ViewContext;
use super::position;
use crate::analysis::sphere;
use crate::bxdf::math::frame;
use crate::ui::widgets::{handle, pictures};

/// How far outside the disc a light stands that is right behind the sphere, in radii.
const BEHIND: f64 = 0.3;

/// The handle of the light: on the sphere where it faces the light, outside of it where the light stands behind.
pub(super) fn drag(ui: &Ui, cx: &mut ViewContext<'_>, rect: Rect) {
    let options = &mut cx.session.views.sphere;
    if !options.light.has_direction() {
        return;
    }
    let (sin, cos) = options.phi_deg.to_radians().sin_cos();
    let reach = if options.theta_deg <= 90.0 {
        options.theta_deg.to_radians().sin()
    } else {
        1.0 + BEHIND * (options.theta_deg - 90.0) / 90.0
    };
    let at = position(rect, [reach * cos, reach * sin]);
    let id = ui.scope_id().with("light of the sphere");
    let named = (id, "Light of the sphere", ui.clip_rect());
    let handle = handle::show(ui, at, named, cx.palette.light, cx.palette);
    let Some(place) = handle.dragged_to() else {
        return;
    };
    let [x, y] = pictures::share_of(rect, place).map(|share| (2.0 * share - 1.0) / sphere::RADIUS);
    let radius = x.hypot(y);
    let theta_deg = if radius <= 1.0 {
        frame::theta(DVec3::new(
            radius,
            0.0,
            (1.0 - radius * radius).max(0.0).sqrt(),
        ))
        .to_degrees()
    } else {
        90.0 + 90.0 * ((radius - 1.0) / BEHIND).min(1.0)
    };
    let tenth = |angle: f64| (10.0 * angle).round() / 10.0;
    options.theta_deg = tenth(theta_deg);
    if radius > 1e-3 {
        options.phi_deg = tenth(frame::phi(DVec3::new(x, -y, 0.0)).to_degrees());
    }
    ui.ctx().request_repaint();
}
