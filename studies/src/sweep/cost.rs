//! What runs will cost, from short pilot runs.

use super::plan::Planned;
use gouge_runner::any_scene::AnyScene;
use gouge_runner::error::Error;
use gouge_runner::peridem;
use gouge_runner::run::{begin_phase, phases};
use gouge_runner::scene::Scene;
use std::time::Instant;

/// Number of runs that are tried.
const PILOTS: usize = 5;
/// Steps of a pilot run.
const STEPS: u64 = 2000;
/// Nodes times steps of a pilot run of peridynamic grains.
const NODE_STEPS: u64 = 2_000_000;
/// Time in s per body and step of contact dynamics. The first steps tell nothing of the later ones, which need many
/// sweeps: sheared packings took 1 to 4 microseconds.
const PER_BODY: f64 = 3e-6;
/// Bytes of a row of the series per column, and of the outputs per particle.
const BYTES: [f64; 2] = [20.0, 1200.0];

/// What runs will cost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// Core-hours.
    pub core_hours: f64,
    /// Bytes on the disk.
    pub bytes: f64,
}

impl Cost {
    /// Seconds on one core.
    pub fn seconds(self) -> f64 {
        3600.0 * self.core_hours
    }
}

/// What some runs will cost: a few of them, spread evenly, are tried for a number of steps.
pub fn estimate(runs: &[&Planned]) -> Cost {
    let chosen = runs.len().min(PILOTS);
    let pilots = (0..chosen).map(|pilot| runs[pilot * runs.len() / chosen]);
    // What is refused costs nothing.
    let costs = pilots.map(|run| pilot_run(run).unwrap_or_default());
    let sum = costs.fold(Cost::default(), |sum, one| Cost {
        core_hours: sum.core_hours + one.core_hours,
        bytes: sum.bytes + one.bytes,
    });
    let factor = runs.len() as f64 / chosen.max(1) as f64;
    Cost {
        core_hours: factor * sum.core_hours,
        bytes: factor * sum.bytes,
    }
}

fn pilot_run(run: &Planned) -> Result<Cost, Error> {
    let scene = run.load()?;
    let [per_step, particles] = match &scene {
        AnyScene::Dem(scene) => steps_of_grains(scene)?,
        AnyScene::ContactDynamics(scene) => {
            let bodies = scene.number_of_bodies() as f64;
            [PER_BODY * bodies, bodies]
        }
        AnyScene::Peridem(scene) => steps_of_nodes(scene)?,
    };
    Ok(Cost {
        core_hours: per_step * scene.steps() as f64 / 3600.0,
        bytes: BYTES[0] * 16.0 * scene.samples() + BYTES[1] * particles,
    })
}

/// Time per step in s at the beginning of a run of peridynamic grains, and the number of nodes.
fn steps_of_nodes(scene: &peridem::Scene) -> Result<[f64; 2], Error> {
    let mut world = peridem::world(scene)?;
    let nodes = world.grains().nodes();
    let steps = (NODE_STEPS / nodes.max(1) as u64).clamp(1, STEPS);
    let began = Instant::now();
    for _ in 0..steps {
        if world.step().is_err() {
            break;
        }
    }
    Ok([began.elapsed().as_secs_f64() / steps as f64, nodes as f64])
}

/// Time per step in s at the beginning of a run, and the number of particles.
fn steps_of_grains(scene: &Scene) -> Result<[f64; 2], Error> {
    let phases = phases(scene);
    let mut world = begin_phase(scene, &phases, 0, None)?.with_threads(1);
    let steps = STEPS.min(phases[0].steps).max(1);
    let began = Instant::now();
    for _ in 0..steps {
        // A run that fails is found out when it is run.
        if world.step().is_err() {
            break;
        }
    }
    let per_step = began.elapsed().as_secs_f64() / steps as f64;
    Ok([per_step, world.particles().len() as f64])
}
