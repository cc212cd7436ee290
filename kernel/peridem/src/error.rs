//! What can go wrong.

use thiserror::Error;

/// A node that moves so far per step that contacts could be missed.
#[derive(Clone, Debug, Error, PartialEq)]
#[error(
    "node {node} of grain {grain} has a speed of {speed:.4e} m/s and moves by {distance:.3e} m per step relative to {other}: \
     more than {limit:.3e} m, half of the contact radius, so that contacts could be missed; the time step must be at most \
     {safe_step:.3e} s for that"
)]
pub struct TooFast {
    /// The grain.
    pub grain: usize,
    /// The node, counted from the first of the grain.
    pub node: usize,
    /// Its speed in m/s.
    pub speed: f64,
    /// Relative to what it moves.
    pub other: &'static str,
    /// How far in m it moves along an axis relative to that.
    pub distance: f64,
    /// How far it may move, in m.
    pub limit: f64,
    /// The longest time step in s in which it does not move farther than that.
    pub safe_step: f64,
}

/// An invalid shape, mesh, material or setting.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum SetupError {
    /// A parameter is outside its range.
    #[error("{name} is {value:?}, but must be {accepted}")]
    Parameter {
        /// Name of the parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Which values are accepted.
        accepted: &'static str,
    },
    /// A parameter is so large or small that what follows from it is no usable number.
    #[error(
        "{name} is {value:?}, which makes {product} {result:?}, but that must be from {least:?} to {most:?}",
        least = USABLE[0],
        most = USABLE[1]
    )]
    Product {
        /// Name of the parameter, of those in the product the one with the most extreme power.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What follows from it, with its unit.
        product: &'static str,
        /// The value of that.
        result: f64,
    },
    /// There are more nodes than indices.
    #[error("there are {nodes} nodes, but at most 4294967295 are accepted")]
    TooManyNodes {
        /// Number of nodes of all grains.
        nodes: usize,
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
    /// A column of a state has not one value per node.
    #[error("the state has {length} values of {column} for {nodes} nodes")]
    StateLength {
        /// Name of the column.
        column: &'static str,
        /// Its length.
        length: usize,
        /// Number of nodes of all grains.
        nodes: usize,
    },
    /// The time step exceeds the limit of stability of a part of the model.
    #[error("the time step of {step:.4e} s exceeds the limit of {limit}, {value:.4e} s")]
    TimeStep {
        /// The time step in s.
        step: f64,
        /// What sets the limit.
        limit: &'static str,
        /// The limit in s.
        value: f64,
    },
    /// The contact radius is so small that grains pass through each other.
    #[error(
        "the contact radius of {radius:.4e} m is below 1.2 times the smallest distance of two nodes of a grain, \
         {smallest:.4e} m: grains would pass through each other"
    )]
    ContactRadius {
        /// The radius in m.
        radius: f64,
        /// The smallest distance in m.
        smallest: f64,
    },
    /// A node moves too fast from the beginning.
    #[error(transparent)]
    TooFast(#[from] Box<TooFast>),
    /// A ring of vertices is not a polygon.
    #[error("{} has {vertices} vertices, but a polygon needs 3", ring_name(*ring))]
    TooFewVertices {
        /// 0 for the outer polygon, k for the k-th hole.
        ring: usize,
        /// Number of its vertices.
        vertices: usize,
    },
    /// A coordinate of a vertex is not a number with which orientations can be computed exactly.
    #[error("vertex {vertex} of {} is not finite, or too small or too large", ring_name(*ring))]
    InvalidVertex {
        /// 0 for the outer polygon, k for the k-th hole.
        ring: usize,
        /// Position of the vertex in the ring.
        vertex: usize,
    },
    /// All vertices of a ring lie on one line.
    #[error("{} has no area", ring_name(*ring))]
    ZeroArea {
        /// 0 for the outer polygon, k for the k-th hole.
        ring: usize,
    },
    /// Two edges of a ring share a point that is not their common vertex, or overlap.
    #[error("edges {first} and {second} of {} touch or cross each other", ring_name(*ring))]
    SelfIntersection {
        /// 0 for the outer polygon, k for the k-th hole.
        ring: usize,
        /// First edge; edge k begins at vertex k.
        first: usize,
        /// Second edge.
        second: usize,
    },
    /// A hole reaches or crosses the outer polygon.
    #[error("hole {hole} is not inside the outer polygon")]
    HoleOutside {
        /// Position among the holes, from 0.
        hole: usize,
    },
    /// Two holes touch, cross or contain each other.
    #[error("holes {first} and {second} are not apart")]
    HolesMeet {
        /// Position of one among the holes, from 0.
        first: usize,
        /// Position of the other.
        second: usize,
    },
    /// A cut has no length, or an end that is not finite.
    #[error("cut {cut} is not a segment")]
    InvalidCut {
        /// Position among the cuts, from 0.
        cut: usize,
    },
    /// A node lies on a cut, so that it belongs to both sides or to none.
    #[error(
        "node {node} lies on cut {cut}: move the cut by a part of the size of the mesh, or change that size"
    )]
    NodeOnCut {
        /// Position among the nodes.
        node: usize,
        /// Position among the cuts.
        cut: usize,
    },
    /// A mesh of the given size has no node, too many, or cannot be made.
    #[error("no mesh of size {size:?} m: {reason}")]
    Mesh {
        /// The size in m.
        size: f64,
        /// Why not.
        reason: &'static str,
    },
    /// A shape is so thin that rounding changes the area of its mesh.
    #[error(
        "the mesh of size {size:?} m has an area of {area:e} m^2 instead of the {expected:e} m^2 of the shape: it is too thin \
         for the rounding of coordinates, or too far from the origin of its frame"
    )]
    MeshArea {
        /// The size of the mesh in m.
        size: f64,
        /// The sum of the areas of the nodes in m^2.
        area: f64,
        /// The area of the shape in m^2.
        expected: f64,
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
    /// A node is too fast for the time step.
    #[error("at {time:.6e} s, {motion}")]
    TooFast {
        /// The node, and how far it would move in the next step.
        motion: Box<TooFast>,
        /// Time in s.
        time: f64,
    },
    /// A node went through a wall.
    #[error(
        "at {time:.6e} s, {lost}; likely cause: the grain is too fast, or the contact is too soft"
    )]
    BehindWall {
        /// The node.
        lost: LostNode,
        /// Time in s.
        time: f64,
    },
}

