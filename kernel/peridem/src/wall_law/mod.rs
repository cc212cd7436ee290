//! Contact of a node with rigid straight walls and their corners.
//!
//! Each wall is a half-plane. It acts on a node through the part of the disc of the contact radius around the node that
//! lies beyond the wall, section 4.5 of peridem. Distances are those of the node from the wall, positive inside the
//! container; forces are positive along the inward normal.

mod segment;

use crate::contact_law::{ContactForce, FrictionStep, Node};
use crate::error::{SetupError, require};
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;
pub use segment::Overlap;
use segment::{Corner, Segment};

/// Which force a wall exerts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum WallReading {
    /// The force at the centroid, (4.7)-(4.8), with the part beyond both walls of a corner subtracted (peridem Q1).
    #[default]
    Paper,
    /// The integral of (4.1) over the part of the disc beyond the walls. It vanishes at $d = -R_c$ (peridem Q2).
    Exact,
    /// (4.7) at the distance |d| with the sign of d, and nothing subtracted in corners: the authors' program with its
    /// centroid repaired (peridem Q4).
    TwoFixes,
    /// As [`WallReading::TwoFixes`], with the centroid at the node: the authors' program as published.
    Authors,
}

/// Coefficients of the contact with walls.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallLaw {
    /// Contact radius $R_c$ in m.
    pub radius: f64,
    /// Stiffness $K_n$ in N/m^6 per metre of depth.
    pub stiffness: f64,
    /// Damping ratio $r_d$ in [0, 1].
    pub damping_ratio: f64,
    /// Coefficient of friction, not negative.
    pub friction: f64,
    /// The law of the force.
    pub reading: WallReading,
}

/// A node at a wall.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeAtWall {
    /// The node.
    pub node: Node,
    /// Distance d in m, positive inside.
    pub distance: f64,
    /// Unit normal that points out of the container.
    pub outward: Vec2,
    /// Velocity relative to the wall in m/s.
    pub velocity: Vec2,
}

/// The largest slope of the exact law, $2 s t$ where $\operatorname{artanh} s = 2 s$.
#[rendered]
const STEEPEST_EXACT: f64 = 0.552_326_446_877_657_5;

#[rendered]
impl WallLaw {
    /// Check the coefficients.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a radius or stiffness that is not positive, a damping ratio outside [0, 1] or
    /// negative friction.
    pub fn validate(&self) -> Result<(), SetupError> {
        let (radius, stiffness) = (self.radius, self.stiffness);
        require("contact radius", radius, "positive", radius > 0.0)?;
        require("contact stiffness", stiffness, "positive", stiffness > 0.0)?;
        let is_valid = (0.0..=1.0).contains(&self.damping_ratio);
        require("damping ratio", self.damping_ratio, "in [0, 1]", is_valid)?;
        let is_valid = self.friction >= 0.0;
        require("friction", self.friction, "not negative", is_valid)
    }

    /// The segment that the law takes: the authors' is that at |d|.
    fn segment(&self, distance: f64) -> Segment {
        let distance = match self.reading {
            WallReading::Paper | WallReading::Exact => distance,
            WallReading::TwoFixes | WallReading::Authors => distance.abs(),
        };
        Segment::new(distance, self.radius)
    }

    /// Area S in m^2 of the part of the disc beyond a wall at a distance d in m.
    ///
    /// $$ S = R_c^2 \arccos \frac{d}{R_c} - d \sqrt{R_c^2 - d^2} $$
    ///
    /// Zero for $d \ge R_c$ and the whole disc for $d \le -R_c$.
    pub fn area_beyond(&self, distance: f64) -> f64 {
        self.segment(distance).area() * self.radius * self.radius
    }

