//! The lesson of `render --lesson`.

use std::sync::Arc;

use bxdf::error::Result;
use bxdf_study::lessons::Named;

/// The arguments that are of lessons.
#[derive(clap::Args, Debug)]
pub struct OfLesson {
    /// The lesson or question to show at a step [default: 1]: its number, its id or its file (.md), as 1.2 or 01-scattering.2
    #[arg(
        long,
        value_name = "NN[.STEP]",
        value_parser = named,
        conflicts_with_all = ["session", "materials", "hold", "direction", "view", "figure"]
    )]
    lesson: Option<Arc<Named>>,
}

fn named(text: &str) -> Result<Arc<Named>> {
    Named::read(text).map(Arc::new)
}

impl OfLesson {
    /// The lesson, where one is asked for.
    pub(super) fn named(&self) -> Option<&Named> {
        self.lesson.as_deref()
    }
}
