//! Which control keys and drags work on.

use egui::{Context, Event, Key};

use crate::widgets::work::{self, Work};

/// Keys that change the value of a control a little at a time.
const MOVING_OR_TYPING: [Key; 6] = [
    Key::ArrowLeft,
    Key::ArrowRight,
    Key::ArrowUp,
    Key::ArrowDown,
    Key::Backspace,
    Key::Delete,
];

/// How long a button may be down for a click, in seconds: egui's own .8 would lose those that a slow frame lies between.
const MAX_CLICK: f64 = 3.0;

/// Has egui take a press and a release for a click even where frames are slow.
pub(crate) fn allow_slow_clicks(ctx: &Context) {
    ctx.options_mut(|options| options.input_options.max_click_duration = MAX_CLICK);
}

/// The control whose edits are one step together: the one that is dragged, or the one that has the keyboard while keys
/// that move or type are pressed. A number that is typed is a step of its own.
pub(crate) fn control_at_work(ctx: &Context) -> Option<egui::Id> {
    if let Some(work) = work::done(ctx) {
        return match work {
            Work::Entered => None,
            Work::Moved(id) => Some(id),
        };
    }
    let dragged = ctx.dragged_id().or(ctx.drag_stopped_id());
    let is_key = |event: &Event| match event {
        Event::Text(_) => true,
        Event::Key { key, pressed, .. } => *pressed && MOVING_OR_TYPING.contains(key),
        _ => false,
    };
    let is_keyed = ctx.input(|input| input.events.iter().any(is_key));
    dragged.or_else(|| ctx.memory(egui::Memory::focused).filter(|_| is_keyed))
}
