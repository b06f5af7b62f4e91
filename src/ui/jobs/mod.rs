//! Work off the UI thread: a pool of workers that never makes the window wait.
//!
//! A [`Slot`] holds the last answer to one question and is asked again whenever its inputs change. What was asked last
//! is all that counts: a slot waits in the queue at most once, and a worker that comes to it answers the newest question.
//! It answers coarsely first; all coarse answers go before all full ones, and among equals the newest question first.
//! A full answer that nobody waits for any more is given up while it is being computed.
//!
//! Short work is done at once, in the frame that asks: a slot that took less than a few milliseconds last time, as long as
//! the frame has time left. Without a clock (pictures, tests) everything is: so pictures need no patience and are the
//! same bytes twice.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

use super::platform;
use crate::analysis::Detail;

mod slot;

pub use slot::{Answer, Slot, Watch};

/// A clock: seconds since some start. Pictures and tests have none, so that they are the same bytes twice.
pub type Clock = fn() -> f64;

/// Seconds of a frame that may be spent on answers; what is expected to take longer goes to the pool.
const FRAME_BUDGET: f64 = 4e-3;

/// Something that waits in the queue.
trait Task: Send + Sync {
    /// Answers in this detail; says in which detail it wants to answer next, if at all.
    fn work(&self, detail: Detail) -> Option<Detail>;
}

/// The pool, and the time that is left in this frame.
pub struct Jobs {
    queue: Arc<Queue>,
    clock: Option<Clock>,
    has_workers: bool,
    spent: f64,
}

/// The tasks that wait, newest last, and what is to be done when one is answered.
struct Queue {
    state: Mutex<QueueState>,
    has_more: Condvar,
    wake: Box<dyn Fn() + Send + Sync>,
}

#[derive(Default)]
struct QueueState {
    coarse: Vec<Arc<dyn Task>>,
    full: Vec<Arc<dyn Task>>,
    running: usize,
    is_closed: bool,
}

/// What a lock protects. No code that holds one of these can panic half-way.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Queue {
    fn push(&self, detail: Detail, task: Arc<dyn Task>) {
        let mut state = locked(&self.state);
        match detail {
            Detail::Coarse => state.coarse.push(task),
            Detail::Full => state.full.push(task),
        }
        self.has_more.notify_one();
    }

    /// Works on the task that comes first; whether there was one.
    fn work(&self, state: MutexGuard<'_, QueueState>) -> bool {
        let mut state = state;
        let first = match state.coarse.pop() {
            Some(task) => Some((task, Detail::Coarse)),
            None => state.full.pop().map(|task| (task, Detail::Full)),
        };
        let Some((task, detail)) = first else {
            return false;
        };
        state.running += 1;
        drop(state);
        let again = task.work(detail);
        let mut state = locked(&self.state);
        state.running -= 1;
        match again {
            Some(Detail::Coarse) => state.coarse.push(task),
            Some(Detail::Full) => state.full.push(task),
            None => {}
        }
        drop(state);
        self.has_more.notify_one();
        (self.wake)();
        true
    }

    /// What a worker does until the pool is closed.
    fn serve(&self) {
        loop {
            let mut state = locked(&self.state);
            while state.coarse.is_empty() && state.full.is_empty() && !state.is_closed {
                state = self
                    .has_more
                    .wait(state)
                    .unwrap_or_else(PoisonError::into_inner);
            }
            if state.is_closed {
                return;
            }
            self.work(state);
        }
    }
}

impl Jobs {
    /// A pool with a worker for each core but the one that draws; `wake` is called after each answer.
    ///
    /// Without a `clock` there are no workers and everything is answered at once.
    #[must_use]
    pub fn new(clock: Option<Clock>, wake: impl Fn() + Send + Sync + 'static) -> Self {
        let queue = Arc::new(Queue {
            state: Mutex::default(),
            has_more: Condvar::new(),
            wake: Box::new(wake),
        });
        let mut has_workers = false;
        if clock.is_some() {
            for _ in 0..platform::workers() {
                let queue = Arc::clone(&queue);
                has_workers |= platform::spawn(move || queue.serve());
            }
        }
        Self {
            queue,
            clock,
            has_workers,
            spent: 0.0,
        }
    }

    /// Begins a frame. Where there are no workers, as in a browser, this is the time slice in which one task is done.
    pub fn begin_frame(&mut self) {
        self.spent = 0.0;
        if self.clock.is_some() && !self.has_workers {
            self.queue.work(locked(&self.queue.state));
        }
    }

    /// Lets `task` wait for its first answer.
    fn push(&self, task: Arc<dyn Task>) {
        self.queue.push(Detail::Coarse, task);
        if !self.has_workers {
            // The next frame is its time slice.
            (self.queue.wake)();
        }
    }

    /// Whether anything waits or is being worked on.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        let state = locked(&self.queue.state);
        state.running > 0 || !state.coarse.is_empty() || !state.full.is_empty()
    }

    /// Seconds of this frame spent on answers.
    #[must_use]
    pub fn spent(&self) -> f64 {
        self.spent
    }

    /// Whether work of `seconds` may be done in this frame.
    fn has_time_for(&self, seconds: Option<f64>) -> bool {
        self.clock.is_none() || seconds.is_some_and(|seconds| self.spent + seconds <= FRAME_BUDGET)
    }

    /// The result of `work`, whose time counts for this frame, and the seconds it took.
    fn timed<T>(&mut self, work: impl FnOnce() -> T) -> (T, f64) {
        let Some(clock) = self.clock else {
            return (work(), 0.0);
        };
        let start = clock();
        let result = work();
        let seconds = clock() - start;
        self.spent += seconds;
        (result, seconds)
    }
}

impl Drop for Jobs {
    fn drop(&mut self) {
        locked(&self.queue.state).is_closed = true;
        self.queue.has_more.notify_all();
    }
}
