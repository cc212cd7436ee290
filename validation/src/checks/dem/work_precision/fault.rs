//! The initial state of the sheared fault, prepared once by the thesis's protocol, in doubles.

use super::case::Origin;
use crate::checks::Failure;
use crate::checks::dem::remembered::start;
use crate::scenes::Draft;
use gouge_dem::particles::{Particles, Role};
use gouge_runner::run::run_setup;

/// The protocol of granite-fault for a box of a few grains; the upper block is driven at its target
/// speed from the first step by the exact controller.
const TEXT: &str = r#"
[time]
step = 10e-9
end = 1e-3
integrator = "velocity-verlet"
[box]
width = 10e-3
height = 12e-3
boundary = "periodic-x"
[material]
density = 2700.0
[contact.normal]
law = "kelvin-voigt"
stiffness = 1e7
damping = 10.0
[contact.tangential]
law = "cundall-strack-truncated"
friction = 0.7
stiffness = 1e8
[bond.normal]
stiffness = 1e7
damping = 10.0
[bond.tangential]
law = "euler-bernoulli"
stiffness = 1e7
damping = 10.0
[bond.yielding]
law = "zhang-eckert"
normal_strength = 280e6
tangential_strength = 168e6
[driving]
controller = "exact"
speed = 2.0
pressure = 28e6
[output]
energy = false
[setup]
seed = 3
clip = true
correct_density = true
[setup.sizes]
mean = 1e-3
[setup.lattice]
arrangement = "square"
perturbation = 0.05e-3
filling = 0.9069
[[setup.settle]]
duration = 1e-3
step = 100e-9
ambient = { law = "creeping", viscosity = 10.0 }
external = { law = "harmonic-well", stiffness = 4e3 }
[setup.bonding]
reach = 1.224744871391589
strength_spread = 0.1
[setup.fault]
height = 0.5e-3
jags = 1
[[setup.relax]]
duration = 0.2e-3
step = 40e-9
ambient = { law = "creeping", viscosity = 1.0 }
external = { law = "harmonic-well", stiffness = 4e2 }
[setup.roles]
fixed_below = 2.5e-3
driven_above = 9.5e-3
[[setup.press]]
duration = 0.4e-3
step = 40e-9
speed = 0.0
ambient = { law = "creeping", viscosity = 1.0 }
"#;

/// The two blocks under pressure.
pub fn origin() -> Result<Origin, Failure> {
    let world = run_setup(&Draft::parse(TEXT).scene()?)?;
    let mut particles = world.particles().clone();
    drive_at(
        &mut particles,
        world.model().driving.map_or(0.0, |law| law.speed),
    );
    Ok(Origin {
        model: *world.model(),
        start: start(&world),
        particles,
    })
}

/// Gives the driven particles the target mean velocity, so that the controller starts without a
/// velocity error.
fn drive_at(particles: &mut Particles, speed: f64) {
    let driven: Vec<usize> = particles.with_role(Role::Driven).collect();
    let sum: f64 = driven.iter().map(|&i| particles.velocity[i].x).sum();
    let missing = speed - sum / driven.len() as f64;
    for i in driven {
        particles.velocity[i].x += missing;
    }
}
