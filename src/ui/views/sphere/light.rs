//! The handle of the light that the sphere stands in.

use egui::{Align2, Rect, Ui};
use glam::DVec3;

use super::super::context::ViewContext;
use super::place::position;
use crate::widgets::{deltas, handle, pictures};
use bxdf::math::frame;
use bxdf_lab::analysis::sphere::{self, Light};
use bxdf_lab::analysis::{Channel, Hold, Subject};
use bxdf_study::session::EntryId;
use bxdf_study::views::sphere::{LIGHT_PHI, LIGHT_THETA, Options};

/// How far outside the disc a light stands that is right behind the sphere, in radii.
const BEHIND: f64 = 0.3;

/// Where a mirror shows the light itself: a delta, too small to be seen, with a ring about it.
pub(super) fn mark_glint(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    (strip, rect): (Rect, Rect),
    light: DVec3,
    entry: EntryId,
) {
    let session = &*cx.session;
    // The other lights are wide enough to be seen.
    let is_point = cx.options.light == Light::Directional;
    let Some(found) = session.materials.get(entry).filter(|_| is_point) else {
        return;
    };
    let glint = |subject: &Subject<'_>| sphere::glint(&subject.lobe, light);
    let Some((place, flux)) = cx.answers.with_subject(session, found, glint) else {
        return;
    };
    let painter = ui.painter_at(strip);
    let (at, color) = (position(rect, place), cx.palette.material(found.slot()));
    if strip.contains(at) {
        deltas::ring(&painter, at, (color, cx.palette), true);
        let beside = at + egui::vec2(deltas::BESIDE_RING, 0.0);
        let place = (beside, Align2::LEFT_CENTER);
        let text = deltas::label(Channel::Luminance.of(flux));
        let look = (cx.palette.ink, cx.palette);
        let mut taken = vec![handle::room(position(
            rect,
            handle_place(cx.options.light_at(cx.session)),
        ))];
        deltas::write(ui, &painter, &mut taken, place, &text, look);
    }
}

/// Where the light's handle is, in radii of the sphere: on the sphere where it faces the light, outside of it where the light
/// stands behind.
fn handle_place([theta_deg, phi_deg]: [f64; 2]) -> [f64; 2] {
    let (sin, cos) = phi_deg.to_radians().sin_cos();
    let reach = if theta_deg <= 90.0 {
        theta_deg.to_radians().sin()
    } else {
        1.0 + BEHIND * (theta_deg - 90.0) / 90.0
    };
    [reach * cos, reach * sin]
}

/// The handle of the light.
pub(super) fn drag(ui: &Ui, cx: &mut ViewContext<'_, Options>, rect: Rect) {
    if !cx.options.light.has_direction() {
        return;
    }
    let at = position(rect, handle_place(cx.options.light_at(cx.session)));
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
    if cx.options.is_shared {
        let phi_deg = frame::phi(DVec3::new(x, -y, 0.0)).to_degrees();
        let light = frame::direction_from_degrees(theta_deg, phi_deg);
        cx.put(Hold::Light, light);
        ui.ctx().request_repaint();
        return;
    }
    let options = &mut *cx.options;
    let tenth = |angle: f64| (10.0 * angle).round() / 10.0;
    LIGHT_THETA.put(&mut options.theta_deg, tenth(theta_deg));
    if radius > 1e-3 {
        let phi_deg = frame::phi(DVec3::new(x, -y, 0.0)).to_degrees();
        LIGHT_PHI.put(&mut options.phi_deg, tenth(phi_deg));
    }
    ui.ctx().request_repaint();
}
