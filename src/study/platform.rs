//! What differs between a native window and a page in a browser: time, other programs.

use std::io;
use std::path::Path;

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

/// The number of this process among those of the machine; a page in a browser has none.
#[must_use]
pub fn process() -> u32 {
    if cfg!(target_arch = "wasm32") {
        0
    } else {
        std::process::id()
    }
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
