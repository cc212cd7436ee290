//! Writes the file `series.csv`, and others that grow by rows.

use crate::error::Error;
use std::fmt;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// A value in a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number in SI units.
    Number(f64),
    /// A count.
    Count(usize),
}

impl Value {
    /// The value as a number.
    pub fn number(self) -> f64 {
        match self {
            Self::Number(number) => number,
            Self::Count(count) => count as f64,
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(number) => write!(f, "{number:?}"),
            Self::Count(count) => write!(f, "{count}"),
        }
    }
}

/// A sample: values by name, with the same names in every sample of a series.
pub type Sample = Vec<(&'static str, Value)>;

/// A CSV file, open for appending.
pub struct Series {
    path: PathBuf,
    file: File,
    bytes: u64,
}

impl Series {
    /// Begin a file with the given columns, or continue an existing one after its first `bytes` bytes, if any.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn open(path: PathBuf, columns: &[&str], bytes: Option<u64>) -> Result<Self, Error> {
        let open = || -> std::io::Result<(File, u64)> {
            let bytes = bytes.unwrap_or(0);
            if bytes == 0 {
                return Ok((File::create(&path)?, 0));
            }
            let mut file = File::options().write(true).open(&path)?;
            if file.metadata()?.len() < bytes {
                return Err(std::io::Error::other(
                    "it is shorter than when it was last written",
                ));
            }
            file.set_len(bytes)?;
            file.seek(SeekFrom::End(0))?;
            Ok((file, bytes))
        };
        let (file, bytes) = open().map_err(|error| Error::file("open", &path, error))?;
        let mut series = Self { path, file, bytes };
        if series.bytes == 0 {
            series.append(&(columns.join(",") + "\n"))?;
        }
        Ok(series)
    }

    /// Bytes of a series without the last row of its first `bytes` bytes.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn without_last_row(path: &Path, bytes: u64) -> Result<u64, Error> {
        let text = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        let rows = text.get(..bytes as usize).unwrap_or(&text);
        let before = rows.strip_suffix(b"\n").unwrap_or(rows);
        let end = before.iter().rposition(|&byte| byte == b'\n');
        Ok(end.map_or(0, |end| end as u64 + 1))
    }

    /// Flush the appended rows to the disk.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn sync(&self) -> Result<(), Error> {
        let synced = self.file.sync_data();
        synced.map_err(|error| Error::file("write", &self.path, error))
    }

    /// Append a sample.
    ///
    /// # Errors
    /// Failures of the file system; the rows written before are kept.
    pub fn write(&mut self, sample: &Sample) -> Result<(), Error> {
        let cells: Vec<String> = sample.iter().map(|(_, value)| value.to_string()).collect();
        self.append_row(&cells)
    }

    /// Append several rows at once.
    ///
    /// # Errors
    /// As for [`Series::write`].
    pub fn append_rows(&mut self, rows: &[Vec<String>]) -> Result<(), Error> {
        let lines = rows.iter().map(|cells| cells.join(",") + "\n");
        self.append(&lines.collect::<String>())
    }

    /// Append a row.
    ///
    /// # Errors
    /// As for [`Series::write`].
    pub fn append_row(&mut self, cells: &[String]) -> Result<(), Error> {
        self.append(&(cells.join(",") + "\n"))
    }

    fn append(&mut self, text: &str) -> Result<(), Error> {
        if let Err(error) = self.file.write_all(text.as_bytes()) {
            let _ = self.file.set_len(self.bytes);
            return Err(Error::file("write", &self.path, error));
        }
        self.bytes += text.len() as u64;
        Ok(())
    }

    /// Bytes written so far.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}
