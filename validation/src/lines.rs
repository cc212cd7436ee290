//! Lines for standard output, in order, until nobody reads them.

use std::collections::BTreeMap;
use std::io::{self, ErrorKind, Write};

/// Lines that become known in any order. A line is held back until all lines before it have been
/// printed.
///
/// After an error nothing more is printed: what comes after the lines is more important than they
/// are.
pub struct Lines<W> {
    out: W,
    waiting: BTreeMap<usize, String>,
    next: usize,
    error: Option<io::Error>,
}

impl<W: Write> Lines<W> {
    /// Lines that are printed to a writer.
    pub fn new(out: W) -> Self {
        Self {
            out,
            waiting: BTreeMap::new(),
            next: 0,
            error: None,
        }
    }

    /// Adds the line at a place, counted from zero, and prints the lines that were waiting for it.
    pub fn add(&mut self, place: usize, line: String) {
        self.waiting.insert(place, line);
        while let Some(line) = self.waiting.remove(&self.next) {
            self.next += 1;
            if self.error.is_none() {
                let printed = writeln!(self.out, "{line}").and_then(|()| self.out.flush());
                self.error = printed.err();
            }
        }
    }

    /// Ends the lines.
    ///
    /// # Errors
    /// A line could not be written. A closed pipe is no error: its reader has seen enough.
    pub fn finish(self) -> io::Result<()> {
        match self.error {
            Some(error) if error.kind() != ErrorKind::BrokenPipe => Err(error),
            _ => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Lines;
    use std::io::{Error, ErrorKind, Result, Write};

    /// Accepts some lines, then fails.
    struct Full {
        room: usize,
        text: String,
        calls_after_failure: usize,
        kind: ErrorKind,
    }

    impl Full {
        fn after(room: usize, kind: ErrorKind) -> Self {
            Self {
                room,
                text: String::new(),
                calls_after_failure: 0,
                kind,
            }
        }
    }

    impl Write for &mut Full {
        fn write(&mut self, bytes: &[u8]) -> Result<usize> {
            if self.text.lines().count() >= self.room && self.text.ends_with('\n') {
                self.calls_after_failure += 1;
                return Err(Error::from(self.kind));
            }
            self.text += &String::from_utf8_lossy(bytes);
            Ok(bytes.len())
        }
        fn flush(&mut self) -> Result<()> {
            Ok(())
        }
    }

    fn add_all<W: Write>(lines: &mut Lines<W>) {
        for place in [1, 0, 3, 2] {
            lines.add(place, format!("line {place}"));
        }
    }

    #[test]
    fn lines_are_printed_in_order_once_they_are_complete() {
        let mut text = Vec::new();
        let mut lines = Lines::new(&mut text);
        lines.add(1, "second".to_owned());
        lines.add(2, "third".to_owned());
        assert!(lines.out.is_empty());
        lines.add(0, "first".to_owned());
        assert!(lines.finish().is_ok());
        assert_eq!(text, b"first\nsecond\nthird\n");
    }

    #[test]
    fn a_closed_pipe_ends_the_lines_quietly_and_a_full_device_is_an_error() {
        for (kind, is_error) in [
            (ErrorKind::BrokenPipe, false),
            (ErrorKind::StorageFull, true),
        ] {
            let mut full = Full::after(2, kind);
            let mut lines = Lines::new(&mut full);
            add_all(&mut lines);
            assert_eq!(lines.finish().is_err(), is_error, "{kind}");
            assert_eq!(full.text, "line 0\nline 1\n");
            assert_eq!(full.calls_after_failure, 1, "nothing is tried again");
        }
    }
}
