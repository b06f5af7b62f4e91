//! Which lesson is open, at which step, and what was made of its questions.

use std::sync::Arc;

use crate::widgets::lesson::Group;
use bxdf_study::history::Document;
use bxdf_study::lessons::{self, Ask, Lesson, Scenes, Work};
use bxdf_study::session::Session;
use bxdf_study::store::Progress;

/// The panel of lessons, while it is there.
#[derive(Default)]
pub struct Learning {
    /// Whether it is shown.
    pub(super) is_shown: bool,
    /// Whether it was in the last frame.
    pub(super) is_seen: bool,
    /// The lessons that a person opened.
    pub(super) opened: Vec<Lesson>,
    /// Whether the list has just come by a key.
    pub(super) is_new: bool,
    /// What is looked for in the list.
    pub(super) typed: String,
    /// The lesson at hand.
    pub(super) at: Option<At>,
    /// Which questions were answered.
    pub(super) progress: Progress,
}

/// A lesson, and a step of it.
pub(super) struct At {
    pub(super) lesson: Lesson,
    pub(super) step: usize,
    /// The work at the question of each step.
    pub(super) works: Vec<Work>,
    /// What the numbers of the text are computed of.
    pub(super) scenes: Arc<Scenes>,
    /// The state that the step begins with.
    pub(super) begun: Session,
    /// Which session the lesson works on: none other is changed by it.
    pub(super) document: Document,
    /// The session before what a wrong answer would look like was shown.
    pub(super) before: Option<Session>,
    /// Whether the state behind the question is to be shown, once nothing is in the hand.
    pub(super) is_after_due: bool,
    /// Whether the step has just come by a key, which goes on with it.
    pub(super) is_new: bool,
}

impl At {
    /// A step of a lesson, in a window with this room for views. Nothing, where its state cannot be had: it was refused when it was read.
    pub(super) fn of(lesson: Lesson, step: usize, room: [f32; 2]) -> Option<Self> {
        let begun = begun(&lesson, step, room)?;
        Some(Self {
            works: vec![Work::default(); lesson.steps.len()],
            scenes: Arc::new(Scenes::of(&begun)),
            begun,
            document: Document::default(),
            before: None,
            is_after_due: false,
            is_new: false,
            lesson,
            step,
        })
    }

    /// The question of the step, before it is answered.
    pub(super) fn open(&self) -> Option<&Ask> {
        let ask = self.lesson.steps.get(self.step)?.ask.as_ref();
        let is_answered = self.works.get(self.step).is_some_and(Work::is_revealed);
        ask.filter(|_| !is_answered)
    }
}

/// The state that a step begins with, in a window with this room for views.
pub(super) fn begun(lesson: &Lesson, step: usize, room: [f32; 2]) -> Option<Session> {
    let mut session = lesson.state_of(step).ok()?;
    session.views.fit(room);
    Some(session)
}

impl Learning {
    /// Begins with the progress of the last run.
    pub fn restore(&mut self, progress: &Progress) {
        self.progress.clone_from(progress);
    }

    /// Which questions were answered.
    #[must_use]
    pub fn progress(&self) -> &Progress {
        &self.progress
    }

    /// The groups of the list, in their order.
    pub(super) fn groups(&self) -> [Group<'_>; 3] {
        [
            Group {
                title: "Lessons",
                lessons: lessons::lessons(),
            },
            Group {
                title: "Questions",
                lessons: lessons::questions(),
            },
            Group {
                title: "Opened",
                lessons: &self.opened,
            },
        ]
    }
}
