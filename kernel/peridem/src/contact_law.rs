//! Contact of two nodes: repulsion, normal damping, friction; stiffness of contacts and the time step they allow.

use crate::error::{SetupError, require, require_product};
use crate::material::{Material, Weight};
use core::f64::consts::PI;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// Which mass damping and friction refer to.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ContactReading {
    /// The reduced mass of both nodes: forces are exactly opposite (peridem P15, P17).
    #[default]
    Symmetric,
    /// The mass $\rho V_x$ of the node the force acts on, as printed: momentum is not conserved for unequal nodes.
    OneSided,
    /// As [`ContactReading::OneSided`], with the sticking force density $-v_t/(\rho \Delta t)$ of the authors' program
    /// (peridem Q5).
    Authors,
    /// As [`ContactReading::OneSided`], with the signs and the normalised velocity of the source (peridem P2, P3): damping
    /// and friction drive the nodes.
    Printed,
}

/// Whether the nodes of a contact slide on each other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Motion {
    /// There is no contact.
    #[default]
    Separate,
    /// Friction stops the tangential motion within the step.
    Stick,
    /// Friction is at the Coulomb limit.
    Slip,
}

/// A node as contacts see it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Area in m^2.
    pub area: f64,
    /// Density in kg/m^3.
    pub density: f64,
}

/// Two nodes x and y.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodePair {
    /// $p_y - p_x$ in m.
    pub separation: Vec2,
    /// $v_x - v_y$ in m/s.
    pub velocity: Vec2,
    /// The node on which the force acts.
    pub x: Node,
    /// The other node.
    pub y: Node,
}

/// The spring of a contact.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactSpring {
    /// Stiffness K in N/m^6 per metre of depth: times two areas and an overlap, it is a force per metre of depth.
    pub stiffness: f64,
    /// Distance $r_0$ in m below which the nodes repel each other.
    pub rest_distance: f64,
}

/// How friction turns a velocity into a force within a time step.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrictionStep {
    /// Time step in s.
    pub time_step: f64,
    /// Number of partners that stop a node together, at least 1; the same for both nodes of a pair. It divides the
    /// coefficient of the sticking force; 1 is the source.
    pub stick_share: f64,
}

/// Forces of a contact on one node, in N per metre of depth.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactForce {
    /// Elastic force.
    pub repulsion: Vec2,
    /// Normal damping.
    pub damping: Vec2,
    /// Friction.
    pub friction: Vec2,
    /// Whether the nodes stick.
    pub motion: Motion,
}

/// Coefficients of the contact of nodes.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaw {
    /// Contact radius $R_c$ in m.
    pub radius: f64,
    /// Damping ratio $r_d$ in [0, 1].
    pub damping_ratio: f64,
    /// Coefficient of friction, not negative.
    pub friction: f64,
    /// The mass in damping and friction.
    pub reading: ContactReading,
}

impl Node {
    /// Mass in kg per metre of depth.
    #[inline(always)]
    pub fn mass(&self) -> f64 {
        self.density * self.area
    }
}

impl ContactForce {
    /// Sum of the three forces.
    #[inline(always)]
    pub fn total(&self) -> Vec2 {
        self.repulsion + self.damping + self.friction
    }

    /// The opposite forces.
    #[inline(always)]
    pub fn reversed(&self) -> Self {
        Self {
            repulsion: -self.repulsion,
            damping: -self.damping,
            friction: -self.friction,
            motion: self.motion,
        }
    }
}

#[rendered]
impl ContactSpring {
    /// Stored energy in J per metre of depth of two areas in m^2 at a distance d in m.
    ///
    /// $$ \frac{1}{2} K V_x V_y \max(r_0 - d, 0)^2 $$
    #[inline(always)]
    pub fn energy(&self, distance: f64, area_x: f64, area_y: f64) -> f64 {
        let overlap = (self.rest_distance - distance).max(0.0);
        0.5 * (self.stiffness * (area_x * area_y)) * overlap * overlap
    }
}

#[rendered]
impl FrictionStep {
    /// Friction on a node, in N per metre of depth, for the tangential velocity $v_t$ relative to its partner, in m/s.
    ///
    /// $$ F = -\mu N \frac{v_t}{|v_t|} \; \text{if} \; |v_t| > \mu N \frac{\Delta t}{m}, \qquad F = -C v_t \; \text{otherwise} $$
    ///
    /// peridem (4.3) with the sign of peridem P3. `limit` is $\mu N$ in N/m, m the mass in kg/m that sets the threshold,
    /// and `sticking` the coefficient C in N s/m^2 before it is divided by [`FrictionStep::stick_share`]; $C = m/\Delta t$
    /// stops the node in one step.
    #[inline(always)]
    pub(crate) fn force(
        &self,
        velocity: Vec2,
        limit: f64,
        mass: f64,
        sticking: f64,
    ) -> (Vec2, Motion) {
        let speed = velocity.norm();
        if speed * mass > limit * self.time_step {
            (velocity * (-limit / speed), Motion::Slip)
        } else {
            (velocity * (-sticking / self.stick_share), Motion::Stick)
        }
    }
}

