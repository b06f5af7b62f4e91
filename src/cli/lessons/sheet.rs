//! `lessons --sheet`: the questions of lessons on paper.

use std::path::{Path, PathBuf};

use crate::cli::output;
use bxdf::error::{Error, Result};
use bxdf_study::lessons::{Lesson, Named, lessons, questions};

/// The arguments that are of sheets.
#[derive(clap::Args)]
pub struct OfSheet {
    /// Write the questions on a sheet to be printed, a PDF file
    #[arg(long, requires = "output", conflicts_with_all = ["check", "json", "quantities"])]
    sheet: bool,
    /// Write the computed answers on it too
    #[arg(long, requires = "sheet")]
    answers: bool,
    /// The file of the sheet: its name ends in .pdf
    #[arg(short, value_name = "FILE", requires = "sheet")]
    output: Option<PathBuf>,
}

impl OfSheet {
    /// Whether a sheet is asked for.
    pub(super) fn is_wanted(&self) -> bool {
        self.sheet
    }

    /// Writes the sheet of the questions of the lessons of these names; of all where there is none.
    ///
    /// # Errors
    /// Where there is no such lesson, none of them asks anything, or the file is no .pdf or cannot be written; and in a build
    /// without the window.
    pub(super) fn write(&self, names: &[PathBuf]) -> Result<()> {
        // Whoever asks for a sheet names its file: the arguments require it.
        let file = self.output.as_deref().unwrap_or(Path::new(""));
        if !output::ends_in(file, "pdf") {
            return Err(Error::parse(
                format!("sheet '{}'", file.display()),
                "expected a name that ends in .pdf",
            ));
        }
        let named = if names.is_empty() {
            let whole = |lesson: &Lesson| Named {
                lesson: lesson.clone(),
                step: None,
            };
            lessons().iter().chain(questions()).map(whole).collect()
        } else {
            let names = names
                .iter()
                .map(|name| Named::read(&name.to_string_lossy()));
            names.collect::<Result<Vec<_>>>()?
        };
        output::write(file, &drawn(&named, self.answers)?)
    }
}

#[cfg(feature = "gui")]
fn drawn(named: &[Named], has_answers: bool) -> Result<Vec<u8>> {
    bxdf_ui::export::sheet::of_class(named, has_answers)
}

#[cfg(not(feature = "gui"))]
fn drawn(_: &[Named], _: bool) -> Result<Vec<u8>> {
    Err(crate::cli::say::no_window())
}
