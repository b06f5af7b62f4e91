//! What the views show of each material, computed from the session and kept while the inputs stay the same.

use std::collections::HashMap;
use std::sync::Arc;

use super::memo::{Memo, Same};
use super::session::{EntryId, MaterialEntry, Session};
use crate::analysis::lobe::Arrow;
use crate::analysis::reflectance::{LobeShare, lobe_shares};
use crate::analysis::{HeldLobe, Hold, lobe3d, polar};
use crate::bxdf::math::frame;
use crate::bxdf::rotated::Rotated;
use crate::bxdf::{Bxdf, Material};

/// Absolute error of the shares of light: below half a unit of the last digit shown.
const SHARE_TOLERANCE: f64 = 2e-4;

/// Evaluations the shares may take: a few milliseconds, whatever the material.
const SHARE_EVALUATIONS: usize = 60_000;

/// A clock: seconds since some start. Pictures and tests have none, so that they are the same bytes twice.
pub type Clock = fn() -> f64;

/// A material, turned about n.
pub type Surface = Box<dyn Bxdf<f64>>;

/// A surface and the direction held: the input of every request.
#[derive(Clone, PartialEq)]
struct Held {
    surface: Same<Surface>,
    hold: Hold,
    theta_deg: f64,
    phi_deg: f64,
}

impl Held {
    fn lobe(&self) -> HeldLobe<'_> {
        let held = frame::direction_from_degrees(self.theta_deg, self.phi_deg);
        HeldLobe::new(&**self.surface.0, self.hold, held)
    }
}

/// The answers of one material.
#[derive(Default)]
struct Answers {
    surface: Memo<(Material, f64), Surface>,
    section: Memo<(Held, polar::Request), polar::Section>,
    mesh: Memo<(Held, lobe3d::Request), lobe3d::Mesh>,
    arrows: Memo<Held, Vec<Arrow>>,
    shares: Memo<Held, Vec<LobeShare>>,
}

impl Answers {
    /// A number that grows with each computation worth timing.
    fn computations(&self) -> u64 {
        self.section.version() + self.mesh.version() + self.shares.version()
    }
}

/// The data of each view and material, and how long the last update took.
#[derive(Default)]
pub struct Data {
    answers: HashMap<EntryId, Answers>,
    clock: Option<Clock>,
    /// Seconds the last update took; `None` before the first, and without a clock.
    pub last_update: Option<f64>,
    updating: f64,
}

impl Data {
    /// No data yet; `clock` measures the updates.
    #[must_use]
    pub fn new(clock: Option<Clock>) -> Self {
        Self {
            clock,
            ..Self::default()
        }
    }

    /// Begins a frame: the computations from here on are one update. What belongs to materials that `session` has no
    /// longer is dropped.
    pub fn begin_frame(&mut self, session: &Session) {
        self.updating = 0.0;
        self.answers
            .retain(|id, _| session.materials.get(*id).is_some());
    }

    /// The surface of a material.
    pub fn surface(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<Surface> {
        self.ask(session, entry, |_, held| Arc::clone(&held.surface.0))
    }

    /// The section that the polar plot shows.
    pub fn section(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<polar::Section> {
        let request = section_request(session);
        self.ask(session, entry, |answers, held| {
            let key = (held.clone(), request);
            answers
                .section
                .get(key, || polar::section(&held.lobe(), &request))
        })
    }

    /// The mesh that the 3D view shows.
    pub fn mesh(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<lobe3d::Mesh> {
        let request = lobe3d::Request {
            scale: session.scale,
            with_cosine: session.with_cosine,
        };
        self.ask(session, entry, |answers, held| {
            let key = (held.clone(), request);
            answers
                .mesh
                .get(key, || lobe3d::mesh(&held.lobe(), &request))
        })
    }

    /// The Dirac deltas of the held direction.
    pub fn arrows(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<Vec<Arrow>> {
        self.ask(session, entry, |answers, held| {
            answers.arrows.get(held.clone(), || held.lobe().arrows())
        })
    }

    /// What each lobe does with light arriving along the held direction.
    pub fn shares(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<Vec<LobeShare>> {
        self.ask(session, entry, |answers, held| {
            answers.shares.get(held.clone(), || {
                let surface = &**held.surface.0;
                lobe_shares(surface, session.held(), SHARE_TOLERANCE, SHARE_EVALUATIONS)
            })
        })
    }

    /// What `work` makes of the answers of a material and of what is held; timed where something is computed.
    fn ask<T>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        work: impl FnOnce(&mut Answers, &Held) -> T,
    ) -> T {
        let start = self.clock.map(|clock| clock());
        let answers = self.answers.entry(entry.id()).or_default();
        let before = answers.computations();
        let key = (entry.material.clone(), session.rotation_deg);
        let surface = answers.surface.get(key, || {
            let turn = frame::cos_sin_deg(session.rotation_deg);
            Box::new(Rotated::new(entry.material.build(), turn))
        });
        let held = Held {
            surface: Same(surface),
            hold: session.hold,
            theta_deg: session.theta_deg,
            phi_deg: session.phi_deg,
        };
        let result = work(answers, &held);
        if answers.computations() != before
            && let (Some(clock), Some(start)) = (self.clock, start)
        {
            self.updating += clock() - start;
            self.last_update = Some(self.updating);
        }
        result
    }
}

/// The section of a session's polar plot.
#[must_use]
pub fn section_request(session: &Session) -> polar::Request {
    polar::Request {
        phi: session.section_azimuth_deg().to_radians(),
        with_cosine: session.with_cosine,
        scale: session.scale,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_material_keeps_its_answers_until_it_is_removed() {
        let mut session = Session::of("oren_nayar".parse().unwrap());
        let added = session.materials.add("phong".parse().unwrap()).unwrap();
        let mut data = Data::new(None);
        data.begin_frame(&session);
        let section = |data: &mut Data, session: &Session, index: usize| {
            let entry = session.materials.iter().nth(index).unwrap();
            data.section(session, entry)
        };
        let [first, second] = [0, 1].map(|index| section(&mut data, &session, index));
        assert_ne!(first, second);
        // One is edited: the other one is not computed anew.
        session.materials.get_mut(added).unwrap().material = "ward".parse().unwrap();
        assert!(Arc::ptr_eq(&first, &section(&mut data, &session, 0)));
        assert!(!Arc::ptr_eq(&second, &section(&mut data, &session, 1)));
        session.materials.remove(added);
        data.begin_frame(&session);
        assert_eq!(data.answers.len(), 1);
    }
}
