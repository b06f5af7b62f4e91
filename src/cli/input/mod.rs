//! Rows of directions read from comma-separated values.

mod lines;

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, BufRead, BufReader};
use std::path::{Path, PathBuf};

use csv::ByteRecord;
use glam::DVec3;

use lines::DataLines;

use super::args::is_standard_stream;
use super::output::csv_error;
use super::say::say;
use bxdf::error::{Error, Result, shown};
use bxdf::internals::files;
use bxdf::math::Vec3;

/// The columns read, by name.
pub const COLUMNS: [&str; 6] = ["wo_x", "wo_y", "wo_z", "wi_x", "wi_y", "wi_z"];

/// How far the squared length of a unit vector may be from 1: coordinates written with 7 digits pass.
const UNIT_TOLERANCE: f64 = 1e-6;

/// What may stand between fields: a comma, or what spreadsheets write where commas stand in numbers.
const SEPARATORS: [u8; 3] = [b',', b';', b'\t'];

/// What some spreadsheets write before the header, and the separator after it.
const SEPARATOR_MARK: &[u8] = b"sep=";

/// A pair of directions, and how they were written.
pub struct Row<'a> {
    /// The six fields in the order of [`COLUMNS`], as they were written, but for decimal commas, which are points.
    pub texts: [Cow<'a, str>; 6],
    /// The direction to the viewer, a unit vector.
    pub wo: DVec3,
    /// The direction to the light, a unit vector.
    pub wi: DVec3,
    /// Whether one of them had to be normalised.
    pub was_normalised: bool,
}

/// Reads rows one by one: separated by commas, or by semicolons or tabs, where numbers may have decimal commas; in UTF-8 or
/// UTF-16, with the line ends of any system.
pub struct Rows {
    reader: csv::Reader<DataLines<Box<dyn BufRead>>>,
    record: ByteRecord,
    columns: [usize; 6],
    field_count: usize,
    separator: u8,
    name: PathBuf,
}

impl Rows {
    /// Opens the file at `path` and reads its header; `-` is standard input.
    ///
    /// # Errors
    /// [`Error::Io`], and [`Error::Parse`] where a column is missing or stands twice.
    pub fn open(path: &Path) -> Result<Self> {
        if is_standard_stream(path) {
            return Self::read(Box::new(io::stdin().lock()), "standard input".into());
        }
        let file = File::open(path).map_err(|source| Error::io(path, source))?;
        Self::read(Box::new(BufReader::new(file)), path.to_owned())
    }

    /// Reads the header of `source`; `name` is that in errors.
    ///
    /// # Errors
    /// As of [`Self::open`].
    pub fn read(source: Box<dyn BufRead>, name: PathBuf) -> Result<Self> {
        let failed = |error| Error::io(&name, error);
        let mut lines = DataLines::new(files::utf8(source).map_err(failed)?);
        let separator = separator(&mut lines).map_err(failed)?;
        let mut rows = Self {
            reader: csv::ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .delimiter(separator)
                .from_reader(lines),
            record: ByteRecord::new(),
            columns: [0; 6],
            field_count: 0,
            separator,
            name,
        };
        if !rows.read_record()? {
            return Err(Error::parse(
                rows.name.display().to_string(),
                format!("no header; the columns read are {}", COLUMNS.join(",")),
            ));
        }
        rows.field_count = rows.record.len();
        rows.find_columns()?;
        Ok(rows)
    }

    /// Finds the columns in the record just read, which is the header.
    fn find_columns(&mut self) -> Result<()> {
        let is_named = |field: &[u8], name: &str| field.trim_ascii() == name.as_bytes();
        if !COLUMNS
            .iter()
            .any(|name| self.record.iter().any(|field| is_named(field, name)))
        {
            let separator = [self.separator];
            let found = self.record.iter().collect::<Vec<_>>().join(&separator[..]);
            return Err(self.problem(format!(
                "'{}' is no header; it has the columns {}, with commas, semicolons or tabs between them",
                shown(&String::from_utf8_lossy(&found)),
                COLUMNS.join(",")
            )));
        }
        for (index, name) in COLUMNS.into_iter().enumerate() {
            let mut places = (0..)
                .zip(&self.record)
                .filter(|(_, field)| is_named(field, name));
            let place = match (places.next(), places.next()) {
                (Some((place, _)), None) => place,
                (None, _) => return Err(self.problem(format!("no column '{name}'"))),
                _ => return Err(self.problem(format!("two columns '{name}'"))),
            };
            if let Some(column) = self.columns.get_mut(index) {
                *column = place;
            }
        }
        Ok(())
    }

    fn read_record(&mut self) -> Result<bool> {
        self.reader
            .read_byte_record(&mut self.record)
            .map_err(|error| csv_error(&self.name, error))
    }

