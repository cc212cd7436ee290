//! Data of another program, from a LAMMPS dump or a CSV file.

use super::{dump, table};
use crate::error::Error;
use std::collections::HashSet;
use std::path::Path;

/// When a frame was taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum When {
    /// After a number of steps of the other program.
    Step(u64),
    /// At a time in s.
    Time(f64),
    /// At the end of the run.
    End,
}

/// What the rows of a file are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Particles.
    Particles,
    /// Values of the whole run, such as energies.
    Run,
}

/// The rows of one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The time.
    pub when: When,
    /// The particle of each row, counted from zero; none if the rows describe the whole run.
    pub ids: Option<Vec<usize>>,
    /// The values of each column, in the order of the names.
    pub columns: Vec<Vec<f64>>,
}

/// Data of another program.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    /// Name of the file.
    pub file: String,
    /// What its rows are.
    pub kind: Kind,
    /// Names of the columns of numbers.
    pub names: Vec<String>,
    /// Names of columns that hold other things than numbers.
    pub others: Vec<String>,
    /// The identifier of the first particle: 1 in dumps, 0 in CSV files.
    pub first_id: usize,
    /// The frames in order of time.
    pub frames: Vec<Frame>,
}

/// What some editors write at the beginning of a text file.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Read a LAMMPS dump, or a CSV file with a header.
///
/// # Errors
/// A file that cannot be read or is neither; the error names the line.
pub fn read(path: &Path) -> Result<Data, Error> {
    let bytes = std::fs::read(path)
        .map_err(|error| Error::Argument(format!("cannot read {}: {error}", path.display())))?;
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(&bytes);
    let file = path.display().to_string();
    let data = match bytes.starts_with(b"ITEM:") {
        true => dump::parse(&file, bytes),
        false => table::parse(&file, bytes),
    };
    let mut data = data.map_err(|(line, reason)| match line {
        0 => Error::Argument(format!("{file}: {reason}")),
        line => Error::Argument(format!("{file}:{line}: {reason}")),
    })?;
    let time = |frame: &Frame| match frame.when {
        When::Step(step) => step as f64,
        When::Time(time) => time,
        When::End => f64::INFINITY,
    };
    data.frames.sort_by(|a, b| time(a).total_cmp(&time(b)));
    data.frames = merged(data.frames);
    match data.frames.iter().find_map(repeated) {
        None => Ok(data),
        Some(id) => Err(Error::Argument(format!(
            "{file}: id {}: occurs twice at the same time; the column of times must be named time or step",
            id + data.first_id
        ))),
    }
}

/// A particle that a frame lists twice.
fn repeated(frame: &Frame) -> Option<usize> {
    let mut seen = HashSet::new();
    let mut ids = frame.ids.iter().flatten();
    ids.find(|id| !seen.insert(**id)).copied()
}

/// The sorted frames, with those of the same time joined.
fn merged(frames: Vec<Frame>) -> Vec<Frame> {
    let mut all: Vec<Frame> = Vec::new();
    for frame in frames {
        match all.last_mut() {
            Some(last) if last.when == frame.when => last.join(frame),
            _ => all.push(frame),
        }
    }
    all
}

impl Frame {
    fn join(&mut self, other: Self) {
        if let (Some(ids), Some(more)) = (&mut self.ids, other.ids) {
            ids.extend(more);
        }
        for (column, more) in self.columns.iter_mut().zip(other.columns) {
            column.extend(more);
        }
    }
}
