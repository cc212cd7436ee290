//! What can go wrong.

use thiserror::Error;

/// An invalid shape, mesh, material or setting.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SetupError {
    /// A parameter is outside its range.
    #[error("{name} is {value}, but must be {accepted}")]
    Parameter {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Which values are accepted.
        accepted: &'static str,
    },
}

/// Accept a finite number that satisfies a condition.
pub(crate) fn require(
    name: &'static str,
    value: f64,
    accepted: &'static str,
    condition: bool,
) -> Result<(), SetupError> {
    if condition && value.is_finite() {
        return Ok(());
    }
    Err(SetupError::Parameter {
        name,
        value,
        accepted,
    })
}
