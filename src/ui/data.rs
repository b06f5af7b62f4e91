//! What the views show of each material, computed from the session and kept while the inputs stay the same.

use std::collections::HashMap;
use std::sync::Arc;

use super::jobs::{Answer, Clock, Jobs, Slot};
use super::memo::{Memo, Same};
use super::session::{EntryId, MaterialEntry, Session};
use crate::analysis::lobe::Arrow;
use crate::analysis::reflectance::{LobeShare, lobe_shares};
use crate::analysis::{Detail, HeldLobe, Hold, lobe3d, polar};
use crate::bxdf::math::frame;
use crate::bxdf::rotated::Rotated;
use crate::bxdf::{Bxdf, Material};
use crate::lab::contract::{LawReport, check_physical};

/// Absolute error of the shares of light: below half a unit of the last digit shown.
const SHARE_TOLERANCE: f64 = 2e-4;

/// Evaluations the shares may take: a few milliseconds, whatever the material.
const SHARE_EVALUATIONS: usize = 60_000;

/// Seconds after which it is said that something is being computed.
const BLINK: f64 = 0.1;

/// How far the answers to what is asked are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Progress {
    /// Something has been computed for longer than a blink.
    Computing,
    /// All is shown, or will be in a moment; with the seconds the last change took.
    Complete(Option<f64>),
}

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
    section: Slot<(Held, polar::Request), polar::Section>,
    mesh: Slot<(Held, lobe3d::Request), lobe3d::Mesh>,
    arrows: Memo<Held, Vec<Arrow>>,
    shares: Slot<Held, Vec<LobeShare>>,
    checks: Slot<Material, Vec<LawReport>>,
}

/// The data of each view and material, and how long the last update took.
///
/// What takes longer than a frame is computed by the pool: until then the views get the last answer, or an empty one.
pub struct Data {
    answers: HashMap<EntryId, Answers>,
    jobs: Jobs,
    clock: Option<Clock>,
    /// Seconds from the last change to its full answers; `None` before the first, and without a clock.
    last_update: Option<f64>,
    /// Since when answers are awaited, in seconds of the clock.
    awaited_since: Option<f64>,
    /// The least detailed of the answers of this frame.
    shown: Option<Detail>,
}

