//! What a view asks about a material, as a value of its own: the same query is answered for the window's workers, for
//! exports and for tests.

use super::{Detail, HeldLobe};

/// What a query is asked about: a surface with one direction held, and what else the answer may depend on.
#[derive(Clone, Copy)]
pub struct Subject<'a> {
    /// The surface and the direction held.
    pub lobe: HeldLobe<'a>,
    /// The index of refraction below the surface over the one above; 1 without transmission.
    pub relative_index: f64,
    /// A surface to compare with, the same direction held.
    pub against: Option<HeldLobe<'a>>,
}

impl<'a> Subject<'a> {
    /// The surface of `lobe` by itself, of one medium on either side.
    #[must_use]
    pub fn of(lobe: HeldLobe<'a>) -> Self {
        Self {
            lobe,
            relative_index: 1.0,
            against: None,
        }
    }
}

/// Whether an answer is still wanted: long computations ask now and then, from any thread.
pub type IsWanted<'a> = &'a (dyn Fn() -> bool + Sync);

/// A query: all that the answer depends on besides its subject.
pub trait Query: Clone + PartialEq + Send + Sync + 'static {
    /// The answer; its default is the answer of nothing, which a view draws while the first one is computed.
    type Answer: Default + Send + Sync + 'static;

    /// Whether the answer depends on the direction held.
    const USES_HELD: bool = true;

    /// The detail of the first answer: queries that are answered within a frame or two have no coarse one.
    const FIRST: Detail = Detail::Full;

    /// What tells queries of one kind apart that are asked side by side.
    fn place(&self) -> usize {
        0
    }

    /// The answer in this detail; `None` where it was not wanted to the end.
    fn answer(
        &self,
        subject: &Subject<'_>,
        detail: Detail,
        is_wanted: IsWanted<'_>,
    ) -> Option<Self::Answer>;
}
