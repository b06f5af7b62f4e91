use std::sync::atomic::AtomicUsize;
use std::sync::mpsc;
use std::time::Duration;

use super::*;
use crate::jobs::FRAME_BUDGET;
use crate::parallel::Pool;
use crate::platform;

/// A pool whose answers are announced.
fn pool() -> (Jobs, mpsc::Receiver<()>) {
    let (sender, receiver) = mpsc::channel();
    let clock: Clock = platform::seconds;
    let jobs = Jobs::new(Some(clock), Pool::new(), move || {
        let _ = sender.send(());
    });
    (jobs, receiver)
}

/// What `compute` makes, in one step.
fn at_once<V: Send + Sync + 'static>(
    compute: impl Fn(Detail, &Watch<'_, V>) -> Option<V> + Send + Sync + 'static,
) -> impl for<'a> Fn(Detail, &'a Watch<'a, V>) -> Steps<'a, Option<V>> + Send + Sync + 'static {
    move |detail, watch| Box::pin(std::future::ready(compute(detail, watch)))
}

fn wait(announced: &mpsc::Receiver<()>) {
    announced
        .recv_timeout(Duration::from_secs(10))
        .expect("an answer");
}

/// What is expected to take long never does so in the frame: first nothing, then a coarse answer, then the full one.
#[test]
fn answers_come_coarse_first() {
    let (mut jobs, announced) = pool();
    let mut slot = Slot::<u32, (u32, Detail)>::default();
    let (open, gate) = mpsc::channel::<()>();
    let gate = Mutex::new(gate);
    let compute = move |detail, _: &Watch<'_, _>| {
        let _ = locked(&gate).recv();
        Some((1, detail))
    };
    let compute = Arc::new(compute);
    let ask = |slot: &mut Slot<_, _>, jobs: &mut Jobs| {
        let compute = Arc::clone(&compute);
        slot.ask(
            jobs,
            &1,
            Pace::CoarseFirst,
            at_once(move |detail, watch| compute(detail, watch)),
        )
    };
    assert!(ask(&mut slot, &mut jobs).value.is_none());
    open.send(()).unwrap();
    wait(&announced);
    let answer = ask(&mut slot, &mut jobs);
    assert_eq!(answer.value.as_deref(), Some(&(1, Detail::Coarse)));
    assert!(answer.detail == Some(Detail::Coarse) && jobs.is_busy());
    open.send(()).unwrap();
    wait(&announced);
    let answer = ask(&mut slot, &mut jobs);
    assert_eq!(answer.value.as_deref(), Some(&(1, Detail::Full)));
    assert!(answer.detail == Some(Detail::Full) && slot.version() == 2);
}

/// A query that was overtaken is given up, and the newest one answered.
#[test]
fn the_newest_question_counts() {
    let (mut jobs, announced) = pool();
    let mut slot = Slot::<u32, u32>::default();
    let answered = Arc::new(AtomicUsize::new(0));
    let mut ask = |key: u32| {
        let answered = Arc::clone(&answered);
        slot.ask(
            &mut jobs,
            &key,
            Pace::CoarseFirst,
            at_once(move |detail, watch| {
                // The first query's full answer would take forever.
                while key == 1 && detail == Detail::Full && !watch.is_stale() {
                    std::thread::yield_now();
                }
                if watch.is_stale() {
                    return None;
                }
                answered.fetch_add(1, Ordering::Relaxed);
                Some(key)
            }),
        )
    };
    ask(1);
    wait(&announced);
    for key in 2..100 {
        ask(key);
    }
    loop {
        wait(&announced);
        let answer = ask(99);
        if answer.detail == Some(Detail::Full) {
            assert_eq!(answer.value.as_deref(), Some(&99));
            break;
        }
    }
    // Coarse and full ones of the first and the last, and those a worker came to in between.
    assert!(answered.load(Ordering::Relaxed) < 99);
}

/// What took little time last is computed in the frame that asks, until the frame's time is used up.
#[test]
fn short_work_is_done_at_once() {
    let (mut jobs, announced) = pool();
    let mut slot = Slot::<u32, u32>::default();
    slot.ask(&mut jobs, &1, Pace::CoarseFirst, at_once(|_, _| Some(1)));
    wait(&announced);
    wait(&announced);
    assert!(
        slot.ask(&mut jobs, &1, Pace::CoarseFirst, at_once(|_, _| None))
            .detail
            == Some(Detail::Full)
    );
    assert_eq!(
        slot.ask(&mut jobs, &2, Pace::CoarseFirst, at_once(|_, _| Some(2)))
            .value
            .as_deref(),
        Some(&2)
    );
    jobs.spent = FRAME_BUDGET;
    assert!(
        slot.ask(&mut jobs, &3, Pace::CoarseFirst, at_once(|_, _| Some(3)))
            .detail
            != Some(Detail::Full)
    );
    jobs.begin_frame();
    assert!(
        slot.ask(&mut jobs, &4, Pace::CoarseFirst, at_once(|_, _| Some(4)))
            .detail
            == Some(Detail::Full)
    );
}

