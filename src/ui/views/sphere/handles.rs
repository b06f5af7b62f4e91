//! The light and the viewer on the sphere, and the light that a mirror shows.
//!
//! The light stands where the sphere faces it. The picture is seen from the front whatever the viewer of the other views is: it
//! stands at the point that shows what is seen from there.

use egui::{Align2, Pos2, Rect, Ui};
use glam::DVec3;

use super::super::context::{Named, ViewContext};
use super::super::direction;
use super::place::{faced, facing, position};
use crate::widgets::labels::Labels;
use crate::widgets::{deltas, draw, handle};
use bxdf::math::frame;
use bxdf_lab::analysis::sphere::{self, Light, normal_of, viewer_of};
use bxdf_lab::analysis::{Channel, Hold, Subject};
use bxdf_study::session::EntryId;
use bxdf_study::views::sphere::{LIGHT_PHI, LIGHT_THETA, Options};

/// What a sphere under one light cannot show of a pair.
const EXCEPT: &str = ", but for θd, which is the same all over a sphere under one light";

/// The direction of the light that the sphere stands in.
pub(super) fn light_of(cx: &ViewContext<'_, Options>) -> DVec3 {
    let [theta_deg, phi_deg] = cx.options.light_at(cx.session);
    frame::direction_from_degrees(theta_deg, phi_deg)
}

/// Where the light and the viewer stand on the sphere, in radii: the viewer at the point that shows the pair of both. `None`
/// where none does.
fn place_of(cx: &ViewContext<'_, Options>, of: Hold) -> Option<[f64; 2]> {
    let light = light_of(cx);
    let (wo, wi) = (cx.session.viewer(), cx.session.light());
    match of {
        Hold::Light => Some(facing(light)),
        Hold::Viewer => normal_of(light, wo, wi).map(|shown| facing(shown.normal)),
    }
}

/// What the handles cover.
fn rooms(cx: &ViewContext<'_, Options>, rect: Rect) -> Vec<Rect> {
    let places = [Hold::Light, Hold::Viewer].map(|of| place_of(cx, of));
    let places = places.into_iter().flatten();
    places
        .map(|place| handle::room(position(rect, place)))
        .collect()
}

/// The light and the viewer on a sphere, and the direction pointed at elsewhere as a cross.
pub(super) fn mark(ui: &Ui, cx: &ViewContext<'_, Options>, rect: Rect) {
    let painter = ui.painter();
    for one in cx.directions() {
        if let Some(place) = place_of(cx, one.of) {
            let at = position(rect, place);
            painter.circle(at, 4.0, one.color, (1.5, cx.palette.background));
        }
    }
    if let Some((wo, wi, strength)) = cx.marked_pair() {
        let shown = normal_of(light_of(cx), wo, wi);
        if let Some(shown) = shown.filter(|shown| shown.normal.z > 0.0) {
            let at = position(rect, facing(shown.normal));
            draw::cross(painter, at, (cx.palette, strength));
        }
    }
}

/// Where a mirror shows the light itself: a delta, too small to be seen, with a ring about it. Adds what that covers to
/// `covered`.
pub(super) fn mark_glint(
    ui: &Ui,
    cx: &mut ViewContext<'_, Options>,
    (strip, rect): (Rect, Rect),
    light: DVec3,
    entry: EntryId,
    covered: &mut Vec<Rect>,
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
        let mut taken = rooms(cx, rect);
        deltas::write(ui, &painter, &mut taken, place, &text, look);
        covered.extend(taken);
    }
}

/// The handles of the light and the viewer, with their names clear of what is `covered`.
pub(super) fn drag(ui: &Ui, cx: &mut ViewContext<'_, Options>, rect: Rect, covered: &[Rect]) {
    if !cx.options.light.has_direction() {
        return;
    }
    let mut labels = Labels::within(ui.clip_rect());
    for room in covered.iter().copied().chain(rooms(cx, rect)) {
        labels.keep_off(room);
    }
    for one in cx.directions() {
        let Some(place) = place_of(cx, one.of) else {
            continue;
        };
        let at = position(rect, place);
        direction::name(ui, ui.painter(), cx, &mut labels, (&one, at, rect.center()));
        match one.of {
            Hold::Light => drag_light(ui, cx, (rect, at), &one),
            Hold::Viewer => drag_viewer(ui, cx, (rect, at), &one),
        }
    }
}

fn drag_light(ui: &Ui, cx: &mut ViewContext<'_, Options>, (rect, at): (Rect, Pos2), one: &Named) {
    let light = light_of(cx);
    let one = Named {
        direction: light,
        ..*one
    };
    let named = ("Light of the sphere", ui.clip_rect(), direction::KEYS);
    let handle = direction::show(ui, cx, &one, at, named);
    let dragged_to = handle.dragged_to().map(|place| faced(rect, place));
    let turned = handle.steps().map(|steps| direction::turned(light, steps));
    let Some(w) = dragged_to.or(turned) else {
        return;
    };
    ui.ctx().request_repaint();
    if cx.options.is_shared {
        cx.put(Hold::Light, w);
        return;
    }
    let options = &mut *cx.options;
    let tenth = |angle: f64| (10.0 * angle.to_degrees()).round() / 10.0;
    LIGHT_THETA.put(&mut options.theta_deg, tenth(frame::theta(w)));
    if w.x.hypot(w.y) > 1e-3 {
        LIGHT_PHI.put(&mut options.phi_deg, tenth(frame::phi(w)));
    }
}

fn drag_viewer(ui: &Ui, cx: &mut ViewContext<'_, Options>, (rect, at): (Rect, Pos2), one: &Named) {
    let light = light_of(cx);
    let pair = (cx.session.viewer(), cx.session.light());
    let shown = normal_of(light, pair.0, pair.1);
    let except = if shown.is_some_and(|shown| shown.is_exact) {
        ""
    } else {
        EXCEPT
    };
    let hint = format!(
        "At this point of the sphere light, viewer and n stand to one another as in the other views{except}. {}",
        direction::KEYS
    );
    let named = ("Viewer of the sphere", ui.clip_rect(), hint.as_str());
    let handle = direction::show(ui, cx, one, at, named);
    let dragged_to = handle.dragged_to();
    let dragged_to = dragged_to.and_then(|place| viewer_of(light, faced(rect, place), pair));
    let turned = handle.steps().map(|steps| direction::turned(pair.0, steps));
    if let Some(w) = dragged_to.or(turned) {
        cx.put(Hold::Viewer, w);
        ui.ctx().request_repaint();
    }
}
