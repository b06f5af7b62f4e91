//! What the question of a lesson keeps covered until it is answered: parts of the window that would say the answer.

use egui::{Context, Id, RichText, Ui};

use bxdf_study::lessons::Cover;

/// What stands in the place of what is covered.
pub const INSTEAD: &str = "– shown with the answer";

/// Why it does.
pub const WHY: &str = "The question of the lesson asks for it: it is shown once that is answered";

/// A line in the place of what is covered.
pub fn stand_in(ui: &mut Ui, what: &str) {
    let text = RichText::new(format!("{what} {INSTEAD}")).small();
    ui.weak(text).on_hover_text(WHY);
}

fn id() -> Id {
    Id::unique("covered")
}

/// Covers these parts, and no others, from here on.
pub fn cover(ctx: &Context, covers: Vec<Cover>) {
    ctx.data_mut(|data| data.insert_temp(id(), covers));
}

/// Whether a part is covered.
#[must_use]
pub fn is_covered(ctx: &Context, part: Cover) -> bool {
    let covers: Option<Vec<Cover>> = ctx.data(|data| data.get_temp(id()));
    covers.is_some_and(|covers| covers.contains(&part))
}
