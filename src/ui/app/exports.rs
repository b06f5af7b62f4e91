//! What the window exports, until it is written.

use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::mpsc::Receiver;

use egui::{ColorImage, TextureHandle, Vec2};

use super::picture::Title;
use bxdf::error::Result;
use bxdf_study::export::Format;
use bxdf_study::export::figure::FigureChoice;
use bxdf_study::session::{Session, ViewId};

/// What the window exports.
#[derive(Default)]
pub struct Exports {
    /// What a place is being asked for.
    pub(super) asked: Option<Asked>,
    /// What is being made.
    pub(super) making: Vec<Making>,
    /// How figures are made.
    pub(super) choice: FigureChoice,
    /// The figure that is being chosen.
    pub(super) dialog: Option<Dialog>,
    /// How large views are on the screen, in points.
    pub(super) sizes: HashMap<ViewId, Vec2>,
}

/// What a place is being asked for.
pub(super) struct Asked {
    pub(super) view: ViewId,
    pub(super) format: Format,
    pub(super) title: Title,
}

/// The figure of a view that is being chosen.
pub(super) struct Dialog {
    pub(super) view: ViewId,
    /// A title of the person's own; empty where there is none.
    pub(super) title: String,
    /// What the preview shows.
    pub(super) shown: Option<(Wanted, std::result::Result<TextureHandle, String>)>,
    /// What is being drawn for it.
    pub(super) drawing: Option<(Wanted, Receiver<Result<ColorImage>>)>,
}

/// What a preview is drawn of.
#[derive(Clone, PartialEq)]
pub(super) struct Wanted {
    pub(super) session: Session,
    pub(super) choice: FigureChoice,
    pub(super) title: String,
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
