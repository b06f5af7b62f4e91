//! The threads of the program: who works on a loop that is shared out.
//!
//! Loops are shared out by rayon. A thread that is none of a pool's hands its loop over and sleeps until it is done, and
//! waking the pool's threads anew for each loop often leaves one of them to do nearly all of it: on two cores, of 147
//! loops of 2^20 pairs (1 to 7 ms each, eleven times in turns with one thread), thirteen took as long as on one thread,
//! while a control halved. Where the thread that asks is one of the pool's, none of 305 did. So no thread of the program
//! asks from outside: the first one takes part ([`take_part`]), and whatever else works does so on a [`Pool`].

use bxdf::error::{Error, Result};

/// The threads that this machine has cores for.
#[must_use]
pub fn threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

/// Makes the calling thread the first of those that share out the loops of the process; to be called once, by the first
/// thread, before any loop. `count`: how many threads; without it [`threads`], or as many as the system gives.
///
/// # Errors
/// [`Error::Platform`] where `count` threads cannot be started.
pub fn take_part(count: Option<usize>) -> Result<()> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(count.unwrap_or_else(threads))
        .use_current_thread();
    match (pool.build_global(), count) {
        (Err(error), Some(count)) => Err(Error::Platform {
            problem: format!("{count} threads cannot be started: {error}"),
            remedy: "fewer --threads may do".to_owned(),
        }),
        // Where none was asked for, the first thread does what the others would have.
        (Ok(()), _) | (Err(_), None) => Ok(()),
    }
}

/// Threads of their own, for work that goes on beside the first thread.
pub struct Pool(rayon::ThreadPool);

impl Pool {
    /// A pool of [`threads`]; `None` where there are none to be had, as in a browser.
    #[must_use]
    pub fn new() -> Option<Self> {
        if cfg!(target_arch = "wasm32") {
            return None;
        }
        let pool = rayon::ThreadPoolBuilder::new()
            .thread_name(|_| "worker".to_owned())
            // What panics says so by the hook of the program; nobody waits for it.
            .panic_handler(|_| {})
            .build();
        pool.ok().map(Self)
    }

    /// Does `work` on a thread of the pool; the loops in it are shared out among the others. It is done to the end, even
    /// where the pool is dropped meanwhile.
    pub fn spawn(&self, work: impl FnOnce() + Send + 'static) {
        self.0.spawn(work);
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc;

    use rayon::prelude::*;

    use super::*;

    /// What is spawned is one of the threads that share out its loops, and outlives the handle of its pool.
    #[test]
    fn work_takes_part_in_its_own_loops() {
        let (sender, receiver) = mpsc::channel();
        let pool = Pool::new().unwrap();
        pool.spawn(move || {
            let sum: u64 = (0..1000_u64).into_par_iter().sum();
            sender
                .send((
                    sum,
                    rayon::current_thread_index().is_some(),
                    rayon::current_num_threads(),
                ))
                .unwrap();
        });
        drop(pool);
        assert_eq!(receiver.recv().unwrap(), (499_500, true, threads()));
    }

    #[test]
    fn a_panic_ends_what_panicked_and_nothing_else() {
        let (sender, receiver) = mpsc::channel::<()>();
        let pool = Pool::new().unwrap();
        pool.spawn(move || {
            let _kept = sender;
            panic!("as it is meant to");
        });
        assert!(receiver.recv().is_err());
        let (sender, receiver) = mpsc::channel();
        pool.spawn(move || sender.send(7).unwrap());
        assert_eq!(receiver.recv().unwrap(), 7);
    }
}
