//! What the views show of each material, computed from the session and kept while the inputs stay the same.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::Arc;

use super::jobs::{Answer, Clock, Jobs, Slot};
use super::measured::Measured;
use super::memo::{Memo, Same};
use super::session::{EntryId, MaterialEntry, Session};
use bxdf::Rotated;
use bxdf::math::frame;
use bxdf::{Material, Scatterer};
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::{Detail, HeldLobe, Hold, Question, Subject};
use bxdf_lab::contract::{LawReport, check_physical};

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
pub struct Surface {
    /// What is evaluated.
    pub bxdf: Box<dyn Scatterer<f64>>,
    /// The index of refraction below over that above.
    pub relative_index: f64,
}

/// The direction held.
#[derive(Clone, Copy, PartialEq)]
struct Held {
    hold: Hold,
    theta_deg: f64,
    phi_deg: f64,
}

impl Held {
    fn of(session: &Session) -> Self {
        Self {
            hold: session.hold,
            theta_deg: session.theta_deg,
            phi_deg: session.phi_deg,
        }
    }

    fn lobe<'a>(&self, surface: &'a Surface) -> HeldLobe<'a> {
        let held = frame::direction_from_degrees(self.theta_deg, self.phi_deg);
        HeldLobe::new(&*surface.bxdf, self.hold, held)
    }
}

/// All that an answer depends on.
#[derive(Clone, PartialEq)]
struct Asked<Q> {
    surface: Same<Surface>,
    against: Option<Same<Surface>>,
    /// The direction held; where it does not matter, always the same one.
    held: Held,
    question: Q,
}

/// The answers of one material.
#[derive(Default)]
struct Answers {
    surface: Memo<(Material, f64), Surface>,
    arrows: Memo<(Same<Surface>, Held), Vec<Arrow>>,
    checks: Slot<Material, Vec<LawReport>>,
    /// The slots of the views' questions, by the type of the question and its place.
    slots: HashMap<(TypeId, usize), Kept>,
}

/// A `Slot<Asked<Q>, Q::Answer>` of some question `Q`.
struct Kept {
    slot: Box<dyn Any>,
    /// The frame in which it was asked last.
    frame: u64,
}

impl Answers {
    fn ask<Q: Question>(
        &mut self,
        jobs: &mut Jobs,
        frame: u64,
        asked: &Asked<Q>,
    ) -> Answer<Q::Answer> {
        let place = (TypeId::of::<Q>(), asked.question.place());
        let kept = self.slots.entry(place).or_insert_with(|| Kept {
            slot: Box::new(Slot::<Asked<Q>, Q::Answer>::default()),
            frame,
        });
        kept.frame = frame;
        // The type is a part of the place: it is always this one.
        let Some(slot) = kept.slot.downcast_mut::<Slot<Asked<Q>, Q::Answer>>() else {
            return Answer::nothing();
        };
        let inputs = asked.clone();
        slot.ask(jobs, asked, Q::FIRST, move |detail, watch| {
            let lobe = |surface| inputs.held.lobe(surface);
            let subject = Subject {
                lobe: lobe(&inputs.surface.0),
                relative_index: inputs.surface.0.relative_index,
                against: inputs.against.as_ref().map(|against| lobe(&against.0)),
            };
            inputs
                .question
                .answer(&subject, detail, &|| !watch.is_stale())
        })
    }
}

/// How many frames the answer to a question outlives the view that asked: a view hidden for longer asks anew.
const FRAMES_KEPT: u64 = 3;

/// The data of each view and material, and how long the last update took.
///
/// What takes longer than a frame is computed by the pool: until then the views get the last answer, or an empty one.
pub struct Data {
    answers: HashMap<EntryId, Answers>,
    jobs: Jobs,
    clock: Option<Clock>,
    /// The number of this frame.
    frame: u64,
    /// Seconds from the last change to its full answers; `None` before the first, and without a clock.
    last_update: Option<f64>,
    /// Since when answers are awaited, in seconds of the clock.
    awaited_since: Option<f64>,
    /// The least detailed of the answers of this frame.
    shown: Option<Detail>,
    /// The trade-off of the material last measured.
    pub tradeoff: Measured,
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
            frame: 0,
            last_update: None,
            awaited_since: None,
            shown: Some(Detail::Full),
            tradeoff: Measured::new(clock.is_some()),
        }
    }

    /// Begins a frame. What belongs to materials that `session` has no longer is dropped, and what no view asks for.
    pub fn begin_frame(&mut self, session: &Session) {
        self.end_frame();
        self.frame += 1;
        self.jobs.begin_frame();
        self.answers
            .retain(|id, _| session.materials.get(*id).is_some());
        for answers in self.answers.values_mut() {
            let is_asked = |kept: &Kept| kept.frame + FRAMES_KEPT > self.frame;
            answers.slots.retain(|_, kept| is_asked(kept));
        }
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
        let key = (entry.material.clone(), session.rotation_deg);
        let answers = self.answers.entry(entry.id()).or_default();
        answers.surface.get(key, || {
            let turn = frame::cos_sin_deg(session.rotation_deg);
            Surface {
                bxdf: Box::new(Rotated::new(entry.material.build(), turn)),
                relative_index: entry.material.relative_index(),
            }
        })
    }

    /// The answer to `question` about a material, or to the last one of its kind; an empty one before the first.
    pub fn ask<Q: Question>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        question: Q,
    ) -> Arc<Q::Answer> {
        self.compare(session, entry, None, question)
    }

    /// [`Self::ask`], of a question that compares the material with another one.
    pub fn compare<Q: Question>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        against: Option<&MaterialEntry>,
        question: Q,
    ) -> Arc<Q::Answer> {
        let held = if Q::USES_HELD {
            session
        } else {
            &Session::default()
        };
        let asked = Asked {
            surface: Same(self.surface(session, entry)),
            against: against.map(|against| Same(self.surface(session, against))),
            held: Held::of(held),
            question,
        };
        let answers = self.answers.entry(entry.id()).or_default();
        let answer = answers.ask(&mut self.jobs, self.frame, &asked);
        self.shown = self.shown.min(answer.detail);
        answer.value.unwrap_or_default()
    }

    /// What `of` says of a material with the direction held: for what takes no time and is not kept.
    pub fn with_subject<T>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        of: impl FnOnce(&Subject<'_>) -> T,
    ) -> T {
        let surface = self.surface(session, entry);
        of(&Subject::of(Held::of(session).lobe(&surface)))
    }

    /// The Dirac deltas of the held direction.
    pub fn arrows(&mut self, session: &Session, entry: &MaterialEntry) -> Arc<Vec<Arrow>> {
        let surface = self.surface(session, entry);
        let held = Held::of(session);
        let arrows = &mut self.answers.entry(entry.id()).or_default().arrows;
        let key = (Same(Arc::clone(&surface)), held);
        arrows.get(key, || held.lobe(&surface).arrows())
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
            data.ask(session, entry, session.section_request())
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
