//! Nodes and their areas: triangulations, square lattices, rectangles.

mod boundary;
mod distance;
mod lattice;
mod smoothing;
mod triangulated;
mod triangulation;

pub use distance::smallest_distance;

use crate::error::SetupError;
use crate::shape::Outline;
use gouge_common::geometry::Vec2;

/// The most nodes that a mesh may have.
pub const MOST_NODES: f64 = 4.0e6;

/// Largest difference between the areas of a mesh and of its shape, in parts of the latter. Rounding causes about 1e-16 times
/// the largest coordinate over the width of the shape.
const AREA_TOLERANCE: f64 = 1e-9;

/// Nodes of a grain with the areas that they stand for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Positions in m. All lie in the closed shape, exactly.
    pub position: Vec<Vec2>,
    /// Areas in m^2; their sum is the area of the shape.
    pub area: Vec<f64>,
    /// Triangles of nodes, anticlockwise; none for a lattice.
    pub triangles: Vec<[u32; 3]>,
    /// Whether a node lies on the boundary or, in a lattice, its cell or one of the eight around it is not whole.
    pub on_rim: Vec<bool>,
}

impl Mesh {
    /// This mesh, of a size in m, if its nodes share the area of the shape and each has a part of it.
    fn covering(self, outline: &Outline, size: f64) -> Result<Self, SetupError> {
        let (area, expected) = (self.area.iter().sum::<f64>(), outline.area());
        let is_same = (area - expected).abs() <= AREA_TOLERANCE * expected;
        match is_same && self.area.iter().all(|&area| area > 0.0) {
            true => Ok(self),
            false => Err(SetupError::MeshArea {
                size,
                area,
                expected,
            }),
        }
    }
}
