//! The terms of the energy balance, thesis eqs. (72)-(79).

use crate::particles::Particles;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// The terms of the energy balance, in J.
///
/// $$ E^{kin} + E^{cont} + E^{ext} + Q^{amb} + Q^{fric} + Q^{brk} = W^{bond} + W^{driv} $$
///
/// Thesis eq. (72), with the energies measured from the initial state (erratum E21 of the thesis). Heat keeps its
/// sign: a law that creates energy shows up as negative heat.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy<S = f64> {
    /// Kinetic energy.
    pub kinetic: S,
    /// Elastic energy stored in contacts and bonds.
    pub contact: S,
    /// Potential energy in the external potential, of the particles that can move: of a large fixed one it would be
    /// so large that all other terms lose their digits.
    pub external: S,
    /// Heat from the drag of the medium.
    pub ambient: S,
    /// Heat from contacts and bonds.
    pub friction: S,
    /// Stored energy lost when bonds broke.
    pub breaking: S,
    /// Stored energy of contacts that replaced broken bonds.
    pub bonding: S,
    /// Work of the driving force.
    pub driving: S,
    /// Residual of the balance: left side minus right side of thesis eq. (72), less its initial value.
    pub residual: S,
}

impl<S: Real> Energy<S> {
    /// Names of the terms, in the order of [`values`](Self::values).
    pub const NAMES: [&'static str; 9] = [
        "kinetic", "contact", "external", "ambient", "friction", "breaking", "bonding", "driving",
        "residual",
    ];

    /// The terms, in the order of [`NAMES`](Self::NAMES).
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

    /// Kinetic energy, thesis eq. (74); all other terms are zero.
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

    /// Sum of kinetic, stored and potential energy.
    pub fn mechanical(&self) -> S {
        self.kinetic + self.contact + self.external
    }
}
