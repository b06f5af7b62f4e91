//! The lines of a table that hold data.

use std::io::{self, BufRead, Read};

/// The longest line accepted, in bytes: a file without line breaks is refused before it fills the memory.
pub(super) const MAX_LINE_BYTES: usize = 1 << 20;

/// The lines of `source` that hold data: comments and blank lines are left out, line ends become `\n`.
pub(super) struct DataLines<S> {
    source: S,
    line: Vec<u8>,
    sent: usize,
    /// Whether the last byte read was a carriage return, which a line feed may follow.
    after_return: bool,
    lines_read: u64,
    lines_passed: u64,
    /// From which passed line on how many lines had been left out.
    left_out: Vec<(u64, u64)>,
}

impl<S: BufRead> DataLines<S> {
    pub(super) fn new(source: S) -> Self {
        Self {
            source,
            line: Vec::new(),
            sent: 0,
            after_return: false,
            lines_read: 0,
            lines_passed: 0,
            left_out: Vec::new(),
        }
    }

    /// Where in the file the line stands that was passed on as number `passed`, both counted from 1.
    pub(super) fn line_in_file(&self, passed: u64) -> u64 {
        let after = self.left_out.partition_point(|(first, _)| *first <= passed);
        let left_out = after.checked_sub(1).and_then(|i| self.left_out.get(i));
        passed + left_out.map_or(0, |(_, count)| *count)
    }

    /// The next line that holds data, with its end, which is to be read; empty where there is none.
    ///
    /// # Errors
    /// The system's; `InvalidData` for a line that is too long.
    pub(super) fn peek(&mut self) -> io::Result<&[u8]> {
        if self.sent == self.line.len() {
            self.next_line()?;
        }
        Ok(self.line.get(self.sent..).unwrap_or_default())
    }

    /// Leaves out the line that is to be read.
    pub(super) fn leave_out(&mut self) {
        self.sent = self.line.len();
        self.lines_passed -= 1;
        self.left_out.clear();
    }

    fn next_line(&mut self) -> io::Result<bool> {
        loop {
            self.line.clear();
            self.sent = 0;
            if !self.read_line()? {
                return Ok(false);
            }
            self.lines_read += 1;
            let content = self.line.trim_ascii_start();
            if content.is_empty() || content.starts_with(b"#") {
                continue;
            }
            self.line.push(b'\n');
            self.lines_passed += 1;
            let count = self.lines_read - self.lines_passed;
            if self.left_out.last().map_or(0, |(_, known)| *known) != count {
                self.left_out.push((self.lines_passed, count));
            }
            return Ok(true);
        }
    }

    /// Reads a line without its end, which is that of any system: `\n`, `\r\n` or `\r`. Returns whether there was one.
    fn read_line(&mut self) -> io::Result<bool> {
        let mut is_there = false;
        loop {
            let mut buffer = self.source.fill_buf()?;
            if std::mem::take(&mut self.after_return) && buffer.first() == Some(&b'\n') {
                self.source.consume(1);
                continue;
            }
            if buffer.is_empty() {
                return Ok(is_there);
            }
            is_there = true;
            let end = buffer.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
            if let Some(end) = end {
                self.after_return = buffer.get(end) == Some(&b'\r');
                buffer = buffer.get(..end).unwrap_or_default();
            }
            if self.line.len() + buffer.len() > MAX_LINE_BYTES {
                let number = self.lines_read + 1;
                let problem = format!("line {number} is longer than {MAX_LINE_BYTES} bytes");
                return Err(io::Error::new(io::ErrorKind::InvalidData, problem));
            }
            self.line.extend_from_slice(buffer);
            let count = buffer.len() + usize::from(end.is_some());
            self.source.consume(count);
            if end.is_some() {
                return Ok(true);
            }
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
