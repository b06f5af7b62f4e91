//! What the views show of each material, computed from the session and kept while the inputs stay the same.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::Arc;

use super::jobs::{Answer, Clock, Jobs, Slot, Watch};
use super::memo::{Memo, Same};
use super::session::{EntryId, MaterialEntry, Session, ViewId};
use super::tradeoff_run::Measured;
use bxdf::Rotated;
use bxdf::math::frame;
use bxdf::{Material, Scatterer};
use bxdf_lab::analysis::lobe::Arrow;
use bxdf_lab::analysis::{Detail, HeldLobe, Hold, Query, Subject};
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
    /// The one where it does not matter.
    const ANY: Self = Self {
        hold: Hold::Light,
        theta_deg: 0.0,
        phi_deg: 0.0,
    };

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
    query: Q,
}

/// The answers of one material.
#[derive(Default)]
struct Answers {
    surface: Memo<(Material, f64), Surface>,
    arrows: Memo<(Same<Surface>, Held), Vec<Arrow>>,
    checks: Slot<Material, Vec<LawReport>>,
    /// The slots of queries, by who asks, the type of the query and its place.
    slots: HashMap<(Option<ViewId>, TypeId, usize), Kept>,
}

/// What is kept of a query.
struct Kept {
    /// An `Asking<Q>` of some query `Q`.
    asking: Box<dyn Any>,
    /// The frame in which it was asked last.
    frame: u64,
    /// Whether it shows what another one has been asked too.
    is_following: bool,
}

/// A query, and the slot of its answers.
struct Asking<Q: Query> {
    asked: Option<Asked<Q>>,
    slot: Slot<Asked<Q>, Q::Answer>,
}

impl Kept {
    fn new<Q: Query>() -> Self {
        let asking = Asking::<Q> {
            asked: None,
            slot: Slot::default(),
        };
        Self {
            asking: Box::new(asking),
            frame: 0,
            is_following: false,
        }
    }
}

impl Answers {
    fn ask<Q: Query>(
        &mut self,
        jobs: &mut Jobs,
        (asker, frame): (Option<ViewId>, u64),
        asked: &Asked<Q>,
    ) -> Answer<Q::Answer> {
        let place = (asker, TypeId::of::<Q>(), asked.query.place());
        let mut kept = self.slots.remove(&place).unwrap_or_else(Kept::new::<Q>);
        // Where another view has asked the same in this frame, it is answered once.
        let leader = self.slots.iter().find_map(|(other, kept)| {
            let is_asked = kept.frame == frame && !kept.is_following && other.2 == place.2;
            let asking = kept.asking.downcast_ref::<Asking<Q>>();
            asking.filter(|asking| is_asked && asking.asked.as_ref() == Some(asked))
        });
        (kept.frame, kept.is_following) = (frame, leader.is_some());
        let answer = match (kept.asking.downcast_mut::<Asking<Q>>(), leader) {
            (Some(own), Some(leader)) => own.slot.follow(&leader.slot, asked),
            (Some(own), None) => {
                if own.asked.as_ref() != Some(asked) {
                    own.asked = Some(asked.clone());
                }
                own.answer(jobs, asked)
            }
            // The type is a part of the place: it is always this one.
            (None, _) => Answer::nothing(),
        };
        self.slots.insert(place, kept);
        answer
    }
}

impl<Q: Query> Asking<Q> {
    fn answer(&mut self, jobs: &mut Jobs, asked: &Asked<Q>) -> Answer<Q::Answer> {
        let inputs = asked.clone();
        let compute = move |detail, watch: &Watch<'_>| {
            let lobe = |surface| inputs.held.lobe(surface);
            let subject = Subject {
                lobe: lobe(&inputs.surface.0),
                relative_index: inputs.surface.0.relative_index,
                against: inputs.against.as_ref().map(|against| lobe(&against.0)),
            };
            inputs.query.answer(&subject, detail, &|| !watch.is_stale())
        };
        self.slot.ask(jobs, asked, Q::FIRST, compute)
    }
}

/// How many frames the answer to a query outlives the view that asked: a view hidden for longer asks anew.
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
    /// Who asks.
    asker: Option<ViewId>,
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
            asker: None,
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

    /// Says who asks from here on: a view, or nobody of them. The answers of each are kept by themselves, so that two views
    /// of one kind do not take the slots from one another.
    pub fn asked_by(&mut self, asker: Option<ViewId>) {
        self.asker = asker;
    }

    /// The answer to `query` about a material, or to the last one of its kind; an empty one before the first.
    pub fn ask<Q: Query>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        query: Q,
    ) -> Arc<Q::Answer> {
        self.compare(session, entry, None, query)
    }

    /// [`Self::ask`], of a query that compares the material with another one.
    pub fn compare<Q: Query>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        against: Option<&MaterialEntry>,
        query: Q,
    ) -> Arc<Q::Answer> {
        let held = if Q::USES_HELD {
            Held::of(session)
        } else {
            Held::ANY
        };
        let asked = Asked {
            surface: Same(self.surface(session, entry)),
            against: against.map(|against| Same(self.surface(session, against))),
            held,
            query,
        };
        let answers = self.answers.entry(entry.id()).or_default();
        let answer = answers.ask(&mut self.jobs, (self.asker, self.frame), &asked);
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
mod tests;
