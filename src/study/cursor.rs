//! The direction pointed at.

use glam::DVec3;

use super::answers::Answers;
use super::session::{EntryId, MaterialEntry, Session};
use bxdf_lab::analysis::{HeldLobe, Hold};
use bxdf_lab::contract::Witness;

/// A direction pointed at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cursor {
    /// The material that is pointed at; else the selected one.
    pub material: EntryId,
    /// The free direction, a unit vector.
    pub direction: DVec3,
}

impl Cursor {
    /// Holds one direction of the pair at `witness`, which is of a surface that is not turned, puts the other one, and points
    /// at it. A light alone is held whatever was held before; so is a viewer alone.
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
        session.put_other(direction);
        Some(Self {
            material,
            direction,
        })
    }

    /// The other direction of the session, of the selected material: what is read while nobody points.
    #[must_use]
    pub fn at_other(session: &Session) -> Self {
        Self {
            material: session.materials.selected().id(),
            direction: session.other(),
        }
    }

    /// The material pointed at; the selected one where it is no longer there, or hidden; of what is not here nothing is read.
    #[must_use]
    pub fn entry<'a>(&self, session: &'a Session) -> &'a MaterialEntry {
        let mut shown = session.materials.shown();
        let pointed = shown.find(|entry| entry.id() == self.material);
        let selected = session.materials.selected();
        let first_shown = || session.materials.shown().next();
        let is_here = selected.material.is_complete();
        let other = if is_here { None } else { first_shown() };
        pointed.or(other).unwrap_or(selected)
    }

    /// The value there: f in 1/sr (times the cosine, if shown so), per channel; its limit at the horizon. No number where
    /// the material lacks its data.
    pub fn value(&self, session: &Session, answers: &mut Answers) -> [f64; 3] {
        let entry = self.entry(session);
        if !entry.material.is_complete() {
            return [f64::NAN; 3];
        }
        let surface = answers.surface(session, entry);
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
