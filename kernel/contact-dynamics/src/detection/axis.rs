//! The separating axis of two convex polygons among the normals of their sides.

use super::Placed;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// The side of one polygon that separates it most from another shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SeparatingSide {
    /// Index of the side.
    pub side: usize,
    /// Smallest distance of the other shape from the line of the side in m; negative in overlap.
    pub separation: f64,
    /// The vertex of the other shape that is nearest to the line, or deepest behind it.
    pub vertex: usize,
}

/// The side of polygon `a` with the largest separation from polygon `b`, whose centre is displaced by `d`.
///
/// $$ s(a, b) = \max_k \min_j \; n_k \cdot (d + v_j - p_k) $$
///
/// with the normals $n_k$ and starting points $p_k$ of the sides of a, and the vertices $v_j$ of b. The search starts
/// at the side that faces the other centre and walks both ways. A side k cannot be better than
/// $n_k \cdot d - h_a - h_b$ with the inradii h, and this bound falls while the walk turns away from d, so that the
/// walk ends early and the result is still that of all sides. If the separation exceeds `enough`, a side with that
/// property is returned, which need not be the best one.
#[rendered]
pub fn separating_side(a: &Placed, b: &Placed, d: Vec2, enough: f64) -> SeparatingSide {
    let walk = Walk {
        a,
        b,
        d: a.to_body(d),
        turn: Vec2::new(b.axis.dot(a.axis), b.axis.cross(a.axis)),
        inner: a.inradius() + b.inradius(),
    };
    let start = a.outline.side_facing(walk.d);
    let toward_a = walk.against(start);
    let mut best = walk.separation(start, b.outline.support(toward_a).0);
    let others = a.outline.sides.len() - 1;
    for forward in [true, false] {
        let (mut side, mut vertex) = (start, best.vertex);
        for _ in 0..others {
            side = if forward {
                a.outline.next(side)
            } else {
                a.outline.previous(side)
            };
            let is_hopeless =
                a.outline.sides[side].normal.dot(walk.d) - walk.inner <= best.separation;
            if best.separation > enough || is_hopeless {
                break;
            }
            let found = walk.separation(side, vertex);
            vertex = found.vertex;
            if found.separation > best.separation {
                best = found;
            }
        }
    }
    best
}

struct Walk<'a> {
    a: &'a Placed<'a>,
    b: &'a Placed<'a>,
    /// Displacement of b in the frame of a.
    d: Vec2,
    /// The x axis of a in the frame of b.
    turn: Vec2,
    inner: f64,
}

impl Walk<'_> {
    /// The inward normal of a side of a, in the frame of b.
    #[inline]
    fn against(&self, side: usize) -> Vec2 {
        let n = self.a.outline.sides[side].normal;
        -(self.turn * n.x + self.turn.perpendicular() * n.y)
    }

    /// Separation by a side, with the deepest vertex found from one nearby.
    #[inline]
    fn separation(&self, side: usize, nearby: usize) -> SeparatingSide {
        let (vertex, reach) = self.b.outline.climb(self.against(side), nearby);
        let normal = self.a.outline.sides[side].normal;
        SeparatingSide {
            side,
            separation: normal.dot(self.d) - self.a.offset(side) - self.b.scale * reach,
            vertex,
        }
    }
}
