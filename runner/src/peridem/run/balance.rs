//! Watches the balance of energy of a run.

use crate::run::bytes::{Reader, put_words};
use gouge_common::geometry::Vec2;
use gouge_peridem::grain::GrainRow;
use gouge_peridem::world::{Beginning, World};
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
const ROUNDING: f64 = 1e-12;
/// Part of the energy of relative motion that counts as exchanged, because a rebound may pass unseen between two samples.
const UNSEEN: f64 = 1e-4;
/// Number of steps up to which an exchange counts more than once. A method that begins with a step of first order has a
/// residual of 1 / n of its energy after n steps.
const EARLY: f64 = 40.0;

/// What the samples so far say about the balance of energy; all energies in J per metre of depth.
///
/// The residual is compared with what was exchanged. That is the largest sum of heat, work, and changes of the energy
/// of bonds and contacts, and for each grain the kinetic energy of half of the largest change of its momentum and angular
/// momentum between samples that gravity does not explain: what a grain that rebounds gives and gets back. So neither a
/// common motion of everything nor grains that fly past hide an error in the contacts of others.
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
    /// Largest exchange over the number of steps, in which everything counts if the first acceleration is not that of forces.
    early: f64,
    /// Largest kinetic energy of motion relative to walls and clamps, or to the common motion if there are none.
    relative: f64,
    /// Largest energy that damping and friction gave to the grains, which takes wrong signs.
    gained: f64,
    /// Time of the latest sample in s.
    time: f64,
    /// What the samples say of every grain.
    motions: Vec<Motion>,
}