    /// Distance in m of a node from the centroid of the part of the disc beyond a wall at a distance d in m.
    ///
    /// $$ \frac{M}{S}, \qquad M = \frac{2}{3} (R_c^2 - d^2)^{3/2} $$
    ///
    /// $R_c$, its limit, where the wall does not reach the disc.
    pub fn centroid(&self, distance: f64) -> f64 {
        let segment = self.segment(distance);
        match segment.is_empty() {
            true => self.radius,
            false => segment.moment() / segment.area() * self.radius,
        }
    }

    /// Part of the disc beyond both of two perpendicular walls at distances in m: area in m^2 and first moments in m^3, for
    /// all signs of the distances (peridem Q1).
    pub fn overlap(&self, distances: [f64; 2]) -> Overlap {
        let corner = Corner::new(self.segment(distances[0]), self.segment(distances[1]));
        let overlap = corner.overlap();
        Overlap {
            area: overlap.area * self.radius.powi(2),
            moments: overlap.moments.map(|moment| moment * self.radius.powi(3)),
        }
    }

    /// Force K V R_c^3 of a node of an area in m^2, in N/m.
    fn unit(&self, area: f64) -> f64 {
        self.stiffness * area * self.radius.powi(3)
    }

    /// Elastic force in N per metre of depth of one wall on a node of area V in m^2 at a distance d in m, positive inwards.
    ///
    /// $$ N = K_n V (R_c S - M), \qquad M = \frac{2}{3} (R_c^2 - d^2)^{3/2} $$
    ///
    /// peridem (4.7); M/S is the distance of the centroid. [`WallReading::Exact`] is
    ///
    /// $$ N = K_n V \left[ \frac{s R_c^2}{3} + \frac{2 s d^2}{3} - R_c d^2 \ln \frac{R_c + s}{|d|} \right] $$
    ///
    /// with $ s = \sqrt{R_c^2 - d^2} $.
    /// Both have a small relative error up to $d = R_c$. For $d \le -R_c$ the paper's force stays $\pi K_n V R_c^3$.
    pub fn push(&self, distance: f64, area: f64) -> f64 {
        let segment = self.segment(distance);
        let sign = if distance > 0.0 { 1.0 } else { -1.0 };
        let force = match self.reading {
            WallReading::Paper => segment.depth_integral(),
            WallReading::Exact => segment.exact(),
            WallReading::TwoFixes => sign * segment.depth_integral(),
            WallReading::Authors => sign * segment.area(),
        };
        force * self.unit(area)
    }

    /// Elastic forces in N per metre of depth of two perpendicular walls on a node of an area in m^2 at distances in m,
    /// positive along the inward normals.
    ///
    /// $$ F = F_i + F_j - F_{ij}, \qquad F_{ij} = K_n V \left( \frac{R_c S_{ij}}{|I|} - 1 \right) I $$
    ///
    /// peridem (4.8) with the first moments I; for all signs of the distances (peridem Q1). [`WallReading::Exact`]
    /// integrates over the part of the disc beyond either wall.
    pub fn corner_push(&self, distances: [f64; 2], area: f64) -> [f64; 2] {
        let corner = Corner::new(self.segment(distances[0]), self.segment(distances[1]));
        let subtracted = match self.reading {
            WallReading::Paper => {
                let overlap = corner.overlap();
                let [x, y] = overlap.moments;
                let moment = Vec2::new(x, y).norm();
                let factor = if moment > 0.0 {
                    overlap.area / moment - 1.0
                } else {
                    0.0
                };
                [factor * x, factor * y]
            }
            WallReading::Exact => {
                let unit = self.unit(area);
                return corner.exact().map(|force| force * unit);
            }
            WallReading::TwoFixes | WallReading::Authors => [0.0; 2],
        };
        let unit = self.unit(area);
        [0, 1].map(|k| self.push(distances[k], area) - subtracted[k] * unit)
    }

