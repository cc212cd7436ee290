//! External potentials, thesis eqs. (8)-(10) and (67).

use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// A potential that acts on every particle; it exerts no torque on spheres, thesis eq. (9).
pub trait ExternalLaw: Copy {
    /// Force in N on a particle of the given mass in kg, minus the gradient of the potential (8).
    fn force<S: Real>(self, mass: S, position: Vec2<S>) -> Vec2<S>;
    /// Potential energy in J.
    fn potential<S: Real>(self, mass: S, position: Vec2<S>) -> S;
}

/// Uniform gravity.
///
/// $$ U = a\, m\, y $$
///
/// Thesis eq. (10); pulls towards negative y.
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

/// Harmonic well around a horizontal line, the same for every mass.
///
/// $$ U = \tfrac12 k \left( y - y_0 \right)^2 $$
///
/// Thesis eq. (67), which centres the well at half the height. A column of grains under it has a
/// parabolic pressure, largest at the centre and zero at the edges, not a uniform one (E41 of
/// `docs/thesis/errata.md`).
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
