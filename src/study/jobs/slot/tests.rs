use std::sync::atomic::AtomicUsize;
use std::sync::mpsc;
use std::time::Duration;

use super::*;
use crate::jobs::FRAME_BUDGET;
use crate::platform;

/// A pool whose answers are announced.
fn pool() -> (Jobs, mpsc::Receiver<()>) {
    let (sender, receiver) = mpsc::channel();
    let clock: Clock = platform::seconds;
    let jobs = Jobs::new(Some(clock), move || {
        let _ = sender.send(());
    });
    (jobs, receiver)
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
    let compute = move |detail, _: &Watch<'_>| {
        let _ = locked(&gate).recv();
        Some((1, detail))
    };
    let compute = Arc::new(compute);
    let ask = |slot: &mut Slot<_, _>, jobs: &mut Jobs| {
        let compute = Arc::clone(&compute);
        slot.ask(jobs, &1, Detail::Coarse, move |detail, watch| {
            compute(detail, watch)
        })
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
        slot.ask(&mut jobs, &key, Detail::Coarse, move |detail, watch| {
            // The first query's full answer would take forever.
            while key == 1 && detail == Detail::Full && !watch.is_stale() {
                std::thread::yield_now();
            }
            if watch.is_stale() {
                return None;
            }
            answered.fetch_add(1, Ordering::Relaxed);
            Some(key)
        })
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
    slot.ask(&mut jobs, &1, Detail::Coarse, |_, _| Some(1));
    wait(&announced);
    wait(&announced);
    assert!(slot.ask(&mut jobs, &1, Detail::Coarse, |_, _| None).detail == Some(Detail::Full));
    assert_eq!(
        slot.ask(&mut jobs, &2, Detail::Coarse, |_, _| Some(2))
            .value
            .as_deref(),
        Some(&2)
    );
    jobs.spent = FRAME_BUDGET;
    assert!(
        slot.ask(&mut jobs, &3, Detail::Coarse, |_, _| Some(3))
            .detail
            != Some(Detail::Full)
    );
    jobs.begin_frame();
    assert!(
        slot.ask(&mut jobs, &4, Detail::Coarse, |_, _| Some(4))
            .detail
            == Some(Detail::Full)
    );
}

#[test]
fn without_a_clock_everything_is_answered_at_once() {
    let mut jobs = Jobs::new(None, || {});
    let mut slot = Slot::<u32, u32>::default();
    for key in [1, 2] {
        let answer = slot.ask(&mut jobs, &key, Detail::Coarse, move |detail, _| {
            (detail == Detail::Full).then_some(key)
        });
        assert!(answer.detail == Some(Detail::Full) && answer.value.as_deref() == Some(&key));
    }
    assert!(!jobs.is_busy() && slot.version() == 2);
}

/// Two that are asked the same: one is computed, the other one shows it, and goes its own way when it is asked something else.
#[test]
fn a_slot_follows_another() {
    let mut jobs = Jobs::new(None, || {});
    let [mut first, mut second] = [Slot::<u32, u32>::default(), Slot::default()];
    second.ask(&mut jobs, &7, Detail::Full, |_, _| Some(7));
    let computed = first.ask(&mut jobs, &1, Detail::Full, |_, _| Some(1));
    let followed = second.follow(&first, &1);
    assert!(followed.detail == Some(Detail::Full));
    assert!(Arc::ptr_eq(
        &computed.value.unwrap(),
        &followed.value.unwrap()
    ));
    let own = second.ask(&mut jobs, &1, Detail::Full, |_, _| None);
    assert!(own.detail == Some(Detail::Full) && own.value.as_deref() == Some(&1));
    let other = second.ask(&mut jobs, &2, Detail::Full, |_, _| Some(2));
    assert_eq!(other.value.as_deref(), Some(&2));
    assert_eq!(
        first
            .ask(&mut jobs, &1, Detail::Full, |_, _| None)
            .value
            .as_deref(),
        Some(&1)
    );
}
