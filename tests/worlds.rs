//! Worlds from drafts of scenes.

pub use gouge_validation::checks::dem::scenes::bits;

use gouge_dem::World;
use gouge_runner::run::{begin_phase, phases};
use gouge_runner::scene::Scene;
use gouge_validation::scenes::Draft;
use gouge_validation::scenes::fault::sheared;

/// Names of all integrators.
pub const INTEGRATORS: [&str; 5] = [
    "euler",
    "symplectic-euler",
    "taylor",
    "velocity-verlet",
    "beeman",
];

/// The scene of a draft.
pub fn scene(draft: &Draft) -> Scene {
    match draft.scene() {
        Ok(scene) => scene,
        Err(error) => panic!("{error}\n{draft:?}"),
    }
}

/// The world at t = 0 of a draft.
pub fn world(draft: &Draft) -> World {
    match draft.world() {
        Ok(world) => world,
        Err(error) => panic!("{error}\n{draft:?}"),
    }
}

/// Take a number of steps.
pub fn advance(world: &mut World, steps: u64) {
    for _ in 0..steps {
        world.step().expect("the state stays finite");
    }
}

/// A small fault of weak bonds in its shear phase, with short phases before and a change of its scene.
pub fn sheared_with(change: impl Fn(Draft) -> Draft) -> World {
    let scene = scene(&change(sheared()));
    let phases = phases(&scene);
    let mut world = None;
    for index in 0..phases.len() {
        let mut next = begin_phase(&scene, &phases, index, world).expect("enters");
        if index + 1 < phases.len() {
            advance(&mut next, phases[index].steps);
        }
        world = Some(next);
    }
    world.expect("there is a phase")
}