/// A node so far behind a wall that it is no longer pushed back.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error(
    "node {node} of grain {grain} is {depth:.3e} m behind the {wall} wall, farther than the contact radius"
)]
pub struct LostNode {
    /// The grain.
    pub grain: usize,
    /// The node, counted from the first of the grain.
    pub node: usize,
    /// Name of the wall.
    pub wall: &'static str,
    /// How far it is behind the wall in m.
    pub depth: f64,
}

/// How messages name a ring of vertices.
fn ring_name(ring: usize) -> String {
    match ring.checked_sub(1) {
        None => "the outer polygon".to_owned(),
        Some(hole) => format!("hole {hole}"),
    }
}

/// Smallest and largest product of parameters, in SI units, whose further products are surely numbers.
pub const USABLE: [f64; 2] = [1e-100, 1e100];

/// Accept a product of powers of parameters, given with names, values and exponents, that is neither too small nor too large.
pub(crate) fn require_product(
    product: &'static str,
    result: f64,
    factors: &[(&'static str, f64, i32)],
) -> Result<(), SetupError> {
    let (least, most) = (USABLE[0], USABLE[1]);
    if (least..=most).contains(&result) {
        return Ok(());
    }
    let magnitude = |&(_, value, exponent): &(_, f64, i32)| {
        (f64::from(exponent) * libm::log(value.abs())).abs()
    };
    let larger = |a, b| if magnitude(&b) > magnitude(&a) { b } else { a };
    let (name, value, _) = factors.iter().copied().reduce(larger).unwrap_or_default();
    Err(SetupError::Product {
        name,
        value,
        product,
        result,
    })
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
