//! Nodes and their areas: triangulations, square lattices, rectangles.

mod boundary;
mod distance;
mod lattice;
mod smoothing;
mod triangulated;
mod triangulation;

pub use distance::smallest_distance;

use gouge_common::geometry::Vec2;

/// The most nodes that a mesh may have.
const MOST_NODES: f64 = 4.0e6;

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
