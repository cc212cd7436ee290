//! Rows of the CSV files that a scene names.

use super::particles::{Place, ROLES};
use super::table::{Range, Source, Table, shortened};
use crate::error::SceneError;
use gouge_dem::particles::Role;
use std::path::Path;

type Result<T> = std::result::Result<T, SceneError>;

/// The CSV file that replaces a list, if the scene names one.
pub fn side_file(root: &Table, list: &str, folder: &Path) -> Result<Option<Rows>> {
    let key = format!("{list}_file");
    let Some(name) = root.optional_text(&key)? else {
        return Ok(None);
    };
    if root.has(list) {
        let accepted =
            format!("cannot be combined with [[{list}]]; only one of the two may be given");
        return Err(root.error(&key, &accepted));
    }
    rows_of(root, &key, &folder.join(name)).map(Some)
}

/// The CSV file that a key names.
pub fn rows_of(table: &Table, key: &str, path: &Path) -> Result<Rows> {
    match read_regular(path) {
        Ok(bytes) => Ok(Rows {
            file: path.display().to_string(),
            bytes,
        }),
        Err(error) => Err(table.error(
            key,
            &format!("must be the name of a readable CSV file: {error}"),
        )),
    }
}

/// The content of a file; a pipe, which might never end, is refused.
pub fn read_regular(path: &Path) -> std::io::Result<Vec<u8>> {
    match std::fs::metadata(path)?.is_file() {
        true => std::fs::read(path),
        false => Err(std::io::Error::other("it is not a regular file")),
    }
}

/// A CSV file.
pub struct Rows {
    file: String,
    bytes: Vec<u8>,
}

/// A row of a CSV file.
pub struct Row<'a> {
    file: &'a str,
    line: usize,
    /// Number of the row, counted from zero.
    pub ordinal: usize,
    header: &'a csv::StringRecord,
    record: &'a csv::StringRecord,
}

impl Rows {
    /// Names of the columns.
    pub fn header(&self) -> Result<Vec<String>> {
        let mut reader = self.reader();
        let header = reader.headers().map_err(|error| self.broken(&error))?;
        Ok(header.iter().map(str::to_owned).collect())
    }

    fn reader(&self) -> csv::Reader<&[u8]> {
        csv::ReaderBuilder::new()
            .trim(csv::Trim::All)
            .from_reader(&self.bytes[..])
    }

    /// Read all rows.
    pub fn read<T>(
        &self,
        required: &[&str],
        optional: &[&str],
        mut read: impl FnMut(&Row) -> Result<T>,
    ) -> Result<Vec<T>> {
        let mut reader = self.reader();
        let header = reader
            .headers()
            .map_err(|error| self.broken(&error))?
            .clone();
        self.check_header(&header, required, optional)?;
        let mut items = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| self.broken(&error))?;
            let line = record.position().map_or(0, |position| self.line(position));
            items.push(read(&Row {
                file: &self.file,
                line,
                ordinal: items.len(),
                header: &header,
                record: &record,
            })?);
        }
        Ok(items)
    }

    fn check_header(
        &self,
        header: &csv::StringRecord,
        required: &[&str],
        optional: &[&str],
    ) -> Result<()> {
        let source = Source {
            file: &self.file,
            text: "",
            breaks: &[],
            overrides: &[],
        };
        let known = [required, optional].concat().join(", ");
        let accepted = format!("must be one of the columns: {known}");
        let mut seen = std::collections::HashSet::new();
        for (place, name) in header.iter().enumerate() {
            if name.is_empty() {
                let column = format!("column {}", place + 1);
                let accepted = format!(
                    "has no name in the header; pandas writes such an index unless told `index=False`; {accepted}"
                );
                return Err(source.error(0, &column, "", &accepted));
            }
            if !required.contains(&name) && !optional.contains(&name) {
                return Err(source.error(0, "column", &shortened(name), &accepted));
            }
            if !seen.insert(name) {
                return Err(source.error(
                    0,
                    "column",
                    name,
                    "appears twice in the header; each column may appear only once",
                ));
            }
        }
        match required.iter().find(|name| !seen.contains(*name)) {
            Some(name) => {
                let required = required.join(", ");
                let accepted = format!("missing column; the header must contain: {required}");
                Err(source.error(0, name, "", &accepted))
            }
            None => Ok(()),
        }
    }

    /// Line of a row. The parser counts blank lines before a row as part of it; they are skipped here.
    fn line(&self, position: &csv::Position) -> usize {
        let rest = self
            .bytes
            .get(position.byte() as usize..)
            .unwrap_or_default();
        let blank = rest.iter().take_while(|byte| matches!(byte, b'\n' | b'\r'));
        position.line() as usize + blank.filter(|&&byte| byte == b'\n').count()
    }

    fn broken(&self, error: &csv::Error) -> SceneError {
        let (value, accepted) = match error.kind() {
            csv::ErrorKind::UnequalLengths {
                expected_len, len, ..
            } => (
                format!("{len} cells"),
                format!("must have {expected_len} cells, as many as the header"),
            ),
            csv::ErrorKind::Utf8 { .. } => (String::new(), "must be text in UTF-8".to_owned()),
            _ => (String::new(), format!("must be a CSV file: {error}")),
        };
        SceneError {
            file: self.file.clone(),
            line: error.position().map_or(1, |position| self.line(position)),
            key: String::new(),
            value,
            accepted,
        }
    }
}

