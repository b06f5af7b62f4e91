//! What is drawn over the disc: circles, axes, directions and deltas.

use std::sync::Arc;

use egui::{Align2, Pos2, Rect, Ui};
use glam::DVec3;

use super::super::context::ViewContext;
use super::place::{label_room, mirrored, position};
use crate::theme::Palette;
use crate::widgets::{deltas, draw, handle, pictures};
use bxdf::math::frame;
use bxdf_lab::analysis::Channel;
use bxdf_lab::analysis::hemisphere::{DeltaValue, Map, Projection, Quantity};
use bxdf_study::format;
use bxdf_study::session::EntryId;
use bxdf_study::views::hemisphere::Options;

/// The circles drawn, in degrees from n.
const CIRCLES_DEG: [f64; 2] = [30.0, 60.0];

/// Circles of equal angle from n, the axes and their names.
pub(super) fn draw_grid(ui: &Ui, projection: Projection, rect: Rect, palette: &Palette) {
    let painter = ui.painter();
    let (centre, radius) = (rect.center(), 0.5 * rect.width());
    let font = draw::small_font(ui);
    painter.circle_stroke(centre, radius, (1.0, palette.axis));
    for theta in CIRCLES_DEG {
        let [x, _] = projection.place(frame::direction_from_degrees(theta, 0.0));
        let at = x as f32 * radius;
        painter.circle_stroke(centre, at, (0.6, palette.axis));
        if radius > 70.0 {
            let place = centre + egui::vec2(0.0, at);
            let text = format::degrees(theta);
            draw::haloed_text(
                painter,
                place,
                Align2::CENTER_CENTER,
                &text,
                font.clone(),
                palette.faint_ink,
                palette,
            );
        }
    }
    for (place, anchor, name) in axis_names(rect) {
        painter.text(place, anchor, name, font.clone(), palette.ink);
    }
}

/// Where the names of the axes of the surface stand.
fn axis_names(rect: Rect) -> [(Pos2, Align2, &'static str); 2] {
    let [right, top] = [rect.right_center(), rect.center_top()];
    [
        (right + egui::vec2(4.0, 0.0), Align2::LEFT_CENTER, "s"),
        (top - egui::vec2(0.0, 2.0), Align2::CENTER_BOTTOM, "t"),
    ]
}

/// What the names of the axes cover in this room around the disc.
pub(super) fn room_of_axes(rect: Rect, room: f32) -> [Rect; 2] {
    let size = egui::Vec2::splat(room);
    axis_names(rect).map(|(place, anchor, _)| anchor.anchor_size(place, size))
}

/// The mirror direction, light and viewer, those on the other side as they would be seen through the surface.
pub(super) fn draw_directions(ui: &Ui, cx: &ViewContext<'_, Options>, rect: Rect) {
    let (session, palette) = (&*cx.session, cx.palette);
    let painter = ui.painter();
    let held = session.held();
    let mirror = DVec3::new(-held.x, -held.y, held.z);
    let directions = cx.directions().map(|one| (one.direction, one.color));
    for (w, color) in [(mirror, palette.mirror)].into_iter().chain(directions) {
        let place = cx.options.projection.place(w);
        let at = pictures::position_of(rect, mirrored(place));
        if (w.z > 0.0) == cx.options.is_lower {
            // On the other side of the surface: where it would be seen through it.
            painter.circle_stroke(at, 4.0, (1.0, color));
        } else {
            painter.circle(at, 4.0, color, (1.5, palette.background));
        }
    }
}

/// What is written at a delta.
pub(super) fn delta_label(value: &DeltaValue, options: Options) -> String {
    let number = Channel::Luminance.of(value.value);
    let text = match options.quantity {
        Quantity::F | Quantity::FCos => deltas::label(number),
        other => format!(
            "delta, {} {}",
            other.title_of_delta(),
            deltas::share(number)
        ),
    };
    match (value.direction.z > 0.0, options.is_lower) {
        (true, true) => text + ", above",
        (false, false) => text + ", below",
        _ => text,
    }
}

/// The deltas as rings; those to the other side where they would be seen through the surface. Returns what they and the handles
/// cover.
pub(super) fn draw_deltas(
    ui: &Ui,
    cx: &ViewContext<'_, Options>,
    rect: Rect,
    (entry, map): (EntryId, &Arc<Map>),
) -> Vec<Rect> {
    let (session, options) = (&*cx.session, *cx.options);
    let Some(found) = session.materials.get(entry) else {
        return Vec::new();
    };
    let painter = ui.painter_at(rect.expand(label_room(ui)));
    let color = cx.palette.material(found.slot());
    let mut taken = room_of_axes(rect, label_room(ui)).to_vec();
    for w in [session.held(), session.other()] {
        if (w.z > 0.0) != options.is_lower {
            taken.push(handle::room(position(rect, w, options.projection)));
        }
    }
    for value in &map.deltas {
        let is_on_side = (value.direction.z > 0.0) != options.is_lower;
        let at = position(rect, value.direction, options.projection);
        deltas::ring(&painter, at, (color, cx.palette), is_on_side);
        taken.push(Rect::from_center_size(
            at,
            egui::Vec2::splat(2.0 * deltas::BESIDE_RING),
        ));
    }
    for value in &map.deltas {
        let at = position(rect, value.direction, options.projection);
        // Towards the middle, unless another ring stands there.
        let inwards = (rect.center().x - at.x).signum();
        let is_other = |other: &&DeltaValue| {
            let gap = position(rect, other.direction, options.projection) - at;
            gap.x * inwards > 1.0 && gap.y.abs() < 2.0 * deltas::BESIDE_RING
        };
        let is_blocked = map.deltas.iter().any(|other| is_other(&other));
        let (anchor, aside) = if (inwards < 0.0) == is_blocked {
            (Align2::LEFT_CENTER, deltas::BESIDE_RING + 1.0)
        } else {
            (Align2::RIGHT_CENTER, -deltas::BESIDE_RING - 1.0)
        };
        let place = (at + egui::vec2(aside, 0.0), anchor);
        let text = delta_label(value, options);
        let look = (cx.palette.ink, cx.palette);
        deltas::write(ui, &painter, &mut taken, place, &text, look);
    }
    taken
}
