//! Tables as text: how many nodes, and the values in base 64.

use std::fmt;
use std::str::FromStr;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

use super::{Shape, Table};
use crate::error::{Error, Result};

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
        let counts: std::result::Result<Vec<usize>, _> = counts
            .split('x')
            .map(|count| count.trim().parse())
            .collect();
        let shape = match counts.as_deref() {
            Ok([halves, differences, azimuths]) => {
                Shape::new(1, [*halves, *differences, *azimuths])?
            }
            Ok([halves, differences, azimuths, turns]) => {
                Shape::new(*turns, [*halves, *differences, *azimuths])?
            }
            _ => {
                return Err(wrong(
                    "three or four numbers of nodes are needed".to_owned(),
                ));
            }
        };
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
