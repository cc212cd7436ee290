//! Nodes on the boundary of a shape.

use crate::shape::Outline;
use crate::shape::predicates::{edges, orientation};
use gouge_common::geometry::Vec2;

/// A closed chain of nodes per ring of a shape.
pub(super) struct Chains {
    /// Positions in m, ring after ring, in the direction of the ring.
    pub(super) nodes: Vec<Vec2>,
    /// Consecutive nodes; the shape lies to the left.
    pub(super) edges: Vec<[usize; 2]>,
}

/// Number of pieces of about a given length in m into which an edge is divided.
fn pieces(edge: [Vec2; 2], size: f64) -> f64 {
    ((edge[1] - edge[0]).norm() / size).round().max(1.0)
}

/// Number of nodes on the boundary of a shape for a given length of pieces in m.
pub(super) fn count(outline: &Outline, size: f64) -> f64 {
    let all = outline.rings().flat_map(edges);
    all.map(|edge| pieces(edge, size)).sum()
}

/// Divide the edges of a shape into equal pieces of about a given length in m. Vertices are nodes.
pub(super) fn divide(outline: &Outline, size: f64) -> Chains {
    let mut chains = Chains {
        nodes: Vec::new(),
        edges: Vec::new(),
    };
    for ring in outline.rings() {
        let first = chains.nodes.len();
        for [a, b] in edges(ring) {
            let count = pieces([a, b], size);
            chains.nodes.push(a);
            let inner = (1..count as usize).map(|k| between(a, b, k as f64 / count));
            chains.nodes.extend(inner);
        }
        let last = chains.nodes.len() - 1;
        chains.edges.extend((first..last).map(|k| [k, k + 1]));
        chains.edges.push([last, first]);
    }
    chains
}

/// A point on an edge, rounded towards the inside.
///
/// No point of the closed shape may be lost by rounding: a node to the right of its edge would have no bonds.
/// Two nodes that are both on the left of an edge, by whatever distance, have a bond that does not cross it.
fn between(a: Vec2, b: Vec2, fraction: f64) -> Vec2 {
    let edge = b - a;
    let inward = edge.perpendicular() * (1.0 / edge.norm());
    let rounded = a + edge * fraction;
    let mut point = rounded;
    let mut step = f64::EPSILON * (a.norm() + b.norm());
    while orientation(a, b, point) < 0.0 {
        point = rounded + inward * step;
        step *= 2.0;
    }
    point
}