#[rendered]
impl ContactLaw {
    /// Check the coefficients.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a radius that is not positive, a damping ratio outside [0, 1] or negative friction, and
    /// [`SetupError::Product`] for a radius whose square under- or overflows.
    pub fn validate(&self) -> Result<(), SetupError> {
        let (radius, ratio) = (self.radius, self.damping_ratio);
        require("contact radius", radius, "positive", radius > 0.0)?;
        let factors = [("contact radius", radius, 2)];
        let square = "the square of the contact radius in m^2";
        require_product(square, radius * radius, &factors)?;
        let is_valid = (0.0..=1.0).contains(&ratio);
        require("damping ratio", ratio, "in [0, 1]", is_valid)?;
        let is_valid = self.friction >= 0.0;
        require("friction", self.friction, "not negative", is_valid)
    }

    /// Spring between nodes of different grains, for a stiffness $K_n$ in N/m^6.
    #[inline(always)]
    pub fn between_grains(&self, stiffness: f64) -> ContactSpring {
        ContactSpring {
            stiffness,
            rest_distance: self.radius,
        }
    }

    /// Spring between two nodes of one grain that share no bond, section 4.4 of peridem.
    ///
    /// $$ r_0 = \min(|\xi|, R_c), \qquad K = c/r_0 $$
    ///
    /// Here $|\xi|$ is the distance of the undeformed nodes in m, and c the bond stiffness of the constant weight in N/m^6
    /// (peridem Q7).
    #[inline(always)]
    pub fn within_grain(&self, bond_stiffness: f64, reference_distance: f64) -> ContactSpring {
        let rest_distance = reference_distance.min(self.radius);
        ContactSpring {
            stiffness: bond_stiffness / rest_distance,
            rest_distance,
        }
    }

    /// Mass in kg/m that damping and friction on node x refer to.
    #[inline(always)]
    pub fn mass(&self, x: &Node, y: &Node) -> f64 {
        let (x, y) = (x.mass(), y.mass());
        match self.reading {
            ContactReading::Symmetric => x * y / (x + y),
            ContactReading::OneSided | ContactReading::Authors | ContactReading::Printed => x,
        }
    }

    /// Coefficient of the normal damping force on node x, in N s/m^2.
    ///
    /// $$ c_d = 2 r_d \sqrt{K V_x V_y m} $$
    #[inline(always)]
    pub fn damping(&self, x: &Node, y: &Node, stiffness: f64) -> f64 {
        2.0 * self.damping_ratio * (stiffness * (x.area * y.area) * self.mass(x, y)).sqrt()
    }

    /// Force on node x of a pair.
    ///
    /// $$ F_r = -K (r_0 - d) V_x V_y e, \qquad F_d = -c_d (v \cdot e) e, \qquad d < r_0 $$
    ///
    /// peridem (4.1), (4.3), (4.5); e points from x to y, and v is the velocity of x relative to y (peridem P2). Friction
    /// is limited by $\mu |F_r|$. There is no force at a distance of zero, where no direction exists. With
    /// [`ContactReading::Symmetric`] the force on y, computed with exchanged roles, is the opposite one to the last bit.
    #[inline(always)]
    pub fn force(
        &self,
        pair: &NodePair,
        spring: &ContactSpring,
        step: &FrictionStep,
    ) -> ContactForce {
        let distance = pair.separation.norm();
        if distance >= spring.rest_distance || distance == 0.0 {
            return ContactForce::default();
        }
        let (x, y) = (&pair.x, &pair.y);
        let direction = pair.separation * (1.0 / distance);
        let repulsion = spring.stiffness * (x.area * y.area) * (spring.rest_distance - distance);
        let normal_velocity = pair.velocity.dot(direction);
        let tangential = pair.velocity - direction * normal_velocity;
        let mass = self.mass(x, y);
        let sticking = match self.reading {
            ContactReading::Symmetric | ContactReading::OneSided | ContactReading::Printed => {
                mass / step.time_step
            }
            ContactReading::Authors => x.area / (x.density * step.time_step),
        };
        let limit = self.friction * repulsion;
        let (friction, motion) = step.force(tangential, limit, mass, sticking);
        let damping = direction * (self.damping(x, y, spring.stiffness) * normal_velocity);
        let (damping, friction) = match self.reading {
            ContactReading::Printed => (
                damping * (1.0 / pair.velocity.norm().max(f64::MIN_POSITIVE)),
                -friction,
            ),
            _ => (-damping, friction),
        };
        ContactForce {
            repulsion: direction * -repulsion,
            damping,
            friction,
            motion,
        }
    }
}

