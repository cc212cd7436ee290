//! Small scenes for checks, written as text, as users write them.

use crate::checks::Failure;
use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_dem::integrators::Integrator;
use gouge_dem::model::{Model, Reading};
use gouge_dem::particles::{Particle, Role, SPHERE_INERTIA_FACTOR};
use gouge_dem::{Number, World};
use gouge_runner::machine::with_chosen_execution;
use gouge_runner::scene::Scene;
use std::path::Path;

/// Head of a scene in an open box: integrator, time step, density 2700 kg/m^3, and an end that no run
/// reaches.
pub fn head(integrator: &str, step: f64) -> String {
    format!(
        "[time]\nstep = {step:e}\nend = {:e}\nintegrator = \"{integrator}\"\n\
         [material]\ndensity = 2700.0\n",
        1e12 * step
    )
}

/// One particle of a scene.
pub fn particle(position: [f64; 2], velocity: [f64; 2], spin: f64, radius: f64) -> String {
    format!(
        "[[particles]]\nposition = [{:e}, {:e}]\nvelocity = [{:e}, {:e}]\n\
         angular_velocity = {spin:e}\nradius = {radius:e}\n",
        position[0], position[1], velocity[0], velocity[1]
    )
}

/// The scene of a text.
///
/// # Errors
/// Mistakes in the text.
pub fn scene(text: &str) -> Result<Scene, Failure> {
    Ok(Scene::parse("check", text.as_bytes(), Path::new("."))?)
}

/// The world of a scene's text at t = 0.
///
/// # Errors
/// Mistakes in the text, states that the kernel refuses.
pub fn world(text: &str) -> Result<World, Failure> {
    world_in(text)
}

/// The world of a scene's text at t = 0, in another number type.
///
/// # Errors
/// As [`world`].
pub fn world_in<S: Number>(text: &str) -> Result<World<S>, Failure> {
    Ok(scene(text)?.initial_world_in().map(with_chosen_execution)?)
}

/// Advances a world by the given number of steps.
///
/// # Errors
/// States that are no longer finite.
pub fn advance<S: Number>(world: &mut World<S>, steps: u64) -> Result<(), Failure> {
    for _ in 0..steps {
        world.step()?;
    }
    Ok(())
}

/// Bits of all positions, velocities, angles and angular velocities.
pub fn bits(world: &World) -> Vec<u64> {
    let p = world.particles();
    let vectors = p
        .position
        .iter()
        .chain(&p.velocity)
        .flat_map(|v| [v.x, v.y]);
    let numbers = p.angle.iter().chain(&p.angular_velocity).copied();
    vectors.chain(numbers).map(f64::to_bits).collect()
}

/// An empty model: an open box without contacts, bonds, fields and ledger.
pub fn empty_model(integrator: Integrator, time_step: f64) -> Model {
    Model {
        reading: Reading::Corrected,
        integrator,
        time_step,
        domain: Domain {
            width: None,
            height: None,
            periodic: false,
        },
        contact: None,
        bond: None,
        ambient: None,
        external: None,
        driving: None,
        ledger: false,
    }
}

/// A free sphere of density 2700 kg/m^3.
pub fn sphere(position: Vec2, velocity: Vec2, spin: f64, radius: f64) -> Particle {
    Particle {
        position,
        velocity,
        angle: 0.0,
        angular_velocity: spin,
        radius,
        density: 2700.0,
        inertia_factor: SPHERE_INERTIA_FACTOR,
        role: Role::Free,
    }
}
