//! What the files of a sweep say about its runs.

use super::plan::Planned;
use gouge_runner::run::{Summary, UNTRUSTED};
use std::collections::BTreeMap;
use std::path::Path;

/// File that keeps why a run was refused or ended without a summary.
pub const CAUSE: &str = "cause.txt";

/// State of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// Nothing is there yet.
    Waiting,
    /// Begun and not finished: running, killed or interrupted.
    Begun,
    /// Finished.
    Done,
    /// Finished, but its energy balance is off.
    Untrusted,
    /// It stopped at an error of the model.
    Failed,
    /// It could not begin.
    Refused,
}

impl Status {
    /// All of them.
    pub const ALL: [Self; 6] = [
        Self::Waiting,
        Self::Begun,
        Self::Done,
        Self::Untrusted,
        Self::Failed,
        Self::Refused,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Waiting => "waiting",
            Self::Begun => "begun",
            Self::Done => "done",
            Self::Untrusted => "untrusted",
            Self::Failed => "failed",
            Self::Refused => "refused",
        }
    }

    /// The status of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|status| status.name() == name)
    }

    /// Whether nothing remains to be done for the run, unless it is retried.
    pub fn is_final(self) -> bool {
        !matches!(self, Self::Waiting | Self::Begun)
    }
}

/// State of a run, and what is known of it.
#[derive(Clone, Debug)]
pub struct State {
    /// The status.
    pub status: Status,
    /// Why it is not done, if it is known.
    pub cause: String,
    /// Its summary, if it has one.
    pub summary: Option<Summary>,
}

impl State {
    /// The state of the run in a folder.
    pub fn of(folder: &Path) -> Self {
        if let Ok(cause) = std::fs::read_to_string(folder.join(CAUSE)) {
            return Self {
                status: Status::Refused,
                cause: cause.trim().to_owned(),
                summary: None,
            };
        }
        let summary = Summary::read(folder).ok();
        let (status, cause) = match &summary {
            None if folder.join("checkpoint").exists() => (Status::Begun, String::new()),
            None => (Status::Waiting, String::new()),
            Some(summary) if summary.status == UNTRUSTED => (
                Status::Untrusted,
                summary.warnings.last().cloned().unwrap_or_default(),
            ),
            Some(summary) if summary.is_finished() => (Status::Done, String::new()),
            Some(summary) if summary.is_interrupted() => (Status::Begun, String::new()),
            Some(summary) => (Status::Failed, summary.status.clone()),
        };
        Self {
            status,
            cause,
            summary,
        }
    }
}

/// Number of runs in each state.
pub fn status(runs: &[Planned], out: &Path) -> BTreeMap<Status, usize> {
    let mut numbers = BTreeMap::new();
    for run in runs {
        *numbers
            .entry(State::of(&run.folder(out)).status)
            .or_default() += 1;
    }
    numbers
}
