//! What answers are kept by: a surface, the direction held, and the query.

use std::sync::Arc;

use crate::jobs::{Answer, Jobs, Slot};
use crate::session::Session;
use bxdf::math::frame;
use bxdf::{Material, Rotated, Scatterer};
use bxdf_lab::analysis::{Basis, HeldLobe, Hold, Query, Subject};

/// A material, turned about n.
pub struct Surface {
    /// The material, not turned.
    pub material: Material,
    /// By how much it is turned, in degrees.
    pub rotation_deg: f64,
    /// What is evaluated.
    pub bxdf: Box<dyn Scatterer<f64>>,
}

impl Surface {
    pub(super) fn new(material: &Material, rotation_deg: f64) -> Self {
        let turn = frame::cos_sin_deg(rotation_deg);
        Self {
            bxdf: Box::new(Rotated::new(material.build(), turn)),
            material: material.clone(),
            rotation_deg,
        }
    }
}

/// The direction held.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Held {
    hold: Hold,
    theta_deg: f64,
    phi_deg: f64,
}

impl Held {
    /// The one where it does not matter.
    const ANY: Self = Self {
        hold: Hold::Light,
        theta_deg: 0.0,
        phi_deg: 0.0,
    };

    pub(super) fn of(session: &Session) -> Self {
        Self {
            hold: session.hold,
            theta_deg: session.theta_deg,
            phi_deg: session.phi_deg,
        }
    }

    pub(super) fn lobe<'a>(&self, surface: &'a Surface) -> HeldLobe<'a> {
        let held = frame::direction_from_degrees(self.theta_deg, self.phi_deg);
        HeldLobe::new(&*surface.bxdf, self.hold, held)
    }
}

/// All that an answer depends on.
#[derive(Clone)]
pub(super) struct Asked<Q> {
    pub(super) surface: Arc<Surface>,
    against: Option<Arc<Surface>>,
    /// The direction held; where it does not matter, always the same one.
    held: Held,
    pub(super) query: Q,
}

impl<Q: Query> PartialEq for Asked<Q> {
    fn eq(&self, other: &Self) -> bool {
        // A surface is equal to itself alone, so that it need not be compared.
        let is_same = |a: &Arc<Surface>, b: &Arc<Surface>| match Q::BASIS {
            Basis::Nothing => true,
            Basis::Material => Arc::ptr_eq(a, b) || a.material == b.material,
            Basis::Surface | Basis::Held => Arc::ptr_eq(a, b),
        };
        let are_same = match (&self.against, &other.against) {
            (Some(a), Some(b)) => is_same(a, b),
            (a, b) => a.is_none() && b.is_none(),
        };
        are_same
            && is_same(&self.surface, &other.surface)
            && self.held == other.held
            && self.query == other.query
    }
}

impl<Q: Query> Asked<Q> {
    /// `query` about `surface`, whatever is held.
    pub(super) fn of(surface: Arc<Surface>, query: Q) -> Self {
        Self {
            surface,
            against: None,
            held: Held::ANY,
            query,
        }
    }

    /// `query` about `surface`, compared with another one, with the direction that `session` holds.
    pub(super) fn held_in(
        session: &Session,
        surface: Arc<Surface>,
        against: Option<Arc<Surface>>,
        query: Q,
    ) -> Self {
        Self {
            against,
            held: match Q::BASIS {
                Basis::Held => Held::of(session),
                Basis::Surface | Basis::Material | Basis::Nothing => Held::ANY,
            },
            ..Self::of(surface, query)
        }
    }
}

/// A query, and the slot of its answers.
pub(super) struct Asking<Q: Query> {
    pub(super) asked: Option<Asked<Q>>,
    pub(super) slot: Slot<Asked<Q>, Q::Answer>,
}

impl<Q: Query> Default for Asking<Q> {
    fn default() -> Self {
        Self {
            asked: None,
            slot: Slot::default(),
        }
    }
}

impl<Q: Query> Asking<Q> {
    pub(super) fn answer(&mut self, jobs: &mut Jobs, asked: &Asked<Q>) -> Answer<Q::Answer> {
        if self.asked.as_ref() != Some(asked) {
            self.asked = Some(asked.clone());
        }
        let inputs = asked.clone();
        self.slot.ask(jobs, asked, Q::PACE, move |detail, watch| {
            let inputs = inputs.clone();
            Box::pin(async move {
                let lobe = |surface| inputs.held.lobe(surface);
                let subject = Subject {
                    lobe: lobe(&inputs.surface),
                    material: Some(&inputs.surface.material),
                    against: inputs.against.as_ref().map(|against| lobe(against)),
                };
                let is_wanted = || !watch.is_stale();
                let tell = |part, share| watch.tell(part, share);
                let steps = inputs.query.in_steps(subject, detail, &is_wanted, &tell);
                steps.await
            })
        })
    }
}