#[test]
fn without_a_clock_everything_is_answered_at_once() {
    let mut jobs = Jobs::new(None, Pool::at_once(), || {});
    let mut slot = Slot::<u32, u32>::default();
    for key in [1, 2] {
        let answer = slot.ask(
            &mut jobs,
            &key,
            Pace::CoarseFirst,
            at_once(move |detail, _| (detail == Detail::Full).then_some(key)),
        );
        assert!(answer.detail == Some(Detail::Full) && answer.value.as_deref() == Some(&key));
    }
    assert!(!jobs.is_busy() && slot.version() == 2);
}

/// Two that are asked the same: one is computed, the other one shows it, and goes its own way when it is asked something else.
#[test]
fn a_slot_follows_another() {
    let mut jobs = Jobs::new(None, Pool::at_once(), || {});
    let [mut first, mut second] = [Slot::<u32, u32>::default(), Slot::default()];
    second.ask(&mut jobs, &7, Pace::Short, at_once(|_, _| Some(7)));
    let computed = first.ask(&mut jobs, &1, Pace::Short, at_once(|_, _| Some(1)));
    let followed = second.follow(&first, &1);
    assert!(followed.detail == Some(Detail::Full));
    assert!(Arc::ptr_eq(
        &computed.value.unwrap(),
        &followed.value.unwrap()
    ));
    let own = second.ask(&mut jobs, &1, Pace::Short, at_once(|_, _| None));
    assert!(own.detail == Some(Detail::Full) && own.value.as_deref() == Some(&1));
    let other = second.ask(&mut jobs, &2, Pace::Short, at_once(|_, _| Some(2)));
    assert_eq!(other.value.as_deref(), Some(&2));
    assert_eq!(
        first
            .ask(&mut jobs, &1, Pace::Short, at_once(|_, _| None))
            .value
            .as_deref(),
        Some(&1)
    );
}

/// Parts are shown while the whole is computed, beside what takes a moment; called off, the last one stays.
#[test]
fn a_long_answer_is_told_in_parts_and_holds_nothing_up() {
    let (mut jobs, announced) = pool();
    let mut slot = Slot::<u32, Vec<u32>>::default();
    let (open, gate) = mpsc::channel::<()>();
    let gate = Mutex::new(gate);
    let compute = move |_, watch: &Watch<'_, _>| {
        let mut parts = Vec::new();
        for part in 1..=4 {
            let _ = locked(&gate).recv();
            if watch.is_stale() {
                return None;
            }
            parts.push(part);
            watch.tell(parts.clone(), 0.25 * f64::from(part));
        }
        Some(parts)
    };
    assert!(
        slot.ask(&mut jobs, &1, Pace::Long, at_once(compute))
            .value
            .is_none()
    );
    for part in 1..=3 {
        open.send(()).unwrap();
        let told: Vec<u32> = (1..=part).collect();
        let (answer, is_awaited) = loop {
            let (answer, is_awaited) = slot.look(&1);
            if answer.value.as_deref() == Some(&told) {
                break (answer, is_awaited);
            }
            wait(&announced);
        };
        assert!(is_awaited && answer.detail == Some(Detail::Coarse) && jobs.is_busy());
        let known = answer.part.unwrap();
        assert!((known.share - 0.25 * f64::from(part)).abs() < 1e-12);
        assert!(known.seconds_left.is_some_and(|seconds| seconds >= 0.0));
        // What takes a moment is answered meanwhile, as often as it is asked.
        let mut short = Slot::<u32, u32>::default();
        for key in 0..20 {
            while short
                .ask(
                    &mut jobs,
                    &key,
                    Pace::CoarseFirst,
                    at_once(move |_, _| Some(key)),
                )
                .detail
                != Some(Detail::Full)
            {
                wait(&announced);
            }
        }
    }
    slot.call_off();
    open.send(()).unwrap();
    while jobs.is_busy() {
        wait(&announced);
    }
    let (answer, is_awaited) = slot.look(&1);
    assert!(!is_awaited && answer.part.is_some_and(|part| part.share == 0.75));
    assert_eq!(answer.value.as_deref(), Some(&vec![1, 2, 3]));
}

