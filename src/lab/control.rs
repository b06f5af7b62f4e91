//! A control of what threads bring: plain arithmetic on one thread and on all.

use std::time::Instant;

use rayon::prelude::*;
use serde::Serialize;

use super::timing::Timing;

/// Steps of the arithmetic: as long as a batch takes.
const STEPS: usize = 1 << 20;

/// Steps that one task takes.
const CHUNK: usize = 1 << 14;

/// What threads bring on this machine at this moment: the same plain arithmetic on one and on all of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Control {
    /// Nanoseconds of a step on one thread, the median of the repetitions.
    pub one_thread_ns: f64,
    /// Nanoseconds of a step on all threads.
    pub all_threads_ns: f64,
}

impl Control {
    /// The medians of several, each by itself; none of none.
    #[must_use]
    pub fn median_of(all: &[Self]) -> Option<Self> {
        let median = |of: fn(&Self) -> f64| Timing::of(all.iter().map(of).collect()).ns;
        (!all.is_empty()).then(|| Self {
            one_thread_ns: median(|one| one.one_thread_ns),
            all_threads_ns: median(|one| one.all_threads_ns),
        })
    }
}

/// Arithmetic that touches no memory: no batch gains more from threads, and on a machine whose cores are busy this gains as
/// little as they do.
fn plain_arithmetic(is_parallel: bool) {
    let steps =
        |count: usize| (0..count).fold(0.5, |x: f64, _| std::hint::black_box(1.25 * x * (1.0 - x)));
    let parts = STEPS / CHUNK;
    let sum: f64 = if is_parallel {
        (0..parts).into_par_iter().map(|_| steps(CHUNK)).sum()
    } else {
        (0..parts).map(|_| steps(CHUNK)).sum()
    };
    std::hint::black_box(sum);
}

/// The times of a control so far, on one thread and on all.
#[derive(Default)]
pub(super) struct Controls([Vec<f64>; 2]);

impl Controls {
    pub(super) fn time(&mut self, round: usize) {
        for (is_parallel, times) in [false, true].into_iter().zip(&mut self.0) {
            time(round, STEPS, times, || plain_arithmetic(is_parallel));
        }
    }

    pub(super) fn medians(self) -> Control {
        let [one, all] = self.0.map(|times| Timing::of(times).ns);
        Control {
            one_thread_ns: one,
            all_threads_ns: all,
        }
    }
}

/// Adds the nanoseconds that `work` takes for each of `count` steps to `times`.
pub(super) fn time(round: usize, count: usize, times: &mut Vec<f64>, work: impl FnOnce()) {
    let start = Instant::now();
    work();
    // The first round warms up: the pages of the output are touched, the clock is raised, the threads are awake.
    if round > 0 {
        times.push(start.elapsed().as_secs_f64() * 1e9 / count as f64);
    }
}
