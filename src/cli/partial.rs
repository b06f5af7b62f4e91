//! Files that are not complete yet: none is left behind, neither by an error nor by an interrupt.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use bxdf_study::files;

/// The files that are being written.
static PENDING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn pending() -> MutexGuard<'static, Vec<PathBuf>> {
    PENDING.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A file beside its place. It is removed where it is dropped, and where a signal ends the program, before it was moved there.
pub(super) struct Partial {
    path: PathBuf,
}

impl Partial {
    /// Makes the file that is to stand at `target`.
    ///
    /// # Errors
    /// The system's.
    pub(super) fn create(target: &Path) -> io::Result<(Self, File)> {
        #[cfg(unix)]
        signals::watch();
        let path = files::temporary_beside(target)?;
        // Listed first: a signal finds it in the list, or not on the disk.
        let mut pending = pending();
        pending.push(path.clone());
        drop(pending);
        let partial = Self { path };
        let file = File::create(&partial.path)?;
        Ok((partial, file))
    }

    /// Moves the file to `target`, now that it is complete and closed.
    ///
    /// # Errors
    /// The system's; the file is then removed.
    pub(super) fn complete(self, target: &Path) -> io::Result<()> {
        fs::rename(&self.path, target)
    }
}

impl Drop for Partial {
    fn drop(&mut self) {
        // Nothing is there where it was moved; else the error that led here is the one to tell.
        let _ = fs::remove_file(&self.path);
        pending().retain(|path| *path != self.path);
    }
}

#[cfg(unix)]
mod signals {
    use std::ffi::c_int;
    use std::fs;
    use std::sync::{Once, mpsc};

    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;

    /// The signals that end a program which does not care.
    const ENDING: [c_int; 4] = [SIGINT, SIGTERM, SIGHUP, SIGQUIT];

    /// From now on a signal that ends the program removes the pending files first.
    pub(super) fn watch() {
        static START: Once = Once::new();
        START.call_once(|| {
            let (is_ready, ready) = mpsc::channel();
            let wait = move || {
                if let Ok(mut signals) = Signals::new(wanted()) {
                    // Nobody listens where the program ends by itself.
                    let _ = is_ready.send(());
                    signals.forever().for_each(end);
                }
            };
            let thread = std::thread::Builder::new().name("signals".to_owned());
            // Where no thread can be had, no signal is caught: each ends the program as it did before.
            if thread.spawn(wait).is_ok() {
                let _ = ready.recv();
            }
        });
    }

    /// Removes the pending files and ends the program as if nobody had cared: whoever waits for it sees which signal did.
    fn end(signal: c_int) {
        // Held to the end: nothing is begun any more.
        let pending = super::pending();
        for path in pending.iter() {
            let _ = fs::remove_file(path);
        }
        let _ = emulate_default_handler(signal);
    }

    /// The signals to be caught, without those that whoever started the program had it ignore, as `nohup` does. What is ignored
    /// is known on Linux only.
    fn wanted() -> impl Iterator<Item = c_int> {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        let ignored = status
            .lines()
            .find_map(|line| line.strip_prefix("SigIgn:"))
            .and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok())
            .unwrap_or(0);
        ENDING
            .into_iter()
            .filter(move |signal| (ignored >> (signal - 1)) & 1 == 0)
    }
}