/// Where nobody can be shown it any more, it is given up.
#[test]
fn what_was_asked_of_a_slot_ends_with_it() {
    let (mut jobs, announced) = pool();
    for pace in [Pace::Background, Pace::Long] {
        let mut slot = Slot::<u32, u32>::default();
        slot.ask(
            &mut jobs,
            &1,
            pace,
            at_once(|_, watch| {
                while !watch.is_stale() {
                    std::thread::yield_now();
                }
                None
            }),
        );
        drop(slot);
        while jobs.is_busy() {
            wait(&announced);
        }
    }
}

/// A clock that the test below moves on, in milliseconds.
static NOW: AtomicU64 = AtomicU64::new(1000);

fn moved_on() -> f64 {
    1e-3 * NOW.load(Ordering::Relaxed) as f64
}

/// Without threads frames have slices: first answers in the next ones, as many as fit, all others once nothing moves.
#[test]
fn without_threads_answers_come_in_slices_of_frames() {
    let mut jobs = Jobs::new(Some(moved_on), Pool::at_once(), || {});
    let pass = |milliseconds| NOW.fetch_add(milliseconds, Ordering::Relaxed);
    for (pace, waits) in [
        (Pace::Short, false),
        (Pace::Background, true),
        (Pace::Long, true),
    ] {
        let mut slot = Slot::<u32, u32>::default();
        let mut ask = |jobs: &mut Jobs| slot.ask(jobs, &1, pace, at_once(|_, _| Some(1))).detail;
        assert_eq!(ask(&mut jobs), None);
        jobs.begin_frame();
        assert_eq!(ask(&mut jobs).is_none(), waits, "{pace:?}");
        pass(200);
        jobs.begin_frame();
        assert_eq!(ask(&mut jobs), Some(Detail::Full));
    }
    let mut slots: [Slot<u32, u32>; 3] = Default::default();
    let mut ask = |jobs: &mut Jobs| {
        let compute = move |detail, _: &Watch<'_, u32>| {
            pass(5);
            Some(u32::from(detail == Detail::Full))
        };
        let mut details = Vec::new();
        for slot in &mut slots {
            details.push(
                slot.ask(jobs, &1, Pace::CoarseFirst, at_once(compute))
                    .detail,
            );
        }
        details
    };
    assert_eq!(ask(&mut jobs), [None; 3]);
    jobs.begin_frame();
    let coarse = Some(Detail::Coarse);
    assert_eq!(
        ask(&mut jobs),
        [None, coarse, coarse],
        "two of 5 ms fill the slice"
    );
    jobs.begin_frame();
    assert_eq!(
        ask(&mut jobs),
        [coarse; 3],
        "and nothing is refined meanwhile"
    );
    pass(200);
    jobs.begin_frame();
    let full = ask(&mut jobs)
        .iter()
        .filter(|detail| **detail == Some(Detail::Full))
        .count();
    assert_eq!(full, 2);
    let mut slot = Slot::<u32, u32>::default();
    let answer = slot.ask(&mut jobs, &1, Pace::AtOnce, at_once(|_, _| Some(1)));
    assert_eq!(answer.detail, Some(Detail::Full));
}

/// A computation that panics is given up; its thread answers what is asked next, of this slot and of others.
#[test]
fn what_panics_holds_nothing_up() {
    let (mut jobs, announced) = pool();
    let [mut failing, mut other] = [Slot::<u32, u32>::default(), Slot::default()];
    let mut ask = |slot: &mut Slot<u32, u32>, key: u32, pace| {
        let compute = move |_, _: &Watch<'_, _>| {
            assert!(key != 1, "a fault that the test plants");
            Some(key)
        };
        slot.ask(&mut jobs, &key, pace, at_once(compute)).value
    };
    for pace in [Pace::CoarseFirst, Pace::Background, Pace::Long] {
        assert!(ask(&mut failing, 1, pace).is_none());
        wait(&announced);
        assert!(!failing.look(&1).1, "nothing more will come");
        // It is not tried again as long as the same is asked.
        ask(&mut failing, 1, pace);
        assert!(announced.recv_timeout(Duration::from_millis(50)).is_err());
        for (slot, key) in [(&mut other, 2), (&mut failing, 3)] {
            while ask(slot, key, pace) != Some(Arc::new(key)) {
                wait(&announced);
            }
        }
        while announced.recv_timeout(Duration::from_millis(50)).is_ok() {}
        failing = Slot::default();
        other = Slot::default();
    }
    assert!(!jobs.is_busy());
}
