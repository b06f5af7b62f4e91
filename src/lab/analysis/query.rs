//! What a view asks about a material, as a value of its own: the same query is answered for the window's workers, for
//! exports and for tests.

use std::future::poll_fn;
use std::mem::replace;
use std::pin::Pin;
use std::task::{Context, Poll, Waker};

use super::{Detail, HeldLobe};
use bxdf::Material;

/// What a query is asked about: a surface with one direction held, and what else the answer may depend on.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// The surface and the direction held.
    pub lobe: HeldLobe<'a>,
    /// The material that the surface is of, not turned; a surface by itself is of none.
    pub material: Option<&'a Material>,
    /// A surface to compare with, the same direction held.
    pub against: Option<HeldLobe<'a>>,
}

impl<'a> Subject<'a> {
    /// The surface of `lobe` by itself.
    #[must_use]
    pub fn of(lobe: HeldLobe<'a>) -> Self {
        Self {
            lobe,
            material: None,
            against: None,
        }
    }

    /// The index of refraction below the surface over the one above; 1 without transmission.
    #[must_use]
    pub fn relative_index(&self) -> f64 {
        self.material.map_or(1.0, Material::relative_index)
    }
}

/// Whether an answer is still wanted: long computations ask now and then, from any thread.
pub type IsWanted<'a> = &'a (dyn Fn() -> bool + Sync);

/// Is handed the parts of an answer: all there is of it so far, and the share of the work done, 0..1.
pub type Tell<'a, A> = &'a dyn Fn(A, f64);

/// A computation that is made step by step: where no threads are to be had, other work is done between them.
pub type Steps<'a, T> = Pin<Box<dyn Future<Output = T> + 'a>>;

/// Ends a step.
pub async fn pause() {
    let mut is_ended = false;
    poll_fn(|_| {
        if replace(&mut is_ended, true) {
            Poll::Ready(())
        } else {
            // Whoever makes the steps goes on when there is time: nobody has to be woken.
            Poll::Pending
        }
    })
    .await;
}

/// Makes one step; what comes of all of them after the last.
pub fn step<T>(steps: &mut Steps<'_, T>) -> Poll<T> {
    steps.as_mut().poll(&mut Context::from_waker(Waker::noop()))
}

/// Makes all steps, one right after the other.
#[must_use]
pub fn finish<T>(mut steps: Steps<'_, T>) -> T {
    loop {
        if let Poll::Ready(made) = step(&mut steps) {
            return made;
        }
    }
}

/// What an answer depends on besides its query.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// Nothing: it is of no material.
    Nothing,
    /// The material alone, however it is turned.
    Material,
    /// The surface.
    Surface,
    /// The surface and the direction held.
    Held,
}

/// How soon a query is to be answered, and how that goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// It takes no time: at once, by whoever asks.
    AtOnce,
    /// Within a frame or two: in full from the first.
    Short,
    /// Coarsely first.
    CoarseFirst,
    /// Once all others have a first answer; nobody is told to wait for it.
    Background,
    /// Seconds, beside all others; nobody is told to wait for it.
    Long,
}

impl Pace {
    /// Whether a view is incomplete without the answer.
    #[must_use]
    pub fn is_awaited(self) -> bool {
        !matches!(self, Self::Background | Self::Long)
    }
}

/// A query: all that the answer depends on besides its subject.
pub trait Query: Clone + PartialEq + Send + Sync + 'static {
    /// The answer.
    type Answer: Send + Sync + 'static;

    /// What the answer depends on.
    const BASIS: Basis = Basis::Held;

    /// How soon it is to be answered.
    const PACE: Pace = Pace::Short;

    /// What tells queries of one kind apart that are asked side by side.
    fn place(&self) -> usize {
        0
    }

    /// The answer in this detail; `None` where it was not wanted to the end, and where a surface by itself is asked for what
    /// only materials have.
    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Self::Answer>;

    /// [`Self::answer`] in steps, told in parts meanwhile, where it takes long.
    fn in_steps<'a>(
        &'a self,
        subject: Subject<'a>,
        detail: Detail,
        is_wanted: IsWanted<'a>,
        _tell: Tell<'a, Self::Answer>,
    ) -> Steps<'a, Option<Self::Answer>> {
        Box::pin(async move { self.answer(&subject, detail, is_wanted) })
    }
}
