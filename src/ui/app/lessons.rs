//! Lessons in the window: what becomes of the session at each step, and of the answers.

use std::sync::Arc;

use egui::{Context, Panel, RichText, Ui};

use super::App;
use super::learning::{At, begun};
use crate::theme::{self, Palette};
use crate::widgets::lesson::{self, Done, Prose, Shown, Turn};
use crate::widgets::things;
use bxdf_study::lessons::{Lesson, Scenes, Shelf, Thing, Work};
use bxdf_study::session::ViewId;
use bxdf_study::store::Progress;

impl App {
    /// Shows the panel of lessons, or hides it.
    pub fn switch_learning(&mut self, ctx: &Context) {
        self.learning.is_shown ^= true;
        self.learning.is_new = self.learning.is_shown && is_by_key(ctx);
    }

    /// Whether the panel of lessons is shown.
    #[must_use]
    pub fn is_learning(&self) -> bool {
        self.learning.is_shown
    }

    /// Opens a lesson at a step: its state comes in place of the session, which can be undone.
    pub fn open_lesson(&mut self, lesson: &Lesson, step: usize) {
        let mut room = self.room_of_views();
        if !self.learning.is_seen {
            // The panel will stand beside them, or below.
            let [width, height] = &mut room;
            if self.is_lesson_below(*width) {
                *height *= 1.0 - theme::LESSON_HEIGHT_SHARE;
            } else {
                *width -= theme::LESSON_WIDTH.min(*width * theme::LESSON_SHARE);
            }
        }
        self.learning.is_shown = true;
        self.learning.at = At::of(lesson.clone(), step, room);
        if let Some(at) = &self.learning.at {
            self.session.clone_from(&at.begun);
        }
    }

    /// Shows the lessons of a file or a folder in the list; a single one is opened.
    pub(super) fn take_lessons(&mut self, shelf: Shelf) {
        self.notice.say_all(&shelf.problems);
        self.learning.is_shown = true;
        for lesson in shelf.lessons {
            let is_other = |other: &Lesson| other.id != lesson.id;
            self.learning.opened.retain(is_other);
            self.learning.opened.push(lesson);
        }
        self.learning.at = None;
        if let [lesson] = &self.learning.opened[..] {
            let lesson = lesson.clone();
            self.open_lesson(&lesson, 0);
        }
    }

    /// Whether there is a step so many places on.
    #[must_use]
    pub fn has_step(&self, by: isize) -> bool {
        let is_there = |at: &At| {
            let step = at.step.checked_add_signed(by);
            step.is_some_and(|step| step < at.lesson.steps.len())
        };
        self.learning.is_shown && self.learning.at.as_ref().is_some_and(is_there)
    }

    /// Lets the keyboard go on from the step that has just come, where a key has brought it.
    pub fn attend_step(&mut self, ctx: &Context) {
        if let Some(at) = &mut self.learning.at {
            at.is_new = is_by_key(ctx);
        }
    }

    /// Goes so many steps on.
    pub fn step(&mut self, by: isize, ctx: &Context) {
        let at = self.learning.at.as_ref();
        let step = at.and_then(|at| at.step.checked_add_signed(by));
        if let Some(step) = step.filter(|_| self.has_step(by)) {
            self.go_to_step(step);
            self.attend_step(ctx);
        }
    }

    /// Goes to a step, which begins with its own state.
    fn go_to_step(&mut self, step: usize) {
        let room = self.room_of_views();
        let Some(at) = &mut self.learning.at else {
            return;
        };
        if let Some(begun) = begun(&at.lesson, step, room) {
            (at.step, at.before, at.is_after_due) = (step, None, false);
            at.is_new = false;
            at.begun = begun;
            self.session.clone_from(&at.begun);
            let is_revealed = at.works.get(step).is_some_and(Work::is_revealed);
            if is_revealed {
                // What was answered once is seen with its answer.
                let _ = at.lesson.state_after(step, &mut self.session);
            }
        }
    }

