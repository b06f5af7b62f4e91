//! The first steps in the window: begun at the first start, left for good, and brought back.

use egui::{Context, Rect};

use super::App;
use crate::widgets::first_steps::FirstSteps;

impl App {
    /// Begins the first steps, or leaves them.
    pub fn switch_first_steps(&mut self) {
        self.first_steps = match self.first_steps {
            Some(_) => None,
            None => Some(FirstSteps::begin(&self.session)),
        };
        self.keep_first_steps();
    }

    /// Whether the first steps are shown.
    #[must_use]
    pub fn shows_first_steps(&self) -> bool {
        self.first_steps.is_some()
    }

    /// The caption of the step that is to be done, over the `views`.
    pub(crate) fn show_first_steps(&mut self, ctx: &Context, views: Rect) {
        let session = &self.session;
        let steps = self.first_steps.as_mut();
        if steps.is_some_and(|steps| steps.show(ctx, views, session)) {
            self.switch_first_steps();
        }
    }
}
