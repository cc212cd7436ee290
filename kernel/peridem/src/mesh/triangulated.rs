//! Triangulations by refinement and smoothing.

use super::boundary::{self, Chains};
use super::smoothing::{corners, sweep, thinned};
use super::triangulation::Delaunay;
use super::{MOST_NODES, Mesh};
use crate::error::{SetupError, require};
use crate::shape::Outline;
use crate::shape::predicates::edges;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// How often nodes are moved to the centroids of the triangles around them.
const SWEEPS: usize = 20;

/// Distance, in spacings of the lattice, below which one of two nodes is removed.
const CLOSEST: f64 = 0.7;

/// Least distance of an inner node from the boundary at the beginning, in spacings of the lattice.
const CLEARANCE: f64 = 0.55;

/// Height of an equilateral triangle of side 1.
const HEIGHT: f64 = 0.866_025_403_784_438_6;

/// Area in m^2 of a point of a triangular lattice of a spacing in m.
fn cell_area(spacing: f64) -> f64 {
    HEIGHT * spacing * spacing
}

/// Points of a triangular lattice of a spacing in m in a shape, row by row, symmetric about the centre of its bounds.
fn lattice_points(outline: &Outline, spacing: f64) -> Vec<Vec2> {
    let bounds = outline.bounds();
    let centre = (bounds.lower + bounds.upper) * 0.5;
    let half = (bounds.upper - bounds.lower) * 0.5;
    let rows = (half.y / (HEIGHT * spacing)) as i64;
    let columns = (half.x / spacing) as i64 + 1;
    let row = |j: i64| {
        let shift = if j % 2 == 0 { 0.0 } else { 0.5 };
        (-columns..=columns).map(move |i| {
            let (x, y) = (i as f64 + shift, j as f64 * HEIGHT);
            centre + Vec2::new(x, y) * spacing
        })
    };
    let is_clear = |point: &Vec2| {
        let mut edges = outline.rings().flat_map(edges);
        edges.all(|edge| distance_to(edge, *point) > CLEARANCE * spacing)
    };
    let points = (-rows..=rows).flat_map(row);
    points
        .filter(|point| is_clear(point) && outline.contains(*point))
        .collect()
}

/// Distance in m of a point from a segment.
fn distance_to([a, b]: [Vec2; 2], point: Vec2) -> f64 {
    let (edge, to) = (b - a, point - a);
    let along = (edge.dot(to) / edge.norm_squared()).clamp(0.0, 1.0);
    (to - edge * along).norm()
}

#[rendered]
impl Mesh {
    /// Nodes of a triangulation with triangles of about a size h in m.
    ///
    /// 1. Edges of the shape are divided into equal pieces of about h. Vertices are nodes; nodes between them are
    ///    rounded towards the inside, so that they belong to the closed shape exactly.
    /// 2. Inner nodes are those points of a triangular lattice of spacing h, around the centre of the shape, that are
    ///    farther than 0.55 h from the boundary and 0.7 h from other nodes.
    /// 3. In 20 sweeps, each inner node moves to the centroid of the triangles around it, and all are triangulated again.
    /// 4. The area of a node is a third of each triangle of which it is a vertex.
    ///
    /// The smallest distance of two nodes is [`smallest_distance`](super::smallest_distance).
    /// Cuts do not influence the triangulation. The result is the same, bit by bit, at each call.
    ///
    /// Source: section 5 of peridem uses a mesh generator without naming its settings.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a size that is not positive, [`SetupError::Mesh`] if there would be more than four
    /// million nodes, or if vertices of the shape are so close together that they cannot be triangulated;
    /// [`SetupError::MeshArea`] for a shape so thin that rounding changes its area by more than a billionth.
    pub fn triangulated(outline: &Outline, size: f64) -> Result<Self, SetupError> {
        require("size", size, "positive", size > 0.0)?;
        let failed = |reason| SetupError::Mesh { size, reason };
        let expected = boundary::count(outline, size) + outline.area() / cell_area(size);
        if expected > MOST_NODES {
            return Err(failed("there would be too many nodes"));
        }
        let chains = boundary::divide(outline, size);
        let fixed = chains.nodes.len();
        let triangulate = |nodes: &[Vec2]| {
            let degenerate = || failed("the boundary cannot be triangulated");
            Delaunay::new(nodes, &chains).ok_or_else(degenerate)
        };
        let mut position = chains.nodes.clone();
        position.extend(lattice_points(outline, size));
        let mut delaunay = triangulate(&position)?;
        position = thinned(
            &position,
            &delaunay.triangles(&chains),
            fixed,
            CLOSEST * size,
        );
        delaunay = triangulate(&position)?;
        for _ in 0..SWEEPS {
            sweep(&mut position, &delaunay.triangles(&chains), fixed);
            delaunay = triangulate(&position)?;
        }
        Self::from_triangles(position, delaunay.triangles(&chains), &chains).covering(outline, size)
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
