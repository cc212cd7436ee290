//! Watches the balance of energy of a run.

use crate::run::bytes::{Reader, put_words};
use gouge_common::geometry::Vec2;
use gouge_peridem::world::World;
use std::ops::Range;

/// Terms of the balance of energy, in J per metre of depth.
pub const ENERGY: [&str; 9] = [
    "kinetic",
    "bond",
    "contact",
    "external",
    "wall_work",
    "damping",
    "friction",
    "breaking",
    "residual",
];
/// Number of terms without the residual.
const TERMS: usize = ENERGY.len() - 1;
/// Residual that rounding may cause, in parts of the largest energy.
const ROUNDING: f64 = 1e-9;

/// What the samples so far say about the balance of energy; all energies in J per metre of depth.
///
/// The residual is compared with what was exchanged. That is the largest sum of heat, work, and changes of the energy
/// of bonds and contacts, and for each grain the kinetic energy of half of the largest change of its motion between
/// samples that gravity does not explain: what a grain that rebounds gives and gets back. So neither a common motion of
/// everything nor grains that fly past hide an error in the contacts of others.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Balance {
    /// Terms at t = 0.
    beginning: [f64; TERMS],
    /// Largest magnitude of the residual.
    residual: f64,
    /// Largest magnitude of a term.
    magnitude: f64,
    /// Largest sum of the changes of all terms that a free flight does not change.
    exchanged: f64,
    /// Time of the latest sample in s.
    time: f64,
    /// What the samples say of every grain.
    motions: Vec<Motion>,
}

/// What the samples so far say about the motion of a grain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Motion {
    /// Velocity in m/s and angular velocity in rad/s in the latest sample.
    latest: [f64; 3],
    /// Largest kinetic energy of half of a change between samples.
    change: f64,
}

impl Balance {
    /// The balance at the beginning.
    pub fn new(world: &World) -> Self {
        Self {
            beginning: energies(world),
            motions: bodies(world)
                .map(|body| Motion {
                    latest: body.motion,
                    change: 0.0,
                })
                .collect(),
            ..Self::default()
        }
    }

