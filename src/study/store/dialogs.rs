//! Asking the user for a file.

use std::path::PathBuf;

/// What is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileDialog {
    /// A file to open.
    Open,
    /// A file to save to; this name is proposed.
    Save(String),
    /// A file to save to with all data in it; this name is proposed.
    SaveWithData(String),
    /// A file to export to; this name is proposed.
    Export(String),
}

/// What becomes of a dialog.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// This file is meant.
    File(PathBuf),
    /// The user wants no file after all.
    Dismissed,
    /// This machine has no dialog to ask with.
    NoDialog,
}

/// Asks for files, one dialog at a time, without waiting for the answer.
pub trait Dialogs {
    /// Asks, unless another dialog is open.
    fn ask(&mut self, dialog: FileDialog);

    /// Whether a dialog is open.
    fn is_open(&self) -> bool;

    /// The answer, once it is there, with its dialog.
    fn answer(&mut self) -> Option<(FileDialog, Answer)>;
}
