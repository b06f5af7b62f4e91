//! What every reader and writer of files keeps, in the window and at the command line: how much text is read, and beside
//! which name a file is written until it is complete.

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

pub use bxdf::internals::files::{MAX_TEXT, in_words, read_bytes, require_fit, text_at, text_of};

/// A name beside `target` that no other writer has, in this process or another, hidden where dots hide names: what is written
/// there is moved to `target` once it is complete.
///
/// # Errors
/// `InvalidFilename` where `target` has no name, as `..`.
pub fn temporary_beside(target: &Path) -> io::Result<PathBuf> {
    static COUNT: AtomicU64 = AtomicU64::new(0);
    let name = target.file_name().ok_or(io::ErrorKind::InvalidFilename)?;
    let (process, count) = (std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{process}-{count}.partial"));
    Ok(target.with_file_name(hidden))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_writers_have_one_temporary_name() {
        let target = Path::new("folder/mine.toml");
        let [a, b] = [(); 2].map(|()| temporary_beside(target).unwrap());
        assert!(a != b && a.parent() == target.parent());
        assert!(temporary_beside(Path::new("folder/..")).is_err());
    }
}
