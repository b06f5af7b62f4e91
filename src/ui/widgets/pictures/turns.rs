//! Who paints in this frame: what takes time is shared out over frames, so that a window full of pictures still moves.

use std::sync::Arc;

use egui::Context;

use bxdf_study::jobs::Clock;
use bxdf_study::memo::Memo;

/// Seconds of a frame that pictures may take; what comes later keeps what it shows until it has its turn.
const BUDGET: f64 = 5e-3;

/// The turns of a frame.
#[derive(Default)]
pub struct Turns {
    /// Without one, as for pictures that are files, all is painted at once.
    clock: Option<Clock>,
    spent: f64,
    /// For how many frames somebody had waited at the end of the last one, and will have at the end of this one.
    longest: u32,
    next_longest: u32,
}

impl Turns {
    /// Turns by this clock.
    #[must_use]
    pub fn by(clock: Option<Clock>) -> Self {
        Self {
            clock,
            ..Self::default()
        }
    }

    /// Begins a frame.
    pub fn begin_frame(&mut self) {
        self.spent = 0.0;
        self.longest = std::mem::take(&mut self.next_longest);
    }

    /// What `work` makes, where it has its turn: those that have waited for most frames have it first. `waits`: for how many it
    /// has.
    pub fn take<T>(
        &mut self,
        ctx: &Context,
        waits: &mut u32,
        work: impl FnOnce() -> T,
    ) -> Option<T> {
        let Some(clock) = self.clock else {
            return Some(work());
        };
        if self.spent >= BUDGET || *waits < self.longest {
            *waits += 1;
            self.next_longest = self.next_longest.max(*waits);
            ctx.request_repaint();
            return None;
        }
        *waits = 0;
        Some(self.timed(clock, work))
    }

    /// What `work` makes that cannot wait; its time counts.
    pub fn at_once<T>(&mut self, work: impl FnOnce() -> T) -> T {
        match self.clock {
            Some(clock) => self.timed(clock, work),
            None => work(),
        }
    }

    fn timed<T>(&mut self, clock: Clock, work: impl FnOnce() -> T) -> T {
        let start = clock();
        let made = work();
        self.spent += clock() - start;
        made
    }
}

/// A value that is kept while its inputs stay the same, and a little longer where it has to wait for its turn.
pub struct Turned<K, V> {
    memo: Memo<K, V>,
    waits: u32,
}

impl<K, V> Default for Turned<K, V> {
    fn default() -> Self {
        Self {
            memo: Memo::default(),
            waits: 0,
        }
    }
}

impl<K: PartialEq, V> Turned<K, V> {
    /// The value of `compute` for `key`; where it has no turn yet, the one before.
    pub fn get(
        &mut self,
        (turns, ctx): (&mut Turns, &Context),
        key: K,
        compute: impl FnOnce() -> V,
    ) -> Arc<V> {
        let Self { memo, waits } = self;
        match memo.last() {
            Some(last) if memo.has(&key) => last,
            Some(last) => {
                let made = turns.take(ctx, waits, || memo.get(key, compute));
                made.unwrap_or(last)
            }
            None => turns.at_once(|| memo.get(key, compute)),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::*;

    thread_local! {
        static NOW: Cell<f64> = const { Cell::new(0.0) };
    }

    fn clock() -> f64 {
        NOW.get()
    }

    /// Eight pictures that change in every frame and take 2 ms each: none waits for more than four frames.
    #[test]
    fn everybody_has_a_turn_while_everything_moves() {
        let mut turns = Turns::by(Some(clock));
        let ctx = Context::default();
        let mut waiting = [0; 8];
        let mut last = [0; 8];
        for frame in 1..50 {
            turns.begin_frame();
            for (waits, last) in waiting.iter_mut().zip(&mut last) {
                let paint = || NOW.set(NOW.get() + 2e-3);
                if turns.take(&ctx, waits, paint).is_some() {
                    *last = frame;
                }
            }
            assert!(turns.spent < BUDGET + 2e-3);
            assert!(
                frame < 5 || last.iter().all(|last| frame - last <= 4),
                "{last:?}"
            );
        }
    }

    #[test]
    fn without_a_clock_nobody_waits() {
        let mut turns = Turns::default();
        for _ in 0..100 {
            let made = turns.take(&Context::default(), &mut 0, || 1);
            assert_eq!(made, Some(1));
        }
    }
}
