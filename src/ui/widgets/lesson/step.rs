//! A step of a lesson, with the way to the ones before and after it.

use egui::{Align, Button, Layout, RichText, ScrollArea, Ui, UiBuilder};

use super::prose::Prose;
use super::question::{self, Done};
use crate::widgets::things::{self, By};
use bxdf_study::lessons::{Ask, Lesson, Work};

/// What the line with the way to other steps needs besides its buttons, in points.
const WAY: f32 = 28.0;

/// What is wished of a lesson.
#[derive(Clone, Debug, PartialEq)]
pub enum Turn {
    /// To go to the step at this index.
    To(usize),
    /// To see the state of the step as it begins.
    Again,
    /// What was done at the question.
    Question(Done),
    /// To copy what leads to this step.
    Copy,
}

/// Whether and how a step is shown.
pub struct Shown<'a> {
    /// The lesson.
    pub lesson: &'a Lesson,
    /// The step at hand: an index.
    pub step: usize,
    /// Whether the views show what a wrong answer would look like.
    pub is_other: bool,
    /// Whether the state is that of the step.
    pub is_as_begun: bool,
    /// Whether the step has just come: the keyboard goes on from it.
    pub is_new: bool,
}

/// The step. Returns what is wished.
pub fn show(
    ui: &mut Ui,
    shown: &Shown<'_>,
    work: &mut Work,
    prose: &mut Prose<'_>,
) -> Option<Turn> {
    let Shown { lesson, step, .. } = shown;
    let count = lesson.steps.len();
    let at = lesson.steps.get(*step)?;
    let mut turn = None;
    let below = ui.spacing().interact_size.y + WAY;
    let area = ScrollArea::vertical()
        .id_salt(("step", &lesson.id, *step))
        .auto_shrink([false, false])
        .max_height((ui.available_height() - below).max(80.0));
    // What stands in one step is nothing of another: no focus goes from a field of one to a button of the next.
    let own = UiBuilder::new().id_salt((&lesson.id, *step));
    area.show(ui, |ui| {
        ui.scope_builder(own, |ui| {
            ui.set_max_width(ui.available_width() - crate::theme::SCROLL_ROOM);
            ui.label(RichText::new(&at.title).size(prose.size + 3.0).strong());
            ui.add_space(4.0);
            prose.blocks(ui, &at.text);
            if let Some(ask) = &at.ask {
                let done = question::show(ui, (ask, work), (shown.is_other, shown.is_new), prose);
                turn = done.map(Turn::Question);
                if work.is_revealed() {
                    ui.add_space(6.0);
                    prose.blocks(ui, &at.answer);
                }
            }
            ui.horizontal_wrapped(|ui| {
                let again =
                    ui.add_enabled(!shown.is_as_begun, Button::new("Step from its beginning"));
                let hint = "Show again what this step begins with";
                if again.on_hover_text(hint).clicked() {
                    turn = Some(Turn::Again);
                }
                let hint = "Copies what opens this step elsewhere";
                if ui.button("Copy link").on_hover_text(hint).clicked() {
                    turn = Some(Turn::Copy);
                }
            });
        })
    });
    // What a step points out is marked for as long as it is read.
    for thing in &at.shows {
        things::point(ui.ctx(), thing, By::Words);
    }
    ui.separator();
    ui.horizontal(|ui| {
        let back = ui.add_enabled(*step > 0, Button::new("◀ Back"));
        if back.on_hover_text("The step before (Page Up)").clicked() {
            turn = Some(Turn::To(step - 1));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let next = ui.add_enabled(step + 1 < count, Button::new("Next ▶"));
            let has_choices = at.ask.as_ref().is_some_and(Ask::is_choice);
            if shown.is_new && !has_choices {
                next.request_focus();
            }
            if next.on_hover_text("The next step (Page Down)").clicked() {
                turn = Some(Turn::To(step + 1));
            }
            ui.label(format!("Step {} of {count}", step + 1));
        });
    });
    turn
}
