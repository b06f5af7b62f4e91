//! The light and the viewer in the hand: their handles in every view of directions, dragged or moved by the arrow keys.

use egui::{Align2, Painter, Pos2, Rect, Ui};
use glam::DVec3;

use super::context::{Named, ViewContext};
use crate::widgets::directions;
use crate::widgets::draw;
use crate::widgets::handle::{self, Handle};
use crate::widgets::labels::{Labels, Reach};
use crate::widgets::steps::Steps;
use crate::widgets::things::{self, By};
use bxdf::math::frame;
use bxdf_lab::analysis::half_difference::Spherical;
use bxdf_study::format;

/// What the arrow keys do where directions have both of their angles.
pub(super) const KEYS: &str =
    "Up and Down change θ by 1°, Left and Right change φ; with Shift by 0.1°";

/// Room around a name on its patch, in points.
const PATCH: egui::Vec2 = egui::vec2(6.0, 2.0);

/// The handle of `one` at `middle`, known by `name` and seen inside of `room`; `keys`: what the arrow keys do to it.
pub(super) fn show<O>(
    ui: &Ui,
    cx: &mut ViewContext<'_, O>,
    one: &Named,
    middle: Pos2,
    (name, room, keys): (&'static str, Rect, &str),
) -> Handle {
    let key = directions::key_of(one.of).name();
    let hint = format!(
        "The {}. Drag it, or press {key} and move it by keys: {keys}",
        one.name
    );
    let named = (ui.scope_id().with(name), name, room);
    if cx.state.take_focus(one.of, cx.view) {
        ui.memory_mut(|memory| memory.request_focus(named.0));
    }
    let handle = handle::show(ui, middle, named, &hint, (one.color, cx.palette));
    handle.says(angles(one.direction));
    let thing = one.thing();
    if handle.is_touched() {
        things::point(ui.ctx(), &thing, By::Place);
    }
    things::ring(ui, middle, &thing, cx.palette);
    handle
}

/// The angles of a direction in words.
fn angles(w: DVec3) -> String {
    let place = Spherical::of(w);
    let [theta, phi] = [place.theta_deg, place.phi_deg].map(format::degrees);
    format!("θ {theta}, φ {phi}")
}

/// The direction `w` moved by the arrow keys: up is towards n, right is counter-clockwise about it.
pub(super) fn turned(w: DVec3, steps: Steps) -> DVec3 {
    let [theta, phi] = [frame::theta(w), frame::phi(w)].map(f64::to_degrees);
    frame::direction_from_degrees(theta - steps.up, phi + steps.right)
}

/// Writes the name of `one` beside its place `middle` in a picture about `centre`, where there is room.
pub(super) fn name<O>(
    ui: &Ui,
    painter: &Painter,
    cx: &ViewContext<'_, O>,
    labels: &mut Labels,
    (one, middle, centre): (&Named, Pos2, Pos2),
) {
    let (font, ink) = (draw::body_font(ui), cx.palette.text_in(one.color));
    let galley = painter.layout_no_wrap(one.name.to_owned(), font.clone(), ink);
    let outwards = middle - centre;
    let towards = if outwards.length() > 1.0 {
        outwards
    } else {
        egui::Vec2::UP
    };
    let from = middle + handle::room(middle).width() * 0.5 * towards.normalized();
    let size = galley.size() + PATCH;
    if let Some(place) = labels.place(from, size, towards, Reach::Near) {
        let (at, anchor) = (place.rect.center(), Align2::CENTER_CENTER);
        draw::haloed_text(painter, at, anchor, one.name, font, ink, cx.palette);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrow_keys_turn_by_degrees_and_beyond_n() {
        let w = frame::direction_from_degrees(30.0, 40.0);
        let after = |right, up| {
            let place = Spherical::of(turned(w, Steps { right, up }));
            [place.theta_deg, place.phi_deg].map(|angle| (10.0 * angle).round() / 10.0)
        };
        assert_eq!(after(1.0, 0.0), [30.0, 41.0]);
        assert_eq!(after(-0.1, 0.1), [29.9, 39.9]);
        assert_eq!(after(0.0, -1.0), [31.0, 40.0]);
        assert_eq!(
            after(0.0, 31.0),
            [1.0, -140.0],
            "it goes on at the other side"
        );
    }
}
