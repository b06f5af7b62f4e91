//! Lessons in the window: what becomes of the session at each step, and of the answers.

use std::sync::Arc;

use egui::{Context, Panel, RichText, Ui};

use super::App;
use super::learning::{At, begun};
use crate::theme::{self, Palette};
use crate::widgets::lesson::{self, Done, Prose, Shown, Turn};
use crate::widgets::things;
use bxdf_study::lessons::{Cover, Lesson, Scenes, Shelf, Thing, Work};
use bxdf_study::link;
use bxdf_study::session::{Session, ViewId};
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
        self.begin_step();
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
            let is_revealed = at.works.get(step).is_some_and(Work::is_revealed);
            self.begin_step();
            if is_revealed && let Some(at) = &self.learning.at {
                // What was answered once is seen with its answer.
                let _ = at.lesson.state_after(step, &mut self.session);
            }
        }
    }

    /// Puts the state that the step begins with in place of the session.
    fn begin_step(&mut self) {
        let begun = self.learning.at.as_ref().map(|at| at.begun.clone());
        let document = begun.map(|begun| self.replace(begun));
        if let (Some(at), Some(document)) = (&mut self.learning.at, document) {
            (at.before, at.document) = (None, document);
        }
    }

    /// Changes the session for the lesson. Where another one has come meanwhile, what comes of it is a session by itself: the file of
    /// that one is not written over with it.
    fn change_for(&mut self, at: &mut At, change: impl FnOnce(&mut Session)) {
        let mut session = self.session.clone();
        change(&mut session);
        if self.history.document() == at.document {
            self.session = session;
        } else if session != self.session {
            at.document = self.replace(session);
        }
    }

    /// Shows the state behind the question.
    fn show_answer(&mut self, at: &mut At) {
        if let Some(Some(after)) = at.lesson.steps.get(at.step).map(|step| step.after.clone()) {
            self.change_for(at, |session| {
                let _ = after.apply(session);
            });
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
        match self.step_link() {
            Some(named) if self.links.page.is_some() => self.give_link(link::to_step(&named), ctx),
            Some(named) => ctx.copy_text(named),
            None => {}
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
            Some(Turn::Again) => self.begin_step(),
            Some(Turn::Question(done)) => self.take_answer(&done),
            Some(Turn::Copy) => self.copy_step_link(ui.ctx()),
            None => {}
        }
        if is_left {
            self.learning.at = None;
            self.learning.is_new = is_by_key(ui.ctx());
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
            self.show_answer(at);
        }
    }

    fn take_answer(&mut self, done: &Done) {
        let Some(mut at) = self.learning.at.take() else {
            return;
        };
        let scenes = Arc::clone(&at.scenes);
        let step = at.lesson.steps.get(at.step).cloned();
        let ask = step.as_ref().and_then(|step| step.ask.as_ref());
        if let (Some(ask), Some(mut work)) = (ask, at.works.get(at.step).cloned()) {
            let was_revealed = work.is_revealed();
            match done {
                Done::Choose(index) => work.choose(ask, *index, &scenes),
                Done::Submit => work.submit(ask, &scenes),
                Done::LookUp => {
                    if let Some(solution) = work.look_up(ask, &scenes) {
                        self.change_for(&mut at, |session| {
                            let _ = solution.apply(session);
                        });
                    }
                }
                Done::Show => {
                    if let Some(shown) = work.shown(ask, &self.session) {
                        at.before = Some(self.session.clone());
                        self.change_for(&mut at, |session| *session = shown);
                    }
                }
                Done::Back => self.go_back(&mut at),
            }
            if work.is_revealed() && !was_revealed {
                self.go_back(&mut at);
                self.show_answer(&mut at);
                if !work.is_looked_up
                    && let Some(step) = &step
                {
                    self.learning.progress.answer(&at.lesson.id, &step.title);
                }
            }
            if let Some(kept) = at.works.get_mut(at.step) {
                *kept = work;
            }
        }
        self.learning.at = Some(at);
    }

    /// Goes back from what a wrong answer would look like.
    fn go_back(&mut self, at: &mut At) {
        if let Some(before) = at.before.take() {
            self.change_for(at, |session| *session = before);
        }
    }

    /// What the question at hand keeps covered of the session that it is about: nothing once it is answered, or while it is not to be seen.
    pub(crate) fn covers(&self) -> Vec<Cover> {
        let at = self.learning.at.as_ref();
        let is_about = |at: &&At| self.learning.is_shown && at.document == self.history.document();
        let asked = at.filter(is_about).and_then(At::open);
        asked.map_or_else(Vec::new, |ask| ask.covers.clone())
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
