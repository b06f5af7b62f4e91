//! What every reader and writer of files keeps, in the window and at the command line: how much text is read, and beside
//! which name a file is written until it is complete.

use std::ffi::OsString;
use std::io::{self, Cursor, Read};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

use crate::encoding;
use bxdf::error::{Error, Result};

/// The most text that is read or written as one, in bytes: a session, a material, what is pasted. Room for some ten of the
/// largest tables that the trade-off offers; a hundred times as much as is typed by hand.
pub const MAX_TEXT: u64 = 32 << 20;

/// Reads `source` to its end, at most `limit` bytes of it.
///
/// # Errors
/// The system's; `FileTooLarge` where there is more, which is then not read.
pub fn read_bytes(source: impl Read, limit: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    // One byte more tells what is too large from what just fits.
    source
        .take(limit.saturating_add(1))
        .read_to_end(&mut bytes)?;
    if bytes.len() as u64 > limit {
        let problem = format!("more than {}, the most that is read", in_words(limit));
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}

/// Reads the text of a session or a material from `source`, at most [`MAX_TEXT`]; `place` names it in errors.
///
/// # Errors
/// [`Error::Io`] where it cannot be read or is longer, [`Error::Parse`] where it is no text.
pub fn read_text(source: impl Read, place: &Path) -> Result<String> {
    let bytes = read_bytes(source, MAX_TEXT).map_err(|error| Error::io(place, error))?;
    text_of(bytes, place)
}

/// Reads the text of the file at `path`, at most [`MAX_TEXT`].
///
/// # Errors
/// As [`read_text`].
pub fn text_at(path: &Path) -> Result<String> {
    let file = std::fs::File::open(path).map_err(|error| Error::io(path, error))?;
    read_text(file, path)
}

/// `bytes`, in UTF-8 or UTF-16, as text; `place` names them in errors.
///
/// # Errors
/// [`Error::Parse`] where they are none.
pub fn text_of(bytes: Vec<u8>, place: &Path) -> Result<String> {
    let decode = || {
        let mut text = String::new();
        encoding::utf8(Cursor::new(bytes))?.read_to_string(&mut text)?;
        Ok(text)
    };
    decode().map_err(|_: io::Error| {
        let place = place.display().to_string();
        Error::parse(place, "no text: neither a session nor a material")
    })
}

/// Refuses a text of so many bytes where it is longer than [`MAX_TEXT`]; `what` is its subject in the error.
///
/// # Errors
/// [`Error::Limit`], naming size and limit.
pub fn require_fit(what: &'static str, bytes: u64) -> Result<()> {
    if bytes <= MAX_TEXT {
        return Ok(());
    }
    Err(Error::Limit {
        what,
        value: format!("{} of text", in_words(bytes)),
        limit: in_words(MAX_TEXT),
    })
}

/// A size in words, in the unit that suits it.
#[must_use]
pub fn in_words(bytes: u64) -> String {
    const MEBIBYTE: u64 = 1 << 20;
    if bytes.is_multiple_of(MEBIBYTE) && bytes > 0 {
        format!("{} MiB", bytes / MEBIBYTE)
    } else if bytes > MEBIBYTE {
        // Rounded up: what is over a limit never reads as the limit itself.
        let tenths = (bytes * 10).div_ceil(MEBIBYTE);
        format!("{}.{} MiB", tenths / 10, tenths % 10)
    } else {
        format!("{bytes} bytes")
    }
}

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
    fn what_has_no_end_is_refused_at_the_limit() {
        let place = Path::new("endless");
        let line = read_text(io::repeat(b'#'), place).unwrap_err().to_string();
        assert_eq!(line, "endless: more than 32 MiB, the most that is read");
        assert_eq!(read_bytes(&b"abc"[..], 3).unwrap(), b"abc");
        assert!(read_bytes(&b"abcd"[..], 3).is_err());
        let line = read_text(&b"\x89PNG\xff"[..], place)
            .unwrap_err()
            .to_string();
        assert!(line.starts_with("endless: no text"), "{line}");
    }

    #[test]
    fn sizes_are_told_from_their_limit() {
        assert!(require_fit("the text", MAX_TEXT).is_ok());
        let line = require_fit("the text", MAX_TEXT + 1)
            .unwrap_err()
            .to_string();
        assert_eq!(line, "the text is 32.1 MiB of text; the limit is 32 MiB");
        assert_eq!(in_words(700), "700 bytes");
    }

    #[test]
    fn no_two_writers_have_one_temporary_name() {
        let target = Path::new("folder/mine.toml");
        let [a, b] = [(); 2].map(|()| temporary_beside(target).unwrap());
        assert!(a != b && a.parent() == target.parent());
        assert!(temporary_beside(Path::new("folder/..")).is_err());
    }
}
