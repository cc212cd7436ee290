//! Time per bond and step of a square lattice of 100 x 100 nodes, with one and two threads.

use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::{Settings, Workspace};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{Material, Plane, Weight};
use gouge_peridem::state::State;
use std::error::Error;
use std::time::Instant;

const SIDE: usize = 100;
const SPACING: f64 = 1e-3;
const PASSES: usize = 200;

fn lattice(weight: Weight, breaking: Option<BreakingRule>) -> Result<Grain, Box<dyn Error>> {
    let material = Material {
        young_modulus: 1e9,
        poisson_ratio: 1.0 / 3.0,
        fracture_energy: 1e5,
        density: 1200.0,
        plane: Plane::Stress,
    };
    let nodes = SIDE * SIDE;
    let place = |k: usize| Vec2::new((k % SIDE) as f64, (k / SIDE) as f64) * SPACING;
    Ok(Grain {
        position: (0..nodes).map(place).collect(),
        area: vec![SPACING * SPACING; nodes],
        density: material.density,
        constants: material.bond_constants(weight, 4.015 * SPACING)?,
        breaking,
        touches_itself: false,
        contact_stiffness: 0.0,
        material: 0,
        clamped: Vec::new(),
        load: Vec::new(),
    })
}

/// Shortest time in s of a pass over all bonds.
fn shortest(grains: &Grains, state: &mut State, threads: usize) -> Result<f64, Box<dyn Error>> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()?;
    let settings = Settings {
        time_step: 1e-7,
        gravity: Vec2::zero(),
        break_order: BreakOrder::BreakFirst,
        contact: None,
        walls: None,
    };
    let mut workspace = Workspace::new(grains, &settings, state);
    let mut best = f64::INFINITY;
    for _ in 0..PASSES {
        let begin = Instant::now();
        pool.install(|| workspace.evaluate(grains, &settings, state));
        best = best.min(begin.elapsed().as_secs_f64());
    }
    Ok(best)
}

fn main() -> Result<(), Box<dyn Error>> {
    let breaks = Some(BreakingRule::TensionOnly);
    for (weight, breaking) in [
        (Weight::Constant, None),
        (Weight::Constant, breaks),
        (Weight::Conic, breaks),
    ] {
        let grains = Grains::new(&[lattice(weight, breaking)?])?;
        let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
        let count = bonds.count();
        let mut state = State::at_rest(&grains, bonds);
        for (k, place) in state.places.iter_mut().enumerate() {
            let part = |factor: usize, of: usize| 1e-6 * ((k * factor) % of) as f64;
            place.displacement = Vec2::new(part(7, 11), part(5, 17));
        }
        let times = [
            shortest(&grains, &mut state, 1)?,
            shortest(&grains, &mut state, 2)?,
        ];
        let [one, two] = times.map(|seconds| 1e9 * seconds / count as f64);
        println!(
            "{weight:?}, breaking {breaking:?}: {count} bonds, {one:.2} ns with one thread, {two:.2} ns with two"
        );
    }
    Ok(())
}
