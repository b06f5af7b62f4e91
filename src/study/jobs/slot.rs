//! A query that is asked again whenever its inputs change, and the last answer to it.

use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use super::{Clock, Jobs, Task, locked};
use bxdf_lab::analysis::Detail;

/// Tells a computation whether its answer is still wanted.
pub struct Watch<'a> {
    newest: &'a AtomicU64,
    number: u64,
}

impl Watch<'_> {
    /// Whether a newer query has been asked since.
    #[must_use]
    pub fn is_stale(&self) -> bool {
        self.newest.load(Ordering::Relaxed) != self.number
    }
}

/// What answers a query: the answer, or nothing where it was given up.
type Compute<V> = dyn Fn(Detail, &Watch<'_>) -> Option<V> + Send + Sync;

/// The last answer to a query, and the query that is being answered.
pub struct Slot<K, V> {
    shown: Option<Shown<K, V>>,
    asked: Arc<Asked<K, V>>,
    version: u64,
}

struct Shown<K, V> {
    number: u64,
    key: K,
    value: Arc<V>,
    detail: Detail,
}

/// What a slot shares with the workers.
struct Asked<K, V> {
    /// The number of the newest query; see [`Watch`].
    newest: AtomicU64,
    state: Mutex<AskedState<K, V>>,
}

struct AskedState<K, V> {
    query: Option<Query<K, V>>,
    answer: Option<Shown<K, V>>,
    /// Whether the slot waits in the queue or a worker is at it.
    is_queued: bool,
    /// Seconds the last full answer took.
    took: Option<f64>,
}

struct Query<K, V> {
    number: u64,
    key: K,
    first: Detail,
    compute: Arc<Compute<V>>,
    clock: Option<Clock>,
}

impl<K, V> Default for Slot<K, V> {
    fn default() -> Self {
        Self {
            shown: None,
            asked: Arc::new(Asked {
                newest: AtomicU64::new(0),
                state: Mutex::new(AskedState {
                    query: None,
                    answer: None,
                    is_queued: false,
                    took: None,
                }),
            }),
            version: 0,
        }
    }
}

/// An answer, and what is to be said of it.
#[derive(Debug)]
pub struct Answer<V> {
    /// The answer; to an older query, where the newest one has none yet. `None` before the first.
    pub value: Option<Arc<V>>,
    /// In what detail it answers the query asked; `None` for the answer to an older one, and for none.
    pub detail: Option<Detail>,
}

impl<V> Answer<V> {
    /// No answer yet.
    #[must_use]
    pub fn nothing() -> Self {
        Self {
            value: None,
            detail: None,
        }
    }
}

impl<K, V> Slot<K, V>
where
    K: PartialEq + Clone + Send + 'static,
    V: Send + Sync + 'static,
{
    /// The answer for `key`, computed by `compute` only where the key differs from the last one.
    ///
    /// It is computed now if there is time in this frame; else the last answer is returned, and `jobs` wakes the window
    /// when there is a better one. `first`: the detail of the first answer; short work has no coarse one.
    pub fn ask(
        &mut self,
        jobs: &mut Jobs,
        key: &K,
        first: Detail,
        compute: impl Fn(Detail, &Watch<'_>) -> Option<V> + Send + Sync + 'static,
    ) -> Answer<V> {
        self.collect();
        let is_full = |shown: &Shown<K, V>| shown.key == *key && shown.detail == Detail::Full;
        let mut state = locked(&self.asked.state);
        let asked = state.query.as_ref().map(|asked| asked.key == *key);
        if let Some(shown) = self.shown.as_mut().filter(|shown| is_full(shown)) {
            // The inputs are what they were: what was asked in between is of no interest any more.
            if asked == Some(false) {
                state.query = None;
                shown.number = self.asked.newest.fetch_add(1, Ordering::Relaxed) + 1;
            }
        } else if asked != Some(true) {
            let number = self.asked.newest.fetch_add(1, Ordering::Relaxed) + 1;
            if jobs.has_time_for(state.took) {
                state.query = None;
                drop(state);
                self.answer_now(jobs, number, key.clone(), &compute);
            } else {
                state.query = Some(Query {
                    number,
                    key: key.clone(),
                    first,
                    compute: Arc::new(compute),
                    clock: jobs.clock,
                });
                if !std::mem::replace(&mut state.is_queued, true) {
                    jobs.push(Arc::clone(&self.asked) as _);
                }
            }
        }
        self.answer(key)
    }

    /// Shows what `other` shows, which is asked for `key` too: nothing is computed here, and what was asked here before is of
    /// no interest any more.
    pub fn follow(&mut self, other: &Self, key: &K) -> Answer<V> {
        let number = self.asked.newest.fetch_add(1, Ordering::Relaxed) + 1;
        locked(&self.asked.state).query = None;
        if let Some(shown) = &other.shown {
            self.show(Shown {
                number,
                key: shown.key.clone(),
                value: Arc::clone(&shown.value),
                detail: shown.detail,
            });
        }
        self.answer(key)
    }

    /// What is shown, as an answer for `key`.
    fn answer(&self, key: &K) -> Answer<V> {
        let answers = |shown: &&Shown<K, V>| shown.key == *key;
        let shown = self.shown.as_ref();
        Answer {
            value: shown.map(|shown| Arc::clone(&shown.value)),
            detail: shown.filter(answers).map(|shown| shown.detail),
        }
    }

    fn answer_now(
        &mut self,
        jobs: &mut Jobs,
        number: u64,
        key: K,
        compute: &impl Fn(Detail, &Watch<'_>) -> Option<V>,
    ) {
        let watch = Watch {
            newest: &self.asked.newest,
            number,
        };
        let (value, seconds) = jobs.timed(|| compute(Detail::Full, &watch));
        locked(&self.asked.state).took = Some(seconds);
        if let Some(value) = value {
            self.show(Shown {
                number,
                key,
                value: Arc::new(value),
                detail: Detail::Full,
            });
        }
    }

    /// Shows what a worker has answered, unless something newer is shown.
    fn collect(&mut self) {
        let answer = locked(&self.asked.state).answer.take();
        if let Some(answer) = answer {
            let rank = |shown: &Shown<K, V>| (shown.number, shown.detail);
            if self
                .shown
                .as_ref()
                .is_none_or(|shown| rank(shown) < rank(&answer))
            {
                self.show(answer);
            }
        }
    }

    fn show(&mut self, answer: Shown<K, V>) {
        self.shown = Some(answer);
        self.version += 1;
    }

    /// A number that grows by 1 with each answer.
    #[must_use]
    pub fn version(&self) -> u64 {
        self.version
    }
}

impl<K, V> Task for Asked<K, V>
where
    K: PartialEq + Clone + Send + 'static,
    V: Send + Sync + 'static,
{
    fn work(&self, turn: Detail) -> Option<Detail> {
        let (number, key, first, compute, clock) = {
            let mut state = locked(&self.state);
            let Some(query) = &state.query else {
                state.is_queued = false;
                return None;
            };
            let (key, compute) = (query.key.clone(), Arc::clone(&query.compute));
            (query.number, key, query.first, compute, query.clock)
        };
        let detail = turn.max(first);
        // A first answer is always finished: else nothing new would be shown while the inputs keep changing.
        let unchanging = AtomicU64::new(number);
        let newest = match turn {
            Detail::Coarse => &unchanging,
            Detail::Full => &self.newest,
        };
        let start = clock.map(|clock| clock());
        let value = compute(detail, &Watch { newest, number });
        let seconds = clock.zip(start).map(|(clock, start)| clock() - start);
        let mut state = locked(&self.state);
        if let Some(value) = value {
            if detail == Detail::Full {
                state.took = seconds;
            }
            state.answer = Some(Shown {
                number,
                key,
                value: Arc::new(value),
                detail,
            });
        }
        let next = match &state.query {
            Some(query) if query.number != number => Some(Detail::Coarse),
            Some(_) if detail == Detail::Coarse => Some(Detail::Full),
            _ => None,
        };
        if next.is_none() {
            state.query = None;
            state.is_queued = false;
        }
        next
    }
}

#[cfg(test)]
mod tests;
