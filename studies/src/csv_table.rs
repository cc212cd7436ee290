//! Tables as CSV.

use crate::text::{LONGEST, read_text};
use gouge_runner::error::{Error, SceneError};
use std::path::Path;

/// The text of a table whose first row is its header; `path` is the file that errors name.
///
/// # Errors
/// Rows of different lengths.
pub(crate) fn csv_table<R>(path: &Path, rows: impl IntoIterator<Item = R>) -> Result<Vec<u8>, Error>
where
    R: IntoIterator,
    R::Item: AsRef<[u8]>,
{
    let failed = |error: csv::Error| Error::file("write", path, std::io::Error::other(error));
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.write_record(row).map_err(failed)?;
    }
    let bytes = writer.into_inner();
    bytes.map_err(|error| Error::file("write", path, error.into_error()))
}

/// A table that a user names, with the line of each row.
pub(crate) struct CsvFile {
    file: String,
    pub header: Vec<String>,
    pub rows: Vec<(usize, csv::StringRecord)>,
}

impl CsvFile {
    /// Read a table.
    ///
    /// # Errors
    /// A file that cannot be read, or rows of different lengths.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text = read_text(path)?;
        let mut reader = csv::Reader::from_reader(text.as_bytes());
        let mut table = Self {
            file: path.display().to_string(),
            header: Vec::new(),
            rows: Vec::new(),
        };
        let refusal = |table: &Self, error: &csv::Error| {
            let line = error.position().map_or(1, |place| place.line() as usize);
            table.error(line, "", "", &format!("must be CSV: {error}"))
        };
        let header = reader.headers().map_err(|error| refusal(&table, &error))?;
        table.header = header.iter().map(str::to_owned).collect();
        for row in reader.records() {
            let row = row.map_err(|error| refusal(&table, &error))?;
            let line = row.position().map_or(0, |place| place.line() as usize);
            table.rows.push((line, row));
        }
        Ok(table)
    }

    /// Check that the table has some columns.
    ///
    /// # Errors
    /// The first one that is missing.
    pub fn check_header<'a>(&self, mut needed: impl Iterator<Item = &'a str>) -> Result<(), Error> {
        let is_missing = |name: &&str| !self.header.iter().any(|own| own == name);
        match needed.find(is_missing) {
            None => Ok(()),
            Some(name) => {
                let accepted = "missing; the first line must name this column";
                Err(self.error(1, name, "", accepted).into())
            }
        }
    }

    /// An error about a cell.
    pub fn error(&self, line: usize, column: &str, cell: &str, accepted: &str) -> SceneError {
        SceneError {
            file: self.file.clone(),
            line,
            key: column.to_owned(),
            value: cell.chars().take(LONGEST).collect(),
            accepted: accepted.to_owned(),
        }
    }
}
