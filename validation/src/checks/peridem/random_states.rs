//! Random states of grains: numbers or a typed error, never a panic.

use super::grains::{MATERIAL, grain};
use crate::checks::random::Random;
use crate::checks::{
    Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, peridem,
};
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::error::StepError;
use gouge_peridem::forces::{Settings, Walls};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{Material, Weight};
use gouge_peridem::state::State;
use gouge_peridem::wall_law::{WallLaw, WallReading};
use gouge_peridem::world::{Beginning, World};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

pub fn checks() -> Vec<Check> {
    let check = |id, scene, effort, measure| Check {
        id,
        claim: "Grains in any state are evaluated without a panic and with finite forces and energies; their steps end with numbers or a typed error.",
        equations: peridem("(2.1), (3.1), (3.2), (4.1)-(4.8), section 6.1"),
        scene,
        oracle: "Every number is finite, energies are not negative, and where no wall and no printed reading acts the sum of all forces vanishes",
        norm: "Number of violations; a panic fails the check by itself",
        origin: Origin::Exact,
        reason: "No violation is allowed; a sum of forces may differ from zero by 1e-10 of the sum of their sizes, which is a million roundings",
        effort,
        measure,
    };
    vec![
        check(
            "peridem.extremes.random",
            "1e4 random states of two grains of six nodes: sizes from 1e-9 to 1e3 m, moduli from 1e3 to 1e13 Pa, densities from 1 to 2e4 kg/m^3, areas that differ by up to 1e6, speeds up to 1e4 m/s, displacements up to 1000 cells, nodes at one place and on walls, all weights, rules and readings; one in eight makes four steps",
            Effort::Thorough,
            || run_cases(10_000),
        ),
        check(
            "peridem.extremes.random-million",
            "1e6 random states of the same kind",
            Effort::Report,
            || run_cases(1_000_000),
        ),
    ]
}

/// Number of nodes of a grain.
const NODES: usize = 6;
/// One state in so many is stepped.
const STEPPED: u64 = 8;

/// What the two grains of a case share.
struct Draw {
    random: Random,
    side: f64,
    material: Material,
    weight: Weight,
}

impl Draw {
    fn new(case: u64) -> Self {
        let mut random = Random::new(case);
        Self {
            side: random.magnitude(1e-9, 1e3),
            material: Material {
                young_modulus: random.magnitude(1e3, 1e13),
                fracture_energy: random.magnitude(1e-6, 1e6),
                density: random.magnitude(1.0, 2e4),
                ..MATERIAL
            },
            weight: random.choice(&[Weight::Constant, Weight::Conic, Weight::Parabolic]),
            random,
        }
    }

    fn vector(&mut self, size: f64) -> Vec2 {
        let mut part = || self.random.between(-size, size);
        Vec2::new(part(), part())
    }

    fn grain(&mut self, shift: f64) -> Result<Grain, Failure> {
        let horizon = self.side * self.random.between(1.0, 4.0);
        let constants = self.material.bond_constants(self.weight, horizon)?;
        let constant = self.material.bond_constants(Weight::Constant, horizon)?;
        let mut place = |k: usize| {
            let cell = Vec2::new((k % 3) as f64 + shift, (k / 3) as f64);
            (cell + self.vector(0.4)) * self.side
        };
        let position = (0..NODES).map(&mut place).collect();
        let cell = self.side * self.side;
        let area = (0..NODES).map(|_| cell * self.random.magnitude(1e-6, 1.0));
        let mut one = grain(position, area.collect(), constants);
        one.density = self.material.density;
        one.contact_stiffness = constant.stiffness;
        let rules = [BreakingRule::TensionOnly, BreakingRule::TwoSided].map(Some);
        one.breaking = self.random.choice(&[None, rules[0], rules[1]]);
        one.touches_itself = self.random.choice(&[true, false]);
        Ok(one)
    }

    fn settings(&mut self) -> Result<Settings, Failure> {
        let radius = 1.5 * self.side;
        let constants = self
            .material
            .bond_constants(Weight::Constant, 3.0 * self.side)?;
        let stiffness = constants.stiffness / radius;
        let period = self.side * (self.material.density / self.material.young_modulus).sqrt();
        let random = &mut self.random;
        let law = ContactLaw {
            radius,
            damping_ratio: random.between(0.0, 1.0),
            friction: random.between(0.0, 2.0),
            reading: random.choice(&[
                ContactReading::Symmetric,
                ContactReading::OneSided,
                ContactReading::Authors,
                ContactReading::Printed,
            ]),
        };
        let walls = WallLaw {
            radius,
            stiffness,
            damping_ratio: random.between(0.0, 1.0),
            friction: random.between(0.0, 2.0),
            reading: random.choice(&[
                WallReading::Paper,
                WallReading::Exact,
                WallReading::TwoFixes,
                WallReading::Authors,
            ]),
        };
        let walls = Walls {
            law: walls,
            velocity: [0.0, -1.0, 0.0, 1.0],
        };
        Ok(Settings {
            time_step: period * random.magnitude(1e-6, 1.0),
            gravity: Vec2::zero(),
            break_order: random.choice(&[BreakOrder::BreakFirst, BreakOrder::ForceFirst]),
            contact: Some(Contact {
                law,
                stiffness: vec![vec![stiffness]],
                shares_sticking: random.choice(&[true, false]),
            }),
            walls: random.choice(&[true, false]).then_some(walls),
        })
    }

