//! External potentials, thesis eqs. (8)-(10) and (67).

use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// A potential that acts on every particle. It exerts no torque on spheres, thesis eq. (9).
pub trait ExternalLaw: Copy {
    /// Force in N on a particle with mass in kg: minus the gradient of the potential, thesis eq. (8).
    fn force<S: Real>(self, mass: S, position: Vec2<S>) -> Vec2<S>;
    /// Potential energy in J of a particle with mass in kg at a position in m.
    fn potential<S: Real>(self, mass: S, position: Vec2<S>) -> S;
}

/// Uniform gravity.
///
/// # Equation
/// Thesis eq. (10):
///
/// $$ U = a\, m\, y $$
///
/// # Symbols
/// $a$ is `acceleration` in m/s^2, $m$ the mass in kg and $y$ the height in m.
///
/// # Sign
/// A positive acceleration points towards negative y.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity {
    /// Acceleration in m/s^2.
    pub acceleration: f64,
}

impl ExternalLaw for Gravity {
    #[inline(always)]
    fn force<S: Real>(self, mass: S, _: Vec2<S>) -> Vec2<S> {
        Vec2::new(S::zero(), -(mass * self.acceleration))
    }
    #[inline(always)]
    fn potential<S: Real>(self, mass: S, position: Vec2<S>) -> S {
        mass * position.y * self.acceleration
    }
}

/// Harmonic well around a horizontal line, independent of the mass.
///
/// # Equation
/// Thesis eq. (67), which centres the well at half the height of the box:
///
/// $$ U = \tfrac12 k \left( y - y_0 \right)^2 $$
///
/// # Symbols
/// $k$ is `stiffness` in kg/s^2, $y_0$ `centre` in m and $y$ the height in m.
///
/// # Errata
/// The pressure in a column of particles is parabolic, largest at the centre and zero at the ends, and not uniform
/// (E41 of `docs/thesis/errata.md`).
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HarmonicWell {
    /// Stiffness in kg/s^2.
    pub stiffness: f64,
    /// Height of the centre line in m.
    pub centre: f64,
}

impl ExternalLaw for HarmonicWell {
    #[inline(always)]
    fn force<S: Real>(self, _: S, position: Vec2<S>) -> Vec2<S> {
        Vec2::new(
            S::zero(),
            (S::from_f64(self.centre) - position.y) * self.stiffness,
        )
    }
    #[inline(always)]
    fn potential<S: Real>(self, _: S, position: Vec2<S>) -> S {
        let offset = position.y - S::from_f64(self.centre);
        offset * offset * (0.5 * self.stiffness)
    }
}
