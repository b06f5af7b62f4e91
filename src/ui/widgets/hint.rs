//! Tooltips of what is dragged: they go when it is taken, and stand away from where it goes.

use egui::{Align2, Context, Id, Pos2, Rect, RectAlign, Response, Tooltip};

/// Between a tooltip and the edge of its room, in points.
const EDGE: f32 = 8.0;

/// How far the pointer leaves the place where a drag has ended before there are tooltips again, in points.
const LEFT: f32 = 24.0;

/// Under which name is kept what tooltips go by.
const KEPT: &str = "tooltips";

/// Whether the views are presented: their tooltips would stand over what a class is shown.
#[derive(Clone, Copy, Default)]
struct Presented(bool);

/// Where a drag has ended, as long as the pointer rests there.
#[derive(Clone, Copy)]
struct LetGo(Pos2);

/// Says whether the views are presented.
pub fn present(ctx: &Context, is_presenting: bool) {
    ctx.data_mut(|data| data.insert_temp(Id::unique(KEPT), Presented(is_presenting)));
}

fn is_presented(ctx: &Context) -> bool {
    let kept: Option<Presented> = ctx.data(|data| data.get_temp(Id::unique(KEPT)));
    kept.unwrap_or_default().0
}

/// Whether something is dragged: it is under the pointer, and under its tooltip. So it is where the pointer rests after a drag:
/// who looks at what has become of it asks for no tooltip. A finger that rests asks for one.
fn is_dragging(ctx: &Context) -> bool {
    let (is_down, pointer) = ctx.input(|input| {
        let is_down = input.pointer.any_down() && !input.any_touches();
        (is_down, input.pointer.latest_pos())
    });
    if is_down {
        return true;
    }
    if let Some(at) = pointer.filter(|_| ctx.drag_stopped_id().is_some()) {
        ctx.data_mut(|data| data.insert_temp(Id::unique(KEPT), LetGo(at)));
    }
    let kept: Option<LetGo> = ctx.data(|data| data.get_temp(Id::unique(KEPT)));
    let rests = kept
        .zip(pointer)
        .is_some_and(|(LetGo(at), pointer)| at.distance(pointer) < LEFT);
    if !rests {
        ctx.data_mut(|data| data.remove::<LetGo>(Id::unique(KEPT)));
    }
    rests
}

/// The tooltip of a number or its slider.
#[must_use]
pub fn at_number(response: Response, text: &str) -> Response {
    if is_dragging(&response.ctx) {
        response
    } else {
        response.on_hover_text(text)
    }
}

/// The tooltip of what stands in a plot or above it.
#[must_use]
pub fn in_plot(response: Response, text: &str) -> Response {
    if is_presented(&response.ctx) {
        response
    } else {
        at_number(response, text)
    }
}

/// The tooltip of a handle: in the corner of `room` that is furthest from it.
pub fn at_handle(response: &Response, room: Rect, text: &str) {
    if is_dragging(&response.ctx) || is_presented(&response.ctx) {
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
