//! Tooltips of what is dragged: they go when it is taken, and stand away from where it goes.

use egui::{Align2, Context, Rect, RectAlign, Response, Tooltip};

/// Between a tooltip and the edge of its room, in points.
const EDGE: f32 = 8.0;

/// Whether a button is down: whatever is dragged is under the pointer, and under its tooltip. A finger that rests asks for one.
fn is_held(ctx: &Context) -> bool {
    ctx.input(|input| input.pointer.any_down() && !input.any_touches())
}

/// The tooltip of a number or its slider.
#[must_use]
pub fn at_number(response: Response, text: &str) -> Response {
    if is_held(&response.ctx) {
        response
    } else {
        response.on_hover_text(text)
    }
}

/// The tooltip of a handle: in the corner of `room` that is furthest from it.
pub fn at_handle(response: &Response, room: Rect, text: &str) {
    if is_held(&response.ctx) {
        return;
    }
    let mut tooltip = Tooltip::for_enabled(response);
    let corner = corner_away(response.rect, room);
    tooltip.popup = tooltip
        .popup
        .anchor(room.shrink(EDGE))
        .align(RectAlign::from_align2(corner))
        .align_alternatives(&[])
        .gap(0.0);
    tooltip.show(|ui| ui.label(text));
}

/// The corner of `room` furthest from the middle of `rect`.
fn corner_away(rect: Rect, room: Rect) -> Align2 {
    let from = rect.center() - room.center();
    match (from.x < 0.0, from.y < 0.0) {
        (true, true) => Align2::RIGHT_BOTTOM,
        (true, false) => Align2::RIGHT_TOP,
        (false, true) => Align2::LEFT_BOTTOM,
        (false, false) => Align2::LEFT_TOP,
    }
}

#[cfg(test)]
mod tests {
    use egui::{pos2, vec2};

    use super::*;

    #[test]
    fn a_handle_has_its_tooltip_across() {
        let room = Rect::from_min_size(pos2(0.0, 0.0), vec2(400.0, 300.0));
        let at = |x, y| Rect::from_center_size(pos2(x, y), vec2(40.0, 40.0));
        assert_eq!(corner_away(at(30.0, 30.0), room), Align2::RIGHT_BOTTOM);
        assert_eq!(corner_away(at(390.0, 30.0), room), Align2::LEFT_BOTTOM);
        assert_eq!(corner_away(at(390.0, 290.0), room), Align2::LEFT_TOP);
        assert_eq!(corner_away(at(30.0, 290.0), room), Align2::RIGHT_TOP);
    }
}
