//! Text as UTF-8, whichever of the common encodings it was saved in: spreadsheets and editors write UTF-16, and marks of the
//! order of bytes before UTF-8.

use std::io::{self, BufRead, BufReader, Cursor, Read};

/// The encodings that are told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Encoding {
    /// UTF-8, or whatever else has one byte for each of the letters of ASCII.
    Bytes,
    /// UTF-16, the low byte first.
    Utf16Little,
    /// UTF-16, the high byte first.
    Utf16Big,
    /// UTF-32, which is not read.
    Utf32,
}

/// How many bytes tell the encodings apart.
const TELLING: usize = 4;

/// The encoding of a text that begins so, and the length of its mark. Without a mark, UTF-16 is known by its first character
/// being one of ASCII.
fn encoding_of(start: &[u8]) -> (Encoding, usize) {
    match *start {
        [0xef, 0xbb, 0xbf, ..] => (Encoding::Bytes, 3),
        [0xff, 0xfe, 0, 0] | [0, 0, 0xfe, 0xff] => (Encoding::Utf32, 4),
        [0xff, 0xfe, ..] => (Encoding::Utf16Little, 2),
        [0xfe, 0xff, ..] => (Encoding::Utf16Big, 2),
        [first, 0, second, 0] if first != 0 && second != 0 => (Encoding::Utf16Little, 0),
        [0, first, 0, second] if first != 0 && second != 0 => (Encoding::Utf16Big, 0),
        _ => (Encoding::Bytes, 0),
    }
}

/// `source` as UTF-8, without a mark of the order of bytes. What is no UTF-16 is passed on as it is.
///
/// # Errors
/// The system's; `InvalidData` for UTF-32, and, when read, for broken UTF-16.
pub fn utf8(mut source: impl BufRead + 'static) -> io::Result<Box<dyn BufRead>> {
    let mut start = Vec::with_capacity(TELLING);
    (&mut source).take(TELLING as u64).read_to_end(&mut start)?;
    let (encoding, mark) = encoding_of(&start);
    let source = Cursor::new(start.split_off(mark)).chain(source);
    match encoding {
        Encoding::Bytes => Ok(Box::new(source)),
        Encoding::Utf16Little => Ok(from_utf16(source, u16::from_le_bytes)),
        Encoding::Utf16Big => Ok(from_utf16(source, u16::from_be_bytes)),
        Encoding::Utf32 => Err(invalid("text in UTF-32; UTF-8 and UTF-16 are read")),
    }
}

fn invalid(problem: &'static str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, problem)
}

/// UTF-16 read as UTF-8, character by character.
struct Utf16<S> {
    source: S,
    unit: fn([u8; 2]) -> u16,
    /// The last character, as UTF-8, and what of it is still to be read.
    character: [u8; TELLING],
    rest: std::ops::Range<usize>,
}

/// `source`, whose pairs of bytes are put together by `unit`, as UTF-8.
fn from_utf16<S: BufRead + 'static>(source: S, unit: fn([u8; 2]) -> u16) -> Box<dyn BufRead> {
    Box::new(BufReader::new(Utf16 {
        source,
        unit,
        character: [0; TELLING],
        rest: 0..0,
    }))
}

impl<S: BufRead> Utf16<S> {
    /// The next two bytes; `None` at the end.
    fn next_unit(&mut self) -> io::Result<Option<u16>> {
        if self.source.fill_buf()?.is_empty() {
            return Ok(None);
        }
        let mut bytes = [0; 2];
        match self.source.read_exact(&mut bytes) {
            Ok(()) => Ok(Some((self.unit)(bytes))),
            Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                Err(invalid("text in UTF-16 that ends within a character"))
            }
            Err(error) => Err(error),
        }
    }

    fn next_character(&mut self) -> io::Result<Option<char>> {
        let Some(unit) = self.next_unit()? else {
            return Ok(None);
        };
        let is_first_half = (0xd800..0xdc00).contains(&unit);
        let second = if is_first_half {
            self.next_unit()?
        } else {
            None
        };
        let units = std::iter::once(unit).chain(second);
        match char::decode_utf16(units).next() {
            Some(Ok(character)) => Ok(Some(character)),
            _ => Err(invalid("text in UTF-16 with half a character")),
        }
    }
}

impl<S: BufRead> Read for Utf16<S> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let mut count = 0;
        while count < buffer.len() {
            if self.rest.is_empty() {
                let Some(character) = self.next_character()? else {
                    break;
                };
                self.rest = 0..character.encode_utf8(&mut self.character).len();
            }
            let mut from = self.character.get(self.rest.clone()).unwrap_or_default();
            let read = from.read(buffer.get_mut(count..).unwrap_or_default())?;
            self.rest.start += read;
            count += read;
        }
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: Vec<u8>) -> io::Result<String> {
        let mut text = String::new();
        utf8(Cursor::new(bytes))?.read_to_string(&mut text)?;
        Ok(text)
    }

    /// `text` in UTF-16.
    fn utf16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes).collect()
    }

    #[test]
    fn one_text_in_every_encoding() {
        // Longer than a buffer, with characters of one to four bytes.
        let text = "wo_x;0,5\r\né中😀\n".repeat(2000);
        let marked = format!("\u{feff}{text}");
        for bytes in [
            text.clone().into_bytes(),
            marked.clone().into_bytes(),
            utf16(&marked, u16::to_le_bytes),
            utf16(&marked, u16::to_be_bytes),
            utf16(&text, u16::to_le_bytes),
            utf16(&text, u16::to_be_bytes),
        ] {
            assert!(read(bytes).unwrap() == text);
        }
        for short in ["", "a", "ab", "abc"] {
            assert_eq!(read(short.into()).unwrap(), short);
        }
    }

    #[test]
    fn what_is_broken_is_refused() {
        let odd = [utf16("\u{feff}ab", u16::to_le_bytes), vec![b'c']].concat();
        let half = [utf16("\u{feff}ab", u16::to_le_bytes), vec![0, 0xd8]].concat();
        let swapped = [
            utf16("\u{feff}ab", u16::to_le_bytes),
            vec![0, 0xdc, 0, 0xd8],
        ]
        .concat();
        for (bytes, expected) in [
            (odd, "ends within a character"),
            (half, "half a character"),
            (swapped, "half a character"),
            (vec![0xff, 0xfe, 0, 0, b'a', 0, 0, 0], "UTF-32"),
        ] {
            let line = read(bytes).unwrap_err().to_string();
            assert!(line.contains(expected), "{line}");
        }
    }
}
