//! What is being opened or pasted, until it is read.

use std::path::PathBuf;
use std::sync::mpsc::Receiver;

use bxdf::error::Result;
use bxdf_study::session::Opened;

/// A text that is being read.
pub struct Reading {
    pub(super) what: String,
    /// The file it stands in.
    pub(super) path: Option<PathBuf>,
    pub(super) answer: Receiver<Result<Opened>>,
}