    /// The next row; `None` at the end.
    ///
    /// # Errors
    /// [`Error::Io`], and [`Error::Parse`] with the line of the file where the row is malformed.
    pub fn next_row(&mut self) -> Result<Option<Row<'_>>> {
        if !self.read_record()? {
            return Ok(None);
        }
        let count = self.record.len();
        if count != self.field_count {
            let expected = self.field_count;
            let hint = if self.separator == b',' && count > expected {
                "; where commas part the fields, numbers have a point"
            } else {
                ""
            };
            let problem = format!("{count} fields where the header has {expected}{hint}");
            return Err(self.problem(problem));
        }
        self.parse()
            .map(Some)
            .map_err(|problem| self.problem(problem))
    }

    fn parse(&self) -> std::result::Result<Row<'_>, String> {
        let mut texts = [const { Cow::Borrowed("") }; 6];
        let mut numbers = [0.0_f64; 6];
        for (((text, number), name), column) in texts
            .iter_mut()
            .zip(&mut numbers)
            .zip(COLUMNS)
            .zip(self.columns)
        {
            let field = self.record.get(column).unwrap_or_default();
            let field = std::str::from_utf8(field).map_err(|_| format!("{name} is not text"))?;
            *text = with_point(field, self.separator);
            *number = text
                .trim()
                .parse()
                .map_err(|_| format!("{name} = '{}' is not a number", shown(field)))?;
            if !number.is_finite() {
                return Err(format!("{name} = {} is not finite", shown(field)));
            }
        }
        let [a, b, c, x, y, z] = numbers;
        let (wo, wo_was_unit) = unit("wo", DVec3::new(a, b, c))?;
        let (wi, wi_was_unit) = unit("wi", DVec3::new(x, y, z))?;
        Ok(Row {
            texts,
            wo,
            wi,
            was_normalised: !(wo_was_unit && wi_was_unit),
        })
    }

    /// A parse error about the record just read.
    fn problem(&self, problem: impl Into<String>) -> Error {
        let passed = self.record.position().map_or(1, csv::Position::line);
        let line = self.reader.get_ref().line_in_file(passed);
        Error::parse(format!("line {line}"), problem)
    }
}

/// Says on standard error how many rows (one, several) had directions that were normalised, if any had.
pub(super) fn say_normalised(count: u64, rows: [&str; 2]) {
    if count > 0 {
        let [one, several] = rows;
        let rows = if count == 1 { one } else { several };
        say(&format!(
            "{count} {rows} with directions that are not of unit length, normalised"
        ));
    }
}

/// What separates the fields of `lines`, by their first line: what parts most of the columns that are read, or what it
/// names, which is then left out.
fn separator(lines: &mut DataLines<impl BufRead>) -> io::Result<u8> {
    let header = lines.peek()?;
    let named = header
        .split_at_checked(SEPARATOR_MARK.len())
        .filter(|(mark, _)| mark.eq_ignore_ascii_case(SEPARATOR_MARK))
        .and_then(|(_, rest)| rest.first().copied())
        .filter(u8::is_ascii);
    if let Some(named) = named {
        lines.leave_out();
        return Ok(named);
    }
    let is_column = |field: &[u8]| {
        let unquoted = field.trim_ascii();
        let unquoted = unquoted.strip_prefix(b"\"").unwrap_or(unquoted);
        let unquoted = unquoted.strip_suffix(b"\"").unwrap_or(unquoted);
        COLUMNS
            .iter()
            .any(|name| name.as_bytes() == unquoted.trim_ascii())
    };
    let columns = |separator: &u8| {
        let fields = header.split(|byte| byte == separator);
        fields.filter(|field| is_column(field)).count()
    };
    // The first of equals: the comma.
    let best = SEPARATORS.into_iter().rev().max_by_key(columns);
    Ok(best.unwrap_or(b','))
}

/// `field` with a decimal point, where a comma stands for it: alone, and where commas part no fields.
fn with_point(field: &str, separator: u8) -> Cow<'_, str> {
    let is_alone = field.matches(',').count() == 1 && !field.contains('.');
    if separator != b',' && is_alone {
        Cow::Owned(field.replace(',', "."))
    } else {
        Cow::Borrowed(field)
    }
}

/// `w` as a unit vector, and whether it was one.
pub(super) fn unit(name: &str, w: DVec3) -> std::result::Result<(DVec3, bool), String> {
    if (w.length_squared() - 1.0).abs() <= UNIT_TOLERANCE {
        return Ok((w, true));
    }
    let (unit, _) = Vec3::<f64>::from(w)
        .unit_and_length()
        .ok_or_else(|| format!("{name} has length 0"))?;
    Ok((unit.into(), false))
}

#[cfg(test)]
mod tests;