    /// All terms of a state by their names.
    pub fn terms(&self, world: &World) -> [(&'static str, f64); ENERGY.len()] {
        let now = energies(world);
        let residual = total(&now) - total(&self.beginning);
        std::array::from_fn(|k| (ENERGY[k], *now.get(k).unwrap_or(&residual)))
    }

    /// Take note of a sample and its terms.
    pub fn add(&mut self, world: &World, terms: &[(&'static str, f64); ENERGY.len()]) {
        let [now @ .., residual] = terms.map(|(_, energy)| energy);
        let [_, bond, contact, external, heat_and_work @ ..] = self.changes_to(&now);
        let exchanged = bond + contact + heat_and_work.iter().sum::<f64>();
        let work_of_loads = match world.grains().load.is_empty() {
            true => 0.0,
            false => external,
        };
        self.exchanged = self.exchanged.max(exchanged + work_of_loads);
        self.magnitude = now
            .iter()
            .fold(self.magnitude, |all, term| all.max(term.abs()));
        self.look_at_motions(world);
        let is_nan = residual.is_nan() || self.residual.is_nan();
        self.residual = match is_nan {
            true => f64::NAN,
            false => self.residual.max(residual.abs()),
        };
    }

    fn changes_to(&self, now: &[f64; TERMS]) -> [f64; TERMS] {
        std::array::from_fn(|k| (now[k] - self.beginning[k]).abs())
    }

    fn look_at_motions(&mut self, world: &World) {
        let fall = world.settings().gravity * (world.time() - self.time);
        for (body, motion) in bodies(world).zip(&mut self.motions) {
            let [x, y, turn] = std::array::from_fn(|k| body.motion[k] - motion.latest[k]);
            let half = [x - fall.x, y - fall.y, turn].map(|change| 0.5 * change);
            motion.change = motion.change.max(body.energy(half));
            motion.latest = body.motion;
        }
        self.time = world.time();
    }

    /// The largest residual in parts of the energy exchanged; zero if rounding explains it.
    pub fn error(&self) -> f64 {
        match self.residual <= ROUNDING * self.magnitude {
            true => 0.0,
            false => self.residual / self.scale(),
        }
    }

    /// The energy exchanged.
    fn scale(&self) -> f64 {
        self.exchanged + self.motions.iter().map(|motion| motion.change).sum::<f64>()
    }

    /// Append the balance to the bytes of a checkpoint.
    pub fn put(&self, bytes: &mut Vec<u8>) {
        let numbers = [self.residual, self.magnitude, self.exchanged, self.time];
        put_words(bytes, &self.beginning.map(f64::to_bits));
        put_words(bytes, &numbers.map(f64::to_bits));
        put_words(bytes, &[self.motions.len() as u64]);
        for motion in &self.motions {
            let [x, y, turn] = motion.latest;
            put_words(bytes, &[x, y, turn, motion.change].map(f64::to_bits));
        }
    }

    /// Read the balance that [`Balance::put`] wrote.
    pub fn read(bytes: &mut Reader) -> Option<Self> {
        let beginning = bytes.array()?.map(f64::from_bits);
        let numbers = bytes.array()?.map(f64::from_bits);
        let [residual, magnitude, exchanged, time] = numbers;
        let number = bytes.word()?;
        let words = bytes.words(number.checked_mul(4)?)?;
        let (words, _) = words.as_chunks::<4>();
        let motion = |words: &[u64; 4]| {
            let [x, y, turn, change] = words.map(f64::from_bits);
            Motion {
                latest: [x, y, turn],
                change,
            }
        };
        Some(Self {
            beginning,
            residual,
            magnitude,
            exchanged,
            time,
            motions: words.iter().map(motion).collect(),
        })
    }
}

/// All terms of the balance but the residual.
fn energies(world: &World) -> [f64; TERMS] {
    let (energies, work) = (world.energies(), world.state().work);
    [
        energies.kinetic,
        energies.bonds,
        energies.contacts,
        energies.external,
        work.walls,
        work.damping,
        work.friction,
        work.broken,
    ]
}

/// What stays the same: the energy stored and lost, without the work of walls.
fn total(terms: &[f64; TERMS]) -> f64 {
    let [kinetic, bond, contact, external, walls, lost @ ..] = terms;
    kinetic + bond + contact + external + lost.iter().sum::<f64>() - walls
}

/// A grain as if it were rigid.
struct Body {
    mass: f64,
    moment_of_inertia: f64,
    /// Velocity in m/s and angular velocity in rad/s.
    motion: [f64; 3],
}

impl Body {
    fn energy(&self, [x, y, turn]: [f64; 3]) -> f64 {
        0.5 * (self.mass * (x * x + y * y) + self.moment_of_inertia * turn * turn)
    }
}

fn bodies(world: &World) -> impl Iterator<Item = Body> + '_ {
    let nodes = world.grains().rows.iter().map(|row| row.nodes.clone());
    nodes.map(|nodes| body(world, nodes))
}

/// The motion of some nodes as if they were one rigid body: their momentum and their angular momentum.
fn body(world: &World, nodes: Range<usize>) -> Body {
    let (grains, state) = (world.grains(), world.state());
    let (mass, place) = (
        |node| grains.mass(node),
        |node: usize| state.places[node].position(),
    );
    let total: f64 = nodes.clone().map(mass).sum();
    let mean = |of: &dyn Fn(usize) -> Vec2| {
        let sum = nodes
            .clone()
            .fold(Vec2::zero(), |sum, node| sum + of(node) * mass(node));
        sum * (1.0 / total)
    };
    let (centre, velocity) = (mean(&place), mean(&|node| state.velocity[node]));
    let (mut inertia, mut spin) = (0.0, 0.0);
    for node in nodes.clone() {
        let arm = place(node) - centre;
        inertia += mass(node) * arm.norm_squared();
        spin += mass(node) * arm.cross(state.velocity[node] - velocity);
    }
    let turn = if inertia > 0.0 { spin / inertia } else { 0.0 };
    Body {
        mass: total,
        moment_of_inertia: inertia,
        motion: [velocity.x, velocity.y, turn],
    }
}
