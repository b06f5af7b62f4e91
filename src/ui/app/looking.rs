//! Which changes of the camera are one move.

use egui::Context;

use bxdf_study::history::Control;

/// A pause of the wheel of this many seconds ends a move.
const PAUSE: f64 = 0.4;

/// The move of the camera that was made last: one drag, or turns of the wheel without a pause.
#[derive(Debug, Default)]
pub struct Looking {
    number: u64,
    /// When the button went down, and when the camera was last moved, in seconds.
    last: Option<(Option<f64>, f64)>,
}

impl Looking {
    /// What the move of this frame belongs to.
    pub fn control(&mut self, ctx: &Context) -> Control {
        let (pressed, now) = ctx.input(|input| {
            let is_down = input.pointer.any_down();
            let pressed = input.pointer.press_start_time().filter(|_| is_down);
            (pressed, input.time)
        });
        let is_same = self.last.is_some_and(|(before, at)| {
            before == pressed && (pressed.is_some() || now - at < PAUSE)
        });
        if !is_same {
            self.number += 1;
        }
        self.last = Some((pressed, now));
        // Moves are no controls: they are counted down from where no id is likely.
        Control(u64::MAX - self.number)
    }
}
