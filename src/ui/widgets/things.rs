//! Words and the things they stand for: pointing at the one marks the other.

use egui::{Color32, Context, Id, Pos2, Rect, Stroke, StrokeKind, Ui};

use crate::theme::{HANDLE_RADIUS, Palette};
use bxdf_study::lessons::Thing;

/// From the edge of a handle to the ring that marks it, in points.
const RING_GAP: f32 = 7.0;

/// The width of a mark, in points.
const MARK_WIDTH: f32 = 2.5;

/// By what a thing is pointed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// By words that stand for it.
    Words,
    /// Where it stands.
    Place,
}

/// What is pointed at in a pass.
#[derive(Clone, Default)]
struct Pointed {
    pass: u64,
    now: Vec<(Thing, By)>,
    before: Vec<(Thing, By)>,
}

impl Pointed {
    /// What was pointed at in the pass before this one, or in this one.
    fn at(mut self, pass: u64) -> Self {
        if self.pass + 1 == pass {
            self.before = std::mem::take(&mut self.now);
        } else if self.pass != pass {
            (self.now, self.before) = (Vec::new(), Vec::new());
        }
        self.pass = pass;
        self
    }
}

fn read(ctx: &Context) -> Pointed {
    let pointed: Option<Pointed> = ctx.data(|data| data.get_temp(Id::NULL));
    pointed.unwrap_or_default().at(ctx.cumulative_pass_nr())
}

/// Says that a thing is pointed at.
pub fn point(ctx: &Context, thing: &Thing, by: By) {
    let mut pointed = read(ctx);
    let one = (thing.clone(), by);
    if !pointed.now.contains(&one) {
        if !pointed.before.contains(&one) {
            // Its other side stands elsewhere, and may have been drawn already.
            ctx.request_repaint();
        }
        pointed.now.push(one);
    }
    ctx.data_mut(|data| data.insert_temp(Id::NULL, pointed));
}

/// Whether a thing is pointed at so.
#[must_use]
pub fn is_pointed(ctx: &Context, thing: &Thing, by: By) -> bool {
    let pointed = read(ctx);
    let mut all = pointed.now.iter().chain(&pointed.before);
    all.any(|one| one.0 == *thing && one.1 == by)
}

/// The things that words point at.
#[must_use]
pub fn pointed_by_words(ctx: &Context) -> Vec<Thing> {
    let pointed = read(ctx);
    let mut things = Vec::new();
    for (thing, by) in pointed.now.into_iter().chain(pointed.before) {
        if by == By::Words && !things.contains(&thing) {
            things.push(thing);
        }
    }
    things
}

/// The colour that a thing has everywhere.
#[must_use]
pub fn color(thing: &Thing, palette: &Palette, lobe: Color32) -> Color32 {
    match thing {
        Thing::Light => palette.light,
        Thing::Viewer => palette.viewer,
        Thing::Mirror => palette.mirror,
        Thing::Half => palette.geometry,
        Thing::Lobe | Thing::Material(_) => lobe,
        Thing::Normal | Thing::View(_) | Thing::Control(_) => palette.ink,
    }
}

/// Marks a handle that words point at.
pub fn ring(ui: &Ui, middle: Pos2, thing: &Thing, palette: &Palette) {
    if is_pointed(ui.ctx(), thing, By::Words) {
        let stroke = Stroke::new(MARK_WIDTH, palette.accent_line);
        ui.painter()
            .circle_stroke(middle, HANDLE_RADIUS + RING_GAP, stroke);
    }
}

/// Marks a place that words point at.
pub fn frame(ui: &Ui, place: Rect, thing: &Thing, palette: &Palette) {
    if is_pointed(ui.ctx(), thing, By::Words) {
        let stroke = Stroke::new(MARK_WIDTH, palette.accent_line);
        ui.painter()
            .rect_stroke(place.expand(2.0), 3.0, stroke, StrokeKind::Outside);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_pointed_at_is_marked_in_this_pass_and_the_next() {
        let ctx = Context::default();
        let mut seen = Vec::new();
        for pass in 0..4 {
            let mut output = ctx.run_ui(egui::RawInput::default(), |ui| {
                let by = |by| is_pointed(ui.ctx(), &Thing::Light, by);
                seen.push((by(By::Words), by(By::Place)));
                if pass == 1 {
                    point(ui.ctx(), &Thing::Light, By::Words);
                }
            });
            output.textures_delta.clear();
        }
        assert_eq!(
            seen,
            [
                (false, false),
                (false, false),
                (true, false),
                (false, false)
            ]
        );
    }
}
