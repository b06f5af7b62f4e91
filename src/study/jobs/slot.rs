//! A query that is asked again whenever its inputs change, and the last answer to it.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;

use super::{Clock, Jobs, Task, first_turn, locked};
use bxdf_lab::analysis::{Detail, Pace, Steps, finish};

mod watch;

use watch::{Compute, TELLING_SHARE};
pub use watch::{Part, Watch};

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
        compute: impl for<'a> Fn(Detail, &'a Watch<'a, V>) -> Steps<'a, Option<V>>
        + Send
        + Sync
        + 'static,
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

    fn answer_now(&mut self, jobs: &mut Jobs, number: u64, key: K, compute: &Compute<V>) {
        let watch = Watch {
            newest: &self.asked.newest,
            number,
            // The whole is there before anything is shown.
            tell: &|_, _| {},
        };
        let (value, seconds) = jobs.timed(|| finish(compute(Detail::Full, &watch)));
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

/// A query that is being answered.
struct Run<K, V> {
    number: u64,
    key: K,
    pace: Pace,
    compute: Arc<Compute<V>>,
    clock: Option<Clock>,
    start: Option<f64>,
}

impl<K, V> Run<K, V> {
    fn seconds(&self) -> Option<f64> {
        let (clock, start) = self.clock.zip(self.start)?;
        Some(clock() - start)
    }
}

impl<K, V> Asked<K, V>
where
    K: PartialEq + Clone + Send + Sync + 'static,
    V: Send + Sync + 'static,
{
    /// Begins to answer what is asked by now.
    fn begin(&self) -> Option<Run<K, V>> {
        let mut state = locked(&self.state);
        let Some(query) = &state.query else {
            state.is_queued = false;
            return None;
        };
        Some(Run {
            number: query.number,
            key: query.key.clone(),
            pace: query.pace,
            compute: Arc::clone(&query.compute),
            clock: query.clock,
            start: query.clock.map(|clock| clock()),
        })
    }

    /// Shows a part of the answer.
    fn tell(&self, run: &Run<K, V>, value: V, share: f64) {
        let left = |seconds: f64| seconds * (1.0 / share - 1.0);
        let part = Part {
            share,
            seconds_left: run.seconds().map(left).filter(|_| share > TELLING_SHARE),
        };
        locked(&self.state).answer = Some(Shown {
            number: run.number,
            key: run.key.clone(),
            value: Arc::new(value),
            detail: Detail::Coarse,
            part: Some(part),
        });
    }

    /// Takes what has come of a run; says in which detail it wants to be answered next, if at all.
    fn settle(
        &self,
        run: Run<K, V>,
        detail: Detail,
        value: thread::Result<Option<V>>,
    ) -> Option<Detail> {
        let has_failed = value.is_err();
        let seconds = run.seconds();
        let mut state = locked(&self.state);
        if let Ok(Some(value)) = value {
            if detail == Detail::Full {
                state.took = seconds;
            }
            state.answer = Some(Shown {
                number: run.number,
                key: run.key,
                value: Arc::new(value),
                detail,
                part: None,
            });
        }
        let next = match &state.query {
            Some(query) if query.number != run.number => Some(first_turn(query.pace)),
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

impl<K, V> Task for Asked<K, V>
where
    K: PartialEq + Clone + Send + Sync + 'static,
    V: Send + Sync + 'static,
{
    fn work(&self, turn: Detail, wake: &(dyn Fn() + Sync)) -> Option<Detail> {
        let run = self.begin()?;
        let detail = match run.pace {
            Pace::CoarseFirst => turn,
            _ => Detail::Full,
        };
        // A first answer is always finished: else nothing new would be shown while the inputs keep changing.
        let unchanging = AtomicU64::new(run.number);
        let newest = match turn {
            Detail::Coarse => &unchanging,
            Detail::Full => &self.newest,
        };
        let tell = |value: V, share: f64| {
            self.tell(&run, value, share);
            wake();
        };
        let watch = Watch {
            newest,
            number: run.number,
            tell: &tell,
        };
        // Whatever panics says so by the hook of the program. The thread goes on with what others ask.
        let computed = catch_unwind(AssertUnwindSafe(|| finish((run.compute)(detail, &watch))));
        self.settle(run, detail, computed)
    }

    fn in_steps(self: Arc<Self>) -> Steps<'static, ()> {
        Box::pin(async move {
            while let Some(run) = self.begin() {
                let tell = |value: V, share: f64| self.tell(&run, value, share);
                let watch = Watch {
                    newest: &self.newest,
                    number: run.number,
                    tell: &tell,
                };
                let value = (run.compute)(Detail::Full, &watch).await;
                if self.settle(run, Detail::Full, Ok(value)).is_none() {
                    return;
                }
            }
        })
    }
}

#[cfg(test)]
mod tests;