    /// What leads to the step at hand: the word for it at the command line.
    #[must_use]
    pub fn step_link(&self) -> Option<String> {
        let at = self.learning.at.as_ref()?;
        Some(format!("{}.{}", at.lesson.id, at.step + 1))
    }

    /// Copies what leads to the step at hand.
    pub fn copy_step_link(&mut self, ctx: &Context) {
        if let Some(link) = self.step_link() {
            ctx.copy_text(link);
        }
    }

    /// The panel, where it is shown.
    pub(crate) fn show_lessons(&mut self, ui: &mut Ui, palette: &Palette) {
        self.learning.is_seen = self.learning.is_shown;
        if !self.learning.is_shown {
            return;
        }
        let is_large = self.is_presenting();
        if self.is_lesson_below(ui.available_width()) {
            let height = ui.available_height() * theme::LESSON_HEIGHT_SHARE;
            Panel::bottom("lesson below")
                .resizable(false)
                .exact_size(height)
                .show(ui, |ui| self.show_lesson(ui, palette, theme::LESSON_TEXT));
            return;
        }
        let (id, width, size) = if is_large {
            (
                "large lesson",
                theme::LARGE_LESSON_WIDTH,
                theme::LARGE_LESSON_TEXT,
            )
        } else {
            ("lesson", theme::LESSON_WIDTH, theme::LESSON_TEXT)
        };
        let share = ui.available_width() * theme::LESSON_SHARE;
        Panel::right(id)
            .resizable(false)
            .exact_size(width.min(share))
            .show(ui, |ui| self.show_lesson(ui, palette, size));
    }

    /// Whether the panel stands below the view, in a room of this `width`: there is none beside it.
    fn is_lesson_below(&self, width: f32) -> bool {
        self.is_small() && width < theme::SMALL_WINDOW.x
    }

    /// The step at hand, in letters of this `size`, or the list.
    fn show_lesson(&mut self, ui: &mut Ui, palette: &Palette, size: f32) {
        ui.add_space(4.0);
        if self.learning.at.is_some() {
            self.show_step(ui, palette, size);
        } else {
            self.show_list(ui, palette);
        }
    }

    fn show_list(&mut self, ui: &mut Ui, palette: &Palette) {
        ui.horizontal(|ui| {
            ui.label(RichText::new("Learn").heading());
            let has_progress = !self.learning.progress.is_empty();
            let reset = ui.add_enabled(has_progress, egui::Button::new("Forget answers"));
            let hint = "Forget which questions were answered";
            if reset.on_hover_text(hint).clicked() {
                self.learning.progress = Progress::default();
            }
        });
        let mut typed = std::mem::take(&mut self.learning.typed);
        let is_new = std::mem::take(&mut self.learning.is_new);
        let groups = self.learning.groups();
        let look = (&self.learning.progress, palette);
        let chosen = lesson::list(ui, &groups, (&mut typed, is_new), look);
        let chosen = chosen.and_then(|(of, place)| groups.get(of)?.lessons.get(place).cloned());
        self.learning.typed = typed;
        if let Some(lesson) = chosen {
            self.open_lesson(&lesson, 0);
            self.attend_step(ui.ctx());
        }
    }

