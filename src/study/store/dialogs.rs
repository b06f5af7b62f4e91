//! Asking the user for a file.

use std::path::PathBuf;

/// What is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Question {
    /// A file to open.
    Open,
    /// A file to save to; this name is proposed.
    Save(String),
    /// A file to export to; this name is proposed.
    Export(String),
}

/// What becomes of a question.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// This file is meant.
    File(PathBuf),
    /// The user wants no file after all.
    Dismissed,
    /// This machine has no dialog to ask with.
    NoDialog,
}

/// Asks for files, one question at a time, without waiting for the answer.
pub trait Dialogs {
    /// Asks, unless another question is open.
    fn ask(&mut self, question: Question);

    /// Whether a question is open.
    fn is_open(&self) -> bool;

    /// The answer, once it is there, with its question.
    fn answer(&mut self) -> Option<(Question, Answer)>;
}
