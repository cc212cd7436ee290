//! Stops a run whose state is no longer physical, and reports the likely cause.

use super::simulation::{Number, World};
use crate::error::StepError;
use crate::integrators::{Oscillator, critical_step};
use crate::laws::EulerBernoulli;
use crate::model::{ContactNormal, ContactTangential, Model};

impl<S: Number> World<S> {
    /// Check that the state is finite and that no particle moves farther than a cell per step.
    ///
    /// # Errors
    /// The first particle that violates either.
    pub fn check(&self) -> Result<(), StepError> {
        check(self)
    }
}

fn check<S: Number>(world: &World<S>) -> Result<(), StepError> {
    let p = &world.state.particles;
    let step = world.model.time_step;
    let cell = farthest(world);
    for i in 0..p.len() {
        let is_finite = p.position[i].is_finite()
            && p.velocity[i].is_finite()
            && p.angle[i].is_finite()
            && p.angular_velocity[i].is_finite();
        if !is_finite {
            return Err(StepError::NotFinite {
                particle: i,
                link: most_strained_link(world, i),
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
                link: most_strained_link(world, i),
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

/// How far a particle may move in one step in m: a cell, where there are contacts; with bonds alone
/// the largest diameter, which no bond survives; without links any distance.
fn farthest<S: Number>(world: &World<S>) -> f64 {
    match (&world.workspace.neighbors, &world.state.bonds) {
        (Some(neighbors), _) => neighbors.cell_side(),
        (None, Some(_)) => 2.0 * world.state.particles.largest_radius(),
        (None, None) => f64::INFINITY,
    }
}

/// The link of a particle with the largest force, or one whose force is not even finite.
fn most_strained_link<S: Number>(world: &World<S>, particle: usize) -> Option<[usize; 2]> {
    let strain = |link: &crate::forces::Interaction| {
        let force = link.normal_force.abs() + link.tangential_force.abs();
        if force.is_finite() {
            force
        } else {
            f64::INFINITY
        }
    };
    let links = world.interactions();
    let touching = links.iter().filter(|link| {
        let (i, j) = link.pair.indices();
        i == particle || j == particle
    });
    let worst = touching.max_by(|a, b| strain(a).total_cmp(&strain(b)))?;
    let (i, j) = worst.pair.indices();
    Some([i, j])
}

/// Estimate of the largest stable step of a world in s, on the safe side for linear forces and methods
/// whose bound falls with damping: symplectic Euler and velocity Verlet. The others need damping in every
/// mode to be stable at all, which a bound from above does not see.
///
/// By Gershgorin's theorem no mode is stiffer than twice the sum of the stiffnesses on one particle
/// over its inertia; the same holds for damping. The largest of both are taken together. Contacts count
/// as if every pair near enough to touch did.
pub fn stable_step_estimate<S: Number>(world: &World<S>) -> f64 {
    let number = world.state.particles.len();
    let mut stiffness = vec![0.0; number];
    let mut damping = vec![0.0; number];
    let mut add = |(i, j): (usize, usize), link: LinkConstants| {
        for particle in [i, j] {
            let [k, c] = link.for_mass(world.state.particles.ease_of_turning(particle));
            stiffness[particle] += k;
            damping[particle] += c;
        }
    };
    if let (Some(strong), Some(bond)) = (&world.state.bonds, bond_constants(&world.model)) {
        strong
            .pairs
            .iter()
            .for_each(|pair| add(pair.indices(), bond));
    }
    if let (Some(weak), Some(contact)) = (&world.state.contacts, world.model.contact) {
        for pair in &weak.pairs {
            let (i, j) = pair.indices();
            let radii = [
                world.state.particles.radius[i].to_f64(),
                world.state.particles.radius[j].to_f64(),
            ];
            let link = contact_constants(&contact.normal, &contact.tangential, radii);
            add((i, j), link);
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
        stiffness: largest(&stiffness),
        damping: largest(&damping),
    };
    critical_step(world.model.integrator, stiffest)
}

/// Stiffness in N/m and damping in kg/s of a link.
#[derive(Clone, Copy)]
struct LinkConstants {
    /// Along the normal.
    normal: [f64; 2],
    /// Along the tangent.
    tangential: [f64; 2],
    /// Rotations that one tangential spring sees at once, of the two.
    shared: f64,
}

impl LinkConstants {
    /// The larger of normal and tangential constants, for the mass of a particle with q = m r^2 / J.
    ///
    /// Between equal masses the normal mode has the squared frequency 2 k / m. The spring of a contact sees
    /// both rotations: 2 (1 + q) k / m. The ends of a beam are springs of their own: at most 2 (1 + q/2) k / m
    /// for any ratio of radii, (1 + q) k / m for equal ones.
    fn for_mass(self, ease_of_turning: f64) -> [f64; 2] {
        let share = 1.0 + self.shared * ease_of_turning;
        [0, 1].map(|n| self.normal[n].max(share * self.tangential[n]))
    }
}

/// The constants of a bond.
fn bond_constants(model: &Model) -> Option<LinkConstants> {
    let bond = model.bond?;
    let beam = |law: EulerBernoulli| [law.stiffness, law.damping];
    Some(LinkConstants {
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
) -> LinkConstants {
    LinkConstants {
        normal: normal.constants(radii),
        tangential: tangential.map_or([0.0; 2], |law| law.constants()),
        shared: 1.0,
    }
}
