//! Tables as text: how many nodes, and the values in base 64.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::{Shape, Table};
use crate::error::{Error, Result};
use crate::resource::Decoder;

/// The format of these texts, which files have too.
pub static TABLE: Decoder = Decoder {
    title: "Table of values",
    extensions: &["table"],
    begins,
    decode: |bytes| {
        let text = std::str::from_utf8(bytes);
        let text = text.map_err(|_| Error::parse("table", "is no text"))?;
        Ok(Arc::new(text.trim().parse::<Table>()?))
    },
};

/// Whether there are numbers of nodes before the first separator.
fn begins(bytes: &[u8]) -> bool {
    // Four numbers of four digits, and what stands between and around them.
    const LONGEST: usize = 40;
    let start = bytes.trim_ascii_start();
    let counts = start
        .iter()
        .take(LONGEST)
        .position(|byte| *byte == SEPARATOR as u8);
    let counts = counts.and_then(|end| start.get(..end)).unwrap_or_default();
    let is_count = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'x' | b' ');
    counts.first().is_some_and(u8::is_ascii_digit) && counts.iter().all(is_count)
}

/// What stands between the numbers of nodes and the values.
const SEPARATOR: char = ';';

impl fmt::Display for Table {
    /// `HALVESxDIFFERENCESxAZIMUTHS;VALUES`, or `..xTURNS;VALUES`: the values as little-endian `f32` in base 64.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let channels = self.values.as_flattened().iter();
        let bytes: Vec<u8> = channels.flat_map(|x| x.to_le_bytes()).collect();
        write!(f, "{}{SEPARATOR}{}", self.shape, STANDARD.encode(bytes))
    }
}

impl Table {
    /// How many bytes its text has, without writing it.
    #[must_use]
    pub fn text_bytes(&self) -> u64 {
        let counts = self.shape.to_string().len() + SEPARATOR.len_utf8();
        // Four characters for every three bytes that are begun.
        counts as u64 + 4 * self.shape.bytes().div_ceil(3)
    }
}

impl FromStr for Table {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let wrong = |problem: String| Error::parse("table", problem);
        let (counts, values) = text
            .split_once(SEPARATOR)
            .ok_or_else(|| wrong("is not HALVESxDIFFERENCESxAZIMUTHS;VALUES".to_owned()))?;
        let shape: Shape = counts.parse()?;
        let bytes = STANDARD
            .decode(values.trim())
            .map_err(|error| wrong(format!("values: {error}")))?;
        if bytes.len() as u64 != shape.bytes() {
            let problem = format!("{} bytes of values for {shape} nodes", bytes.len());
            return Err(wrong(problem));
        }
        let (numbers, _) = bytes.as_chunks::<4>();
        let numbers: Vec<f32> = numbers.iter().map(|b| f32::from_le_bytes(*b)).collect();
        if let Some(number) = numbers.iter().find(|x| !(**x >= 0.0 && x.is_finite())) {
            return Err(wrong(format!(
                "a value of {number}; allowed are finite ones, 0 or more"
            )));
        }
        let (values, _) = numbers.as_chunks::<3>();
        Ok(Self::new(shape, values.to_vec()))
    }
}
