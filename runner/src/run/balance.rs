//! Watches the energy balance of a run.

use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::estimators::Energy;
use gouge_dem::integrators::Integrator;
use gouge_dem::particles::Role;

/// Largest residual that is trusted, in units of the largest term of the balance.
pub const TRUSTED: f64 = 0.05;
/// Residual that rounding may cause, in units of the largest energy.
const ROUNDING: f64 = 1e-9;

/// What the samples so far say about the balance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// Potential energy at t = 0 in J.
    external: f64,
    /// Kinetic energy of the common motion in J.
    common: f64,
    /// The largest term so far in J. The potential energy counts by its change, the kinetic energy without that of the
    /// common motion.
    pub largest: f64,
    /// The largest absolute energy so far in J.
    magnitude: f64,
    /// The largest ratio so far of the residual to the largest term at that time.
    pub worst: f64,
    /// Whether any sample was beyond trust.
    pub is_off: bool,
}

impl Balance {
    /// The watch with which a run begins.
    pub fn new(world: &World) -> Self {
        Self {
            external: world.energy().external,
            common: common_energy(world),
            ..Self::default()
        }
    }

    /// Look at a sample; whether this is the first one beyond trust.
    pub fn watch(&mut self, world: &World, energy: &Energy) -> bool {
        let terms = [
            energy.kinetic - self.common,
            energy.contact,
            energy.external - self.external,
            energy.ambient,
            energy.friction,
            energy.breaking,
            energy.bonding,
            energy.driving,
        ];
        self.largest = terms
            .iter()
            .fold(self.largest, |all, term| all.max(term.abs()));
        let absolute = energy.kinetic.max(energy.external.abs());
        self.magnitude = self.magnitude.max(self.largest).max(absolute);
        let residual = (energy.residual + lag(world)).abs();
        if residual <= ROUNDING * self.magnitude {
            return false;
        }
        self.worst = self.worst.max(residual / self.largest);
        let is_off = residual > TRUSTED * self.largest;
        let is_first = is_off && !self.is_off;
        self.is_off |= is_off;
        is_first
    }

    /// The watch as numbers, for a checkpoint.
    pub fn words(&self) -> [u64; 6] {
        [
            self.external.to_bits(),
            self.largest.to_bits(),
            self.magnitude.to_bits(),
            u64::from(self.is_off),
            self.common.to_bits(),
            self.worst.to_bits(),
        ]
    }

    /// The watch that [`Balance::words`] stored.
    pub fn of_words([external, largest, magnitude, is_off, common, worst]: [u64; 6]) -> Self {
        Self {
            external: f64::from_bits(external),
            common: f64::from_bits(common),
            largest: f64::from_bits(largest),
            magnitude: f64::from_bits(magnitude),
            worst: f64::from_bits(worst),
            is_off: is_off != 0,
        }
    }
}

/// What the kinetic energy lacks in J because the velocities are those of another time.
///
/// The velocities of symplectic Euler are those of half a step earlier than the positions: seen as leapfrog, it is of
/// second order. Without this term its residual oscillates in every contact, although the motion is right.
fn lag(world: &World) -> f64 {
    if world.model().integrator != Integrator::SymplecticEuler {
        return 0.0;
    }
    let (p, forces) = (world.particles(), world.forces());
    let power =
        |i: usize| forces.force[i].dot(p.velocity[i]) + forces.torque[i] * p.angular_velocity[i];
    let mobile = (0..p.len()).filter(|&i| !p.is_fixed(i));
    0.5 * world.model().time_step * mobile.map(power).sum::<f64>()
}

/// Kinetic energy of the motion of the common centre of mass in J, if nothing acts on the particles from outside: it
/// stays constant, and a balance must not be trusted because of it.
fn common_energy(world: &World) -> f64 {
    let (model, p) = (world.model(), world.particles());
    let is_isolated = model.external.is_none()
        && model.ambient.is_none()
        && p.role.iter().all(|&role| role == Role::Free);
    if !is_isolated {
        return 0.0;
    }
    let momentum = p.velocity.iter().zip(&p.mass).map(|(&v, &mass)| v * mass);
    let momentum = momentum.fold(Vec2::zero(), |sum, one| sum + one);
    0.5 * momentum.norm_squared() / p.mass.iter().sum::<f64>()
}
