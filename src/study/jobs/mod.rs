//! Work off the UI thread: a pool of workers that never makes the window wait.
//!
//! A [`Slot`] holds the last answer to one query and is asked again whenever its inputs change. What was asked last
//! is all that counts: a slot waits in the queue at most once, and a worker that comes to it answers the newest query.
//! It answers coarsely first; all coarse answers go before all full ones, and among equals the newest query first.
//! A full answer that nobody waits for any more is given up while it is being computed.
//!
//! Short work is done at once, in the frame that asks: a slot that took less than a few milliseconds last time, as long as
//! the frame has time left. Without a clock (pictures, tests) everything is: so pictures need no patience and are the
//! same bytes twice.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::platform;
use crate::parallel::Pool;
use bxdf_lab::analysis::Detail;

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
    pool: Option<Pool>,
    spent: f64,
}

/// The tasks that wait, newest last, and what is to be done when one is answered.
struct Queue {
    state: Mutex<QueueState>,
    /// How many threads of the pool may serve at a time; the others take part in what these do.
    most_serving: usize,
    wake: Box<dyn Fn() + Send + Sync>,
}

#[derive(Default)]
struct QueueState {
    coarse: Vec<Arc<dyn Task>>,
    full: Vec<Arc<dyn Task>>,
    running: usize,
    serving: usize,
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
    }

    /// Whether one more thread may serve; it is counted then.
    fn can_serve(&self) -> bool {
        let mut state = locked(&self.state);
        let can_serve = state.serving < self.most_serving;
        state.serving += usize::from(can_serve);
        can_serve
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
        (self.wake)();
        true
    }

    /// What a thread of the pool does until nothing is left to do, or nobody waits for it any more.
    fn serve(&self) {
        loop {
            let mut state = locked(&self.state);
            if state.is_closed || (state.coarse.is_empty() && state.full.is_empty()) {
                state.serving -= 1;
                return;
            }
            self.work(state);
        }
    }
}

impl Jobs {
    /// A pool that serves with as many threads as there are cores but the one that draws; `wake` is called after each
    /// answer.
    ///
    /// Without a `clock` there is no pool and everything is answered at once.
    #[must_use]
    pub fn new(clock: Option<Clock>, wake: impl Fn() + Send + Sync + 'static) -> Self {
        let queue = Arc::new(Queue {
            state: Mutex::default(),
            most_serving: platform::workers(),
            wake: Box::new(wake),
        });
        Self {
            queue,
            clock,
            pool: clock.and_then(|_| Pool::new()),
            spent: 0.0,
        }
    }

    /// Begins a frame. Where there are no workers, as in a browser, this is the time slice in which one task is done.
    pub fn begin_frame(&mut self) {
        self.spent = 0.0;
        if self.clock.is_some() && self.pool.is_none() {
            self.queue.work(locked(&self.queue.state));
        }
    }

    /// Lets `task` wait for its first answer.
    fn push(&self, task: Arc<dyn Task>) {
        self.queue.push(Detail::Coarse, task);
        match &self.pool {
            Some(pool) if self.queue.can_serve() => {
                let queue = Arc::clone(&self.queue);
                pool.spawn(move || queue.serve());
            }
            Some(_) => {}
            // The next frame is its time slice.
            None => (self.queue.wake)(),
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
    }
}
