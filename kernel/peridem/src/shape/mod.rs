//! Shapes of grains: polygons with holes and cuts.
//!
//! Section 7.2 of peridem. Whether three points turn left or right is decided exactly, whatever the rounding of products.

mod checks;
mod families;
pub(crate) mod predicates;

use crate::error::SetupError;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// A polygon without the open holes in it, and cuts of zero width.
///
/// The outer polygon is anticlockwise and holes are clockwise, so that the grain lies to the left of every edge. A wedge
/// notch is part of the outer polygon; a cut is a segment that no bond may cross.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    outer: Vec<Vec2>,
    holes: Vec<Vec<Vec2>>,
    cuts: Vec<[Vec2; 2]>,
}

/// Smallest box with sides along the axes that contains a shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower left corner in m.
    pub lower: Vec2,
    /// Upper right corner in m.
    pub upper: Vec2,
}

#[rendered]
impl Outline {
    /// A shape with vertices in m, in either direction. Vertices between two edges of one line are allowed.
    ///
    /// Coordinates other than zero have magnitudes from 1e-60 to 1e60 m, so that all orientations are exact.
    ///
    /// # Errors
    /// [`SetupError::TooFewVertices`], [`SetupError::InvalidVertex`], [`SetupError::ZeroArea`] and
    /// [`SetupError::SelfIntersection`] for a ring that is not a simple polygon, [`SetupError::HoleOutside`] for a hole
    /// that is not strictly inside the outer polygon, [`SetupError::HolesMeet`] for holes that touch or contain each
    /// other, [`SetupError::InvalidCut`] for a cut without a length or with invalid ends.
    pub fn new(
        mut outer: Vec<Vec2>,
        mut holes: Vec<Vec<Vec2>>,
        cuts: Vec<[Vec2; 2]>,
    ) -> Result<Self, SetupError> {
        if !checks::simple(0, &outer)? {
            outer.reverse();
        }
        for (k, hole) in holes.iter_mut().enumerate() {
            if checks::simple(k + 1, hole)? {
                hole.reverse();
            }
        }
        checks::nested(&outer, &holes)?;
        checks::segments(&cuts)?;
        Ok(Self { outer, holes, cuts })
    }

    /// Vertices of the outer polygon in m, anticlockwise.
    pub fn outer(&self) -> &[Vec2] {
        &self.outer
    }

    /// Vertices of the holes in m, clockwise.
    pub fn holes(&self) -> &[Vec<Vec2>] {
        &self.holes
    }

    /// Ends of the cuts in m.
    #[doc(alias = "pre-notch")]
    pub fn cuts(&self) -> &[[Vec2; 2]] {
        &self.cuts
    }

    /// The outer polygon, then the holes.
    pub fn rings(&self) -> impl Iterator<Item = &[Vec2]> {
        let holes = self.holes.iter().map(Vec::as_slice);
        core::iter::once(self.outer.as_slice()).chain(holes)
    }

    /// Area of the grain in m^2: that of the outer polygon minus those of the holes.
    ///
    /// $$ A = \frac12 \sum_k (x_k - x_0) \times (x_{k+1} - x_0) $$
    ///
    /// summed over all rings, with $x_0$ a vertex of the ring; holes are clockwise and count negative.
    pub fn area(&self) -> f64 {
        self.rings().map(signed_area).sum()
    }

    /// Smallest box that contains the grain.
    pub fn bounds(&self) -> Bounds {
        let smaller = |a: Vec2, b: &Vec2| Vec2::new(a.x.min(b.x), a.y.min(b.y));
        let larger = |a: Vec2, b: &Vec2| Vec2::new(a.x.max(b.x), a.y.max(b.y));
        Bounds {
            lower: self.outer.iter().fold(self.outer[0], smaller),
            upper: self.outer.iter().fold(self.outer[0], larger),
        }
    }

    /// Largest distance of a point of the grain from the origin in m: radius of the security disc.
    #[doc(alias = "security disk")]
    pub fn circumradius(&self) -> f64 {
        let distances = self.outer.iter().map(|vertex| vertex.norm());
        distances.fold(0.0, f64::max)
    }

    /// Whether a point in m lies inside the grain or on its boundary: exact for coordinates allowed in [`Outline::new`].
    ///
    /// Cuts have no width and contain no point. Cost: the number of edges.
    pub fn contains(&self, point: Vec2) -> bool {
        point.is_finite() && predicates::in_rings(point, self.rings())
    }

    /// The shape with all coordinates times a factor above zero.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for another factor; errors of [`Outline::new`] if rounding makes parts meet.
    pub fn scaled(&self, factor: f64) -> Result<Self, SetupError> {
        crate::error::require("factor", factor, "positive", factor > 0.0)?;
        self.mapped(|point| point * factor)
    }

    /// The shape turned anticlockwise about the origin by an angle in radians.
    ///
    /// # Errors
    /// Those of [`Outline::new`] if rounding makes parts meet or the angle is not finite.
    pub fn rotated(&self, angle: f64) -> Result<Self, SetupError> {
        let (sin, cos) = libm::sincos(angle);
        self.mapped(|p| Vec2::new(cos * p.x - sin * p.y, sin * p.x + cos * p.y))
    }

    /// The shape moved by a displacement in m.
    ///
    /// # Errors
    /// Those of [`Outline::new`] if rounding makes parts meet or the displacement is not finite.
    pub fn moved(&self, displacement: Vec2) -> Result<Self, SetupError> {
        self.mapped(|point| point + displacement)
    }

    fn mapped(&self, map: impl Fn(Vec2) -> Vec2) -> Result<Self, SetupError> {
        let ring = |ring: &[Vec2]| ring.iter().map(|&point| map(point)).collect();
        Self::new(
            ring(&self.outer),
            self.holes.iter().map(|hole| ring(hole)).collect(),
            self.cuts.iter().map(|&cut| cut.map(&map)).collect(),
        )
    }
}

fn signed_area(ring: &[Vec2]) -> f64 {
    let origin = ring[0];
    let triangle = |[a, b]: [Vec2; 2]| 0.5 * (a - origin).cross(b - origin);
    predicates::edges(ring).map(triangle).sum()
}
