//! Plates of peridynamic bonds against LAMMPS.

use super::grains::{bonds_only, grain};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    peridem,
};
use crate::references::Plate;
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::Settings;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{BondConstants, Weight};
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};

pub fn checks() -> Vec<Check> {
    let check = |id, claim, norm, reason, measure| Check {
        id,
        claim,
        equations: peridem("(2.1), (3.1), (3.2), P4, Q6"),
        scene: "A plate of 160 nodes: one vibrates for 1000 steps with volumes that differ by up to a factor of 1.8; two are torn apart for 400 steps, with equal volumes and with different ones",
        oracle: "LAMMPS 22 Jul 2025, pair peri/pmb with fix nve, stored in references/lammps/peri-pmb",
        norm,
        origin: Origin::Exact,
        reason,
        effort: Effort::Quick,
        measure,
    };
    vec![
        check(
            "peridem.lammps.motion",
            "Nodes move as in LAMMPS, to rounding, while bonds hold and after they break.",
            "Largest difference of a position in units of the length of the plate, and of a velocity in units of ten times the largest one",
            "LAMMPS rounds positions of 1 m, by 1e-16 m each, and takes elongations from them; 1000 steps that err in one direction add up to 1e-13 m of 1.2 m. An elongation that is wrong by d changes an acceleration by up to w^2 d, with w below 3e4/s by row sums: 6e-11 m/s in a random walk of 1000 steps, of 40 m/s",
            motion,
        ),
        check(
            "peridem.lammps.damage",
            "In every step the same bonds break as in LAMMPS.",
            "Largest difference of the damage of a node at the recorded steps, and of the sum of damage over all nodes after each step",
            "A bond is at least 0.01 of the volume of the partners of its nodes. LAMMPS writes sums of 160 numbers with 15 digits: 14 of them count",
            damage,
        ),
    ]
}

fn plate_of(run: &Plate) -> Grain {
    let constants = BondConstants {
        weight: Weight::Constant,
        horizon: run.horizon,
        stiffness: run.stiffness,
        critical_stretch: run.critical_stretch,
    };
    let position = run.nodes.iter().map(|node| Vec2::new(node.x, node.y));
    let area = run.nodes.iter().map(|node| node.volume).collect();
    Grain {
        density: run.nodes[0].density,
        breaking: Some(BreakingRule::TensionOnly),
        ..grain(position.collect(), area, constants)
    }
}

/// The plate of a run at its beginning.
fn world(run: &Plate) -> Result<World, Failure> {
    let grains = Grains::new(&[plate_of(run)])?;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
    let mut state = State::at_rest(&grains, bonds);
    for (velocity, node) in state.velocity.iter_mut().zip(&run.nodes) {
        *velocity = Vec2::new(node.vx, node.vy);
    }
    let settings = Settings {
        break_order: BreakOrder::ForceFirst,
        ..bonds_only(run.step)
    };
    Ok(World::new(grains, settings, state, Beginning::Forces)?)
}

/// Lost part of the volume of the partners of each node.
struct Damage {
    initial: Vec<f64>,
}

impl Damage {
    fn new(world: &World) -> Self {
        Self {
            initial: volumes(world),
        }
    }

    fn of(&self, world: &World) -> Vec<f64> {
        let left = volumes(world);
        let parts = left.iter().zip(&self.initial);
        parts.map(|(left, initial)| 1.0 - left / initial).collect()
    }
}

/// Volume of the partners of each node.
fn volumes(world: &World) -> Vec<f64> {
    let area = &world.grains().area;
    let mut sums = vec![0.0; area.len()];
    for (earlier, later, _) in world.bonds().all() {
        sums[earlier] += area[later];
        sums[later] += area[earlier];
    }
    sums
}

fn advance(world: &mut World, step: u64) -> Result<(), Failure> {
    while world.state().steps < step {
        world.step()?;
    }
    Ok(())
}

