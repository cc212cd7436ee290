//! The terms of the energy balance, thesis eqs. (72)-(79).

use crate::particles::Particles;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// The terms of the energy balance in J.
///
/// $$ E^{kin} + E^{cont} + E^{ext} + Q^{amb} + Q^{fric} + Q^{brk} = W^{bond} + W^{driv} $$
///
/// Thesis eq. (72), where the energies count from the initial state (erratum E21 of the thesis).
/// Dissipated heats are signed sums: a law that creates energy shows as a negative heat.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy<S = f64> {
    /// Kinetic energy.
    pub kinetic: S,
    /// Energy stored in links.
    pub contact: S,
    /// Energy in the external potential.
    pub external: S,
    /// Heat of ambient forces.
    pub ambient: S,
    /// Heat of links.
    pub friction: S,
    /// Stored energy lost with links that were removed.
    pub breaking: S,
    /// Stored energy gained with links that were made under load.
    pub bonding: S,
    /// Work of the driving force.
    pub driving: S,
    /// What does not close: left minus right side of (72), less its initial value.
    pub residual: S,
}

impl<S: Real> Energy<S> {
    /// Names of the terms, in order.
    pub const NAMES: [&'static str; 9] = [
        "kinetic", "contact", "external", "ambient", "friction", "breaking", "bonding", "driving",
        "residual",
    ];

    /// The terms, in the order of their names.
    pub fn values(&self) -> [f64; 9] {
        [
            self.kinetic,
            self.contact,
            self.external,
            self.ambient,
            self.friction,
            self.breaking,
            self.bonding,
            self.driving,
            self.residual,
        ]
        .map(Real::to_f64)
    }

    /// Kinetic energy (74), all other terms zero.
    pub(crate) fn kinetic_of(particles: &Particles<S>) -> Self {
        let mut energy = Self::default();
        for i in 0..particles.len() {
            let omega = particles.angular_velocity[i];
            energy.kinetic += (particles.mass[i] * particles.velocity[i].norm_squared()
                + particles.moment_of_inertia[i] * omega * omega)
                * 0.5;
        }
        energy
    }

    /// Kinetic, stored and potential energy.
    pub fn mechanical(&self) -> S {
        self.kinetic + self.contact + self.external
    }
}
