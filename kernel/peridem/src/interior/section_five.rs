//! The method of section 5 of peridem to find pairs that cannot be bonded, for comparison.

use crate::error::{SetupError, require};
use crate::shape::Outline;
use crate::shape::predicates::{cross_properly, orientation};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Which segments a bond must not cross.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Interceptors {
    /// Only the bisectors of re-entrant vertices, as in the program of the authors.
    Bisectors,
    /// Bisectors and the boundary moved outwards, as in the text.
    BisectorsAndBoundary,
}

/// Outer bisectors of re-entrant vertices, and the boundary moved outwards by a small distance.
///
/// Simulations use [`Interior`](super::Interior). This method fails where
/// - a pocket is deeper than wide and only bisectors are used: bonds across it are kept;
/// - a bisector ends on an edge opposite to its vertex, as in a spiral: rounding may put its end into the grain, and
///   bonds along that edge are removed;
/// - the boundary moved outwards reaches another part of the grain, because a gap is narrower than the distance;
/// - the grain has holes or cuts: the source does not treat them, and they are ignored.
#[derive(Clone, Debug)]
pub struct SectionFive {
    interceptors: Vec<[Vec2; 2]>,
}

#[rendered]
impl SectionFive {
    /// Interceptors of the outer polygon of a shape, for a distance $\delta$ in m by which the boundary is moved.
    ///
    /// With the unit tangent $v_i$ of the edge that begins at vertex $p_i$, the outer bisector is
    ///
    /// $$ n_i = \frac{v_i - v_{i-1}}{|v_i - v_{i-1}|} \quad \text{if} \quad v_{i-1} \times v_i < 0, $$
    /// $$ n_i = \frac{v_{i-1} - v_i}{|v_{i-1} - v_i|} \quad \text{if} \quad v_{i-1} \times v_i > 0, $$
    ///
    /// and the outward normal of the edge at a straight vertex (erratum P6 of peridem). The moved boundary is the
    /// polygon of the points $p_i + \delta n_i$. From a re-entrant vertex, the bisector reaches to its first point on
    /// the boundary, or has the length $|p_i| + \max |p|$.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a distance that is not positive.
    pub fn new(
        outline: &Outline,
        distance: f64,
        interceptors: Interceptors,
    ) -> Result<Self, SetupError> {
        require("distance", distance, "positive", distance > 0.0)?;
        let ring = outline.outer();
        let corners: Vec<_> = (0..ring.len()).map(|k| Corner::new(ring, k)).collect();
        let reach = outline.circumradius();
        let re_entrant = corners.iter().filter(|corner| corner.re_entrant);
        let mut all: Vec<_> = re_entrant.map(|c| c.bisector(ring, reach)).collect();
        if interceptors == Interceptors::BisectorsAndBoundary {
            let moved: Vec<_> = corners
                .iter()
                .map(|corner| corner.vertex + corner.outward * distance)
                .collect();
            all.extend(crate::shape::predicates::edges(&moved));
        }
        Ok(Self { interceptors: all })
    }

    /// Whether the open segment between two points in m crosses no interceptor.
    pub fn admits(&self, from: Vec2, to: Vec2) -> bool {
        let crossed = |interceptor: &[Vec2; 2]| cross_properly([from, to], *interceptor);
        !self.interceptors.iter().any(crossed)
    }

    /// Ends of the interceptors in m, those of bisectors first.
    pub fn interceptors(&self) -> &[[Vec2; 2]] {
        &self.interceptors
    }
}

/// A vertex and the direction of its outer bisector.
struct Corner {
    vertex: Vec2,
    outward: Vec2,
    re_entrant: bool,
}

impl Corner {
    fn new(ring: &[Vec2], k: usize) -> Self {
        let count = ring.len();
        let (previous, vertex) = (ring[(k + count - 1) % count], ring[k]);
        let next = ring[(k + 1) % count];
        let before = unit(vertex - previous);
        let after = unit(next - vertex);
        let turn = orientation(previous, vertex, next);
        let bend = if turn < 0.0 {
            after - before
        } else {
            before - after
        };
        // The difference of nearly equal tangents has no accurate direction.
        let outward = if turn == 0.0 || bend.norm() < 1e-7 {
            -unit(before + after).perpendicular()
        } else {
            unit(bend)
        };
        Self {
            vertex,
            outward,
            re_entrant: turn < 0.0,
        }
    }

    /// Segment along the outer bisector, to its first point on the boundary.
    fn bisector(&self, ring: &[Vec2], reach: f64) -> [Vec2; 2] {
        let hits = crate::shape::predicates::edges(ring).filter_map(|edge| self.hit(edge));
        let length = hits.fold(self.vertex.norm() + reach, f64::min);
        [self.vertex, self.vertex + self.outward * length]
    }

    /// Distance along the outer bisector to an edge that does not end at the vertex.
    fn hit(&self, [a, b]: [Vec2; 2]) -> Option<f64> {
        let edge = b - a;
        let across = self.outward.cross(edge);
        if a == self.vertex || b == self.vertex || across == 0.0 {
            return None;
        }
        let distance = (a - self.vertex).cross(edge) / across;
        let along = (a - self.vertex).cross(self.outward) / across;
        (distance > 0.0 && (0.0..=1.0).contains(&along)).then_some(distance)
    }
}

fn unit(vector: Vec2) -> Vec2 {
    vector * (1.0 / vector.norm())
}
