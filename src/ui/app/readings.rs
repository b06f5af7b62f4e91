//! What is being opened or pasted, until it is read.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::mpsc::Receiver;

use bxdf::error::Result;
use bxdf_study::session::Opened;

/// What is being read, in the order in which it came.
pub struct Readings {
    pub(super) waiting: VecDeque<Reading>,
    /// Whether there are threads to read in; else everything is read at once.
    pub(super) is_threaded: bool,
}

impl Readings {
    /// Nothing yet; in threads, where it is so and there are any.
    pub(super) fn new(is_threaded: bool) -> Self {
        Self {
            waiting: VecDeque::new(),
            is_threaded,
        }
    }
}

/// A text that is being read.
pub(super) struct Reading {
    pub(super) what: String,
    /// The file it stands in.
    pub(super) path: Option<PathBuf>,
    pub(super) answer: Receiver<Result<Opened>>,
}
