//! What the views show of each material, computed from the session and kept while the inputs stay the same.

use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::sync::Arc;

use super::jobs::{Answer, Clock, Jobs, Part};
use super::parallel::Pool;
use super::session::{EntryId, MaterialEntry, Session, ViewId};
use asked::{Asked, Asking, Held};
use bxdf::Material;
use bxdf_lab::analysis::{Basis, Detail, Query, Subject};

mod asked;

pub use asked::Surface;

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

/// Of what answers are kept together.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Of {
    /// A material of the session.
    Entry(EntryId),
    /// One of the lists of models and named materials, by its id: it is in no session.
    Listed(&'static str),
    /// None of them.
    Nothing,
}

/// The answers of one material.
#[derive(Default)]
struct OfMaterial {
    surface: Option<Arc<Surface>>,
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

impl OfMaterial {
    /// The surface of `material`; `rotation_deg`: by how much it is turned, where that matters.
    fn surface(&mut self, material: &Material, rotation_deg: Option<f64>) -> Arc<Surface> {
        let last = self.surface.as_ref();
        let rotation_deg = rotation_deg.or(last.map(|last| last.rotation_deg));
        let rotation_deg = rotation_deg.unwrap_or(0.0);
        let is_it = |surface: &&Arc<Surface>| {
            surface.rotation_deg == rotation_deg && surface.material == *material
        };
        if let Some(surface) = last.filter(is_it) {
            return Arc::clone(surface);
        }
        let surface = Arc::new(Surface::new(material, rotation_deg));
        self.surface = Some(Arc::clone(&surface));
        surface
    }

    fn ask<Q: Query>(
        &mut self,
        jobs: &mut Jobs,
        (asker, frame): (Option<ViewId>, u64),
        asked: &Asked<Q>,
    ) -> Answer<Q::Answer> {
        let place = (asker, TypeId::of::<Q>(), asked.query.place());
        let mut kept = self.slots.remove(&place).unwrap_or_else(|| Kept {
            asking: Box::new(Asking::<Q>::default()),
            frame: 0,
            is_following: false,
        });
        // Where another view has asked the same in this frame, it is answered once.
        let leader = self.slots.iter().find_map(|(other, kept)| {
            let is_asked = kept.frame == frame && !kept.is_following && other.2 == place.2;
            let asking = kept.asking.downcast_ref::<Asking<Q>>();
            asking.filter(|asking| is_asked && asking.asked.as_ref() == Some(asked))
        });
        (kept.frame, kept.is_following) = (frame, leader.is_some());
        let answer = match (kept.asking.downcast_mut::<Asking<Q>>(), leader) {
            (Some(own), Some(leader)) => own.slot.follow(&leader.slot, asked),
            (Some(own), None) => own.answer(jobs, asked),
            // The type is a part of the place: it is always this one.
            (None, _) => Answer::nothing(),
        };
        self.slots.insert(place, kept);
        answer
    }
}

/// What was ordered last of a kind, and how far it is.
pub struct Ordered<A> {
    /// What it is about.
    pub surface: Arc<Surface>,
    /// What there is of the answer by now.
    pub answer: Option<Arc<A>>,
    /// How far that is, where it is a part.
    pub part: Option<Part>,
    /// Whether more of it will come.
    pub is_awaited: bool,
}

/// How many frames the answer to a query outlives the view that asked: a view hidden for longer asks anew.
const FRAMES_KEPT: u64 = 3;

/// The answers about each material, by who asks, and how long the last update took.
///
/// What takes longer than a frame is computed by the pool: until then the views get the last answer, or an empty one.
pub struct Answers {
    given: HashMap<Of, OfMaterial>,
    /// What was ordered: an `Asking<Q>` for each type of query `Q`.
    orders: HashMap<TypeId, Box<dyn Any>>,
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
}

impl Answers {
    /// Nothing is answered yet, and no clock: every answer is computed at once.
    #[must_use]
    pub fn at_once() -> Self {
        Self::new(None, Pool::at_once(), || {})
    }

    /// Nothing is answered yet; `clock` measures the updates, `pool` answers what takes longer than a frame, and `wake` is called when
    /// there are answers to be shown. Without a clock every answer is computed at once.
    #[must_use]
    pub fn new(clock: Option<Clock>, pool: Pool, wake: impl Fn() + Send + Sync + 'static) -> Self {
        Self {
            given: HashMap::new(),
            orders: HashMap::new(),
            jobs: Jobs::new(clock, pool, wake),
            clock,
            frame: 0,
            asker: None,
            last_update: None,
            awaited_since: None,
            shown: Some(Detail::Full),
        }
    }

    /// Begins a frame. What belongs to materials that `session` has no longer is dropped, and what no view asks for.
    pub fn begin_frame(&mut self, session: &Session) {
        self.end_frame();
        self.frame += 1;
        self.jobs.begin_frame();
        let frame = self.frame;
        self.given.retain(|of, answers| {
            let is_entry = matches!(of, Of::Entry(_));
            // What the window itself asks of a material may be out of sight for a while.
            answers.slots.retain(|(asker, ..), kept| {
                is_entry && asker.is_none() || kept.frame + FRAMES_KEPT > frame
            });
            match of {
                Of::Entry(id) => session.materials.get(*id).is_some(),
                Of::Listed(_) | Of::Nothing => !answers.slots.is_empty(),
            }
        });
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
        let answers = self.given.entry(Of::Entry(entry.id())).or_default();
        answers.surface(&entry.material, Some(session.rotation_deg))
    }

    /// Says who asks from here on: a view, or nobody of them. The answers of each are kept by themselves, so that two views
    /// of one kind do not take the slots from one another.
    pub fn asked_by(&mut self, asker: Option<ViewId>) {
        self.asker = asker;
    }