/// How the contact stiffness follows from the materials.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum ContactStiffness {
    /// $ K_n = c/R_c $ with c of the constant weight: contact between grains is contact within a grain.
    #[default]
    FromBonds,
    /// $ K_n = 18 k/(\pi \epsilon^4) $, of the dimension that (4.1) requires in two dimensions.
    Published,
    /// $ K_n = 18 k/(\pi \epsilon^5) $ as printed, a three-dimensional constant (peridem P1).
    Printed,
    /// A stiffness in N/m^6.
    Given(f64),
}

/// What a contact stiffness may depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactMaterial {
    /// The material of the bonds.
    pub material: Material,
    /// Bulk modulus in Pa, which the source gives independently of the material.
    pub bulk_modulus: f64,
    /// Horizon in m.
    pub horizon: f64,
}

impl ContactMaterial {
    /// Stiffness of bonds of the constant weight, in N/m^6; self contact takes it for every weight.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for an invalid material or horizon.
    pub fn bond_stiffness(&self) -> Result<f64, SetupError> {
        let constants = (self.material).bond_constants(Weight::Constant, self.horizon)?;
        Ok(constants.stiffness)
    }
}

/// Harmonic mean 2 a b/(a + b) of two positive numbers.
fn harmonic_mean(a: f64, b: f64) -> f64 {
    2.0 * a * b / (a + b)
}

#[rendered]
impl ContactStiffness {
    /// Stiffness $K_n$ in N/m^6 between two materials for a contact radius in m.
    ///
    /// The bulk modulus k (or the bond stiffness c) is the harmonic mean of both sides, and the horizon the mean.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a number outside its range, and [`SetupError::Product`] for a stiffness that under- or
    /// overflows.
    pub fn between(
        self,
        first: &ContactMaterial,
        second: &ContactMaterial,
        radius: f64,
    ) -> Result<f64, SetupError> {
        require("contact radius", radius, "positive", radius > 0.0)?;
        let bulk = harmonic_mean(first.bulk_modulus, second.bulk_modulus);
        let horizon = 0.5 * (first.horizon + second.horizon);
        let stiffness = match self {
            Self::FromBonds => {
                harmonic_mean(first.bond_stiffness()?, second.bond_stiffness()?) / radius
            }
            Self::Published => 18.0 * bulk / (PI * horizon.powi(4)),
            Self::Printed => 18.0 * bulk / (PI * horizon.powi(5)),
            Self::Given(stiffness) => stiffness,
        };
        let factors = match self {
            Self::FromBonds => vec![("contact radius", radius, -1)],
            Self::Published => vec![
                ("bulk_modulus", first.bulk_modulus, 1),
                ("horizon", horizon, -4),
            ],
            Self::Printed => vec![
                ("bulk_modulus", first.bulk_modulus, 1),
                ("horizon", horizon, -5),
            ],
            Self::Given(_) => {
                require("contact stiffness", stiffness, "positive", stiffness > 0.0)?;
                vec![("contact stiffness", stiffness, 1)]
            }
        };
        require_product("the stiffness of contacts in N/m^6", stiffness, &factors)?;
        Ok(stiffness)
    }
}

/// Largest stable time step in s of an oscillator under velocity Verlet with the damping of the previous velocity.
///
/// $$ \omega^2 \Delta t^2 + \lambda \Delta t < 2 \quad (\lambda > 0), \qquad \omega \Delta t < 2 \quad (\lambda = 0) $$
///
/// `frequency_squared` is $\omega^2$ in 1/s^2 and `damping_rate` is $\lambda$ in 1/s. A pair of nodes has
/// $\omega^2 = K V_x V_y/m$ and $\lambda = c_d/m$ with the reduced mass m. A node among partners that may all move
/// against it has at most $\omega^2 = 2 K \sum V_y/\rho$ and $\lambda = 2 \sum c_d/(\rho V)$. With
/// $a = \omega^2 \Delta t^2$ and $q = \lambda \Delta t$ the characteristic polynomial is
/// $z^3 + (a + q/2 - 2) z^2 + z - q/2$, and the condition is Jury's (peridem Q8).
/// Infinite if nothing limits the step.
#[rendered]
pub fn largest_step(frequency_squared: f64, damping_rate: f64) -> f64 {
    if damping_rate > 0.0 {
        let root = (damping_rate * damping_rate + 8.0 * frequency_squared).sqrt();
        4.0 / (damping_rate + root)
    } else {
        2.0 / frequency_squared.sqrt()
    }
}
