//! Round handles that are dragged.

use egui::{
    Color32, Context, CursorIcon, Id, LayerId, Pos2, Rect, Response, Role, Sense, Ui, Vec2,
    WidgetInfo, accesskit,
};

use super::steps::{self, Steps};
use super::{focus, hint, still};
use crate::theme::{HANDLE_RADIUS, HANDLE_REACH, Palette};

/// The radius of what stands for it in a picture, where nobody can take it, in points.
const MARK_RADIUS: f32 = 5.0;

/// What is left free about a handle, in points.
const LABEL_GAP: f32 = 6.0;

/// Between a handle and the ring that says that it has the focus, in points.
const FOCUS_GAP: f32 = 3.0;

/// A handle on the screen.
pub struct Handle {
    response: Option<Response>,
    place: Option<Pos2>,
    steps: Option<Steps>,
}

/// How a handle is held.
#[derive(Clone, Copy)]
struct Grasp {
    /// From the pointer to the middle of the handle, so that it does not jump when it is taken.
    to_middle: Vec2,
    /// Whether the pointer has moved since: to take a handle and let go changes nothing.
    is_moved: bool,
}

/// The handles of a pass so far.
#[derive(Clone, Default)]
struct Shown {
    pass: u64,
    places: Vec<(LayerId, Pos2)>,
}

impl Handle {
    /// Whether it is being dragged.
    #[must_use]
    pub fn is_dragged(&self) -> bool {
        self.response.as_ref().is_some_and(Response::dragged)
    }

    /// Whether it is pointed at, or dragged.
    #[must_use]
    pub fn is_touched(&self) -> bool {
        let is_touched = |response: &Response| response.hovered() || response.dragged();
        self.response.as_ref().is_some_and(is_touched)
    }

    /// Where its middle is to go; `None` while it is not moved.
    #[must_use]
    pub fn dragged_to(&self) -> Option<Pos2> {
        self.place
    }

    /// By what the arrow keys move it; `None` where none is pressed, or it has not got the focus.
    #[must_use]
    pub fn steps(&self) -> Option<Steps> {
        self.steps
    }

    /// Tells screen readers where it stands.
    pub fn says(&self, value: String) {
        if let Some(response) = &self.response {
            let set = |node: &mut accesskit::Node| node.set_value(value);
            response.ctx.accesskit_node_builder(response.id, set);
        }
    }
}

/// What a handle at `middle` covers: no label stands there.
#[must_use]
pub fn room(middle: Pos2) -> Rect {
    Rect::from_center_size(middle, Vec2::splat(2.0 * HANDLE_RADIUS + LABEL_GAP))
}

