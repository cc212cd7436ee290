//! What can go wrong with files and cases.

use gouge_contact_dynamics::error::SetupError;
use std::path::PathBuf;
use thiserror::Error;

/// A folder or a file that cannot be used.
#[derive(Debug, Error)]
pub enum ReplayError {
    /// The folder does not exist, or is none.
    #[error("{}: not a folder", .0.display())]
    NotAFolder(PathBuf),
    /// The folder has none of the files.
    #[error(
        "{0}: has none of {accepted}; a case of peridynamic grains is given by its file, such as {0}/case.json",
        folder.display()
    )]
    NothingKnown {
        /// The folder.
        folder: PathBuf,
        /// Names of the files that are read.
        accepted: String,
    },
    /// A file cannot be read.
    #[error("cannot read {}: {source}", file.display())]
    Read {
        /// The file.
        file: PathBuf,
        /// The cause.
        source: std::io::Error,
    },
    /// A file is not text.
    #[error("{}: neither text nor text compressed with gzip: {source}", file.display())]
    NotText {
        /// The file.
        file: PathBuf,
        /// The cause.
        source: std::io::Error,
    },
    /// A file is not JSON.
    #[error("{}: not JSON: {source}", file.display())]
    Syntax {
        /// The file.
        file: PathBuf,
        /// The cause, with line and column.
        source: serde_json::Error,
    },
    /// A row of a table has a value that cannot be used.
    #[error("{}: line {line}: {column} is {value}: must be {accepted}", file.display())]
    Row {
        /// The file.
        file: PathBuf,
        /// Number of the line, from 1.
        line: usize,
        /// Name of the column.
        column: &'static str,
        /// The value.
        value: String,
        /// What it must be.
        accepted: String,
    },
    /// A file is JSON, but of no known kind.
    #[error("{}: must have {accepted}", file.display())]
    UnknownKind {
        /// The file.
        file: PathBuf,
        /// Keys by which kinds of files are known.
        accepted: String,
    },
    /// A file is JSON, but has no list of cases.
    #[error("{}: {fault}", file.display())]
    Structure {
        /// The file.
        file: PathBuf,
        /// What is missing.
        fault: Fault,
    },
}

/// A case without a result.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{file}: {case}: {fault}")]
pub struct CaseError {
    /// Name of the file.
    pub file: String,
    /// Identity of the case, or its place if it has none.
    pub case: String,
    /// What is wrong.
    pub fault: Fault,
}

/// What is wrong with a case.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Fault {
    /// A key is missing.
    #[error("{key} is missing: must be {accepted}")]
    Missing {
        /// The key, as a path.
        key: String,
        /// What it must be.
        accepted: String,
    },
    /// The value of a key cannot be used.
    #[error("{key} is {value}: must be {accepted}")]
    Value {
        /// The key, as a path.
        key: String,
        /// The value.
        value: String,
        /// What it must be.
        accepted: String,
    },
    /// A key is not known, or what it asks for is not available.
    #[error("{key} is not known: only {accepted} are")]
    Unknown {
        /// The key, as a path.
        key: String,
        /// The keys that are known.
        accepted: String,
    },
    /// The kernel refuses a body or a setting.
    #[error("{0}")]
    Setup(#[from] SetupError),
    /// The kernel of peridynamic grains refuses a grain or a setting.
    #[error("{0}")]
    Grain(#[from] gouge_peridem::error::SetupError),
    /// A step of peridynamic grains failed.
    #[error("{0}")]
    Step(#[from] gouge_peridem::error::StepError),
    /// A motion has a quantity that is no finite number.
    #[error(
        "in step {step}, {quantity} is {value}, which is no finite number; likely cause: the time step is too long, or \
         velocities or forces are too large"
    )]
    NoNumber {
        /// The step.
        step: u64,
        /// The quantity.
        quantity: String,
        /// Its value.
        value: f64,
    },
    /// A number of the result is not finite.
    #[error("the result {0} is not finite")]
    NotFinite(String),
}
