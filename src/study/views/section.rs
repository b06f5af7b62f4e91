//! The section that a view shows: the session's, or one of its own.

use serde::{Deserialize, Serialize};

use crate::number::NumberSpec;
use crate::session::{Section, Session, folded_deg};

/// The azimuth of a section that a view has for itself: a plane, the same after half a turn.
pub static OWN_SECTION: NumberSpec = NumberSpec::new("own_section_deg", [-360.0, 360.0])
    .unit("degrees")
    .folded([-90.0, 90.0], folded_deg);

/// The azimuth of a section of the view's own, in degrees; the session's section where there is none.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct OwnSection(pub Option<f64>);

impl OwnSection {
    /// The section that the view shows.
    #[must_use]
    pub fn of(self, session: &Session) -> Section {
        let own = self.0.map(|azimuth_deg| session.section_at(azimuth_deg));
        own.unwrap_or_else(|| session.section())
    }

    /// Whether the view shows the session's section.
    pub(super) fn is_absent(&self) -> bool {
        self.0.is_none()
    }

    /// Gives the view a section of its own, at first the one that it shows, or takes it away.
    pub fn set(&mut self, is_own: bool, session: &Session) {
        let shown = self.of(session);
        self.0 = is_own.then_some(shown.azimuth_deg);
    }

    /// Its azimuth, with what it may be.
    pub(super) fn number(&mut self) -> Option<(&'static NumberSpec, &mut f64)> {
        self.0.as_mut().map(|azimuth| (&OWN_SECTION, azimuth))
    }
}
