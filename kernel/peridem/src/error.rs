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
    /// A grain has no nodes.
    #[error("grain {grain} has no nodes")]
    NoNodes {
        /// Index of the grain.
        grain: usize,
    },
    /// A column of a grain has not one value per node.
    #[error("grain {grain} has {length} values of {column} for {nodes} nodes")]
    Length {
        /// Index of the grain.
        grain: usize,
        /// Name of the column.
        column: &'static str,
        /// Its length.
        length: usize,
        /// Number of nodes.
        nodes: usize,
    },
    /// A node does not exist.
    #[error("grain {grain} has no node {node}: it has only {nodes}")]
    MissingNode {
        /// Index of the grain.
        grain: usize,
        /// The node.
        node: usize,
        /// Number of nodes.
        nodes: usize,
    },
    /// Bonds that cannot be.
    #[error("grain {grain}: {what} of nodes {i} and {j}")]
    Bond {
        /// Index of the grain.
        grain: usize,
        /// One node, counted from the first of the grain.
        i: usize,
        /// The other node.
        j: usize,
        /// What is wrong.
        what: &'static str,
    },
}

/// A step that failed.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum StepError {
    /// The velocity of a node is no longer finite.
    #[error(
        "the velocity of node {node} of grain {grain} is not finite at {time:.6e} s, after {steps} steps; likely cause: the \
         time step is too long, or forces are too large"
    )]
    NotFinite {
        /// The grain.
        grain: usize,
        /// The node, counted from the first of the grain.
        node: usize,
        /// Time in s.
        time: f64,
        /// Number of steps, with the one that failed.
        steps: u64,
    },
    /// A node went through a wall.
    #[error(
        "node {node} of grain {grain} is {depth:.3e} m behind the {wall} wall at {time:.6e} s, farther than the contact \
         radius; likely cause: the grain is too fast, or the contact is too soft"
    )]
    BehindWall {
        /// The grain.
        grain: usize,
        /// The node, counted from the first of the grain.
        node: usize,
        /// Name of the wall.
        wall: &'static str,
        /// How far it is behind the wall in m.
        depth: f64,
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