impl Row<'_> {
    /// The cell of a column, unless it is empty or missing.
    pub fn cell(&self, key: &str) -> Option<&str> {
        let column = self.header.iter().position(|name| name == key)?;
        self.record.get(column).filter(|cell| !cell.is_empty())
    }

    /// Where the row is.
    pub fn place(&self) -> Place {
        Place {
            file: self.file.to_owned(),
            line: self.line,
            key: "i,j".to_owned(),
        }
    }

    /// An error about a cell of the row.
    pub fn error(&self, key: &str, accepted: &str) -> SceneError {
        SceneError {
            file: self.file.to_owned(),
            line: self.line,
            key: key.to_owned(),
            value: shortened(self.cell(key).unwrap_or_default()),
            accepted: accepted.to_owned(),
        }
    }

    /// A number.
    pub fn number(&self, key: &str, range: Range) -> Result<f64> {
        let accepted = range.text();
        let number = self.cell(key).and_then(|cell| cell.parse::<f64>().ok());
        number
            .filter(|&number| range.contains(number))
            .ok_or_else(|| self.error(key, &accepted))
    }

    /// A number, or a default for an empty cell.
    pub fn optional_number(&self, key: &str, range: Range, default: f64) -> Result<f64> {
        if self.cell(key).is_none() {
            Ok(default)
        } else {
            self.number(key, range)
        }
    }

    /// The index of a particle.
    pub fn index(&self, key: &str) -> Result<usize> {
        let number = self.cell(key).and_then(|cell| cell.parse().ok());
        number.ok_or_else(|| self.error(key, "must be a particle index, counted from 0"))
    }

    /// The index of one of a number of nodes.
    pub fn node(&self, key: &str, nodes: usize) -> Result<usize> {
        let number = self.cell(key).and_then(|cell| cell.parse().ok());
        let accepted = format!("must be a node from 0 to {}", nodes.saturating_sub(1));
        let number = number.filter(|&number| number < nodes);
        number.ok_or_else(|| self.error(key, &accepted))
    }

    /// The indices in the columns i and j.
    pub fn pair(&self) -> Result<[usize; 2]> {
        Ok([self.index("i")?, self.index("j")?])
    }

    /// The role; free for an empty cell.
    pub fn role(&self) -> Result<Role> {
        let Some(cell) = self.cell("role") else {
            return Ok(Role::Free);
        };
        let found = ROLES.iter().find(|(name, _)| *name == cell);
        found
            .map(|(_, role)| *role)
            .ok_or_else(|| self.error("role", "must be one of: free, driven, fixed"))
    }
}
