//! Stiff, soft, tiny and huge grains: results do not depend on the units.

use super::grains::{MATERIAL, block};
use crate::checks::{
    Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, peridem,
};
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::{Settings, Walls};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::limits::Limits;
use gouge_peridem::material::{Material, Weight};
use gouge_peridem::state::State;
use gouge_peridem::wall_law::{WallLaw, WallReading};
use gouge_peridem::world::{Beginning, World};

pub fn checks() -> Vec<Check> {
    let check = |id, scene, norm, reason, measure| Check {
        id,
        claim: "The motion of grains in natural units does not depend on their size, density and stiffness: the same bonds break, and all numbers are finite.",
        equations: peridem("(2.1), (3.1), (3.2), (4.1)-(4.8), section 6.1"),
        scene,
        oracle: "Similarity: lengths by L, densities by D, moduli by E and times by L sqrt(D/E) change all equations by the same factors",
        norm,
        origin: Origin::Exact,
        reason,
        effort: Effort::Quick,
        measure,
    };
    vec![
        check(
            "peridem.extremes.binary-units",
            "Two blocks with damping, friction, self contact, breaking and walls, 150 steps; areas of neighbours differ by a million, three nodes start at one place, others on a wall; at 20, 1000 and 1e4 m/s. Sizes from 2e-9 to 1e3 m, densities from 1.2 to 2e4 kg/m^3, moduli from 1e3 to 2e13 Pa, by powers of two",
            "Number of displacements, velocities, energies and limits that differ in any bit, of runs with other bonds, and of numbers that are not finite",
            "Multiplication by powers of two does not round",
            binary_units,
        ),
        check(
            "peridem.extremes.any-units",
            "The same at 20 m/s for 40 steps, with factors that are not powers of two: sizes from 1e-9 to 1e3 m, densities from 1 to 2e4 kg/m^3, moduli from 1e3 to 1e13 Pa",
            "Largest difference of a displacement or velocity in natural units, of the largest one; number of runs with other bonds",
            "40 steps with forces whose terms are up to 30 times their sum round by 1e-16 each: 1e-13, times ten for nodes that touch, which part exponentially: 1e-12",
            any_units,
        ),
    ]
}

/// Units in which a scene is computed.
#[derive(Clone, Copy, Debug)]
struct Units {
    length: f64,
    density: f64,
    modulus: f64,
}

impl Units {
    const SI: Self = Self {
        length: 1.0,
        density: 1.0,
        modulus: 1.0,
    };

    fn time(self) -> f64 {
        self.length * (self.density / self.modulus).sqrt()
    }

    fn velocity(self) -> f64 {
        (self.modulus / self.density).sqrt()
    }

    /// Energy per depth.
    fn energy(self) -> f64 {
        self.modulus * self.length * self.length
    }
}

/// Side of a cell in m.
const SIDE: f64 = 2e-4;
/// Contact radius in m.
const RADIUS: f64 = 3e-4;
/// Distance in m that the upper block moves in a step.
const STEP: f64 = 4e-7;

/// Blocks above each other, with areas of 1e-6 of a cell among those of whole ones.
fn grains(units: Units) -> Result<[Grain; 2], Failure> {
    let material = Material {
        young_modulus: MATERIAL.young_modulus * units.modulus,
        density: MATERIAL.density * units.density,
        fracture_energy: MATERIAL.fracture_energy * units.modulus * units.length,
        ..MATERIAL
    };
    let constants = material.bond_constants(Weight::Constant, 3.015 * SIDE * units.length)?;
    let above = |height: f64| -> Result<Grain, Failure> {
        let mut grain = block([7, 5], SIDE, 3.015, Weight::Constant)?;
        for (node, place) in grain.position.iter_mut().enumerate() {
            // No two distances are equal, and none is at the horizon.
            let shift = 1e-3 * SIDE * (node % 7 * (node + 3) % 5) as f64;
            *place = (*place + Vec2::new(shift, height)) * units.length;
        }
        for (node, area) in grain.area.iter_mut().enumerate() {
            let small = if node % 6 == 4 { 1e-6 } else { 1.0 };
            *area *= small * units.length * units.length;
        }
        grain.constants = constants;
        grain.contact_stiffness = constants.stiffness;
        grain.density = material.density;
        grain.breaking = Some(BreakingRule::TensionOnly);
        grain.touches_itself = true;
        Ok(grain)
    };
    Ok([above(0.0)?, above(5.3 * SIDE)?])
}

fn settings(units: Units, stiffness: f64, speed: f64) -> Settings {
    let radius = RADIUS * units.length;
    let law = ContactLaw {
        radius,
        damping_ratio: 0.3,
        friction: 0.5,
        reading: ContactReading::Symmetric,
    };
    let walls = WallLaw {
        radius,
        stiffness: stiffness / radius,
        damping_ratio: 0.3,
        friction: 0.5,
        reading: WallReading::Paper,
    };
    Settings {
        time_step: STEP / speed * units.time(),
        gravity: Vec2::new(0.0, -1e4 * units.velocity() / units.time()),
        break_order: BreakOrder::BreakFirst,
        contact: Some(Contact {
            law,
            stiffness: vec![vec![stiffness / radius]],
            shares_sticking: true,
        }),
        walls: Some(Walls {
            law: walls,
            velocity: [0.0; 4],
        }),
    }
}