    /// Displace and throw nodes: a little, far, onto each other, or onto the wall on the left.
    fn disturb(&mut self, state: &mut State) {
        let displacement = self.random.choice(&[0.0, 1e-9, 0.1, 1.0, 1e3]) * self.side;
        let speed = self.random.choice(&[0.0, 1e-6, 1.0, 1e4]);
        state.walls = [-2.0, 9.0, 6.0, -2.0].map(|place| place * self.side);
        for node in 0..state.places.len() {
            state.places[node].displacement = self.vector(displacement);
            state.velocity[node] = self.vector(speed);
        }
        if self.random.choice(&[true, false, false]) {
            for node in [1, 4, NODES, NODES + 3] {
                let arm = state.places[node].to(state.places[0]);
                state.places[node].displacement += arm;
            }
        }
        if self.random.choice(&[true, false, false]) {
            let place = &mut state.places[2];
            place.displacement.x = state.walls[0] - place.reference.x;
        }
    }

    fn world(&mut self) -> Result<World, Failure> {
        let grains = [self.grain(0.0)?, self.grain(3.5)?];
        let grains = Grains::new(&grains)?;
        let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
        let mut state = State::at_rest(&grains, bonds);
        self.disturb(&mut state);
        let settings = self.settings()?;
        Ok(World::new(grains, settings, state, Beginning::Forces)?)
    }
}

/// The outcome of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Evaluated,
    Stepped,
    NotFinite,
    BehindWall,
    Refused,
    Wrong,
}

const ENDS: [(End, &str); 6] = [
    (End::Evaluated, "evaluated"),
    (End::Stepped, "finite after four steps"),
    (End::NotFinite, "stopped: not finite"),
    (End::BehindWall, "stopped: behind a wall"),
    (End::Refused, "refused"),
    (End::Wrong, "wrong"),
];

fn has_numbers(world: &World) -> bool {
    let state = world.state();
    let energies = world.energies();
    let sums = [energies.kinetic, energies.bonds, energies.contacts];
    state
        .places
        .iter()
        .all(|place| place.displacement.is_finite())
        && state.velocity.iter().all(|velocity| velocity.is_finite())
        && state.acceleration.iter().all(|one| one.is_finite())
        && sums.iter().all(|sum| sum.is_finite() && *sum >= 0.0)
}

/// Whether forces between nodes, which are all there are, add up to zero.
fn is_balanced(world: &World) -> bool {
    let (grains, settings) = (world.grains(), world.settings());
    let contact = settings.contact.as_ref();
    let is_symmetric = contact.is_none_or(|one| one.law.reading == ContactReading::Symmetric);
    if settings.walls.is_some() || !is_symmetric {
        return true;
    }
    let accelerations = world.state().acceleration.iter().enumerate();
    let (mut sum, mut sizes) = (Vec2::zero(), 0.0);
    for (node, &acceleration) in accelerations {
        let force = acceleration * grains.mass(node);
        sum += force;
        sizes += force.norm();
    }
    sum.norm() <= 1e-10 * sizes
}

fn outcome(case: u64) -> End {
    let Ok(mut world) = Draw::new(case).world() else {
        return End::Refused;
    };
    if !has_numbers(&world) || !is_balanced(&world) {
        return End::Wrong;
    }
    if !case.is_multiple_of(STEPPED) {
        return End::Evaluated;
    }
    match (0..4).find_map(|_| world.step().err()) {
        Some(StepError::NotFinite { .. }) => End::NotFinite,
        Some(StepError::BehindWall { .. }) => End::BehindWall,
        None if has_numbers(&world) => End::Stepped,
        // Worlds do not stop fast nodes unless asked.
        Some(StepError::TooFast { .. }) | None => End::Wrong,
    }
}

fn run_cases(cases: u64) -> Outcome {
    let ends: Vec<End> = (0..cases).into_par_iter().map(outcome).collect();
    let count = |wanted: End| ends.iter().filter(|&&end| end == wanted).count();
    let mut table = Table::new("Outcomes of random states", &["outcome", "states"]);
    for (end, name) in ENDS {
        table.push([name.to_owned(), count(end).to_string()]);
    }
    let wrong = count(End::Wrong) + count(End::Refused);
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}
