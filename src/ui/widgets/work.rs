//! What the history must know of controls that take keys: these are no longer there to be seen.

use egui::{Context, Id};

/// What a control did to its value in this frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// A typed number was accepted: that is a step by itself, whatever else the frame brings.
    Entered,
    /// Keys moved the value of this control.
    Moved(Id),
}

fn place() -> Id {
    Id::unique("work of controls")
}

/// Says what a control has done in this frame.
pub fn note(ctx: &Context, work: Work) {
    let pass = ctx.cumulative_pass_nr();
    ctx.data_mut(|data| data.insert_temp(place(), (pass, work)));
}

/// What a control did in this frame.
#[must_use]
pub fn done(ctx: &Context) -> Option<Work> {
    let last: Option<(u64, Work)> = ctx.data(|data| data.get_temp(place()));
    let (pass, work) = last?;
    (pass == ctx.cumulative_pass_nr()).then_some(work)
}
