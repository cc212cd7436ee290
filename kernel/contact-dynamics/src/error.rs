//! Errors of the set-up. A step cannot fail.

use thiserror::Error;

/// An invalid shape, body or setting.
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
    /// A polygon has too few vertices.
    #[error("a polygon needs at least 3 vertices, but has {vertices}")]
    TooFewVertices {
        /// Number of vertices.
        vertices: usize,
    },
    /// The sides of a polygon do not turn left at a vertex, or turn around more than once.
    #[error("the polygon is not strictly convex and anticlockwise at vertex {vertex}")]
    NotConvex {
        /// Index of the vertex.
        vertex: usize,
    },
    /// A body refers to a shape or a rigid unit that does not exist.
    #[error("{what} {index} does not exist: there are only {count}")]
    Missing {
        /// What is missing.
        what: &'static str,
        /// Its index.
        index: usize,
        /// Number of existing items.
        count: usize,
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