    /// Energy in J per metre of depth of a node of an area in m^2 at a distance in m from one wall; minus its derivative is
    /// [`WallLaw::push`], and it vanishes where the wall does not act.
    ///
    /// $$ U(d) = \int_d^{R_c} N(x) dx $$
    pub fn energy(&self, distance: f64, area: f64) -> f64 {
        let segment = self.segment(distance);
        let energy = match self.reading {
            WallReading::Paper | WallReading::TwoFixes => segment.double_depth_integral(),
            WallReading::Exact => segment.exact_energy(),
            WallReading::Authors => segment.area_integral(),
        };
        energy * self.unit(area) * self.radius
    }

    /// Energy in J per metre of depth at a corner, if the forces have one: those of (4.8) depend on the path where
    /// a part of the disc lies beyond both walls (peridem Q3).
    pub fn corner_energy(&self, distances: [f64; 2], area: f64) -> Option<f64> {
        let [first, second] = distances;
        let corner = Corner::new(self.segment(first), self.segment(second));
        match self.reading {
            WallReading::Paper if corner.overlap().area > 0.0 => None,
            WallReading::Exact => Some(corner.exact_energy() * self.unit(area) * self.radius),
            _ => Some(self.energy(first, area) + self.energy(second, area)),
        }
    }

    /// Minus the derivative of [`WallLaw::push`] by the distance, in N/m^2.
    ///
    /// $$ 2 K_n V (R_c - d) \sqrt{R_c^2 - d^2} $$
    ///
    /// for the paper. The jump of the authors' force at d = 0 has no slope.
    pub fn slope(&self, distance: f64, area: f64) -> f64 {
        let segment = self.segment(distance);
        let slope = match self.reading {
            WallReading::Paper | WallReading::TwoFixes => {
                2.0 * (1.0 - segment.distance) * segment.half_chord
            }
            WallReading::Exact => segment.exact_slope(),
            WallReading::Authors => 2.0 * segment.half_chord,
        };
        slope * self.unit(area) / self.radius
    }

    /// Largest [`WallLaw::slope`] at any distance, in N/m^2; divided by the mass of the node, it is the square of the
    /// frequency that [`crate::contact_law::largest_step`] takes.
    ///
    /// For the paper it is $ \frac{3 \sqrt 3}{2} K_n V R_c^2 $, at $d = -R_c/2$; inside the container, $2 K_n V R_c^2$.
    pub fn steepest(&self, area: f64) -> f64 {
        let slope = match self.reading {
            WallReading::Paper => 1.5 * 3.0_f64.sqrt(),
            WallReading::Exact => STEEPEST_EXACT,
            WallReading::TwoFixes | WallReading::Authors => 2.0,
        };
        slope * self.unit(area) / self.radius
    }

    /// Coefficient of the normal damping of a wall on a node, in N s/m^2.
    ///
    /// $$ c_d = 2 r_d \sqrt{K_n V S m} $$
    ///
    /// peridem (4.5) with the area S beyond the wall for the partner's and the mass $m = \rho V$.
    pub fn damping(&self, distance: f64, node: &Node) -> f64 {
        let product = self.stiffness * node.area * self.area_beyond(distance);
        2.0 * self.damping_ratio * (product * node.mass()).sqrt()
    }

    /// Force of a wall on a node whose elastic force is `push` in N/m: that of [`WallLaw::push`], or the share of this wall
    /// in [`WallLaw::corner_push`].
    ///
    /// Damping and friction are those of nodes with the mass $\rho V$, along and across the normal of the wall. Friction is
    /// limited by $\mu |N|$.
    pub fn force(&self, at: &NodeAtWall, push: f64, step: &FrictionStep) -> ContactForce {
        if at.distance >= self.radius {
            return ContactForce::default();
        }
        let normal_velocity = at.velocity.dot(at.outward);
        let tangential = at.velocity - at.outward * normal_velocity;
        let mass = at.node.mass();
        let limit = self.friction * push.abs();
        let (friction, motion) = step.force(tangential, limit, mass, mass / step.time_step);
        let damping = self.damping(at.distance, &at.node);
        ContactForce {
            repulsion: at.outward * -push,
            damping: at.outward * (-damping * normal_velocity),
            friction,
            motion,
        }
    }
}
