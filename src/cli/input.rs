//! Rows of directions read from comma-separated values.

use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

use csv::ByteRecord;
use glam::DVec3;

use super::args::is_standard_stream;
use super::output::csv_error;
use crate::bxdf::math::Vec3;
use crate::error::{Error, Result};

/// The columns read, by name.
pub const COLUMNS: [&str; 6] = ["wo_x", "wo_y", "wo_z", "wi_x", "wi_y", "wi_z"];

/// How far the squared length of a unit vector may be from 1: coordinates written with 7 digits pass.
const UNIT_TOLERANCE: f64 = 1e-6;

/// The longest line accepted, in bytes: a file without line breaks is refused before it fills the memory.
const MAX_LINE_BYTES: usize = 1 << 20;

/// A pair of directions, and how they were written.
pub struct Row<'a> {
    /// The six fields in the order of [`COLUMNS`], as they were written.
    pub texts: [&'a str; 6],
    /// The direction to the viewer, a unit vector.
    pub wo: DVec3,
    /// The direction to the light, a unit vector.
    pub wi: DVec3,
    /// Whether one of them had to be normalised.
    pub was_normalised: bool,
}

/// Reads rows one by one.
pub struct Rows {
    reader: csv::Reader<DataLines<Box<dyn BufRead>>>,
    record: ByteRecord,
    columns: [usize; 6],
    field_count: usize,
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
        let mut rows = Self {
            reader: csv::ReaderBuilder::new()
                .has_headers(false)
                .flexible(true)
                .from_reader(DataLines::new(source)),
            record: ByteRecord::new(),
            columns: [0; 6],
            field_count: 0,
            name,
        };
        if !rows.read_record()? {
            return Err(Error::parse(
                rows.name.display().to_string(),
                format!("no header; the columns read are {}", COLUMNS.join(",")),
            ));
        }
        rows.field_count = rows.record.len();
        for (column, name) in rows.columns.iter_mut().zip(COLUMNS) {
            let is_named = |field: &[u8]| field.trim_ascii() == name.as_bytes();
            let mut places = (0..).zip(&rows.record).filter(|(_, field)| is_named(field));
            *column = match (places.next(), places.next()) {
                (Some((place, _)), None) => place,
                (None, _) => return Err(rows.problem(format!("no column '{name}'"))),
                _ => return Err(rows.problem(format!("two columns '{name}'"))),
            };
        }
        Ok(rows)
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
            return Err(self.problem(format!("{count} fields where the header has {expected}")));
        }
        self.parse()
            .map(Some)
            .map_err(|problem| self.problem(problem))
    }

    fn parse(&self) -> std::result::Result<Row<'_>, String> {
        let mut texts = [""; 6];
        let mut numbers = [0.0_f64; 6];
        for (((text, number), name), column) in texts
            .iter_mut()
            .zip(&mut numbers)
            .zip(COLUMNS)
            .zip(self.columns)
        {
            let field = self.record.get(column).unwrap_or_default();
            *text = std::str::from_utf8(field).map_err(|_| format!("{name} is not text"))?;
            *number = text
                .trim()
                .parse()
                .map_err(|_| format!("{name} = '{text}' is not a number"))?;
            if !number.is_finite() {
                return Err(format!("{name} = {text} is not finite"));
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

/// `w` as a unit vector, and whether it was one.
fn unit(name: &str, w: DVec3) -> std::result::Result<(DVec3, bool), String> {
    if (w.length_squared() - 1.0).abs() <= UNIT_TOLERANCE {
        return Ok((w, true));
    }
    let (unit, _) = Vec3::<f64>::from(w)
        .unit_and_length()
        .ok_or_else(|| format!("{name} has length 0"))?;
    Ok((unit.into(), false))
}

/// The lines of `source` that hold data: comments and blank lines are left out, line ends become `\n`.
struct DataLines<S> {
    source: S,
    line: Vec<u8>,
    sent: usize,
    lines_read: u64,
    lines_passed: u64,
    /// From which passed line on how many lines had been left out.
    left_out: Vec<(u64, u64)>,
}

impl<S: BufRead> DataLines<S> {
    fn new(source: S) -> Self {
        Self {
            source,
            line: Vec::new(),
            sent: 0,
            lines_read: 0,
            lines_passed: 0,
            left_out: Vec::new(),
        }
    }

    /// Where in the file the line stands that was passed on as number `passed`, both counted from 1.
    fn line_in_file(&self, passed: u64) -> u64 {
        let after = self.left_out.partition_point(|(first, _)| *first <= passed);
        let left_out = after.checked_sub(1).and_then(|i| self.left_out.get(i));
        passed + left_out.map_or(0, |(_, count)| *count)
    }

    fn next_line(&mut self) -> io::Result<bool> {
        loop {
            self.line.clear();
            self.sent = 0;
            let limit = MAX_LINE_BYTES as u64 + 1;
            (&mut self.source)
                .take(limit)
                .read_until(b'\n', &mut self.line)?;
            if self.line.is_empty() {
                return Ok(false);
            }
            self.lines_read += 1;
            if self.line.len() > MAX_LINE_BYTES {
                return Err(io::Error::new(
                    io::ErrorKind::InvalidData,
                    format!(
                        "line {} is longer than {MAX_LINE_BYTES} bytes",
                        self.lines_read
                    ),
                ));
            }
            if self.lines_read == 1 && self.line.starts_with(b"\xef\xbb\xbf") {
                self.line.drain(..3);
            }
            let content = self.line.trim_ascii_start();
            if content.is_empty() || content.starts_with(b"#") {
                continue;
            }
            while self
                .line
                .pop_if(|byte| matches!(byte, b'\n' | b'\r'))
                .is_some()
            {}
            self.line.push(b'\n');
            self.lines_passed += 1;
            let count = self.lines_read - self.lines_passed;
            if self.left_out.last().map_or(0, |(_, known)| *known) != count {
                self.left_out.push((self.lines_passed, count));
            }
            return Ok(true);
        }
    }
}

impl<S: BufRead> Read for DataLines<S> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        if self.sent == self.line.len() && !self.next_line()? {
            return Ok(0);
        }
        let mut rest = self.line.get(self.sent..).unwrap_or_default();
        let count = rest.read(buffer)?;
        self.sent += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HEADER: &str = "wi_z,wo_x,wo_y,wo_z,wi_x,wi_y,note\n";

    fn rows(text: &str) -> Result<Rows> {
        let source = io::Cursor::new(text.to_owned().into_bytes());
        Rows::read(Box::new(source), "test".into())
    }

    /// The error of the first row that has one.
    fn first_error(text: &str) -> String {
        let mut rows = match rows(text) {
            Ok(rows) => rows,
            Err(error) => return error.to_string(),
        };
        loop {
            match rows.next_row() {
                Ok(row) => assert!(row.is_some(), "no error in {text}"),
                Err(error) => return error.to_string(),
            }
        }
    }

    #[test]
    fn columns_go_by_name_and_keep_their_text() {
        let text = format!("\u{feff}# a comment\r\n{HEADER}\r\n 1.0,+0,-0.,2e0,.6,0,\"a, b\"\r\n");
        let mut rows = rows(&text).unwrap();
        let row = rows.next_row().unwrap().unwrap();
        assert_eq!(row.texts, ["+0", "-0.", "2e0", ".6", "0", " 1.0"]);
        assert_eq!(row.wo, DVec3::Z);
        assert!(row.was_normalised && (row.wi.length() - 1.0).abs() < 1e-15);
        assert!(rows.next_row().unwrap().is_none());
    }

    #[test]
    fn vectors_are_normalised_only_where_they_must_be() {
        for (x, was_unit) in [(1.0 + 4e-7, true), (1.0 + 6e-7, false)] {
            let (w, found) = unit("wo", DVec3::X * x).unwrap();
            assert_eq!(found, was_unit);
            assert_eq!(w.x == x, was_unit);
        }
        for tiny_or_huge in [1e-300, 1e300] {
            let (w, _) = unit("wo", DVec3::new(3.0, 0.0, 4.0) * tiny_or_huge).unwrap();
            assert!((w - DVec3::new(0.6, 0.0, 0.8)).length() < 1e-15);
        }
    }

    #[test]
    fn errors_name_the_line_of_the_file() {
        let good = "1,0,0,1,0,0,\n";
        for (text, expected) in [
            (String::new(), "test: no header; the columns read are wo_x,"),
            ("wo_x,wo_y\n".into(), "line 1: no column 'wo_z'"),
            (
                "#\n\nwo_x,wo_x,wo_y,wo_z\n".into(),
                "line 3: two columns 'wo_x'",
            ),
            (
                format!("#\n{HEADER}{good}1,2\n"),
                "line 4: 2 fields where the header has 7",
            ),
            (
                format!("{HEADER}{good}#\n\n{good}#\r\n1,a,0,1,0,0,"),
                "line 7: wo_x = 'a' is not a number",
            ),
            (
                format!("{HEADER}nan,0,0,1,0,0,\n"),
                "line 2: wi_z = nan is not finite",
            ),
            (
                format!("{HEADER}1e400,0,0,1,0,0,\n"),
                "line 2: wi_z = 1e400 is not finite",
            ),
            (format!("{HEADER}0,0,0,1,0,0,\n"), "line 2: wi has length 0"),
            (
                format!("{HEADER}{good}{}", "1".repeat(MAX_LINE_BYTES + 1)),
                "test: line 3 is longer than 1048576 bytes",
            ),
        ] {
            let line = first_error(&text);
            assert!(line.starts_with(expected), "{line}");
        }
    }
}
