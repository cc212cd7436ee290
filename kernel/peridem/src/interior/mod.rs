//! Which pairs of nodes of one grain may be bonded: those whose segment stays in the grain.

mod section_five;

pub use section_five::{Interceptors, SectionFive};

use crate::error::SetupError;
use crate::shape::Outline;
use crate::shape::predicates::{
    cross_properly, crosses_ray, in_box, on_segment, opposite, orientation,
};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// The closed domain of a grain, ready for many questions about segments.
#[derive(Clone, Debug)]
pub struct Interior {
    edges: Vec<Edge>,
    cuts: Vec<[Vec2; 2]>,
}

/// An edge of the boundary; the grain lies to its left.
#[derive(Clone, Copy, Debug)]
struct Edge {
    /// The vertex before the first one.
    previous: Vec2,
    start: Vec2,
    end: Vec2,
    /// Whether the inner angle at the first vertex exceeds 180 degrees.
    re_entrant: bool,
}

#[rendered]
impl Interior {
    /// The domain of a shape.
    pub fn new(outline: &Outline) -> Self {
        Self {
            edges: outline.rings().flat_map(ring_edges).collect(),
            cuts: outline.cuts().to_vec(),
        }
    }

    /// Whether two points in m can be bonded: exact rule.
    ///
    /// The closed segment lies in the closed domain (the polygon without the open holes), and it does not cross a cut at
    /// a point inside both. Bonds on the boundary, along an edge or through a re-entrant vertex are therefore allowed.
    /// This is the complement of the set $C$ of section 5 of peridem.
    ///
    /// # Method
    /// Where a segment from a point P of the closed domain to Q leaves it, there is a last point X in the domain.
    /// - X inside an edge, and P not on that edge: P and Q lie strictly on different sides of the edge and its ends
    ///   on different sides of the segment.
    /// - X = P inside an edge: Q lies strictly to the right of the edge.
    /// - X is a vertex on the segment, not Q: Q lies outside the closed angle between its two edges, which is the
    ///   intersection of the half planes to their left, or the union of them if the vertex is re-entrant.
    ///
    /// All are signs of orientations of given points, and so is whether P lies in the domain: no intersection or
    /// midpoint is ever computed. Exact for coordinates that [`Outline::new`] allows; false if one is not finite.
    ///
    /// Cost: two comparisons of boxes per edge, and orientations for the few edges nearby.
    #[inline]
    pub fn admits(&self, from: Vec2, to: Vec2) -> bool {
        self.contains(from) && self.admits_from_inside(from, to)
    }

    /// As [`Interior::admits`], for a first point that is known to be contained.
    #[inline]
    pub fn admits_from_inside(&self, from: Vec2, to: Vec2) -> bool {
        let near = |edge: &&Edge| boxes_meet([from, to], [edge.start, edge.end]);
        let stays = |edge: &Edge| edge.keeps(from, to);
        let cuts_apart = |cut: &[Vec2; 2]| cross_properly([from, to], *cut);
        to.is_finite()
            && self.edges.iter().filter(near).all(stays)
            && !self.cuts.iter().any(cuts_apart)
    }

    /// Whether a point in m lies in the closed domain: exact.
    #[inline]
    pub fn contains(&self, point: Vec2) -> bool {
        let mut inside = false;
        for edge in &self.edges {
            if on_segment(point, edge.start, edge.end) {
                return true;
            }
            inside ^= crosses_ray(point, edge.start, edge.end);
        }
        inside
    }

    /// Check that no node in m lies on a cut, where it would be bonded to both sides.
    ///
    /// # Errors
    /// [`SetupError::NodeOnCut`] for the first such node. Ends of a cut belong to it.
    pub fn require_off_cuts(&self, nodes: &[Vec2]) -> Result<(), SetupError> {
        for (node, &point) in nodes.iter().enumerate() {
            let on = |&[a, b]: &[Vec2; 2]| on_segment(point, a, b);
            if let Some(cut) = self.cuts.iter().position(on) {
                return Err(SetupError::NodeOnCut { node, cut });
            }
        }
        Ok(())
    }
}

fn ring_edges(ring: &[Vec2]) -> impl Iterator<Item = Edge> + '_ {
    let count = ring.len();
    (0..count).map(move |k| {
        let previous = ring[(k + count - 1) % count];
        let (start, end) = (ring[k], ring[(k + 1) % count]);
        Edge {
            previous,
            start,
            end,
            re_entrant: orientation(previous, start, end) < 0.0,
        }
    })
}

impl Edge {
    /// Whether a segment from a point of the domain does not leave it through the edge or its first vertex.
    fn keeps(&self, from: Vec2, to: Vec2) -> bool {
        let first = orientation(from, to, self.start);
        if first == 0.0 {
            return self.start == to || !in_box(self.start, from, to) || self.opens_towards(to);
        }
        if !opposite(first, orientation(from, to, self.end)) {
            return true;
        }
        orientation(self.start, self.end, from) < 0.0
            || orientation(self.start, self.end, to) >= 0.0
    }

    /// Whether a point lies in the closed angle of the grain at the first vertex.
    fn opens_towards(&self, point: Vec2) -> bool {
        let left_before = orientation(self.previous, self.start, point) >= 0.0;
        let left_after = orientation(self.start, self.end, point) >= 0.0;
        if self.re_entrant {
            left_before || left_after
        } else {
            left_before && left_after
        }
    }
}

/// Whether the closed boxes of two segments share a point.
#[inline]
fn boxes_meet(first: [Vec2; 2], second: [Vec2; 2]) -> bool {
    let [a, b] = first;
    let [c, d] = second;
    let apart = |a: f64, b: f64, c: f64, d: f64| a.max(b) < c.min(d) || c.max(d) < a.min(b);
    !apart(a.x, b.x, c.x, d.x) && !apart(a.y, b.y, c.y, d.y)
}
