//! Work off the UI thread: a pool of workers that never makes the window wait.
//!
//! A [`Slot`] holds the last answer to one query and is asked again whenever its inputs change. What was asked last
//! is all that counts: a slot waits in the queue at most once, and a worker that comes to it answers the newest query.
//! It answers coarsely first; all coarse answers go before all full ones, and among equals the newest query first.
//! A full answer that nobody waits for any more is given up while it is being computed. What takes seconds does not
//! wait in the queue: it has threads of its own, and tells what it has so far.
//!
//! Short work is done at once, in the frame that asks: a slot that took less than a few milliseconds last time, as long as
//! the frame has time left. Without a clock (pictures, tests) everything is: so pictures need no patience and are the
//! same bytes twice.

use std::collections::VecDeque;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::parallel::{Pool, threads};
use bxdf_lab::analysis::{Detail, Pace, Steps, step};

mod slot;

pub use slot::{Answer, Part, Slot, Watch};

/// A clock: seconds since some start. Pictures and tests have none, so that they are the same bytes twice.
pub type Clock = fn() -> f64;

/// Seconds of a frame that may be spent on answers; what is expected to take longer goes to the pool.
const FRAME_BUDGET: f64 = 4e-3;

/// Seconds of a frame in which tasks are worked on where there are no threads: none is begun after that.
const SLICE: f64 = 8e-3;

/// For how many seconds nothing must have been asked before full answers are begun where there are no threads: they may take
/// longer than a frame, and something may be moving.
const QUIET: f64 = 0.12;

/// Something that waits in the queue.
trait Task: Send + Sync {
    /// Answers in this detail, and calls `wake` after each part; says in which detail it wants to answer next, if at all.
    fn work(&self, detail: Detail, wake: &(dyn Fn() + Sync)) -> Option<Detail>;

    /// Answers in full, step by step.
    fn in_steps(self: Arc<Self>) -> Steps<'static, ()>;
}

/// The turn in which a query of this pace is answered first.
fn first_turn(pace: Pace) -> Detail {
    if pace.is_awaited() {
        Detail::Coarse
    } else {
        Detail::Full
    }
}

/// The pool, and the time that is left in this frame.
pub struct Jobs {
    queue: Arc<Queue>,
    clock: Option<Clock>,
    pool: Pool,
    spent: f64,
    /// What takes seconds, where there are no threads: the first one is worked on in slices of frames.
    long: VecDeque<Steps<'static, ()>>,
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
    /// When something was asked last, in seconds of the clock.
    pushed_at: Option<f64>,
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

    /// Works on the task that comes first, a coarse one alone unless `least` is full; whether there was one.
    fn work(&self, state: MutexGuard<'_, QueueState>, least: Detail) -> bool {
        let mut state = state;
        let first = match (state.coarse.pop(), least) {
            (Some(task), _) => Some((task, Detail::Coarse)),
            (None, Detail::Full) => state.full.pop().map(|task| (task, Detail::Full)),
            (None, Detail::Coarse) => None,
        };
        let Some((task, detail)) = first else {
            return false;
        };
        state.running += 1;
        drop(state);
        let again = task.work(detail, &*self.wake);
        locked(&self.state).running -= 1;
        if let Some(detail) = again {
            self.push(detail, task);
        }
        (self.wake)();
        true
    }

    /// Works on a task that waits for no other.
    fn work_beside(&self, task: &dyn Task) {
        while task.work(Detail::Full, &*self.wake).is_some() {}
        locked(&self.state).running -= 1;
        (self.wake)();
    }

    /// What a thread of the pool does until nothing is left to do, or nobody waits for it any more.
    fn serve(&self) {
        loop {
            let mut state = locked(&self.state);
            if state.is_closed || (state.coarse.is_empty() && state.full.is_empty()) {
                state.serving -= 1;
                return;
            }
            self.work(state, Detail::Full);
        }
    }
}

impl Jobs {
    /// Work for as many threads of `pool` at a time as there are cores but the one that draws; `wake` is called after each
    /// answer, and each part of one.
    ///
    /// Without a `clock` everything is answered at once.
    #[must_use]
    pub fn new(clock: Option<Clock>, pool: Pool, wake: impl Fn() + Send + Sync + 'static) -> Self {
        let queue = Arc::new(Queue {
            state: Mutex::default(),
            most_serving: threads().saturating_sub(1).max(1),
            wake: Box::new(wake),
        });
        Self {
            queue,
            clock,
            pool,
            spent: 0.0,
            long: VecDeque::new(),
        }
    }

    /// Begins a frame. Where there are no workers, as in a browser, this is the time slice in which tasks are done.
    pub fn begin_frame(&mut self) {
        self.spent = 0.0;
        if let Some(clock) = self.clock.filter(|_| !self.pool.has_threads()) {
            self.work_in_slice(clock);
        }
    }

    /// Works for a part of a frame: on first answers alone while something moves, and on what takes seconds where nothing else
    /// waits.
    fn work_in_slice(&mut self, clock: Clock) {
        let start = clock();
        let pushed_at = locked(&self.queue.state).pushed_at;
        let is_quiet = pushed_at.is_none_or(|at| start - at > QUIET);
        let least = if is_quiet {
            Detail::Full
        } else {
            Detail::Coarse
        };
        while clock() - start < SLICE {
            if self.queue.work(locked(&self.queue.state), least) {
                continue;
            }
            let Some(first) = self.long.front_mut().filter(|_| is_quiet) else {
                break;
            };
            if step(first).is_ready() {
                self.long.pop_front();
            }
        }
        if self.is_busy() {
            // The next frame goes on.
            (self.queue.wake)();
        }
    }

    /// Lets `task` wait for its first answer.
    fn push(&mut self, pace: Pace, task: Arc<dyn Task>) {
        let queue = Arc::clone(&self.queue);
        if !self.pool.has_threads() {
            locked(&queue.state).pushed_at = self.clock.map(|clock| clock());
            match pace {
                Pace::Long => self.long.push_back(task.in_steps()),
                _ => queue.push(first_turn(pace), task),
            }
            // The next frame has a slice for it.
            (queue.wake)();
            return;
        }
        if pace == Pace::Long {
            locked(&queue.state).running += 1;
            self.pool.spawn_long(move || queue.work_beside(&*task));
            return;
        }
        queue.push(first_turn(pace), task);
        if queue.can_serve() {
            self.pool.spawn(move || queue.serve());
        }
    }

    /// Whether anything waits or is being worked on.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        let state = locked(&self.queue.state);
        let is_long = !self.long.is_empty();
        is_long || state.running > 0 || !state.coarse.is_empty() || !state.full.is_empty()
    }

    /// Seconds of this frame spent on answers.
    #[must_use]
    pub fn spent(&self) -> f64 {
        self.spent
    }

    /// Whether work of `seconds` may be done in this frame.
    fn has_time_for(&self, pace: Pace, seconds: Option<f64>) -> bool {
        let is_short = |seconds| self.spent + seconds <= FRAME_BUDGET;
        self.clock.is_none() || pace == Pace::AtOnce || seconds.is_some_and(is_short)
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
