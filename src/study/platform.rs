//! What differs between a native window and a page in a browser: threads, time, other programs.

use std::io;
use std::path::Path;

use crate::parallel::Pool;

/// Seconds since the first call.
#[must_use]
pub fn seconds() -> f64 {
    use std::sync::OnceLock;
    static START: OnceLock<web_time::Instant> = OnceLock::new();
    START
        .get_or_init(web_time::Instant::now)
        .elapsed()
        .as_secs_f64()
}

/// How many workers there may be: one for each core but the one that draws; none in a browser.
#[must_use]
pub fn workers() -> usize {
    if has_threads() {
        crate::parallel::threads().saturating_sub(1).max(1)
    } else {
        0
    }
}

/// Whether there are threads.
#[must_use]
pub const fn has_threads() -> bool {
    !cfg!(target_arch = "wasm32")
}

/// Starts a thread for what waits rather than computes: files, other programs. Whether it could be started.
pub fn spawn(work: impl FnOnce() + Send + 'static) -> bool {
    std::thread::Builder::new()
        .name("worker".to_owned())
        .spawn(work)
        .is_ok()
}

/// Computes beside all else, on a thread that shares out its loops among others; whether there are threads for it.
pub fn compute(work: impl FnOnce() + Send + 'static) -> bool {
    // The threads end with the work.
    Pool::new().map(|pool| pool.spawn(work)).is_some()
}

/// Opens a folder in the system's program for folders, and waits until that is done or has failed.
///
/// # Errors
/// The system's, where there is no such program, or it fails.
pub fn open_folder(path: &Path) -> io::Result<()> {
    let program = if cfg!(windows) {
        "explorer"
    } else if cfg!(target_os = "macos") {
        "open"
    } else {
        "xdg-open"
    };
    let mut command = std::process::Command::new(program);
    let nothing = std::process::Stdio::null;
    command
        .arg(path)
        .stdin(nothing())
        .stdout(nothing())
        .stderr(nothing());
    let status = command.status().map_err(|error| match error.kind() {
        // Its own words would seem to be about the folder.
        io::ErrorKind::NotFound => io::Error::other(format!("{program} is missing")),
        _ => error,
    })?;
    // The explorer always claims to have failed.
    if status.success() || cfg!(windows) {
        Ok(())
    } else {
        Err(io::Error::other(format!("{program} failed")))
    }
}