/// Largest differences of positions in units of the length, and of velocities in units of ten times the largest one.
fn differences(run: &Plate, tolerance: f64) -> Result<[Vec<Measurement>; 2], Failure> {
    let columns = run.motion.places(["x", "y", "vx", "vy"]);
    let columns = columns.map_err(Failure::Oracle)?;
    let length = run
        .nodes
        .iter()
        .fold(0.0, |most: f64, node| most.max(node.x));
    let speeds = run.nodes.iter().map(|node| node.vx.hypot(node.vy));
    let speed = 10.0 * speeds.fold(0.0, f64::max);
    let mut world = world(run)?;
    let [mut places, mut velocities] = [Vec::new(), Vec::new()];
    for (step, rows) in run.motion.steps().map_err(Failure::Oracle)? {
        advance(&mut world, step)?;
        let state = world.state();
        for ((row, place), velocity) in rows.iter().zip(&state.places).zip(&state.velocity) {
            let position = place.position();
            let found = [position.x, position.y, velocity.x, velocity.y];
            for (k, (found, column)) in found.into_iter().zip(columns).enumerate() {
                let (all, scale) = match k {
                    0 | 1 => (&mut places, length),
                    _ => (&mut velocities, speed),
                };
                all.push(Measurement::scaled(row[column], found, scale, tolerance));
            }
        }
    }
    Ok([places, velocities])
}

fn motion() -> Outcome {
    let (runs, tolerance) = Plate::all().map_err(Failure::Oracle)?;
    let mut table = Table::new(
        "Largest differences from LAMMPS",
        &[
            "run",
            "position, m",
            "velocity, m/s",
            "largest displacement, m",
        ],
    );
    let mut all = Vec::new();
    for run in &runs {
        let found = differences(run, tolerance)?;
        let apart = |all: &[Measurement]| {
            let sizes = all.iter().map(|one| (one.measured - one.expected).abs());
            format!("{:.1e}", sizes.fold(0.0, f64::max))
        };
        let [place, velocity] = [apart(&found[0]), apart(&found[1])];
        let largest = format!("{:.2e}", largest_displacement(run)?);
        table.push([run.name.clone(), place, velocity, largest]);
        all.extend(found.into_iter().flatten());
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

/// Largest displacement in m at a recorded step of LAMMPS.
fn largest_displacement(run: &Plate) -> Result<f64, Failure> {
    let [x, y] = run.motion.places(["x", "y"]).map_err(Failure::Oracle)?;
    let nodes = run.nodes.iter().cycle();
    let sizes = run.motion.rows.iter().zip(nodes);
    let sizes = sizes.map(|(row, node)| (row[x] - node.x).hypot(row[y] - node.y));
    Ok(sizes.fold(0.0, f64::max))
}

fn damage() -> Outcome {
    const ROUNDING: f64 = 1e-12;
    let (runs, _) = Plate::all().map_err(Failure::Oracle)?;
    let mut all = Vec::new();
    let (mut curves, mut broken) = (
        Vec::new(),
        Table::new("Broken bonds", &["run", "bonds", "broken"]),
    );
    for run in &runs {
        let [id, lost] = run
            .motion
            .places(["id", "c_damage"])
            .map_err(Failure::Oracle)?;
        let frames = run.motion.steps().map_err(Failure::Oracle)?;
        let mut world = world(run)?;
        let damage = Damage::new(&world);
        let bonds = world.bonds().count();
        let (mut ours, mut theirs) = (Vec::new(), Vec::new());
        for row in &run.series.rows {
            let [step, sum] = row[..] else { continue };
            advance(&mut world, step as u64)?;
            let found = damage.of(&world);
            let total = found.iter().sum::<f64>();
            all.push(Measurement::absolute(sum, total, ROUNDING));
            ours.push([step, total]);
            if let Some((_, rows)) = frames.iter().find(|frame| frame.0 == step as u64) {
                theirs.push([step, sum]);
                let node = |row: &[f64]| found[row[id] as usize - 1];
                let each = rows
                    .iter()
                    .map(|row| Measurement::absolute(row[lost], node(row), ROUNDING));
                all.extend(each);
            }
        }
        curves.push(Curve::line(&run.name, ours));
        curves.push(Curve::marks(&format!("{}, LAMMPS", run.name), theirs));
        let lost = bonds - world.bonds().count();
        broken.push([run.name.clone(), bonds.to_string(), lost.to_string()]);
    }
    let figure = Figure::new(
        "Sum of the damage of all nodes in plates that vibrate and tear",
        Axis::linear("step", ""),
        Axis::linear("damage", ""),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure), Exhibit::Table(broken)]))
}
