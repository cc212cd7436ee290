//! Stops a run whose state is no longer physical and reports the likely cause.

use super::choice::NormalChoice;
use super::simulation::{Number, World};
use crate::error::StepError;
use crate::forces::reduced_mass;
use crate::integrators::{Oscillator, critical_step, is_stable_below};
use crate::laws::EulerBernoulli;
use crate::model::{ContactLaws, Model};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;

impl<S: Number, N: NormalChoice<S>> World<S, N> {
    /// Check that the state is finite and that no particle moves so far per step that it may miss a contact.
    ///
    /// Two particles that meet head-on overlap along 2 (r_i + r_j) of their relative way, and miss each other only if
    /// a step is longer. None is as long as each particle moves by at most its diameter relative to the mean
    /// velocity of all. A cloud may thus move at any speed, and so may a single particle.
    ///
    /// # Errors
    /// The first particle that is not finite, or else the one that moves too far by the largest factor.
    pub fn check(&self) -> Result<(), StepError> {
        check(self)
    }
}

fn check<S: Number, N: NormalChoice<S>>(world: &World<S, N>) -> Result<(), StepError> {
    let p = &world.state.particles;
    let step = world.model.time_step;
    let is_finite = |i: &usize| {
        p.position[*i].is_finite()
            && p.velocity[*i].is_finite()
            && p.angle[*i].is_finite()
            && p.angular_velocity[*i].is_finite()
    };
    if let Some(i) = (0..p.len()).find(|i| !is_finite(i)) {
        return Err(StepError::NotFinite {
            particle: i,
            interaction: most_strained_interaction(world, i),
            time: world.time(),
            steps: world.state.steps,
            time_step: step,
            bound: lowest_estimate(world),
        });
    }
    let limits = Limits::new(world);
    let distance = |i: usize| (p.velocity[i] - limits.common).norm().to_f64() * step;
    let limit = |i: usize| limits.diameter.unwrap_or(2.0 * p.radius[i].to_f64());
    if !(0..p.len()).any(|i| distance(i) > limit(i)) {
        return Ok(());
    }
    // The one that moves farthest for its size: it may have moved the mean that others are compared with.
    let excess = |i: usize| distance(i) / limit(i);
    let farther = |i, j| if excess(j) > excess(i) { j } else { i };
    let particle = (0..p.len()).reduce(farther).unwrap_or_default();
    Err(StepError::TooFast {
        particle,
        interaction: most_strained_interaction(world, particle),
        distance: distance(particle),
        limit: limit(particle),
        time: world.time(),
        time_step: step,
        bound: lowest_estimate(world),
    })
}

/// How far particles may move per step.
struct Limits<S> {
    /// The velocity in m/s relative to which they move.
    common: Vec2<S>,
    /// The limit in m for all particles; `None` if it is the diameter of each.
    diameter: Option<f64>,
}

impl<S: Number> Limits<S> {
    /// With contacts, each particle may move by its diameter; with bonds only by the largest one, since no bond
    /// survives that; without interactions by any distance.
    fn new<N>(world: &World<S, N>) -> Self {
        let particles = &world.state.particles;
        if world.state.contacts.is_some() {
            let share = S::from_f64(1.0 / particles.len().max(1) as f64);
            // Summed by shares, so that the sum of finite velocities is finite.
            let add = |sum: Vec2<S>, &velocity: &Vec2<S>| sum + velocity * share;
            return Self {
                common: particles.velocity.iter().fold(Vec2::zero(), add),
                diameter: None,
            };
        }
        let bonded = world
            .state
            .bonds
            .as_ref()
            .map(|_| 2.0 * particles.largest_radius());
        Self {
            common: Vec2::zero(),
            diameter: Some(bonded.unwrap_or(f64::INFINITY)),
        }
    }
}

/// Pair of the contact or bond of a particle with the largest force; forces that are not finite count as infinite.
fn most_strained_interaction<S: Number, N: NormalChoice<S>>(
    world: &World<S, N>,
    particle: usize,
) -> Option<[usize; 2]> {
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
/// a particle divided by its inertia. The same holds for damping. The maxima of both are combined. Contacts that begin
/// later are not in it.
pub fn stable_step_estimate<S: Number, N: NormalChoice<S>>(world: &World<S, N>) -> f64 {
    let stiffest = stiffest(world, &world.touching_pairs());
    critical_step(world.model.integrator, stiffest)
}

/// Whether the time step of a world is surely stable: below [`stable_step_estimate`], but found much faster.
pub fn is_surely_stable<S: Number, N: NormalChoice<S>>(world: &World<S, N>) -> bool {
    let stiffest = stiffest(world, &world.touching_pairs());
    is_stable_below(world.model.integrator, stiffest, world.model.time_step)
}

/// The same if all near pairs touched, as they may have done before they flew apart.
fn lowest_estimate<S: Number, N: NormalChoice<S>>(world: &World<S, N>) -> f64 {
    let contacts = world.state.contacts.as_ref();
    let stiffest = stiffest(world, contacts.map_or(&[], |contacts| &contacts.pairs));
    critical_step(world.model.integrator, stiffest)
}

/// An oscillator at least as stiff and as damped as every mode.
fn stiffest<S: Number, N: NormalChoice<S>>(world: &World<S, N>, touching: &[Pair]) -> Oscillator {
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
    if let Some(laws) = world.model.contact {
        for pair in touching {
            let (i, j) = pair.indices();
            let radii = [
                world.state.particles.radius[i].to_f64(),
                world.state.particles.radius[j].to_f64(),
            ];
            let masses = [i, j].map(|end| world.workspace.inverse_mass[end].to_f64());
            add(
                (i, j),
                contact_constants::<S, N>(&laws, radii, reduced_mass(masses)),
            );
        }
    }
    let largest = |sums: &[f64]| {
        let per_mass = sums
            .iter()
            .zip(&world.workspace.inverse_mass)
            .map(|(sum, m)| 2.0 * sum * m.to_f64());
        per_mass.fold(0.0, f64::max)
    };
    Oscillator {
        frequency_squared: largest(&stiffness),
        damping_rate: largest(&damping),
    }
}

/// Stiffness in N/m and damping in kg/s of a contact or bond.
#[derive(Clone, Copy)]
pub(super) struct PairConstants {
    /// Along the normal.
    pub normal: [f64; 2],
    /// Along the tangent.
    pub tangential: [f64; 2],
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
pub(super) fn bond_constants<N>(model: &Model<N>) -> Option<PairConstants> {
    let bond = model.bond?;
    let beam = |law: EulerBernoulli| [law.stiffness, law.damping];
    Some(PairConstants {
        normal: [bond.normal.stiffness, bond.normal.damping],
        tangential: bond.tangential.map_or([0.0; 2], beam),
        shared: 0.5,
    })
}

/// The constants of a contact.
pub(super) fn contact_constants<S: Number, N: NormalChoice<S>>(
    laws: &ContactLaws<N>,
    radii: [f64; 2],
    reduced_mass: f64,
) -> PairConstants {
    PairConstants {
        normal: laws.normal.linearised(radii, reduced_mass),
        tangential: laws.tangential.map_or([0.0; 2], |law| law.constants()),
        shared: 1.0,
    }
}
