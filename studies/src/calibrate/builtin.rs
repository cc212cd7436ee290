//! The calibrations that come with the program.

use super::calibration::Calibration;
use gouge_runner::error::{Error, SceneError};
use std::path::Path;

/// Name and text of every built-in calibration.
const CALIBRATIONS: [(&str, &str); 11] = [
    ("rebound", include_str!("../calibrations/rebound.toml")),
    (
        "rebound-stiffness",
        include_str!("../calibrations/rebound-stiffness.toml"),
    ),
    (
        "rebound-duration",
        include_str!("../calibrations/rebound-duration.toml"),
    ),
    (
        "rebound-ice",
        include_str!("../calibrations/rebound-ice.toml"),
    ),
    ("elastic", include_str!("../calibrations/elastic.toml")),
    ("repose", include_str!("../calibrations/repose.toml")),
    ("strength", include_str!("../calibrations/strength.toml")),
    (
        "strength-tension",
        include_str!("../calibrations/strength-tension.toml"),
    ),
    ("rock", include_str!("../calibrations/rock.toml")),
    (
        "stress-strain",
        include_str!("../calibrations/stress-strain.toml"),
    ),
    ("fault", include_str!("../calibrations/fault.toml")),
];

/// Names of all built-in calibrations.
pub fn names() -> impl Iterator<Item = &'static str> {
    CALIBRATIONS.iter().map(|(name, _)| *name)
}

/// The text of a built-in calibration; none of another name.
pub fn text(name: &str) -> Option<&'static str> {
    let found = CALIBRATIONS.iter().find(|(other, _)| *other == name);
    found.map(|(_, text)| *text)
}

/// A built-in calibration; none of another name.
///
/// # Errors
/// A mistake in its text.
pub fn builtin(name: &str) -> Option<Result<Calibration, SceneError>> {
    text(name).map(|text| Calibration::parse(name, text))
}

/// The calibration of a file or, if there is no such file, the built-in one of this name.
///
/// # Errors
/// A file that cannot be read, or a mistake in it.
pub fn load(path: &Path) -> Result<Calibration, Error> {
    let named = path.to_str().filter(|_| !path.is_file()).and_then(builtin);
    match named {
        Some(calibration) => Ok(calibration?),
        None => Calibration::load(path),
    }
}
