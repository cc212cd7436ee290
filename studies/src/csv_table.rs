//! Tables as CSV.

use gouge_runner::error::Error;
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
