//! Triangulations by refinement and smoothing.

use super::boundary::{self, Chains};
use super::smoothing::{corners, sweep, thinned};
use super::triangulation::Delaunay;
use super::{MOST_NODES, Mesh};
use crate::error::{SetupError, require};
use crate::shape::Outline;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// How often close nodes are removed, and nodes are moved in between.
const ROUNDS: usize = 4;

/// How often nodes are moved and triangulated again in a round.
const SWEEPS: usize = 5;

/// Distance, in triangle sizes, below which one of two nodes is removed after a round.
const CLOSEST: f64 = 0.6;

#[rendered]
impl Mesh {
    /// Nodes of a triangulation with triangles of about a size h in m.
    ///
    /// 1. Edges of the shape are divided into equal pieces of about h. Vertices are nodes; nodes between them are
    ///    rounded towards the inside, so that they belong to the closed shape exactly.
    /// 2. Refinement adds nodes until triangles are not larger than $\sqrt 3 h^2/4$ and have no angle below 28 degrees,
    ///    where the shape permits and without further nodes on the boundary.
    /// 3. In 20 sweeps, each inner node moves to the centroid of the triangles around it, and all are triangulated
    ///    again.
    ///    After 5, 10 and 15 sweeps, inner nodes nearer than 0.6 h to a neighbour are removed.
    /// 4. The area of a node is a third of each triangle of which it is a vertex.
    ///
    /// Nodes then have a mean spacing of about 0.8 h and a [smallest distance](super::smallest_distance) of about 0.6 h.
    /// Cuts do not influence the triangulation. The result is the same, bit by bit, at each call.
    ///
    /// Source: section 5 of peridem uses a mesh generator without naming its settings.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a size that is not positive, [`SetupError::Mesh`] if there would be more than four
    /// million nodes, or if vertices of the shape are so close together that they cannot be triangulated.
    pub fn triangulated(outline: &Outline, size: f64) -> Result<Self, SetupError> {
        require("size", size, "positive", size > 0.0)?;
        let failed = |reason| SetupError::Mesh { size, reason };
        let expected = boundary::count(outline, size) + 4.0 * outline.area() / (size * size);
        if expected > MOST_NODES {
            return Err(failed("there would be too many nodes"));
        }
        let chains = boundary::divide(outline, size);
        let degenerate = || failed("the boundary cannot be triangulated");
        let mut delaunay = Delaunay::new(&chains.nodes, &chains).ok_or_else(degenerate)?;
        let largest = 0.25 * 3.0_f64.sqrt() * size * size;
        if !delaunay.refine(largest, 1000 + 4 * expected as usize) {
            return Err(failed("refinement does not end"));
        }
        let mut position = delaunay.nodes();
        let fixed = chains.nodes.len();
        for round in 0..ROUNDS {
            if round > 0 {
                let triangles = delaunay.triangles(&chains);
                position = thinned(&position, &triangles, fixed, CLOSEST * size);
                delaunay = Delaunay::new(&position, &chains).ok_or_else(degenerate)?;
            }
            for _ in 0..SWEEPS {
                sweep(&mut position, &delaunay.triangles(&chains), fixed);
                delaunay = Delaunay::new(&position, &chains).ok_or_else(degenerate)?;
            }
        }
        Ok(Self::from_triangles(
            position,
            delaunay.triangles(&chains),
            &chains,
        ))
    }

    fn from_triangles(position: Vec<Vec2>, triangles: Vec<[u32; 3]>, chains: &Chains) -> Self {
        let mut area = vec![0.0; position.len()];
        for &triangle in &triangles {
            let [a, b, c] = corners(&position, triangle);
            let third = (b - a).cross(c - a) / 6.0;
            for node in triangle {
                area[node as usize] += third;
            }
        }
        let on_rim = (0..position.len()).map(|node| node < chains.nodes.len());
        Self {
            on_rim: on_rim.collect(),
            position,
            area,
            triangles,
        }
    }
}
