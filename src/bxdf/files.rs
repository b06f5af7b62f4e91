//! Reading text from files, with one limit for all: sessions, materials, what is pasted.

use std::fs::File;
use std::io::{self, Cursor, Read};
use std::path::Path;

use crate::encoding;
use crate::error::{Error, Result};
use crate::limits::{MAX_DATA, MAX_TEXT, in_words};

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

/// Reads the text of the file at `path`, at most [`MAX_TEXT`]; `wanted` says what one is where there is none.
///
/// # Errors
/// [`Error::Io`] where it cannot be read or is longer, [`Error::Parse`] where there is no text in it.
pub fn text_at(path: &Path, wanted: &str) -> Result<String> {
    let refused = |problem: &str| {
        let problem = format!("{problem}; {wanted}");
        Err(Error::parse(path.display().to_string(), problem))
    };
    if path.is_dir() {
        return refused("is a folder");
    }
    let read = File::open(path).and_then(|file| read_bytes(file, MAX_TEXT));
    let Ok(text) = text_of(read.map_err(|error| Error::io(path, error))?, path) else {
        return refused("holds no text");
    };
    if text.contains('\0') {
        return refused("holds no text");
    }
    if text.trim().is_empty() {
        return refused("is empty");
    }
    Ok(text)
}

/// Reads the file of data at `path`, at most [`MAX_DATA`].
///
/// # Errors
/// [`Error::Io`] where it cannot be read or is longer.
pub fn data_at(path: &Path) -> Result<Vec<u8>> {
    let read = File::open(path).and_then(|file| read_bytes(file, MAX_DATA));
    read.map_err(|error| Error::io(path, error))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_end_is_refused_at_the_limit() {
        let line = read_bytes(io::repeat(b'#'), MAX_TEXT)
            .unwrap_err()
            .to_string();
        assert_eq!(line, "more than 32 MiB, the most that is read");
        assert_eq!(read_bytes(&b"abc"[..], 3).unwrap(), b"abc");
        assert!(read_bytes(&b"abcd"[..], 3).is_err());
        let line = text_of(b"\x89PNG\xff".to_vec(), Path::new("picture"))
            .unwrap_err()
            .to_string();
        assert!(line.starts_with("picture: no text"), "{line}");
    }
}
