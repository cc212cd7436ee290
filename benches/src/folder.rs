//! Temporary folders for the files of measurements.

use gouge_runner::error::Error;
use std::path::Path;
use tempfile::TempDir;

/// A new folder that is removed when it is dropped.
///
/// # Errors
/// A folder that cannot be created.
pub fn temporary_folder() -> Result<TempDir, Error> {
    tempfile::tempdir()
        .map_err(|error| Error::file("create", Path::new("a temporary folder"), error))
}
