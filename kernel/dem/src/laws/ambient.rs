//! Drag of the surrounding medium, thesis eqs. (11)-(19).

use core::f64::consts::PI;
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// Force and torque of the medium on a particle.
#[derive(Clone, Copy, Debug)]
pub struct Drag<S> {
    /// Force in N.
    pub force: Vec2<S>,
    /// Torque in N m.
    pub torque: S,
}

/// Drag law of a medium at rest.
pub trait AmbientLaw: Copy {
    /// Force in N and torque in N m on a sphere with radius in m, velocity in m/s and angular velocity in rad/s.
    ///
    /// Both oppose the motion.
    fn drag<S: Real>(self, radius: S, velocity: Vec2<S>, angular_velocity: S) -> Drag<S>;
}

/// Drag in creeping flow.
///
/// # Equation
/// Thesis eqs. (17)-(19):
///
/// $$ \vec F = -6 \pi \eta\, r\, \vec v, \qquad \tau = -8 \pi \eta\, r^3 \omega $$
///
/// # Symbols
/// $\eta$ is `viscosity` in Pa s, $r$ the radius in m, $\vec v$ the velocity in m/s and $\omega$ the angular velocity
/// in rad/s.
///
/// # Domain
/// Reynolds numbers below one.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CreepingDrag {
    /// Dynamic viscosity in Pa s.
    pub viscosity: f64,
}

impl AmbientLaw for CreepingDrag {
    #[inline(always)]
    fn drag<S: Real>(self, radius: S, velocity: Vec2<S>, angular_velocity: S) -> Drag<S> {
        let cube = radius * radius * radius;
        Drag {
            force: velocity * (radius * (-6.0 * PI * self.viscosity)),
            torque: angular_velocity * cube * (-8.0 * PI * self.viscosity),
        }
    }
}

/// Drag by the correlation of Hölzer and Sommerfeld, for spheres.
///
/// # Equation
/// Thesis eqs. (11)-(13) and (16):
///
/// $$ \vec F = -\frac{\pi}{8} \frac{\eta^2}{\rho} \left( \frac{24}{Re} + \frac{3}{\sqrt{Re}} + c \right) Re^2 \frac{\vec v}{\lvert \vec v \rvert}, \qquad Re = \frac{2 \rho\, r \lvert \vec v \rvert}{\eta} $$
///
/// The torque is that of creeping flow, thesis eq. (19), because the correlation has none.
///
/// # Symbols
/// $\eta$ is `viscosity` in Pa s, $\rho$ `density` in kg/m^3, $c$ `constant`, $r$ the radius in m and $\vec v$ the
/// velocity in m/s.
///
/// # Domain
/// Subcritical Reynolds numbers.
///
/// # Errata
/// The constant c is 0.42; the thesis prints 1 (erratum E7 of the thesis).
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CorrelationDrag {
    /// Dynamic viscosity in Pa s.
    pub viscosity: f64,
    /// Density of the medium in kg/m^3.
    pub density: f64,
    /// The constant c, dimensionless: [`CorrelationDrag::CONSTANT`], or 1 as printed in the thesis.
    pub constant: f64,
}

impl CorrelationDrag {
    /// Drag coefficient of the correlation in the limit of large Reynolds numbers.
    pub const CONSTANT: f64 = 0.42;
    /// The same limit, as printed in thesis eq. (16).
    pub const PRINTED_CONSTANT: f64 = 1.0;
}

impl AmbientLaw for CorrelationDrag {
    #[inline(always)]
    fn drag<S: Real>(self, radius: S, velocity: Vec2<S>, angular_velocity: S) -> Drag<S> {
        let re = reynolds_number(self.viscosity, self.density, radius, velocity.norm());
        // C Re instead of C, which would divide by a Reynolds number of zero.
        let c_re = S::from_f64(24.0) + re.sqrt() * 3.0 + re * self.constant;
        Drag {
            force: velocity * (radius * c_re * (-0.25 * PI * self.viscosity)),
            torque: CreepingDrag {
                viscosity: self.viscosity,
            }
            .drag(radius, velocity, angular_velocity)
            .torque,
        }
    }
}

/// Reynolds number of a sphere, 2 rho r |v| / eta, dimensionless, thesis eq. (12).
///
/// Viscosity in Pa s, density in kg/m^3, radius in m, speed in m/s.
#[inline(always)]
pub fn reynolds_number<S: Real>(viscosity: f64, density: f64, radius: S, speed: S) -> S {
    radius * speed * (2.0 * density / viscosity)
}

/// Drag coefficient of a body with the given sphericities, dimensionless.
///
/// $$ C = \frac{8}{Re \sqrt{\Phi_\parallel}} + \frac{16}{Re \sqrt{\Phi_\circ}} + \frac{3}{\sqrt{Re}\, \Phi_\circ^{3/4}} + \frac{0.42 \cdot 10^{0.4 (-\log_{10} \Phi_\circ)^{0.2}}}{\Phi_\perp} $$
///
/// Thesis eqs. (14)-(15), with the missing base 10 (erratum E7 of the thesis) and with the root of the third term
/// taken of both factors (erratum E8 of the thesis). Sphericities in (0, 1]: `[lengthwise, general, crosswise]`.
#[rendered]
pub fn drag_coefficient(reynolds_number: f64, sphericities: [f64; 3]) -> f64 {
    let [lengthwise, general, crosswise] = sphericities;
    let exponent = 0.4 * libm::pow(-libm::log10(general), 0.2);
    8.0 / (reynolds_number * lengthwise.sqrt())
        + 16.0 / (reynolds_number * general.sqrt())
        + 3.0 / (reynolds_number * general * general.sqrt()).sqrt()
        + 0.42 * libm::pow(10.0, exponent) / crosswise
}
