//! The threads of the program: who works on a loop that is shared out, and who beside the first thread.
//!
//! Loops are shared out by rayon. A thread that is none of a pool's hands its loop over and sleeps until it is done, and
//! waking the pool's threads anew for each loop often leaves one of them to do nearly all of it: on two cores, of 147
//! loops of 2^20 pairs (1 to 7 ms each, eleven times in turns with one thread), thirteen took as long as on one thread,
//! while a control halved. Where the thread that asks is one of the pool's, none of 305 did. So no thread of the program
//! asks from outside: the first one takes part ([`take_part`]), and whatever else computes does so on a [`Pool`].
//!
//! A thread whose loop is not done yet takes up whatever else its pool has to do. So what takes seconds has threads of its
//! own, which end with it: else the answer to a view could wait for it to end.

use std::io;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver};

use rayon::{ThreadBuilder, ThreadPool, ThreadPoolBuilder};

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
    let pool = ThreadPoolBuilder::new()
        .num_threads(count.unwrap_or_else(threads))
        .use_current_thread()
        .spawn_handler(begin);
    match (pool.build_global(), count) {
        (Err(error), Some(count)) => Err(Error::Platform {
            problem: format!("{count} threads cannot be started: {error}"),
            remedy: "fewer --threads may do".to_owned(),
        }),
        // Where none was asked for, the first thread does what the others would have.
        (Ok(()), _) | (Err(_), None) => Ok(()),
    }
}

/// Memory that is to be had before a thread is begun, in bytes: for its stack, and for what those that run allocate meanwhile.
/// Allocators ask the system anew for so much each time, and give it back.
const ROOM: usize = 64 << 20;

/// Begins a thread, and waits until it runs. A thread that gets its stack, but not the little that it takes to run on it, ends
/// the program: so there has to be room for more, and no other one takes it meanwhile.
fn begin(thread: ThreadBuilder) -> io::Result<()> {
    let mut room: Vec<u8> = Vec::new();
    room.try_reserve_exact(ROOM)
        .map_err(|_| io::Error::from(io::ErrorKind::OutOfMemory))?;
    drop(room);
    let (runs, is_running) = mpsc::channel();
    let mut builder = std::thread::Builder::new();
    if let Some(name) = thread.name() {
        builder = builder.name(name.to_owned());
    }
    builder.spawn(move || {
        // Whoever began it waits for that.
        let _ = runs.send(());
        thread.run();
    })?;
    // Nothing comes where it has ended already: that is no reason to end too.
    let _ = is_running.recv();
    Ok(())
}

/// All threads beside the first one, as whoever needs one has it at hand.
#[derive(Clone, Default)]
pub struct Pool(Option<Arc<ThreadPool>>);

impl Pool {
    /// A pool of [`threads`], and of those that it starts beside them; without any where there are none to be had, as in a
    /// browser.
    #[must_use]
    pub fn new() -> Self {
        Self(computing().map(Arc::new))
    }

    /// A pool without threads: whatever is handed to it is done at once.
    #[must_use]
    pub fn at_once() -> Self {
        Self(None)
    }

    /// Whether it has threads.
    #[must_use]
    pub fn has_threads(&self) -> bool {
        self.0.is_some()
    }

    /// Does `work`, which is short, on one of the threads; the loops in it are shared out among the others. It is done to
    /// the end, even where the pool is dropped meanwhile.
    pub(crate) fn spawn(&self, work: impl FnOnce() + Send + 'static) {
        match &self.0 {
            Some(pool) => pool.spawn(work),
            None => work(),
        }
    }

    /// Does `work`, which may take seconds, beside all else: on threads of its own, which share out its loops.
    pub(crate) fn spawn_long(&self, work: impl FnOnce() + Send + 'static) {
        match self.0.as_ref().and_then(|_| computing()) {
            Some(pool) => pool.spawn(work),
            // Where no more threads are to be had, those that there are take longer.
            None => self.spawn(work),
        }
    }

