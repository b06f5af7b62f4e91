//! What a computation is told, and tells, while it works.

use std::sync::atomic::{AtomicU64, Ordering};

use bxdf_lab::analysis::{Detail, Steps};

/// Tells a computation whether its answer is still wanted, and is told what there is of it so far.
pub struct Watch<'a, V> {
    pub(super) newest: &'a AtomicU64,
    pub(super) number: u64,
    pub(super) tell: &'a (dyn Fn(V, f64) + Sync),
}

impl<V> Watch<'_, V> {
    /// Whether a newer query has been asked since.
    #[must_use]
    pub fn is_stale(&self) -> bool {
        self.newest.load(Ordering::Relaxed) != self.number
    }

    /// Shows `value` until there is more of the answer; `share` of the work is done, 0..1.
    pub fn tell(&self, value: V, share: f64) {
        (self.tell)(value, share);
    }
}

/// What answers a query, step by step: the answer, or nothing where it was given up.
pub(super) type Compute<V> =
    dyn for<'a> Fn(Detail, &'a Watch<'a, V>) -> Steps<'a, Option<V>> + Send + Sync;

/// How far an answer is of which a part is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// The share of the work done, 0..1.
    pub share: f64,
    /// About how many seconds are left, once that can be said.
    pub seconds_left: Option<f64>,
}

/// The share of the work from which on the rest can be estimated.
pub(super) const TELLING_SHARE: f64 = 0.02;