impl Data {
    /// No data yet; `clock` measures the updates, and `wake` is called when there are answers to be shown. Without a clock
    /// every answer is computed at once.
    #[must_use]
    pub fn new(clock: Option<Clock>, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            answers: HashMap::new(),
            jobs: Jobs::new(clock, wake),
            clock,
            last_update: None,
            awaited_since: None,
            shown: Some(Detail::Full),
        }
    }

    /// Begins a frame. What belongs to materials that `session` has no longer is dropped.
    pub fn begin_frame(&mut self, session: &Session) {
        self.end_frame();
        self.jobs.begin_frame();
        self.answers
            .retain(|id, _| session.materials.get(*id).is_some());
    }

    /// Takes the time of an update that is complete.
    fn end_frame(&mut self) {
        let now = self.clock.map(|clock| clock());
        if self.shown.replace(Detail::Full) != Some(Detail::Full) {
            self.awaited_since = self.awaited_since.or(now);
        } else if let Some(since) = self.awaited_since.take() {
            self.last_update = now.map(|now| now - since);
        } else if self.jobs.spent() > 0.0 {
            self.last_update = Some(self.jobs.spent());
        }
    }

    /// The least detail in which the answers given since the frame began answer what is asked; `None` where one is an
    /// older answer, or none.
    #[must_use]
    pub fn shown(&self) -> Option<Detail> {
        self.shown
    }

    /// How far the answers are.
    #[must_use]
    pub fn progress(&self) -> Progress {
        let now = self.clock.map(|clock| clock());
        let awaited = now.zip(self.awaited_since);
        match awaited.map(|(now, since)| now - since) {
            Some(seconds) if seconds > BLINK => Progress::Computing,
            _ => Progress::Complete(self.last_update),
        }
    }

    /// The surface of a material.
    pub fn surface(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<Surface> {
        self.held(session, entry).surface.0
    }

    /// The section that the polar plot shows.
    pub fn section(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<polar::Section> {
        let request = section_request(session);
        self.ask(session, entry, |answers, jobs, held| {
            let key = (held.clone(), request);
            answers.section.ask(jobs, &key, Detail::Full, move |_, _| {
                Some(polar::section(&held.lobe(), &request))
            })
        })
    }

    /// The mesh that the 3D view shows.
    pub fn mesh(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<lobe3d::Mesh> {
        let request = lobe3d::Request {
            scale: session.scale,
            with_cosine: session.with_cosine,
        };
        self.ask(session, entry, |answers, jobs, held| {
            let key = (held.clone(), request);
            answers
                .mesh
                .ask(jobs, &key, Detail::Coarse, move |detail, watch| {
                    lobe3d::mesh_while(&held.lobe(), &request, detail, &|| !watch.is_stale())
                })
        })
    }

    /// The Dirac deltas of the held direction.
    pub fn arrows(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<Vec<Arrow>> {
        let held = self.held(session, entry);
        let arrows = &mut self.answers.entry(entry.id()).or_default().arrows;
        arrows.get(held.clone(), || held.lobe().arrows())
    }

    /// What each lobe does with light arriving along the held direction.
    pub fn shares(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<Vec<LobeShare>> {
        let direction = session.held();
        self.ask(session, entry, |answers, jobs, held| {
            answers
                .shares
                .ask(jobs, &held.clone(), Detail::Full, move |_, _| {
                    let surface = &**held.surface.0;
                    Some(lobe_shares(
                        surface,
                        direction,
                        SHARE_TOLERANCE,
                        SHARE_EVALUATIONS,
                    ))
                })
        })
    }

    /// The laws that a material keeps and breaks, whatever is held; `None` while it is being computed.
    pub fn checks(&mut self, entry: &MaterialEntry) -> Option<Arc<Vec<LawReport>>> {
        let answers = self.answers.entry(entry.id()).or_default();
        let material = entry.material.clone();
        let checks = &mut answers.checks;
        let answer = checks.ask(
            &mut self.jobs,
            &entry.material,
            Detail::Coarse,
            move |detail, watch| match detail {
                // Nothing is said of laws half checked: what the views wait for goes first.
                Detail::Coarse => None,
                Detail::Full => check_physical(&material, &|| !watch.is_stale()),
            },
        );
        answer.value.filter(|_| answer.detail.is_some())
    }

    /// The surface of a material and what is held.
    fn held(&mut self, session: &Session, entry: &MaterialEntry) -> Held {
        let key = (entry.material.clone(), session.rotation_deg);
        let answers = self.answers.entry(entry.id()).or_default();
        let surface = answers.surface.get(key, || {
            let turn = frame::cos_sin_deg(session.rotation_deg);
            Box::new(Rotated::new(entry.material.build(), turn))
        });
        Held {
            surface: Same(surface),
            hold: session.hold,
            theta_deg: session.theta_deg,
            phi_deg: session.phi_deg,
        }
    }

    /// The answer of `question`, or the last one; an empty one before the first.
    fn ask<V: Default>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        question: impl FnOnce(&mut Answers, &mut Jobs, Held) -> Answer<V>,
    ) -> Arc<V> {
        let held = self.held(session, entry);
        let answers = self.answers.entry(entry.id()).or_default();
        let answer = question(answers, &mut self.jobs, held);
        self.shown = self.shown.min(answer.detail);
        answer.value.unwrap_or_default()
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
        let mut data = Data::new(None, || {});
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
        // The laws of a material do not depend on what is held.
        let laws = |data: &mut Data, session: &Session| data.checks(session.materials.selected());
        let checked = laws(&mut data, &session).unwrap();
        session.theta_deg = 10.0;
        assert!(Arc::ptr_eq(&checked, &laws(&mut data, &session).unwrap()));
        session.materials.remove(added);
        data.begin_frame(&session);
        assert_eq!(data.answers.len(), 1);
    }
}