    /// The answer to `query` about a material, or to the last one of its kind; an empty one before the first.
    pub fn ask<Q: Query<Answer: Default>>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        query: Q,
    ) -> Arc<Q::Answer> {
        self.compare(session, entry, None, query)
    }

    /// [`Self::ask`], of a query that compares the material with another one.
    pub fn compare<Q: Query<Answer: Default>>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        against: Option<&MaterialEntry>,
        query: Q,
    ) -> Arc<Q::Answer> {
        // Of what is not here nothing can be said.
        if !entry.material.is_complete() {
            return Arc::default();
        }
        let surface = self.surface(session, entry);
        let against = against.map(|against| self.surface(session, against));
        let asked = Asked::held_in(session, surface, against, query);
        let answer = self.answer(Of::Entry(entry.id()), &asked);
        answer.value.unwrap_or_default()
    }

    /// The answer to `query` about a material alone, however it is turned; `None` before there is one to this very query.
    pub fn of_material<Q: Query>(
        &mut self,
        entry: &MaterialEntry,
        query: Q,
    ) -> Option<Arc<Q::Answer>> {
        const { assert!(matches!(Q::BASIS, Basis::Material)) };
        self.find(Of::Entry(entry.id()), &entry.material, None, query)
    }

    /// The answer to `query` about what is listed by this id, a model or a named material, not turned, whatever is held;
    /// `None` before there is one.
    pub fn of_listed<Q: Query>(
        &mut self,
        id: &'static str,
        material: &Material,
        query: Q,
    ) -> Option<Arc<Q::Answer>> {
        const { assert!(!matches!(Q::BASIS, Basis::Held)) };
        self.find(Of::Listed(id), material, Some(0.0), query)
    }

    /// The answer to `query`, which is of no material; `None` before there is one.
    pub fn of_nothing<Q: Query>(&mut self, query: Q) -> Option<Arc<Q::Answer>> {
        const { assert!(matches!(Q::BASIS, Basis::Nothing)) };
        // Whatever it is asked about is not looked at.
        let [any, ..] = bxdf::models::MODELS;
        self.find(Of::Nothing, &Material::of(any), Some(0.0), query)
    }

    fn find<Q: Query>(
        &mut self,
        of: Of,
        material: &Material,
        rotation_deg: Option<f64>,
        query: Q,
    ) -> Option<Arc<Q::Answer>> {
        if !material.is_complete() {
            return None;
        }
        let answers = self.given.entry(of).or_default();
        let asked = Asked::of(answers.surface(material, rotation_deg), query);
        let answer = self.answer(of, &asked);
        answer.value.filter(|_| answer.detail.is_some())
    }

    fn answer<Q: Query>(&mut self, of: Of, asked: &Asked<Q>) -> Answer<Q::Answer> {
        let answers = self.given.entry(of).or_default();
        let answer = answers.ask(&mut self.jobs, (self.asker, self.frame), asked);
        if Q::PACE.is_awaited() {
            self.shown = self.shown.min(answer.detail);
        }
        answer
    }

    /// Begins to answer `query` about a material; what was ordered of its kind before is called off. What takes seconds is
    /// ordered, rather than asked anew with each change, and stays whatever becomes of the session.
    pub fn order<Q: Query>(&mut self, entry: &MaterialEntry, query: Q) {
        const { assert!(matches!(Q::BASIS, Basis::Material)) };
        self.orders.remove(&TypeId::of::<Q>());
        if !entry.material.is_complete() {
            return;
        }
        let answers = self.given.entry(Of::Entry(entry.id())).or_default();
        let asked = Asked::of(answers.surface(&entry.material, None), query);
        let mut order = Asking::default();
        order.answer(&mut self.jobs, &asked);
        self.orders.insert(TypeId::of::<Q>(), Box::new(order));
    }

    /// The last order of a kind.
    fn last_order<Q: Query>(&mut self) -> Option<&mut Asking<Q>> {
        let order = self.orders.get_mut(&TypeId::of::<Q>());
        order.and_then(|order| order.downcast_mut())
    }

    /// Whether it is `query` about this material that was ordered last of its kind.
    pub fn is_ordered<Q: Query>(&mut self, entry: &MaterialEntry, query: &Q) -> bool {
        let last = self.last_order::<Q>();
        let asked = last.and_then(|order| order.asked.as_ref());
        asked.is_some_and(|asked| asked.query == *query && asked.surface.material == entry.material)
    }

    /// What was ordered last of a kind, and how far it is.
    pub fn ordered<Q: Query>(&mut self) -> Option<Ordered<Q::Answer>> {
        let order = self.last_order::<Q>()?;
        let asked = order.asked.as_ref()?;
        let (answer, is_awaited) = order.slot.look(asked);
        Some(Ordered {
            surface: Arc::clone(&asked.surface),
            answer: answer.value,
            part: answer.part,
            is_awaited,
        })
    }

    /// Calls off what was ordered last of a kind; what is known of it stays.
    pub fn call_off<Q: Query>(&mut self) {
        if let Some(order) = self.last_order::<Q>() {
            order.slot.call_off();
        }
    }

    /// What `of` says of a material with the direction held: for what takes no time and is not kept.
    pub fn with_subject<T>(
        &mut self,
        session: &Session,
        entry: &MaterialEntry,
        of: impl FnOnce(&Subject<'_>) -> T,
    ) -> T {
        let surface = self.surface(session, entry);
        of(&Subject {
            material: Some(&surface.material),
            ..Subject::of(Held::of(session).lobe(&surface))
        })
    }
}

#[cfg(test)]
mod tests;
