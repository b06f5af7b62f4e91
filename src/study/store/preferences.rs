//! What is kept of a person from run to run, besides the session.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use super::labels::LabelSize;
use super::progress::Progress;
use super::window::WindowPlace;
use crate::colors::Theme;
use crate::export::figure::FigureChoice;

/// How the panel at the side stands: which of its parts are folded away.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Side {
    /// Whether it is folded to icons; where nothing is chosen the room decides.
    pub is_folded: Option<bool>,
    /// Whether it shows the parameters that are asked for less often.
    pub shows_more: bool,
    /// Whether it shows the numbers behind the name of a substance.
    pub shows_indices: bool,
}

/// What belongs to the person, not to a session.
#[derive(Clone, Default, Serialize, Deserialize)]
#[serde(default)]
pub(super) struct Preferences {
    /// The files opened last, the latest first.
    pub(super) recent: Vec<PathBuf>,
    /// The folder that files were saved in or opened from last.
    pub(super) folder: Option<PathBuf>,
    /// The theme; the system's where none is chosen.
    pub(super) theme: Option<Theme>,
    /// Whether the first steps were done or left.
    pub(super) has_seen_first_steps: bool,
    /// How the panel at the side stands.
    pub(super) side: Side,
    /// How large the labels of plots are.
    pub(super) labels: LabelSize,
    /// Whether nothing moves or fades by itself.
    pub(super) has_reduced_motion: bool,
    /// Where the window stood.
    pub(super) window: Option<WindowPlace>,
    /// How figures are made.
    pub(super) figure: FigureChoice,
    /// Which questions of lessons were answered.
    pub(super) lessons: Progress,
    /// The address of the page that links begin with.
    pub(super) page: Option<String>,
}
