//! What the window exports, until it is written.

use std::path::PathBuf;
use std::sync::mpsc::Receiver;

use egui::ColorImage;

use bxdf::error::Result;
use bxdf_study::export::Format;
use bxdf_study::session::ViewId;

/// What the window exports.
#[derive(Default)]
pub struct Exports {
    /// What a place is being asked for.
    pub(super) asked: Option<(ViewId, Format)>,
    /// What is being made.
    pub(super) making: Vec<Making>,
}

/// What is being made.
pub(super) struct Making {
    /// Where it will be written; `None` for the clipboard.
    pub(super) path: Option<PathBuf>,
    pub(super) answer: Receiver<Result<Made>>,
}

/// What is made.
pub(super) enum Made {
    File(Vec<u8>),
    Picture(ColorImage),
}
