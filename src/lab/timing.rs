//! Time measured honestly: warmed up, repeated, and given with its spread.

use std::time::Duration;

use serde::Serialize;
use web_time::Instant;

/// Timed repetitions of a piece of work.
const REPETITIONS: usize = 7;

/// The least time of a repetition: work that takes less is done several times in each. A thousand times what reading the
/// clock takes.
const SHORTEST: Duration = Duration::from_micros(100);

/// The most that the repetitions of one piece of work may take together, once there are three.
const LONGEST: Duration = Duration::from_millis(150);

/// How long something takes, in nanoseconds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Timing {
    /// The median of the repetitions.
    pub ns: f64,
    /// Their first and third quartile.
    pub spread: [f64; 2],
}

impl Timing {
    /// Of these times, in any order; NaN where there are none.
    #[must_use]
    pub fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        let rank = |quarters: usize| {
            let index = times.len().saturating_sub(1) * quarters / 4;
            times.get(index).copied().unwrap_or(f64::NAN)
        };
        Self {
            ns: rank(2),
            spread: [rank(1), rank(3)],
        }
    }

    /// The time of each of `parts` equal parts.
    #[must_use]
    pub fn over(self, parts: f64) -> Self {
        Self {
            ns: self.ns / parts,
            spread: self.spread.map(|ns| ns / parts),
        }
    }
}

/// Measures how long work takes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stopwatch {
    /// The clock of the machine: once to warm up, then the median of several repetitions.
    #[default]
    WallClock,
    /// No clock at all: a nanosecond for each unit of size. What needs the same result twice, as a stored picture, uses it.
    NoClock,
}

impl Stopwatch {
    /// The time of `work`, which is done several times; `size` says how much it is, in any unit that grows with its cost.
    #[must_use]
    pub fn time(self, size: f64, work: &mut dyn FnMut()) -> Timing {
        match self {
            Self::WallClock => Timing::of(repeated(work)),
            Self::NoClock => {
                work();
                Timing {
                    ns: size,
                    spread: [size; 2],
                }
            }
        }
    }
}

/// The nanoseconds of `work` in each of several repetitions.
fn repeated(work: &mut dyn FnMut()) -> Vec<f64> {
    let once = elapsed(work);
    let count = (SHORTEST.as_secs_f64() / once.as_secs_f64().max(1e-9)).ceil() as u32;
    let count = count.max(1);
    let begin = Instant::now();
    let mut times = Vec::with_capacity(REPETITIONS);
    while times.len() < REPETITIONS && (times.len() < 3 || begin.elapsed() < LONGEST) {
        let time = elapsed(&mut || (0..count).for_each(|_| work()));
        times.push(time.as_secs_f64() * 1e9 / f64::from(count));
    }
    times
}

fn elapsed(work: &mut dyn FnMut()) -> Duration {
    let begin = Instant::now();
    work();
    begin.elapsed()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_stands_between_the_quartiles() {
        let timing = Timing::of(vec![5.0, 1.0, 4.0, 2.0, 3.0]);
        assert_eq!((timing.ns, timing.spread), (3.0, [2.0, 4.0]));
        assert_eq!(timing.over(2.0).spread, [1.0, 2.0]);
        assert!(Timing::of(Vec::new()).ns.is_nan());
    }

    #[test]
    fn work_is_done_and_takes_time() {
        let mut sum = 0.0_f64;
        let mut work =
            || (0..2000_u32).for_each(|x| sum += std::hint::black_box(f64::from(x)).sqrt());
        let timing = Stopwatch::WallClock.time(1.0, &mut work);
        assert!(
            timing.ns > 100.0 && timing.spread[0] <= timing.spread[1],
            "{timing:?}"
        );
        assert_eq!(Stopwatch::NoClock.time(7.0, &mut work).ns, 7.0);
        assert!(sum > 0.0);
    }
}