/// What the samples so far say about the motion of a grain.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Motion {
    /// Momentum in kg/s and angular momentum in kg m/s about the centre, per metre of depth, in the latest sample.
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
                    latest: body.momenta,
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

    /// Take note of a sample and its terms, of a world with a beginning.
    pub fn add(
        &mut self,
        world: &World,
        beginning: Beginning,
        terms: &[(&'static str, f64); ENERGY.len()],
    ) {
        let [now @ .., residual] = terms.map(|(_, energy)| energy);
        let [kinetic, bond, contact, external, walls, _, _, breaking] = self.changes_to(&now);
        let [.., damping, friction, _] = now;
        // Energy out of nothing is no exchange.
        let heat = damping.max(0.0) + friction.max(0.0);
        let exchanged = bond + contact + walls + heat + breaking;
        let late = match beginning {
            Beginning::Forces => 0.0,
            Beginning::Given => kinetic + external,
        };
        let steps = world.state().steps.max(1) as f64;
        let largest = |all: f64, term: &f64| all.max(term.abs());
        self.gained = self.gained.max(-(damping + friction));
        self.exchanged = self.exchanged.max(exchanged + work_of_loads(world).abs());
        self.early = self.early.max((exchanged + late) / steps);
        self.relative = self.relative.max(relative_motion(world, now[0]));
        self.magnitude = now.iter().fold(self.magnitude, largest);
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

    /// Grains that rest, hold on to clamps or fall freely exchange nothing.
    fn look_at_motions(&mut self, world: &World) {
        let fall = world.settings().gravity * (world.time() - self.time);
        let clamped = &world.grains().clamped;
        let is_held = |row: &GrainRow| {
            let first = clamped.partition_point(|&node| (node as usize) < row.nodes.start);
            let found = clamped.get(first);
            found.is_some_and(|&node| row.nodes.contains(&(node as usize)))
        };
        let grains = world.grains().rows.iter().zip(bodies(world));
        for ((row, body), motion) in grains.zip(&mut self.motions) {
            let [x, y, turn] = std::array::from_fn(|k| body.momenta[k] - motion.latest[k]);
            let of_fall = fall * body.mass;
            let changes = [[x, y, turn], [x - of_fall.x, y - of_fall.y, turn]];
            let energies = changes.map(|change| body.energy(change.map(|change| 0.5 * change)));
            if !is_held(row) {
                motion.change = motion.change.max(energies[0].min(energies[1]));
            }
            motion.latest = body.momenta;
        }
        self.time = world.time();
    }

    /// The largest residual in parts of the energy exchanged; zero if rounding explains it.
    pub fn error(&self) -> f64 {
        match () {
            () if !(self.residual.is_finite() && self.magnitude.is_finite()) => f64::NAN,
            () if self.residual <= ROUNDING * self.magnitude => 0.0,
            () => self.residual / self.scale(),
        }
    }

    /// The energy that damping and friction gave to the grains, in parts of the energy exchanged; positive only if
    /// their signs are wrong.
    pub fn gain(&self) -> f64 {
        match self.gained <= ROUNDING * self.magnitude {
            true => 0.0,
            false => self.gained / self.scale(),
        }
    }

    /// The energy exchanged.
    fn scale(&self) -> f64 {
        let rebounds: f64 = self.motions.iter().map(|motion| motion.change).sum();
        self.exchanged + rebounds + EARLY * self.early + UNSEEN * self.relative
    }

    /// Append the balance to the bytes of a checkpoint.
    pub fn put(&self, bytes: &mut Vec<u8>) {
        let numbers = [
            self.residual,
            self.magnitude,
            self.exchanged,
            self.early,
            self.relative,
            self.gained,
            self.time,
        ];
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
        let [
            residual,
            magnitude,
            exchanged,
            early,
            relative,
            gained,
            time,
        ] = numbers;
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
            early,
            relative,
            gained,
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

/// Work of loads since the beginning, without that of gravity.
fn work_of_loads(world: &World) -> f64 {
    let (grains, places) = (world.grains(), &world.state().places);
    let loads = grains.load.iter().zip(&grains.area).zip(places);
    loads
        .map(|((load, area), place)| area * load.dot(place.displacement))
        .sum()
}

/// A grain as if it were rigid.
struct Body {
    mass: f64,
    moment_of_inertia: f64,
    /// Momentum in kg/s and angular momentum in kg m/s about the centre, per metre of depth.
    momenta: [f64; 3],
}

impl Body {
    /// Kinetic energy with some momentum and angular momentum.
    fn energy(&self, [x, y, turn]: [f64; 3]) -> f64 {
        let spin = match self.moment_of_inertia > 0.0 {
            true => turn * turn / self.moment_of_inertia,
            false => 0.0,
        };
        0.5 * ((x * x + y * y) / self.mass + spin)
    }
}

fn bodies(world: &World) -> impl Iterator<Item = Body> + '_ {
    let nodes = world.grains().rows.iter().map(|row| row.nodes.clone());
    nodes.map(|nodes| body(world, nodes))
}

/// The motion of some nodes as if they were one rigid body.
fn body(world: &World, nodes: Range<usize>) -> Body {
    let (grains, state) = (world.grains(), world.state());
    let mass = |node| grains.mass(node);
    let place = |node: usize| state.places[node].position();
    let total: f64 = nodes.clone().map(mass).sum();
    let sum = |of: &dyn Fn(usize) -> Vec2| {
        let terms = nodes.clone().map(|node| of(node) * mass(node));
        terms.fold(Vec2::zero(), |sum, term| sum + term)
    };
    let (centre, momentum) = (
        sum(&place) * (1.0 / total),
        sum(&|node| state.velocity[node]),
    );
    let velocity = momentum * (1.0 / total);
    let (mut inertia, mut spin) = (0.0, 0.0);
    for node in nodes.clone() {
        let arm = place(node) - centre;
        inertia += mass(node) * arm.norm_squared();
        spin += mass(node) * arm.cross(state.velocity[node] - velocity);
    }
    Body {
        mass: total,
        moment_of_inertia: inertia,
        momenta: [momentum.x, momentum.y, spin],
    }
}

/// Kinetic energy relative to walls and clamps, or to the common motion if there are none, of all kinetic energy.
fn relative_motion(world: &World, kinetic: f64) -> f64 {
    let mut walls = world.state().walls.iter();
    let is_held = walls.any(|position| position.is_finite());
    if is_held || !world.grains().clamped.is_empty() {
        return kinetic;
    }
    let common = body(world, 0..world.grains().nodes());
    let [x, y, _] = common.momenta;
    kinetic - common.energy([x, y, 0.0])
}