    /// What `work` makes, which may take seconds, as soon as it has; `wake` is called then.
    pub fn compute<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> T + Send + 'static,
        wake: impl FnOnce() + Send + 'static,
    ) -> Receiver<T> {
        let (work, made) = sent(work, wake);
        self.spawn_long(work);
        made
    }

    /// What comes of what `begin` begins, which may take seconds, and may wait for others meanwhile; `wake` is called then.
    pub fn complete<T: Send + 'static, F: Future<Output = T> + 'static>(
        &self,
        begin: impl FnOnce() -> F + Send + 'static,
        wake: impl FnOnce() + Send + 'static,
    ) -> Receiver<T> {
        #[cfg(not(target_arch = "wasm32"))]
        return self.compute(move || pollster::block_on(begin()), wake);
        #[cfg(target_arch = "wasm32")]
        {
            let (sender, made) = mpsc::channel();
            wasm_bindgen_futures::spawn_local(async move {
                // Nobody listens where the page is closed meanwhile.
                let _ = sender.send(begin().await);
                wake();
            });
            made
        }
    }

    /// What comes of `work`, which waits rather than computes: for files, for other programs. `wake` is called then. Where no
    /// thread is to be had for it, the receiver hears that nobody sends.
    pub fn wait_for<T: Send + 'static>(
        &self,
        work: impl FnOnce() -> T + Send + 'static,
        wake: impl FnOnce() + Send + 'static,
    ) -> Receiver<T> {
        let (work, made) = sent(work, wake);
        if self.has_threads() {
            let thread = std::thread::Builder::new().name(NAME.to_owned());
            drop(thread.spawn(work));
        } else {
            work();
        }
        made
    }
}

/// What the threads are called.
const NAME: &str = "worker";

/// Threads that compute.
fn computing() -> Option<ThreadPool> {
    if cfg!(target_arch = "wasm32") {
        return None;
    }
    let pool = ThreadPoolBuilder::new()
        .thread_name(|_| NAME.to_owned())
        // What panics says so by the hook of the program; who waits for it hears that nobody sends.
        .panic_handler(|_| {})
        .build();
    pool.ok()
}

/// `work`, which sends what it makes, and where that arrives.
fn sent<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
    wake: impl FnOnce() + Send + 'static,
) -> (impl FnOnce() + Send + 'static, Receiver<T>) {
    let (sender, made) = mpsc::channel();
    let work = move || {
        // Nobody listens where the window is closed meanwhile.
        let _ = sender.send(work());
        wake();
    };
    (work, made)
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use rayon::prelude::*;

    use super::*;

    /// What is spawned is one of the threads that share out its loops, and outlives the handle of its pool.
    #[test]
    fn work_takes_part_in_its_own_loops() {
        let (sender, receiver) = mpsc::channel();
        let work = |sender: mpsc::Sender<_>| {
            move || {
                let sum: u64 = (0..1000_u64).into_par_iter().sum();
                sender
                    .send((
                        sum,
                        rayon::current_thread_index().is_some(),
                        rayon::current_num_threads(),
                    ))
                    .unwrap();
            }
        };
        let pool = Pool::new();
        pool.spawn(work(sender.clone()));
        pool.spawn_long(work(sender));
        drop(pool);
        for _ in 0..2 {
            assert_eq!(receiver.recv().unwrap(), (499_500, true, threads()));
        }
    }

    /// However many take long: their threads are others, also those that their loops are shared out among.
    #[test]
    fn what_is_short_does_not_wait_for_what_takes_long() {
        let pool = Pool::new();
        let mut open = Vec::new();
        for _ in 0..2 * threads() {
            let (sender, gate) = mpsc::channel::<()>();
            open.push((sender, pool.compute(move || gate.recv().is_ok(), || {})));
        }
        let (sender, done) = mpsc::channel();
        for round in 0..100 {
            let sender = sender.clone();
            pool.spawn(move || {
                let sum: u64 = (0..1000_u64).into_par_iter().sum();
                sender.send(sum + round).unwrap();
            });
            let patience = Duration::from_secs(10);
            assert_eq!(done.recv_timeout(patience), Ok(499_500 + round));
        }
        for (gate, made) in open {
            gate.send(()).unwrap();
            assert_eq!(made.recv(), Ok(true));
        }
    }

    #[test]
    fn what_waits_does_so_beside_all_else_and_tells() {
        let (open, gate) = mpsc::channel::<()>();
        let (told, heard) = mpsc::channel();
        let made =
            Pool::new().wait_for(move || gate.recv().is_ok(), move || told.send(()).unwrap());
        assert!(made.try_recv().is_err());
        open.send(()).unwrap();
        assert!(made.recv().unwrap() && heard.recv().is_ok());
    }

    #[test]
    fn without_threads_all_is_done_at_once() {
        let pool = Pool::at_once();
        let own = std::thread::current().id();
        let id = || std::thread::current().id();
        assert_eq!(pool.wait_for(id, || {}).try_recv(), Ok(own));
        assert_eq!(pool.compute(id, || {}).try_recv(), Ok(own));
    }

    #[test]
    fn a_panic_ends_what_panicked_and_nothing_else() {
        let (sender, receiver) = mpsc::channel::<()>();
        let pool = Pool::new();
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
