//! What a key did, said for a moment.

use std::time::Duration;

use egui::{Align2, Area, Context, Frame, Id, Label, Order, Rect, vec2};

/// For how long it is said, in seconds.
const SECONDS: f64 = 2.0;

/// How many characters of a longer one are read in a second.
const READ_PER_SECOND: f64 = 16.0;

/// From the lower edge of the views, in points.
const ABOVE_EDGE: f32 = 14.0;

/// What is said, if anything.
#[derive(Debug, Default)]
pub struct Said(Option<Line>);

/// A line, and when it goes.
#[derive(Debug)]
struct Line {
    text: String,
    /// In seconds of the window's time.
    until: f64,
}

impl Said {
    /// Says `text` from now on, in place of what was said before.
    pub fn say(&mut self, text: String, ctx: &Context) {
        let seconds = SECONDS.max(text.chars().count() as f64 / READ_PER_SECOND);
        let until = ctx.input(|input| input.time) + seconds;
        self.0 = Some(Line { text, until });
    }

    /// Shows it at the lower edge of `room`, until its time is over.
    pub fn show(&mut self, ctx: &Context, room: Rect) {
        let now = ctx.input(|input| input.time);
        self.0.take_if(|line| line.until <= now);
        let Some(line) = &self.0 else { return };
        ctx.request_repaint_after(Duration::from_secs_f64(line.until - now));
        Area::new(Id::unique("said"))
            .order(Order::Tooltip)
            .interactable(false)
            .pivot(Align2::CENTER_BOTTOM)
            .fixed_pos(room.center_bottom() - vec2(0.0, ABOVE_EDGE))
            .show(ctx, |ui| {
                // The area keeps the width of what was said before: a longer line is not broken for that.
                Frame::popup(ui.style()).show(ui, |ui| ui.add(Label::new(&line.text).extend()));
            });
    }
}