    fn show_step(&mut self, ui: &mut Ui, palette: &Palette, size: f32) {
        let Some(mut at) = self.learning.at.take() else {
            return;
        };
        let mut is_left = false;
        ui.horizontal_wrapped(|ui| {
            is_left = ui
                .button("☰ All")
                .on_hover_text("All lessons and questions")
                .clicked();
            ui.label(RichText::new(&at.lesson.title).weak());
        });
        ui.separator();
        let scenes = Scenes::of(&self.session);
        if *at.scenes != scenes {
            at.scenes = Arc::new(scenes);
        }
        self.look_at_state(&mut at);
        self.go_behind_question(&mut at, ui.ctx());
        let mut work = at.works.get(at.step).cloned().unwrap_or_default();
        let shown = Shown {
            lesson: &at.lesson,
            step: at.step,
            is_other: at.before.is_some(),
            is_as_begun: self.session == at.begun,
            is_new: std::mem::take(&mut at.is_new),
        };
        let mut prose = Prose {
            scenes: &at.scenes,
            session: &self.session,
            answers: &mut self.answers,
            palette,
            size,
        };
        let turn = lesson::step(ui, &shown, &mut work, &mut prose);
        if let Some(kept) = at.works.get_mut(at.step) {
            *kept = work;
        }
        self.learning.at = Some(at);
        match turn {
            Some(Turn::To(step)) => {
                self.go_to_step(step);
                self.attend_step(ui.ctx());
            }
            Some(Turn::Again) => self.begin_step_again(),
            Some(Turn::Question(done)) => self.take_answer(&done),
            Some(Turn::Copy) => self.copy_step_link(ui.ctx()),
            None => {}
        }
        if is_left {
            self.learning.at = None;
            self.learning.is_new = is_by_key(ui.ctx());
        }
    }

    fn begin_step_again(&mut self) {
        if let Some(at) = &mut self.learning.at {
            at.before = None;
            self.session.clone_from(&at.begun);
        }
    }

    /// Looks whether the state is reached that the step asks for.
    fn look_at_state(&mut self, at: &mut At) {
        let (step, scenes) = (at.step, Arc::clone(&at.scenes));
        let is_reached = match (at.lesson.steps.get(step), at.works.get_mut(step)) {
            (Some(lesson), Some(work)) => {
                let ask = lesson.ask.as_ref();
                ask.is_some_and(|ask| work.look(ask, &scenes))
            }
            _ => false,
        };
        if is_reached && let Some(step) = at.lesson.steps.get(step) {
            self.learning.progress.answer(&at.lesson.id, &step.title);
            at.is_after_due = true;
        }
    }

    /// Shows the state behind the question that was answered by hand, once the hand is off.
    fn go_behind_question(&mut self, at: &mut At, ctx: &Context) {
        if at.is_after_due && ctx.dragged_id().is_none() {
            at.is_after_due = false;
            let _ = at.lesson.state_after(at.step, &mut self.session);
        }
    }

    fn take_answer(&mut self, done: &Done) {
        let Some(mut at) = self.learning.at.take() else {
            return;
        };
        let ask = at.ask().cloned();
        let scenes = Arc::clone(&at.scenes);
        if let (Some(ask), Some(work)) = (ask, at.works.get_mut(at.step)) {
            let was_revealed = work.is_revealed();
            match done {
                Done::Choose(index) => work.choose(&ask, *index, &scenes),
                Done::Submit => work.submit(&ask, &scenes),
                Done::LookUp => {
                    if let Some(solution) = work.look_up(&ask, &scenes) {
                        let _ = solution.apply(&mut self.session);
                    }
                }
                Done::Show => {
                    if let Some(shown) = work.shown(&ask, &self.session) {
                        at.before = Some(std::mem::replace(&mut self.session, shown));
                    }
                }
                Done::Back => {
                    if let Some(before) = at.before.take() {
                        self.session = before;
                    }
                }
            }
            if work.is_revealed() && !was_revealed {
                let is_answered = !work.is_looked_up;
                if let Some(before) = at.before.take() {
                    self.session = before;
                }
                let _ = at.lesson.state_after(at.step, &mut self.session);
                if is_answered && let Some(step) = at.lesson.steps.get(at.step) {
                    self.learning.progress.answer(&at.lesson.id, &step.title);
                }
            }
        }
        self.learning.at = Some(at);
    }

    /// Marks a view that words of a lesson point at.
    pub(crate) fn mark_view(&self, ui: &Ui, view: ViewId, palette: &Palette) {
        if let Some(kind) = self.session.views.kind(view) {
            let thing = Thing::View(kind.id.to_owned());
            things::frame(ui, ui.max_rect(), &thing, palette);
        }
    }
}

/// Whether what is done in this frame is done by a key: no button of the pointer has just come up.
fn is_by_key(ctx: &Context) -> bool {
    !ctx.input(|input| input.pointer.any_released())
}
