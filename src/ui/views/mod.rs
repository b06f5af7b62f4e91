//! The views: one file each, and the one list of them.

use glam::DVec3;

use super::data::Data;
use super::session::{EntryId, MaterialEntry, Session};
use super::theme::Palette;
use crate::analysis::{HeldLobe, Hold};
use crate::error::{Error, Result};
use crate::lab::contract::Witness;

mod inspector;
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
pub static VIEWS: [ViewSpec; 3] = [polar::SPEC, lobe3d::SPEC, inspector::SPEC];

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
    /// The direction last pointed at, which every view shows; set by the view that has the pointer.
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

/// A direction pointed at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cursor {
    /// The material that is pointed at; else the selected one.
    pub material: EntryId,
    /// The free direction, a unit vector.
    pub direction: DVec3,
}

impl Cursor {
    /// Holds one direction of the pair at `witness`, which is of a surface that is not turned, and points at the other. A
    /// light alone is held whatever was held before; a viewer alone likewise.
    #[must_use]
    pub fn jump(session: &mut Session, material: EntryId, witness: &Witness) -> Option<Self> {
        let (held, free) = match (session.hold, witness.wo, witness.wi) {
            (_, None, None) => return None,
            (Hold::Light, wo, Some(wi)) | (_, wo @ None, Some(wi)) => {
                session.hold = Hold::Light;
                (wi, wo)
            }
            (_, Some(wo), wi) => {
                session.hold = Hold::Viewer;
                (wo, wi)
            }
        };
        session.hold_on_surface(held);
        let direction = session.on_surface(free?);
        Some(Self {
            material,
            direction,
        })
    }

    /// The material pointed at; the selected one where it is no longer there, or hidden.
    #[must_use]
    pub fn entry<'a>(&self, session: &'a Session) -> &'a MaterialEntry {
        let mut shown = session.materials.shown();
        let pointed = shown.find(|entry| entry.id() == self.material);
        pointed.unwrap_or_else(|| session.materials.selected())
    }

    /// The value there: f in 1/sr (times the cosine, if shown so), per channel; its limit at the horizon.
    pub fn value(&self, session: &Session, data: &mut Data) -> [f64; 3] {
        let surface = data.surface(session, self.entry(session));
        let lobe = HeldLobe::new(&*surface.bxdf, session.hold, session.held());
        let cosine = if session.with_cosine {
            self.direction.z.abs()
        } else {
            1.0
        };
        let value = lobe.value_or_limit(self.direction, self.direction.z >= 0.0);
        value.map(|f| f * cosine)
    }
}