/// What a run leaves, in natural units.
struct End {
    /// Displacements, velocities, energies and limits.
    numbers: [Vec<f64>; 4],
    /// Bonds that are left.
    bonds: Vec<(usize, usize)>,
}

/// Nodes of both blocks that start at the place of the first one.
const COINCIDENT: [usize; 2] = [8, 36];

fn run(units: Units, coincident: &[usize], speed: f64, steps: usize) -> Result<End, Failure> {
    let grains = Grains::new(&grains(units)?)?;
    let stiffness = grains.rows[0].constants.stiffness;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
    let mut state = State::at_rest(&grains, bonds);
    let settings = settings(units, stiffness, speed);
    let limits = Limits::of(&grains, &state.bonds, &settings);
    state.walls = [-1.0, 10.0, 14.0, 0.0].map(|place| place * SIDE * units.length);
    for node in 0..grains.nodes() {
        let sign = if grains.grain_of[node] == 0 {
            0.2
        } else {
            -1.0
        };
        let across = if node % 7 < 3 { -0.4 } else { 0.1 };
        state.velocity[node] = Vec2::new(across, sign) * (speed * units.velocity());
    }
    for &node in coincident {
        state.places[node].displacement = state.places[0].to(state.places[node]) * -1.0;
    }
    let mut world = World::new(grains, settings, state, Beginning::Forces)?;
    for _ in 0..steps {
        world.step()?;
    }
    Ok(End::of(&world, &limits, units))
}

impl End {
    fn of(world: &World, limits: &Limits, units: Units) -> Self {
        let state = world.state();
        let both = |vector: Vec2, unit: f64| [vector.x / unit, vector.y / unit];
        let energies = world.energies();
        let sums = [energies.kinetic, energies.bonds, energies.contacts];
        let places = state.places.iter();
        let velocities = state.velocity.iter();
        Self {
            numbers: [
                places
                    .flat_map(|place| both(place.displacement, units.length))
                    .collect(),
                velocities
                    .flat_map(|velocity| both(*velocity, units.velocity()))
                    .collect(),
                sums.map(|energy| energy / units.energy()).to_vec(),
                limits.named().map(|(_, step)| step / units.time()).to_vec(),
            ],
            bonds: world.bonds().all().map(|(i, j, _)| (i, j)).collect(),
        }
    }

    fn not_finite(&self) -> usize {
        let all = self.numbers.iter().flatten();
        all.filter(|number| !number.is_finite()).count()
    }
}

/// Corners of sizes, densities and moduli, as factors.
fn corners(lengths: [f64; 2], densities: [f64; 2], moduli: [f64; 2]) -> Vec<Units> {
    let mut all = Vec::new();
    for length in lengths {
        for density in densities {
            for modulus in moduli {
                all.push(Units {
                    length,
                    density,
                    modulus,
                });
            }
        }
    }
    all
}

fn binary_units() -> Outcome {
    const STEPS: usize = 150;
    let power = |exponents: [i32; 2]| exponents.map(|exponent| 2.0_f64.powi(exponent));
    let mut table = Table::new(
        "Runs in natural units",
        &[
            "speed, m/s",
            "bonds before",
            "bonds after",
            "worlds",
            "numbers that differ",
        ],
    );
    let mut wrong = 0;
    for speed in [20.0, 1e3, 1e4] {
        let expected = run(Units::SI, &COINCIDENT, speed, STEPS)?;
        let before = run(Units::SI, &COINCIDENT, speed, 0)?.bonds.len();
        let mut differ = 0;
        // Exponents of density and modulus have an even difference: the unit of time is a power of two.
        let worlds = corners(power([-20, 19]), power([-10, 4]), power([-20, 14]));
        for &units in &worlds {
            let found = run(units, &COINCIDENT, speed, STEPS)?;
            let pairs = found
                .numbers
                .iter()
                .flatten()
                .zip(expected.numbers.iter().flatten());
            differ += pairs.filter(|(a, b)| a.to_bits() != b.to_bits()).count();
            differ += usize::from(found.bonds != expected.bonds);
        }
        let after = expected.bonds.len();
        let numbers = [before, after, worlds.len(), differ].map(|number| number.to_string());
        table.push([speed.to_string()].into_iter().chain(numbers));
        wrong += differ + expected.not_finite();
    }
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}

fn any_units() -> Outcome {
    const STEPS: usize = 40;
    let expected = run(Units::SI, &[], 20.0, STEPS)?;
    let mut all = Vec::new();
    for units in corners([7e-7, 7e5], [1.0 / 1200.0, 17.0], [1e-6, 9e3]) {
        let found = run(units, &[], 20.0, STEPS)?;
        all.push(Measurement::count(usize::from(
            found.bonds != expected.bonds,
        )));
        for (found, expected) in found.numbers.iter().zip(&expected.numbers) {
            let largest = expected
                .iter()
                .fold(0.0, |most: f64, one| most.max(one.abs()));
            let pairs = found.iter().zip(expected);
            all.extend(pairs.map(|(a, b)| Measurement::scaled(*b, *a, largest, 1e-12)));
        }
    }
    Ok(Measurement::worst(all).into())
}
