//! Worlds from the text of scenes.

pub use gouge_validation::checks::scenes::{bits, particle};

use gouge_kernel::World;
use gouge_validation::scene::Scene;
use std::path::Path;

/// Names of all integrators.
pub const INTEGRATORS: [&str; 5] = [
    "euler",
    "symplectic-euler",
    "taylor",
    "velocity-verlet",
    "beeman",
];

/// The scene of a text.
pub fn scene(text: &str) -> Scene {
    match Scene::parse("scene.toml", text.as_bytes(), Path::new(".")) {
        Ok(scene) => scene,
        Err(error) => panic!("{error}\n{text}"),
    }
}

/// The world at t = 0 of a scene.
pub fn world(text: &str) -> World {
    scene(text)
        .initial_world()
        .expect("the kernel takes the scene")
}

/// Take so many steps.
pub fn advance(world: &mut World, steps: u64) {
    for _ in 0..steps {
        world.step().expect("the state stays finite");
    }
}

/// Head of a scene in an open box: integrator, step and density 2700.
pub fn head(integrator: &str, step: f64) -> String {
    format!(
        "[time]\nstep = {step:e}\nend = 1.0\nintegrator = \"{integrator}\"\n\
         [material]\ndensity = 2700.0\n"
    )
}
