//! Arrow keys that move what has the focus, where that is no number but a place.

use egui::{Event, EventFilter, Id, InputState, Key, Ui};

use super::work::{self, Work};

/// What a press moves it by, and what it does with Shift: degrees, where it is a direction.
const STEPS: [f64; 2] = [1.0, 0.1];

/// What the arrow keys of a frame ask for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Steps {
    /// To the right.
    pub right: f64,
    /// Upwards.
    pub up: f64,
}

/// Takes the arrow keys for the control `id`, if it has the focus: they move the focus on no longer. All that are pressed in a
/// row are one step of the history.
#[must_use]
pub fn take(ui: &Ui, id: Id) -> Option<Steps> {
    let arrows = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..EventFilter::default()
    };
    let has_focus = ui.memory_mut(|memory| {
        memory.set_focus_lock_filter(id, arrows);
        memory.has_focus(id)
    });
    let steps = ui.input_mut(|input| has_focus.then(|| pressed(input)).flatten())?;
    work::note(ui.ctx(), Work::Moved(id));
    Some(steps)
}

/// Takes the arrow keys out of the events.
fn pressed(input: &mut InputState) -> Option<Steps> {
    let mut steps: Option<Steps> = None;
    input.events.retain(|event| {
        let Event::Key {
            key,
            pressed: true,
            modifiers,
            ..
        } = event
        else {
            return true;
        };
        if modifiers.alt || modifiers.command {
            return true;
        }
        let [coarse, fine] = STEPS;
        let step = if modifiers.shift { fine } else { coarse };
        let [right, up] = match key {
            Key::ArrowRight => [step, 0.0],
            Key::ArrowLeft => [-step, 0.0],
            Key::ArrowUp => [0.0, step],
            Key::ArrowDown => [0.0, -step],
            _ => return true,
        };
        let sum = steps.get_or_insert_default();
        (sum.right, sum.up) = (sum.right + right, sum.up + up);
        false
    });
    steps
}
