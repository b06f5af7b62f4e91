//! What the history must know of the fields: keys that they took are no longer there to be seen.

use egui::{Context, Id};

/// What a field did to its value in this frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// A typed number was accepted: that is a step by itself, whatever else the frame brings.
    Entered,
    /// Keys moved the value of this field.
    Moved(Id),
}

fn place() -> Id {
    Id::unique("work of number fields")
}

pub(super) fn note(ctx: &Context, work: Work) {
    let pass = ctx.cumulative_pass_nr();
    ctx.data_mut(|data| data.insert_temp(place(), (pass, work)));
}

/// What a field did in this frame.
#[must_use]
pub fn done(ctx: &Context) -> Option<Work> {
    let last: Option<(u64, Work)> = ctx.data(|data| data.get_temp(place()));
    let (pass, work) = last?;
    (pass == ctx.cumulative_pass_nr()).then_some(work)
}
