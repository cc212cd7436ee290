//! Cases of the kernel of peridynamic grains.

mod inputs;
mod options;
mod pairs;
mod refusals;
mod series;
mod states;
mod steps;
mod trajectory;

use crate::error::{CaseError, ReplayError};
use flate2::read::MultiGzDecoder;
pub use gouge_peridem::mode::Mode;
use serde_json::Value;
use std::io::Read;
use std::path::Path;

/// What a repeated file writes.
pub struct Repeated {
    /// Files by name, with their contents.
    pub files: Vec<(String, String)>,
    /// Lines for people.
    pub account: String,
    /// Cases without a result, or with one that ends early.
    pub failures: Vec<CaseError>,
    /// Number of all cases.
    pub cases: usize,
}

/// Told how many steps of a motion are done, and how many there are.
pub type Watch<'a> = &'a mut dyn FnMut(u64, u64);

/// Repeat a case, given by its file, or compute what a file of single states expects.
///
/// A motion whose step fails is written up to that step, and the failure is reported; so are single states that cannot be
/// computed.
///
/// # Errors
/// A file that cannot be read or is of no known kind; a motion that lacks something or has an unusable value, also one whose
/// grains are those of another case that cannot be read.
pub fn repeat(file: &Path, mode: Mode, watch: Watch) -> Result<Repeated, ReplayError> {
    let value = json(file)?;
    match states::Kind::of(&value) {
        Some(kind) => states::repeat(file, &value, kind, mode),
        None if trajectory::KEYS.iter().any(|key| value.get(key).is_some()) => {
            trajectory::repeat(file, &value, mode, watch)
        }
        None => Err(ReplayError::UnknownKind {
            file: file.to_owned(),
            accepted: states::ACCEPTED.to_owned(),
        }),
    }
}

/// The text of a file, which may be compressed with gzip.
fn text(file: &Path) -> Result<String, ReplayError> {
    let read = |source| ReplayError::Read {
        file: file.to_owned(),
        source,
    };
    let bytes = std::fs::read(file).map_err(read)?;
    let mut text = String::new();
    if bytes.starts_with(&[0x1f, 0x8b]) {
        MultiGzDecoder::new(&bytes[..]).read_to_string(&mut text)
    } else {
        (&bytes[..]).read_to_string(&mut text)
    }
    .map_err(|source| ReplayError::NotText {
        file: file.to_owned(),
        source,
    })?;
    Ok(text)
}

/// The JSON of a file, which may be compressed.
fn json(file: &Path) -> Result<Value, ReplayError> {
    serde_json::from_str(&text(file)?).map_err(|source| ReplayError::Syntax {
        file: file.to_owned(),
        source,
    })
}

/// Name of a file without the ending of its compression: what is written is not compressed.
fn output_name(file: &Path) -> String {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    name.strip_suffix(".gz").unwrap_or(&name).to_owned()
}
