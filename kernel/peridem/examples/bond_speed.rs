//! Time per bond and step of a square lattice of 100 x 100 nodes, with one and two threads, beside a plain loop over the
//! same bonds, in turns; and the bytes that a bond takes.

use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::forces::{Settings, Workspace};
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{Material, Plane, Weight};
use gouge_peridem::state::State;
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::error::Error;
use std::time::Instant;

const SIDE: usize = 100;
const SPACING: f64 = 1e-3;
const ROUNDS: usize = 300;
const SETTINGS: Settings = Settings {
    time_step: 1e-7,
    gravity: Vec2 { x: 0.0, y: 0.0 },
    break_order: BreakOrder::BreakFirst,
    contact: None,
    walls: None,
};

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

/// A lattice whose nodes are displaced, so that no bond has its reference length.
fn displaced(grain: Grain) -> Result<(Grains, State, Workspace), Box<dyn Error>> {
    let grains = Grains::new(&[grain])?;
    let bonds = Bonds::within_horizon(&grains, |_, _, _| true)?;
    let mut state = State::at_rest(&grains, bonds);
    for (k, place) in state.places.iter_mut().enumerate() {
        let part = |factor: usize, of: usize| 1e-6 * ((k * factor) % of) as f64;
        place.displacement = Vec2::new(part(7, 11), part(5, 17));
    }
    let mut workspace = Workspace::new(&grains, &SETTINGS, &state);
    workspace.evaluate(&grains, &SETTINGS, &mut state);
    Ok((grains, state, workspace))
}

/// What the kernel is compared with: forces per stiffness of bonds of constant weight that do not break, as the formula
/// reads, one bond after the other.
fn plain(bonds: &[(usize, usize, f64)], area: &[f64], state: &State, force: &mut [Vec2]) {
    force.fill(Vec2::zero());
    for &(i, j, length) in bonds {
        let branch = state.places[i].to(state.places[j]);
        let distance = branch.norm();
        let pull = branch * ((distance - length) / (length * distance));
        force[i] += pull * area[j];
        force[j] += -pull * area[i];
    }
}

/// The shortest of some times in s, and the time of one more run of a task.
fn shorter(before: f64, task: impl FnOnce()) -> f64 {
    let begin = Instant::now();
    task();
    before.min(begin.elapsed().as_secs_f64())
}

fn pool(threads: usize) -> Result<ThreadPool, Box<dyn Error>> {
    Ok(ThreadPoolBuilder::new().num_threads(threads).build()?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let (one, two) = (pool(1)?, pool(2)?);
    let breaks = Some(BreakingRule::TensionOnly);
    for (weight, breaking) in [
        (Weight::Constant, None),
        (Weight::Constant, breaks),
        (Weight::Conic, breaks),
    ] {
        let grain = lattice(weight, breaking)?;
        let mut built = None;
        let memory = allocation_counter::measure(|| built = Some(displaced(grain)));
        let (grains, mut state, mut workspace) = built.ok_or("nothing built")??;
        let bonds: Vec<_> = state.bonds.all().collect();
        let mut force = vec![Vec2::zero(); grains.nodes()];
        let mut best = [f64::INFINITY; 3];
        for _ in 0..ROUNDS {
            let mut evaluate = || workspace.evaluate(&grains, &SETTINGS, &mut state);
            best[0] = shorter(best[0], || one.install(&mut evaluate));
            best[1] = shorter(best[1], || two.install(&mut evaluate));
            best[2] = shorter(best[2], || plain(&bonds, &grains.area, &state, &mut force));
        }
        let count = bonds.len() as f64;
        let [one, two, plain] = best.map(|seconds| 1e9 * seconds / count);
        println!(
            "{weight:?}, breaking {breaking:?}: {count} bonds, {one:.2} ns with one thread, {two:.2} ns with two; plain loop \
             {plain:.2} ns, ratio {:.2}; {:.1} bytes a bond at most",
            one / plain,
            memory.bytes_max as f64 / count
        );
    }
    Ok(())
}
