//! Cases of the kernel of peridynamic grains.

mod inputs;
mod series;
mod trajectory;

use crate::error::ReplayError;
pub use gouge_peridem::mode::Mode;
use std::path::Path;

/// What a repeated case writes.
pub struct Repeated {
    /// Files by name, with their contents.
    pub files: Vec<(String, String)>,
    /// A line for people.
    pub account: String,
}

/// Repeat a case, given by its file.
///
/// # Errors
/// A file that cannot be read; a case that lacks something or has an unusable value, also one whose grains are those of
/// another case that cannot be read; a step that fails.
pub fn repeat(file: &Path, mode: Mode) -> Result<Repeated, ReplayError> {
    let case = trajectory::json(file)?;
    trajectory::repeat(file, &case, mode)
}
