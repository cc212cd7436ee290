//! What makes rings of vertices an outline.

use super::predicates::{edges, in_rings, meet, orientation};
use crate::error::SetupError;
use core::cmp::Ordering;
use gouge_common::geometry::Vec2;

/// Smallest and largest coordinates in m for which no product in an exact orientation under- or overflows.
const REPRESENTABLE: core::ops::RangeInclusive<f64> = 1e-60..=1e60;

/// Accept a simple polygon, and whether it is anticlockwise.
pub(super) fn simple(index: usize, ring: &[Vec2]) -> Result<bool, SetupError> {
    if ring.len() < 3 {
        return Err(SetupError::TooFewVertices {
            ring: index,
            vertices: ring.len(),
        });
    }
    if let Some(vertex) = ring.iter().position(|&point| !representable(point)) {
        return Err(SetupError::InvalidVertex {
            ring: index,
            vertex,
        });
    }
    let turns = (0..ring.len()).map(|k| turn(ring, k));
    if turns.into_iter().all(|turn| turn == 0.0) {
        return Err(SetupError::ZeroArea { ring: index });
    }
    let segments: Vec<_> = edges(ring).collect();
    for (first, &[a, b]) in segments.iter().enumerate() {
        let mut later = segments.iter().enumerate().skip(first + 1);
        if let Some((second, _)) = later.find(|(_, other)| conflict([a, b], **other)) {
            return Err(SetupError::SelfIntersection {
                ring: index,
                first,
                second,
            });
        }
    }
    Ok(turn(ring, lowest(ring)) > 0.0)
}

/// Whether a point can be a vertex or a node.
fn representable(point: Vec2) -> bool {
    let accepted = |value: f64| value == 0.0 || REPRESENTABLE.contains(&value.abs());
    accepted(point.x) && accepted(point.y)
}

/// Orientation of the triangle of a vertex and its two neighbours.
fn turn(ring: &[Vec2], vertex: usize) -> f64 {
    let count = ring.len();
    let previous = ring[(vertex + count - 1) % count];
    orientation(previous, ring[vertex], ring[(vertex + 1) % count])
}

/// The vertex that is farthest to the left, and the lowest of those. A simple polygon is strictly convex there.
fn lowest(ring: &[Vec2]) -> usize {
    let order = |a: Vec2, b: Vec2| {
        let by_x = a.x.partial_cmp(&b.x).unwrap_or(Ordering::Equal);
        by_x.then(a.y.partial_cmp(&b.y).unwrap_or(Ordering::Equal))
    };
    let vertices = 0..ring.len();
    vertices
        .min_by(|&a, &b| order(ring[a], ring[b]))
        .unwrap_or(0)
}

/// Whether two edges of one ring share more than a common vertex.
fn conflict(first: [Vec2; 2], second: [Vec2; 2]) -> bool {
    let [a, b] = first;
    let [c, d] = second;
    if a == b || c == d {
        return true;
    }
    if b == c {
        return fold(a, b, d);
    }
    if a == d {
        return fold(c, a, b);
    }
    meet(first, second)
}

/// Whether the edge from b to c returns on the edge from a to b.
fn fold(a: Vec2, b: Vec2, c: Vec2) -> bool {
    orientation(a, b, c) == 0.0 && (a - b).dot(c - b) > 0.0
}

/// Accept holes inside the outer polygon and apart from each other.
pub(super) fn nested(outer: &[Vec2], holes: &[Vec<Vec2>]) -> Result<(), SetupError> {
    for (hole, ring) in holes.iter().enumerate() {
        if touch(outer, ring) || !contains(outer, ring) {
            return Err(SetupError::HoleOutside { hole });
        }
        let earlier = holes[..hole].iter().enumerate();
        let meets =
            |other: &[Vec2]| touch(other, ring) || contains(other, ring) || contains(ring, other);
        if let Some((first, _)) = earlier.into_iter().find(|(_, other)| meets(other)) {
            return Err(SetupError::HolesMeet {
                first,
                second: hole,
            });
        }
    }
    Ok(())
}

/// Whether two rings share a point.
fn touch(first: &[Vec2], second: &[Vec2]) -> bool {
    edges(first).any(|a| edges(second).any(|b| meet(a, b)))
}

/// Whether a ring that does not touch another one lies inside it.
fn contains(outer: &[Vec2], inner: &[Vec2]) -> bool {
    in_rings(inner[0], core::iter::once(outer))
}

/// Accept cuts that are segments.
pub(super) fn segments(cuts: &[[Vec2; 2]]) -> Result<(), SetupError> {
    let valid = |&[a, b]: &[Vec2; 2]| representable(a) && representable(b) && a != b;
    match cuts.iter().position(|cut| !valid(cut)) {
        Some(cut) => Err(SetupError::InvalidCut { cut }),
        None => Ok(()),
    }
}
