//! Stops a run whose state is no longer physical and reports the likely cause.

use super::simulation::{Number, World};
use crate::error::StepError;
use crate::integrators::{Oscillator, critical_step};
use crate::laws::EulerBernoulli;
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
    let mut add = |(i, j): (usize, usize), link: PairConstants| {
        for particle in [i, j] {
            let [k, c] = link.for_mass(world.state.particles.inverse_inertia_factor(particle));
            stiffness[particle] += k;
            damping[particle] += c;
        }
    };
    if let (Some(bonds), Some(bond)) = (&world.state.bonds, bond_constants(&world.model)) {
        bonds
            .pairs
            .iter()
            .for_each(|pair| add(pair.indices(), bond));
    }
    if let (Some(contacts), Some(laws)) = (&world.state.contacts, world.model.contact) {
        for pair in &contacts.pairs {
            let (i, j) = pair.indices();
            let radii = [
                world.state.particles.radius[i].to_f64(),
                world.state.particles.radius[j].to_f64(),
            ];
            let contact = contact_constants(&laws.normal, &laws.tangential, radii);
            add((i, j), contact);
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

/// Stiffness in N/m and damping in kg/s of a contact or bond.
#[derive(Clone, Copy)]
struct PairConstants {
    /// Along the normal.
    normal: [f64; 2],
    /// Along the tangent.
    tangential: [f64; 2],
    /// Rotations that one tangential spring sees at once, of the two.
    shared: f64,
}

impl PairConstants {
    /// The larger of normal and tangential constants, for the mass of a particle with q = m r^2 / J.
    ///
    /// Between equal masses the normal mode has the squared frequency 2 k / m. The spring of a contact sees
    /// both rotations: 2 (1 + q) k / m. The ends of a beam are springs of their own: at most 2 (1 + q/2) k / m
    /// for any ratio of radii, (1 + q) k / m for equal ones.
    fn for_mass(self, inverse_inertia_factor: f64) -> [f64; 2] {
        let share = 1.0 + self.shared * inverse_inertia_factor;
        [0, 1].map(|n| self.normal[n].max(share * self.tangential[n]))
    }
}

/// The constants of a bond.
fn bond_constants(model: &Model) -> Option<PairConstants> {
    let bond = model.bond?;
    let beam = |law: EulerBernoulli| [law.stiffness, law.damping];
    Some(PairConstants {
        normal: [bond.normal.stiffness, bond.normal.damping],
        tangential: bond.tangential.map_or([0.0; 2], beam),
        shared: 0.5,
    })
}

/// The constants of a contact.
fn contact_constants(
    normal: &ContactNormal,
    tangential: &Option<ContactTangential>,
    radii: [f64; 2],
) -> PairConstants {
    PairConstants {
        normal: normal.constants(radii),
        tangential: tangential.map_or([0.0; 2], |law| law.constants()),
        shared: 1.0,
    }
}
