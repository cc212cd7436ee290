//! Helpers that make worlds from texts of scenes.

pub use gouge_validation::checks::dem::scenes::{bits, particle};

use gouge_dem::World;
use gouge_runner::machine::with_chosen_execution;
use gouge_runner::run::{begin_phase, phases};
use gouge_runner::scene::{Scene, builtin};
use std::path::Path;

/// Names of all integrators.
pub const INTEGRATORS: [&str; 5] = [
    "euler",
    "symplectic-euler",
    "taylor",
    "velocity-verlet",
    "beeman",
];

/// Parse a scene.
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
        .map(with_chosen_execution)
        .expect("the kernel takes the scene")
}

/// Take a number of steps.
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

/// A small fault with weak bonds in its shear phase, after short set-up phases. The given replacements are made in the
/// text of the scene.
pub fn sheared_with(replacements: &[(&str, &str)]) -> World {
    let text = builtin::text("granite-fault-small").expect("built in");
    let shorter = [
        ("duration = 0.5e-3", "duration = 2e-6"),
        ("duration = 1e-3", "duration = 0.2e-3"),
        ("normal_strength = 280e6", "normal_strength = 20e6"),
    ];
    let replaced = |text: String, (old, new): &(&str, &str)| {
        assert!(text.contains(old), "the scene has no {old}");
        text.replace(old, new)
    };
    let text = shorter
        .iter()
        .chain(replacements)
        .fold(text.to_owned(), replaced);
    let scene = scene(&text);
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
