//! Where results go: standard output, or a file that appears only when it is complete.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::args::is_standard_stream;
use bxdf::error::{Error, Result};
use bxdf_study::store::{Disk, Partial};

/// How standard output is called in messages.
const STANDARD_OUTPUT: &str = "standard output";

/// Standard output as a file: it may be a regular one, which must not be replaced.
const STANDARD_OUTPUT_DEVICE: &str = "/dev/stdout";

/// How many bytes of rows are gathered before they are written.
const BUFFER_BYTES: usize = 1 << 16;

/// Writes a whole file, which appears only when it is complete.
///
/// # Errors
/// [`Error::Io`].
pub(super) fn write(path: &Path, bytes: &[u8]) -> Result<()> {
    let mut output = Output::open(path)?;
    output
        .write_all(bytes)
        .map_err(|error| Error::io(path, error))?;
    output.finish()
}

/// Whether the name of a file ends so, behind its last point.
pub(super) fn ends_in(path: &Path, extension: &str) -> bool {
    let end = path.extension();
    end.is_some_and(|end| end.eq_ignore_ascii_case(extension))
}

/// A stream of results. A file is written beside its place and moved there by [`Output::finish`]; dropped before, it
/// leaves nothing behind.
pub(super) struct Output {
    stream: Stream,
    name: PathBuf,
}

enum Stream {
    /// What takes all that is written at once.
    Open(Box<dyn Write>),
    /// A file that appears when it is complete.
    Whole(File, Partial<'static>),
}

impl Output {
    /// Opens the file at `path`; `-` is standard output.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(super) fn open(path: &Path) -> Result<Self> {
        let failed = |source| Error::io(path, source);
        if is_standard_stream(path) || path == Path::new(STANDARD_OUTPUT_DEVICE) {
            return Ok(Self::standard());
        }
        let target = match fs::metadata(path) {
            // What the path points to is replaced, rather than a link.
            Ok(found) if found.is_file() => fs::canonicalize(path).map_err(failed)?,
            Ok(found) if found.is_dir() => {
                return Err(failed(io::ErrorKind::IsADirectory.into()));
            }
            // A device or a pipe: it cannot be moved into its place.
            Ok(_) => {
                let stream = OpenOptions::new().write(true).open(path).map_err(failed)?;
                return Ok(Self {
                    stream: Stream::Open(Box::new(stream)),
                    name: path.to_owned(),
                });
            }
            Err(_) => path.to_owned(),
        };
        #[cfg(unix)]
        super::signals::watch();
        let partial = Partial::of(&Disk, &target).map_err(failed)?;
        let file = File::create(partial.path()).map_err(failed)?;
        Ok(Self {
            stream: Stream::Whole(file, partial),
            name: path.to_owned(),
        })
    }

    fn standard() -> Self {
        Self {
            stream: Stream::Open(Box::new(io::stdout().lock())),
            name: STANDARD_OUTPUT.into(),
        }
    }

    /// Writes what is still held back, and puts a file in its place.
    ///
    /// # Errors
    /// [`Error::Io`]; a file is then removed.
    pub(super) fn finish(self) -> Result<()> {
        let finished = match self.stream {
            Stream::Open(mut stream) => stream.flush(),
            Stream::Whole(file, partial) => {
                let synced = file.sync_all();
                // Closed first: some systems do not move an open file.
                drop(file);
                synced.and_then(|()| partial.complete())
            }
        };
        finished.map_err(|source| Error::io(&self.name, source))
    }

    fn writer(&mut self) -> &mut dyn Write {
        match &mut self.stream {
            Stream::Open(stream) => stream,
            Stream::Whole(file, _) => file,
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.writer().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.writer().flush()
    }
}

/// Writes `text` to standard output.
///
/// # Errors
/// [`Error::Io`].
pub(super) fn print(text: &str) -> Result<()> {
    let mut output = Output::standard();
    output
        .write_all(text.as_bytes())
        .map_err(|source| Error::io(STANDARD_OUTPUT, source))?;
    output.finish()
}

/// Writes `value` to standard output as JSON.
///
/// # Errors
/// [`Error::Io`].
pub(super) fn print_json(value: &impl serde::Serialize) -> Result<()> {
    let text = serde_json::to_string_pretty(value)
        .map_err(|error| Error::io(STANDARD_OUTPUT, error.into()))?;
    print(&format!("{text}\n"))
}

/// Rows of comma-separated values.
pub(super) struct Table {
    writer: csv::Writer<Output>,
    name: PathBuf,
}

impl Table {
    /// A table at `path` with this header; `-` is standard output.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(super) fn open(path: &Path, header: &[&str]) -> Result<Self> {
        let output = Output::open(path)?;
        let mut table = Self {
            name: output.name.clone(),
            writer: csv::WriterBuilder::new()
                .buffer_capacity(BUFFER_BYTES)
                .from_writer(output),
        };
        for column in header {
            table.text(column)?;
        }
        table.end_row()?;
        Ok(table)
    }

    /// Adds a field to the row.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(super) fn text(&mut self, field: &str) -> Result<()> {
        self.writer
            .write_field(field)
            .map_err(|error| csv_error(&self.name, error))
    }

    /// Adds numbers to the row, in the fewest digits that read back as the same `f64`.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(super) fn numbers(&mut self, numbers: &[f64]) -> Result<()> {
        numbers
            .iter()
            .try_for_each(|number| self.text(&shortest(*number)))
    }

    /// Ends the row.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(super) fn end_row(&mut self) -> Result<()> {
        self.writer
            .write_record(None::<&[u8]>)
            .map_err(|error| csv_error(&self.name, error))
    }

    /// Writes what is still held back, and puts a file in its place.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub(super) fn finish(self) -> Result<()> {
        match self.writer.into_inner() {
            Ok(output) => output.finish(),
            Err(error) => Err(Error::io(self.name, error.into_error())),
        }
    }
}

/// What the csv crate reports about the stream called `name`.
pub(super) fn csv_error(name: &Path, error: csv::Error) -> Error {
    match error.into_kind() {
        csv::ErrorKind::Io(source) => Error::io(name, source),
        other => Error::parse(name.display().to_string(), format!("{other:?}")),
    }
}

/// Below and from these magnitudes on, an exponent is shorter than zeros.
const PLAIN_RANGE: std::ops::Range<f64> = 1e-5..1e16;

/// `x` in the fewest digits that read back as the same `f64`.
pub(super) fn shortest(x: f64) -> String {
    if x == 0.0 || PLAIN_RANGE.contains(&x.abs()) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_read_back() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "-0"),
            (1.0, "1"),
            (0.1, "0.1"),
            (1e-300, "1e-300"),
            (-2.5e-7, "-2.5e-7"),
            (1.5e16, "1.5e16"),
            (f64::from(f32::MAX), "3.4028234663852886e38"),
        ] {
            assert_eq!(shortest(x), text);
            assert_eq!(text.parse::<f64>().unwrap(), x);
        }
    }
}
