//! Exact predicates of points and segments: only signs of orientations and comparisons of coordinates.

use gouge_common::geometry::Vec2;
use robust::{Coord, orient2d};

/// Twice the signed area of a triangle in m^2. The sign is exact: positive if the vertices are anticlockwise.
#[inline]
pub(crate) fn orientation(a: Vec2, b: Vec2, c: Vec2) -> f64 {
    let coord = |p: Vec2| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(c))
}

/// Whether a point lies in the closed box with two opposite corners.
#[inline]
pub(crate) fn in_box(point: Vec2, a: Vec2, b: Vec2) -> bool {
    let between = |value: f64, a: f64, b: f64| a.min(b) <= value && value <= a.max(b);
    between(point.x, a.x, b.x) && between(point.y, a.y, b.y)
}

/// Whether a point lies on a closed segment.
#[inline]
pub(crate) fn on_segment(point: Vec2, a: Vec2, b: Vec2) -> bool {
    in_box(point, a, b) && orientation(a, b, point) == 0.0
}

/// Whether two numbers other than zero have different signs.
#[inline]
pub(crate) fn opposite(a: f64, b: f64) -> bool {
    (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)
}

/// Whether the interiors of two segments cross at one point.
#[inline]
pub(crate) fn cross_properly(first: [Vec2; 2], second: [Vec2; 2]) -> bool {
    let [a, b] = first;
    let [c, d] = second;
    opposite(orientation(a, b, c), orientation(a, b, d))
        && opposite(orientation(c, d, a), orientation(c, d, b))
}

/// Whether two closed segments share a point.
pub(crate) fn meet(first: [Vec2; 2], second: [Vec2; 2]) -> bool {
    let [a, b] = first;
    let [c, d] = second;
    cross_properly(first, second)
        || on_segment(c, a, b)
        || on_segment(d, a, b)
        || on_segment(a, c, d)
        || on_segment(b, c, d)
}

/// Whether the edge from a to b crosses the ray from a point to the right. Each vertex belongs to the edge above it.
#[inline]
pub(crate) fn crosses_ray(point: Vec2, a: Vec2, b: Vec2) -> bool {
    if (a.y > point.y) == (b.y > point.y) || point.x > a.x.max(b.x) {
        return false;
    }
    let side = orientation(a, b, point);
    if b.y > a.y { side > 0.0 } else { side < 0.0 }
}

/// The edges of a ring; edge k begins at vertex k.
pub(crate) fn edges(ring: &[Vec2]) -> impl Iterator<Item = [Vec2; 2]> + '_ {
    let ends = ring.iter().cycle().skip(1);
    ring.iter().zip(ends).map(|(&a, &b)| [a, b])
}

/// Whether a point lies inside or on a set of rings: inside an odd number of them.
pub(crate) fn in_rings<'a>(point: Vec2, rings: impl Iterator<Item = &'a [Vec2]>) -> bool {
    let mut inside = false;
    for [a, b] in rings.flat_map(edges) {
        if on_segment(point, a, b) {
            return true;
        }
        inside ^= crosses_ray(point, a, b);
    }
    inside
}
