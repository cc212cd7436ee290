//! Errors outside the kernel, worded for the user.

use std::path::PathBuf;
use thiserror::Error;

/// A scene that cannot be used: file and line or override, key, value and what is accepted.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub struct SceneError {
    /// The file, or the override as `--set KEY=VALUE`.
    pub file: String,
    /// The line, counted from one; zero if no single line is at fault.
    pub line: usize,
    /// The key, as a dotted path; empty if `file` is an override that already names it.
    pub key: String,
    /// The value found.
    pub value: String,
    /// What would be accepted.
    pub accepted: String,
}

impl std::fmt::Display for SceneError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let [file, key, value, accepted] =
            [&self.file, &self.key, &self.value, &self.accepted].map(|text| printable(text));
        write!(f, "{file}")?;
        if self.line > 0 {
            write!(f, ":{}", self.line)?;
        }
        match (key.is_empty(), value.is_empty()) {
            (true, true) => {}
            (true, false) => write!(f, ": {value}")?,
            (false, true) => write!(f, ": {key}")?,
            (false, false) => write!(f, ": {key} = {value}")?,
        }
        write!(f, ": {accepted}")
    }
}

/// The text with control characters and invisible characters escaped.
fn printable(text: &str) -> String {
    let mut result = String::new();
    for character in text.chars() {
        match character {
            '"' | '\'' | '\\' => result.push(character),
            _ => result.extend(character.escape_debug()),
        }
    }
    result
}

/// Any failure of a command.
#[derive(Debug, Error)]
pub enum Error {
    /// The scene cannot be used.
    #[error("{0}")]
    Scene(#[from] SceneError),
    /// An argument of the command cannot be used.
    #[error("{0}")]
    Argument(String),
    /// A file cannot be read or written.
    #[error("cannot {action} {}: {source}", path.display())]
    File {
        /// The operation that failed, as a verb.
        action: &'static str,
        /// The file.
        path: PathBuf,
        /// The cause.
        source: std::io::Error,
    },
    /// A checkpoint belongs to another scene or is damaged.
    #[error("cannot resume from {}: {reason}", path.display())]
    Checkpoint {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// The run stopped at an error of the kernel.
    #[error("the run stopped in phase '{phase}': {source} (run `gouge stability` for the bounds)")]
    Step {
        /// The phase of the run.
        phase: String,
        /// The cause.
        source: gouge_dem::StepError,
    },
    /// A run of contact dynamics stopped at an error of the kernel.
    #[error("the run stopped in phase '{phase}': {source}")]
    ContactDynamicsStep {
        /// The phase of the run.
        phase: String,
        /// The cause.
        source: gouge_contact_dynamics::error::StepError,
    },
    /// A run of peridynamic grains stopped at an error of the kernel.
    #[error("the run stopped in phase '{phase}': {source} (run `gouge stability` for the limits)")]
    PeridemStep {
        /// The phase of the run.
        phase: String,
        /// The cause.
        source: gouge_peridem::error::StepError,
    },
    /// A packing did not settle.
    #[error(
        "the packing has not settled after {steps} steps; give setup.compaction.max_steps or settled_distance other values"
    )]
    Unsettled {
        /// Number of steps.
        steps: u64,
    },
    /// The kernel of contact dynamics refused the bodies of a scene.
    #[error("the scene cannot be set up: {0}")]
    ContactDynamicsSetup(#[from] gouge_contact_dynamics::error::SetupError),
    /// The kernel of peridynamic grains refused the grains of a scene.
    #[error("the scene cannot be set up: {0}")]
    PeridemSetup(#[from] gouge_peridem::error::SetupError),
    /// An energy overflowed although the state itself is still finite.
    #[error(
        "the run stopped in phase '{phase}': the {name} energy is not finite at {time:.6e} s; likely \
             cause: the time step is above the stability bound (run `gouge stability` for the bounds)"
    )]
    Energy {
        /// The phase of the run.
        phase: String,
        /// Which energy.
        name: &'static str,
        /// Time in s.
        time: f64,
    },
    /// The run was interrupted; it can be continued from its checkpoint.
    #[error("interrupted; continue with --resume and the same folder, {}", .0.display())]
    Interrupted(PathBuf),
    /// Many runs were interrupted; the same command continues them.
    #[error("interrupted; the same command continues with what is missing in {}", .0.display())]
    Stopped(PathBuf),
    /// The run finished, but its energy balance is off.
    #[error(
        "the results in {} cannot be trusted (--accept-untrusted ends such a run with status 0)", .0.display()
    )]
    Untrusted(PathBuf),
    /// The model rejected a state that the set-up produced.
    #[error("the set-up produced an invalid state: {0}")]
    Setup(#[from] gouge_dem::ModelError),
    /// A run and the data that it was compared with differ.
    #[error("the run and {0} differ by more than the tolerance")]
    Differs(String),
    /// A model cannot agree with what was measured.
    #[error("{0} is refuted: no parameters in the ranges agree with its targets")]
    Refuted(String),
    /// Some calibrations did not recover known truths.
    #[error("{0} of {1} calibrations do not recover known truths")]
    Recoveries(usize, usize),
    /// Some checks failed.
    #[error("{0} of {1} checks failed")]
    Checks(usize, usize),
    /// Some worked examples of other programs could not be repeated.
    #[error("{0} of {1} cases have no result")]
    Cases(usize, usize),
}

impl Error {
    /// Whether the state of the run is at fault, so that continuing the run is pointless.
    pub fn is_of_state(&self) -> bool {
        matches!(
            self,
            Self::Step { .. }
                | Self::Energy { .. }
                | Self::Setup(_)
                | Self::ContactDynamicsStep { .. }
                | Self::ContactDynamicsSetup(_)
                | Self::PeridemStep { .. }
                | Self::PeridemSetup(_)
                | Self::Unsettled { .. }
        )
    }

    /// Whether the user stopped the run.
    pub fn is_interruption(&self) -> bool {
        matches!(self, Self::Interrupted(_))
    }

    /// Exit status: 3 if the results cannot be trusted, 2 if the input cannot be used, 130 after an interruption, 1 otherwise.
    pub fn status(&self) -> u8 {
        match self {
            Self::Scene(_) | Self::Argument(_) => 2,
            Self::Untrusted(_) => 3,
            Self::Interrupted(_) | Self::Stopped(_) => 130,
            _ => 1,
        }
    }

    /// An [`Error::File`].
    pub fn file(action: &'static str, path: &std::path::Path, source: std::io::Error) -> Self {
        Self::File {
            action,
            path: path.to_owned(),
            source,
        }
    }
}
