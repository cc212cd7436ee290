//! Steps at which tables are written.

use super::text;
use crate::error::ReplayError;
use std::collections::BTreeSet;
use std::path::Path;

/// Steps at which a table is written: those of the table beside the case, or all multiples of the interval and the last.
pub(super) enum Steps {
    Listed(BTreeSet<usize>),
    Regular { interval: usize, last: usize },
}

impl Steps {
    /// Those of a table beside a case, which may be compressed, up to the last step; regular ones if there is no table.
    pub(super) fn beside(
        case: &Path,
        table: &str,
        interval: usize,
        last: usize,
    ) -> Result<Self, ReplayError> {
        let folder = case.parent().unwrap_or(Path::new("."));
        let names = [table.to_owned(), format!("{table}.gz")];
        let mut files = names.iter().map(|name| folder.join(name));
        match files.find(|file| file.is_file()) {
            Some(file) => listed(&file, last).map(Self::Listed),
            None => Ok(Self::Regular { interval, last }),
        }
    }

    /// Whether the table is written after a step.
    pub(super) fn contain(&self, step: usize) -> bool {
        match self {
            Self::Listed(steps) => steps.contains(&step),
            Self::Regular { interval, last } => step.is_multiple_of(*interval) || step == *last,
        }
    }

    /// Whether the table is written before the first step: only if the table beside the case is.
    pub(super) fn contain_beginning(&self) -> bool {
        matches!(self, Self::Listed(steps) if steps.contains(&0))
    }
}

/// Steps of the rows of a table, in its first column.
fn listed(file: &Path, last: usize) -> Result<BTreeSet<usize>, ReplayError> {
    let text = text(file)?;
    let refuse = |line: usize, value: &str, accepted: String| ReplayError::Row {
        file: file.to_owned(),
        line,
        column: "step",
        value: if value.is_empty() { "empty" } else { value }.to_owned(),
        accepted,
    };
    let mut rows = text.trim_end().lines().map(first_column);
    let header = rows.next().unwrap_or_default();
    if header != "step" {
        let accepted = "the name of the first column, step";
        return Err(refuse(1, header, accepted.to_owned()));
    }
    let mut steps = BTreeSet::new();
    let mut before = 0;
    for (line, value) in (2..).zip(rows) {
        let step = value.parse().ok().filter(|step| *step <= last);
        let step =
            step.ok_or_else(|| refuse(line, value, format!("a whole number from 0 to {last}")))?;
        if step < before {
            let accepted = format!("at least {before}, the step of the row before");
            return Err(refuse(line, value, accepted));
        }
        steps.insert(step);
        before = step;
    }
    Ok(steps)
}

fn first_column(line: &str) -> &str {
    line.split(',').next().map(str::trim).unwrap_or_default()
}
