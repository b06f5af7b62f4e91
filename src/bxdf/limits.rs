//! How much text and data is read or written as one: all limits of files in one place.

use crate::error::{Error, Result};

/// The most text that is read or written as one, in bytes: a session, a material, what is pasted. Room for some ten of the
/// largest tables that the trade-off offers; a hundred times as much as is typed by hand.
pub const MAX_TEXT: u64 = 32 << 20;

/// The most data of one parameter, in bytes: room for the measured surfaces of the large databases (33 MiB each).
pub const MAX_DATA: u64 = 64 << 20;

/// The most data that stands in the text of a session or a material beside the name of its file, in bytes: so small a file
/// is not worth being lost.
pub const MAX_INLINE: u64 = 64 << 10;

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_are_told_from_their_limit() {
        assert!(require_fit("the text", MAX_TEXT).is_ok());
        let line = require_fit("the text", MAX_TEXT + 1)
            .unwrap_err()
            .to_string();
        assert_eq!(line, "the text is 32.1 MiB of text; the limit is 32 MiB");
        assert_eq!(in_words(700), "700 bytes");
    }
}