/// A handle at `middle`, with its name for tests and screen readers, and a tooltip that says what it does. It is there only inside
/// of `room`, but goes on while it is dragged. With the focus, which a press gives it, it takes the arrow keys.
#[must_use]
pub fn show(
    ui: &Ui,
    middle: Pos2,
    (id, name, room): (Id, &'static str, Rect),
    hint: &str,
    (color, palette): (Color32, &Palette),
) -> Handle {
    let is_held = ui.ctx().is_being_dragged(id);
    if !room.contains(middle) && !is_held {
        return Handle {
            response: None,
            place: None,
            steps: None,
        };
    }
    if still::is(ui) {
        ui.painter()
            .circle(middle, MARK_RADIUS, color, (1.5, palette.background));
        return Handle {
            response: None,
            place: None,
            steps: None,
        };
    }
    let response = ui
        .interact(grip(middle, &others(ui, middle)), id, Sense::drag())
        .on_hover_cursor(CursorIcon::Grab);
    response.widget_info(|| WidgetInfo::labeled(Role::GraphicsObject, ui.is_enabled(), name));
    let describe = |node: &mut accesskit::Node| node.set_description(hint.to_owned());
    ui.ctx().accesskit_node_builder(id, describe);
    hint::at_handle(&response, room, hint);
    let is_active = response.hovered() || response.dragged();
    let radius = HANDLE_RADIUS + if is_active { 2.0 } else { 0.0 };
    ui.painter()
        .circle(middle, radius, color, (2.0, palette.background));
    if response.drag_started() {
        response.request_focus();
    }
    if response.has_focus() {
        focus::is_shown(ui.ctx());
        let ring = ui.visuals().selection.stroke;
        ui.painter().circle_stroke(middle, radius + FOCUS_GAP, ring);
    }
    let place = place(ui.ctx(), &response, middle);
    let steps = steps::take(ui, id);
    Handle {
        response: Some(response),
        place,
        steps,
    }
}

/// Where a handle goes that was at `middle`.
fn place(ctx: &Context, response: &Response, middle: Pos2) -> Option<Pos2> {
    let pointer = response
        .interact_pointer_pos()
        .filter(|_| response.dragged())?;
    let id = response.id.with("grasp");
    let pressed_at = ctx.input(|input| input.pointer.press_origin());
    let taken = Grasp {
        to_middle: middle - pressed_at.unwrap_or(pointer),
        is_moved: false,
    };
    let kept = ctx
        .data(|data| data.get_temp::<Grasp>(id))
        .filter(|_| !response.drag_started());
    let mut grasp = kept.unwrap_or(taken);
    grasp.is_moved |= pressed_at.is_some_and(|from| from != pointer);
    ctx.data_mut(|data| data.insert_temp(id, grasp));
    grasp.is_moved.then_some(pointer + grasp.to_middle)
}

/// The handles of this pass that are shown already, on the same layer; this one joins them.
fn others(ui: &Ui, middle: Pos2) -> Vec<Pos2> {
    let (pass, layer) = (ui.ctx().cumulative_pass_nr(), ui.layer_id());
    ui.data_mut(|data| {
        let shown: &mut Shown = data.get_temp_mut_or_default(Id::unique("handles"));
        if shown.pass != pass {
            *shown = Shown {
                pass,
                places: Vec::new(),
            };
        }
        let of_layer = shown.places.iter().filter(|(of, _)| *of == layer);
        let others = of_layer.map(|(_, place)| *place).collect();
        shown.places.push((layer, middle));
        others
    })
}

/// Where a press takes the handle: within its reach, but no nearer to one of the `others`. These lie below it, so that it
/// is enough to leave them their half.
fn grip(middle: Pos2, others: &[Pos2]) -> Rect {
    let mut grip = Rect::from_center_size(middle, Vec2::splat(2.0 * HANDLE_REACH));
    for other in others {
        let apart = *other - middle;
        let half = middle + 0.5 * apart;
        if apart.x.abs() >= apart.y.abs() {
            if apart.x > 0.0 {
                grip.max.x = grip.max.x.min(half.x);
            } else {
                grip.min.x = grip.min.x.max(half.x);
            }
        } else if apart.y > 0.0 {
            grip.max.y = grip.max.y.min(half.y);
        } else {
            grip.min.y = grip.min.y.max(half.y);
        }
    }
    grip
}

#[cfg(test)]
mod tests {
    use egui::{Event, Modifiers, PointerButton, pos2, vec2};
    use egui_kittest::Harness;

    use super::*;

    /// Two handles that are dragged freely.
    type Pair = [Pos2; 2];

    fn drag_both(ui: &mut Ui, places: &mut Pair) {
        let palette = Palette::of(egui::Theme::Dark);
        for (index, place) in places.iter_mut().enumerate() {
            let named = (Id::unique("handle").with(index), "Handle", ui.clip_rect());
            let handle = show(ui, *place, named, "", (Color32::WHITE, &palette));
            if let Some(to) = handle.dragged_to() {
                *place = to;
            }
        }
    }

    fn press(at: Pos2, pressed: bool) -> Event {
        Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    /// The handles after a drag from `at` by `by`.
    fn dragged(places: Pair, at: Pos2, by: Vec2) -> Pair {
        let mut harness = Harness::new_ui_state(drag_both, places);
        for event in [
            Event::PointerMoved(at),
            press(at, true),
            Event::PointerMoved(at + by),
            press(at + by, false),
        ] {
            harness.event(event);
            harness.step();
        }
        *harness.state()
    }

    #[test]
    fn a_handle_is_taken_within_its_reach_and_does_not_jump() {
        let places = [pos2(100.0, 100.0), pos2(300.0, 100.0)];
        let by = vec2(40.0, -30.0);
        for off in [
            Vec2::ZERO,
            vec2(19.0, 0.0),
            vec2(0.0, -19.0),
            vec2(-13.0, 13.0),
        ] {
            let [moved, other] = dragged(places, places[0] + off, by);
            assert_eq!([moved, other], [places[0] + by, places[1]], "{off:?}");
        }
        assert_eq!(dragged(places, places[0] + vec2(29.0, 0.0), by), places);
        assert_eq!(
            dragged(places, places[0] + vec2(5.0, 5.0), Vec2::ZERO),
            places
        );
    }

    #[test]
    fn of_two_handles_the_nearer_one_is_taken() {
        let by = vec2(60.0, 25.0);
        for apart in [
            vec2(16.0, 4.0),
            vec2(-16.0, 4.0),
            vec2(4.0, 16.0),
            vec2(4.0, -16.0),
        ] {
            let places = [pos2(150.0, 150.0), pos2(150.0, 150.0) + apart];
            for nearer in [0, 1] {
                let at = places[nearer] + vec2(1.0, 1.0);
                let after = dragged(places, at, by);
                assert_eq!(after[nearer], places[nearer] + by, "{apart:?}");
                assert_eq!(after[1 - nearer], places[1 - nearer], "{apart:?}");
            }
        }
    }
}
