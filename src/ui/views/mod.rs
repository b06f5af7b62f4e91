//! The views: one file each, and the one list of them.

use super::data::Data;
use super::session::{EntryId, Session};
use super::theme::Palette;
use crate::error::{Error, Result};

mod lobe3d;
mod polar;

/// A view of the session.
pub struct ViewSpec {
    /// The id: file name, command-line word and snapshot name.
    pub id: &'static str,
    /// The name at the screen.
    pub title: &'static str,
    /// What to see in it, in a sentence.
    pub what_you_see: &'static str,
    /// Draws it into the space left in the `Ui`.
    pub show: fn(&mut egui::Ui, &mut ViewContext<'_>),
}

/// Every view, in the order of the window.
pub static VIEWS: [ViewSpec; 2] = [polar::SPEC, lobe3d::SPEC];

/// The view with this id.
///
/// # Errors
/// [`Error::UnknownId`], with the nearest ids.
pub fn find(id: &str) -> Result<&'static ViewSpec> {
    VIEWS
        .iter()
        .find(|view| view.id == id)
        .ok_or_else(|| Error::unknown("view", id, VIEWS.iter().map(|view| view.id)))
}

/// What a view draws with.
pub struct ViewContext<'a> {
    /// What to show; gestures change it.
    pub session: &'a mut Session,
    /// The data of the session.
    pub data: &'a mut Data,
    /// What the views keep between frames.
    pub state: &'a mut ViewState,
    /// The direction under the pointer, set by the view that has it.
    pub cursor: &'a mut Option<Cursor>,
    /// The colours.
    pub palette: &'a Palette,
}

/// What views keep between frames; nothing of it is worth saving.
#[derive(Default)]
pub struct ViewState {
    drawing: lobe3d::DrawingMemo,
    is_dragging: bool,
    kept_lower_half: Option<bool>,
}

impl ViewState {
    /// To be called before the views of a frame are drawn.
    pub fn begin_frame(&mut self) {
        if !std::mem::take(&mut self.is_dragging) {
            self.kept_lower_half = None;
        }
    }

    /// Whether the views show what is below the surface. While the held direction is dragged they stay as they were:
    /// a plot that rearranged itself under the pointer would make the angle jump.
    fn shows_lower_half(&self, session: &Session) -> bool {
        self.kept_lower_half
            .unwrap_or_else(|| session.shows_lower_half())
    }

    /// Keeps the arrangement `has_lower` through the next frame.
    fn keep_arrangement(&mut self, has_lower: bool) {
        self.is_dragging = true;
        self.kept_lower_half = Some(has_lower);
    }
}

/// A direction under the pointer, with the value of the lobe there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cursor {
    /// The material that is pointed at; else the selected one.
    pub material: EntryId,
    /// Polar angle of the free direction from n, in degrees.
    pub theta_deg: f64,
    /// Its azimuth from s, in degrees.
    pub phi_deg: f64,
    /// f in 1/sr (times the cosine, if shown so), per channel.
    pub value: [f64; 3],
}
