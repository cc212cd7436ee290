//! What can go wrong.

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
    /// No body is near a wall to which bodies should be glued.
    #[error("no body is near {near}")]
    Nothing {
        /// Which wall.
        near: &'static str,
    },
    /// All bodies would be glued to walls.
    #[error("all bodies are near the walls, so that none stays free")]
    NothingFree,
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

/// A step that failed.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError {
    /// The velocity of a unit is no longer finite.
    #[error(
        "the velocity of rigid unit {unit} is not finite at {time:.6e} s, after {steps} steps; likely cause: forces or \
         velocities are too large"
    )]
    NotFinite {
        /// The unit.
        unit: usize,
        /// Time in s.
        time: f64,
        /// Number of steps, with the one that failed.
        steps: u64,
    },
    /// A body moves so far per step that it may pass others unseen.
    #[error(
        "body {body} moves {distance:.3e} m in the step to {time:.6e} s, more than its diameter of {limit:.3e} m, and may \
         pass others unseen; likely cause: the time step is too long for this speed"
    )]
    TooFast {
        /// The body.
        body: usize,
        /// How far it moves in m.
        distance: f64,
        /// Its diameter in m.
        limit: f64,
        /// Time in s.
        time: f64,
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
