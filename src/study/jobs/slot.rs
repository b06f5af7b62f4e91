//! A query that is asked again whenever its inputs change, and the last answer to it.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};

use super::{Clock, Jobs, Task, first_turn, locked};
use bxdf_lab::analysis::{Detail, Pace};

/// Tells a computation whether its answer is still wanted, and is told what there is of it so far.
pub struct Watch<'a, V> {
    newest: &'a AtomicU64,
    number: u64,
    tell: &'a (dyn Fn(V, f64) + Sync),
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

/// What answers a query: the answer, or nothing where it was given up.
type Compute<V> = dyn Fn(Detail, &Watch<'_, V>) -> Option<V> + Send + Sync;

/// How far an answer is of which a part is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// The share of the work done, 0..1.
    pub share: f64,
    /// About how many seconds are left, once that can be said.
    pub seconds_left: Option<f64>,
}

/// The share of the work from which on the rest can be estimated.
const TELLING_SHARE: f64 = 0.02;

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
    part: Option<Part>,
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
    pace: Pace,
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
    /// In what detail it answers the query asked; `None` for the answer to an older one, and for none. A part is coarse.
    pub detail: Option<Detail>,
    /// Where it is a part: how far that is.
    pub part: Option<Part>,
}

impl<V> Answer<V> {
    /// No answer yet.
    #[must_use]
    pub fn nothing() -> Self {
        Self {
            value: None,
            detail: None,
            part: None,
        }
    }
}

impl<K, V> Slot<K, V>
where
    K: PartialEq + Clone + Send + Sync + 'static,
    V: Send + Sync + 'static,
{
    /// The answer for `key`, computed by `compute` only where the key differs from the last one.
    ///
    /// It is computed now if there is time in this frame; else the last answer is returned, and `jobs` wakes the window
    /// when there is a better one.
    pub fn ask(
        &mut self,
        jobs: &mut Jobs,
        key: &K,
        pace: Pace,
        compute: impl Fn(Detail, &Watch<'_, V>) -> Option<V> + Send + Sync + 'static,
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
            if jobs.has_time_for(pace, state.took) {
                state.query = None;
                drop(state);
                self.answer_now(jobs, number, key.clone(), &compute);
            } else {
                state.query = Some(Query {
                    number,
                    key: key.clone(),
                    pace,
                    compute: Arc::new(compute),
                    clock: jobs.clock,
                });
                if !std::mem::replace(&mut state.is_queued, true) {
                    jobs.push(pace, Arc::clone(&self.asked) as _);
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
                part: shown.part,
            });
        }
        self.answer(key)
    }

    /// What there is by now of the answer for `key`, and whether more of it will come; nothing is asked anew.
    pub fn look(&mut self, key: &K) -> (Answer<V>, bool) {
        self.collect();
        let state = locked(&self.asked.state);
        let is_awaited = state.query.is_some() && state.is_queued;
        drop(state);
        (self.answer(key), is_awaited)
    }

    /// What is shown, as an answer for `key`.
    fn answer(&self, key: &K) -> Answer<V> {
        let answers = |shown: &&Shown<K, V>| shown.key == *key;
        let shown = self.shown.as_ref();
        Answer {
            value: shown.map(|shown| Arc::clone(&shown.value)),
            detail: shown.filter(answers).map(|shown| shown.detail),
            part: shown.filter(answers).and_then(|shown| shown.part),
        }
    }

    fn answer_now(
        &mut self,
        jobs: &mut Jobs,
        number: u64,
        key: K,
        compute: &impl Fn(Detail, &Watch<'_, V>) -> Option<V>,
    ) {
        let watch = Watch {
            newest: &self.asked.newest,
            number,
            // The whole is there before anything is shown.
            tell: &|_, _| {},
        };
        let (value, seconds) = jobs.timed(|| compute(Detail::Full, &watch));
        locked(&self.asked.state).took = Some(seconds);
        if let Some(value) = value {
            self.show(Shown {
                number,
                key,
                value: Arc::new(value),
                detail: Detail::Full,
                part: None,
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
                .is_none_or(|shown| rank(shown) <= rank(&answer))
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

impl<K, V> Slot<K, V> {
    /// Calls off what was asked last: what is known of it stays.
    pub fn call_off(&mut self) {
        self.asked.newest.fetch_add(1, Ordering::Relaxed);
        locked(&self.asked.state).query = None;
    }
}

impl<K, V> Drop for Slot<K, V> {
    fn drop(&mut self) {
        self.call_off();
    }
}

impl<K, V> Task for Asked<K, V>
where
    K: PartialEq + Clone + Send + Sync + 'static,
    V: Send + Sync + 'static,
{
    fn work(&self, turn: Detail, wake: &(dyn Fn() + Sync)) -> Option<Detail> {
        let (number, key, pace, compute, clock) = {
            let mut state = locked(&self.state);
            let Some(query) = &state.query else {
                state.is_queued = false;
                return None;
            };
            let (key, compute) = (query.key.clone(), Arc::clone(&query.compute));
            (query.number, key, query.pace, compute, query.clock)
        };
        let detail = match pace {
            Pace::CoarseFirst => turn,
            _ => Detail::Full,
        };
        // A first answer is always finished: else nothing new would be shown while the inputs keep changing.
        let unchanging = AtomicU64::new(number);
        let newest = match turn {
            Detail::Coarse => &unchanging,
            Detail::Full => &self.newest,
        };
        let start = clock.map(|clock| clock());
        let seconds = || clock.zip(start).map(|(clock, start)| clock() - start);
        let tell = |value: V, share: f64| {
            let left = |seconds: f64| seconds * (1.0 / share - 1.0);
            let part = Part {
                share,
                seconds_left: seconds().map(left).filter(|_| share > TELLING_SHARE),
            };
            locked(&self.state).answer = Some(Shown {
                number,
                key: key.clone(),
                value: Arc::new(value),
                detail: Detail::Coarse,
                part: Some(part),
            });
            wake();
        };
        let watch = Watch {
            newest,
            number,
            tell: &tell,
        };
        // Whatever panics says so by the hook of the program. The thread goes on with what others ask.
        let computed = catch_unwind(AssertUnwindSafe(|| compute(detail, &watch)));
        let has_failed = computed.is_err();
        let value = computed.ok().flatten();
        let mut state = locked(&self.state);
        if let Some(value) = value {
            if detail == Detail::Full {
                state.took = seconds();
            }
            state.answer = Some(Shown {
                number,
                key,
                value: Arc::new(value),
                detail,
                part: None,
            });
        }
        let next = match &state.query {
            Some(query) if query.number != number => Some(first_turn(query.pace)),
            Some(_) if detail == Detail::Coarse && !has_failed => Some(Detail::Full),
            _ => None,
        };
        if next.is_none() {
            // What failed stays asked, and is not tried again before something else is.
            if !has_failed {
                state.query = None;
            }
            state.is_queued = false;
        }
        next
    }
}

#[cfg(test)]
mod tests;
