//! Stops a run whose state is no longer physical and reports the likely cause.

use super::simulation::{Number, World};
use crate::error::StepError;
use crate::integrators::{Oscillator, critical_step};
use crate::model::{ContactNormal, ContactTangential, Model};

impl<S: Number> World<S> {
    /// Check that the state is finite and that no particle moves farther than a cell per step.
    ///
    /// # Errors
    /// The first particle that violates either condition.
    pub fn check(&self) -> Result<(), StepError> {
        check(self)
    }
}

fn check<S: Number>(world: &World<S>) -> Result<(), StepError> {
    let p = &world.state.particles;
    let step = world.model.time_step;
    let cell = distance_limit(world);
    for i in 0..p.len() {
        let is_finite = p.position[i].is_finite()
            && p.velocity[i].is_finite()
            && p.angle[i].is_finite()
            && p.angular_velocity[i].is_finite();
        if !is_finite {
            return Err(StepError::NotFinite {
                particle: i,
                interaction: most_strained_interaction(world, i),
                time: world.time(),
                steps: world.state.steps,
                time_step: step,
                bound: stable_step_estimate(world),
            });
        }
        let distance = p.velocity[i].norm().to_f64() * step;
        if distance > cell {
            return Err(StepError::TooFast {
                particle: i,
                interaction: most_strained_interaction(world, i),
                distance,
                cell,
                time: world.time(),
                time_step: step,
                bound: stable_step_estimate(world),
            });
        }
    }
    Ok(())
}

/// How far a particle may move per step in m: a cell if there are contacts; the largest diameter if there are only
/// bonds, since no bond survives that; any distance without interactions.
fn distance_limit<S: Number>(world: &World<S>) -> f64 {
    match (&world.workspace.neighbors, &world.state.bonds) {
        (Some(neighbors), _) => neighbors.cell_side(),
        (None, Some(_)) => 2.0 * world.state.particles.largest_radius(),
        (None, None) => f64::INFINITY,
    }
}

/// Pair of the contact or bond of a particle with the largest force; forces that are not finite count as infinite.
fn most_strained_interaction<S: Number>(world: &World<S>, particle: usize) -> Option<[usize; 2]> {
    let strain = |interaction: &crate::forces::Interaction| {
        let force = interaction.normal_force.abs() + interaction.tangential_force.abs();
        if force.is_finite() {
            force
        } else {
            f64::INFINITY
        }
    };
    let interactions = world.interactions();
    let own = interactions.iter().filter(|interaction| {
        let (i, j) = interaction.pair.indices();
        i == particle || j == particle
    });
    let worst = own.max_by(|a, b| strain(a).total_cmp(&strain(b)))?;
    let (i, j) = worst.pair.indices();
    Some([i, j])
}

/// Estimate of the largest stable time step of a world, in s.
///
/// The estimate is conservative for linear forces and methods whose bound decreases with damping: symplectic Euler
/// and velocity Verlet. The other methods are stable only if every mode is damped, which an upper bound of the
/// damping does not ensure.
///
/// By Gershgorin's theorem, the squared frequency of a mode is at most twice the sum of the stiffnesses acting on
/// a particle divided by its inertia. The same holds for damping. The maxima of both are combined. All pairs of
/// the contact list count as touching.
pub fn stable_step_estimate<S: Number>(world: &World<S>) -> f64 {
    let number = world.state.particles.len();
    let mut stiffness = vec![0.0; number];
    let mut damping = vec![0.0; number];
    let mut add = |(i, j): (usize, usize), k: f64, c: f64| {
        for particle in [i, j] {
            stiffness[particle] += k;
            damping[particle] += c;
        }
    };
    if let (Some(bonds), Some((k, c))) = (&world.state.bonds, bond_constants(&world.model)) {
        bonds
            .pairs
            .iter()
            .for_each(|pair| add(pair.indices(), k, c));
    }
    if let (Some(contacts), Some(laws)) = (&world.state.contacts, world.model.contact) {
        for pair in &contacts.pairs {
            let (i, j) = pair.indices();
            let radii = [
                world.state.particles.radius[i].to_f64(),
                world.state.particles.radius[j].to_f64(),
            ];
            let (k, c) = contact_constants(&laws.normal, &laws.tangential, radii);
            add((i, j), k, c);
        }
    }
    let largest = |sums: &[f64]| {
        let per_mass = sums
            .iter()
            .zip(&world.workspace.inverse_mass)
            .map(|(sum, m)| 2.0 * sum * m.to_f64());
        per_mass.fold(0.0, f64::max)
    };
    let stiffest = Oscillator {
        frequency_squared: largest(&stiffness),
        damping_rate: largest(&damping),
    };
    critical_step(world.model.integrator, stiffest)
}

/// Factor of the tangential stiffness of a contact in units of normal stiffness: the rolling mode of a pair has the
/// squared frequency 7 k / m, the normal mode 2 k / m.
const ROLLING_FACTOR: f64 = 3.5;
/// The same factor for bonds, whose ends are separate springs: the squared frequency is at most 9/2 k / m for any
/// ratio of radii, and 7/2 k / m for equal radii.
const SHEARING_FACTOR: f64 = 2.25;

/// Stiffness in kg/s^2 and damping in kg/s of a bond: the larger of its normal and scaled tangential constants.
fn bond_constants(model: &Model) -> Option<(f64, f64)> {
    let bond = model.bond?;
    let (k, c) = bond
        .tangential
        .map_or((0.0, 0.0), |beam| (beam.stiffness, beam.damping));
    Some((
        bond.normal.stiffness.max(SHEARING_FACTOR * k),
        bond.normal.damping.max(SHEARING_FACTOR * c),
    ))
}

/// Stiffness in kg/s^2 and damping in kg/s of a contact: the larger of its normal and scaled tangential constants.
fn contact_constants(
    normal: &ContactNormal,
    tangential: &Option<ContactTangential>,
    radii: [f64; 2],
) -> (f64, f64) {
    let [k_n, c_n] = normal.constants(radii);
    let [k_t, c_t] = tangential.map_or([0.0; 2], |law| law.constants());
    (k_n.max(ROLLING_FACTOR * k_t), c_n.max(ROLLING_FACTOR * c_t))
}
