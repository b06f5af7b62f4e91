//! The lesson of `render --lesson`, and the sheet of it.

use std::sync::Arc;

use bxdf::error::Result;
use bxdf_study::lessons::Named;

/// What a file on paper ends in.
pub(super) const PAPER: &str = "pdf";

/// The arguments that are of lessons.
#[derive(clap::Args, Debug)]
pub struct OfLesson {
    /// The lesson or question: its number, its id or its file (.md), as 1.2 or 01-scattering.2. A picture shows the window at the step [default: 1], a .pdf is a sheet of the step [default: all] to be printed
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

/// The lesson on paper.
///
/// # Errors
/// Where a figure needs a graphics adapter and there is none, and in a build without the window.
#[cfg(feature = "gui")]
pub(super) fn sheet(named: &Named) -> Result<Vec<u8>> {
    bxdf_ui::export::sheet::of_lesson(named)
}

/// No sheet: this build has no window.
///
/// # Errors
/// Always.
#[cfg(not(feature = "gui"))]
pub(super) fn sheet(_: &Named) -> Result<Vec<u8>> {
    Err(crate::cli::say::no_window())
}
