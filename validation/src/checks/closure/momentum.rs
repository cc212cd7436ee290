//! Momentum and angular momentum over long runs.

use crate::checks::scenes::{advance, head, particle, world};
use crate::checks::{Check, Effort, Measurement, Origin, Outcome};
use gouge_kernel::World;
use gouge_kernel::geometry::Vec2;

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "closure.momentum",
        claim: "A free cluster of bonded and rubbing grains keeps momentum and angular momentum over a hundred thousand steps.",
        equations: "(5)-(7), (45), (51), E10",
        scene: "Seven grains of different size, four of them bonded in a chain, with Cundall-Strack friction, drifting and spinning, with and without damping: 100 000 steps of symplectic Euler and of velocity Verlet",
        oracle: "The initial momenta",
        norm: "Change over the sum of the sizes of all momenta of the grains, in units of rounding times the root of the number of steps",
        origin: Origin::Exact,
        reason: "Each step rounds every velocity and position once: a random walk with steps of one rounding; eight of them for a margin",
        effort: Effort::Thorough,
        measure: momentum,
    }]
}

/// Momentum, angular momentum about the origin, and the sum of the sizes of their parts.
fn momenta(world: &World) -> (Vec2, f64, [f64; 2]) {
    let p = world.particles();
    let (mut linear, mut angular, mut sizes) = (Vec2::zero(), 0.0, [0.0; 2]);
    for i in 0..p.len() {
        let part = p.velocity[i] * p.mass[i];
        let spin = p.moment_of_inertia[i] * p.angular_velocity[i];
        linear += part;
        angular += p.position[i].cross(part) + spin;
        sizes[0] += part.norm();
        sizes[1] += p.position[i].norm() * part.norm() + spin.abs();
    }
    (linear, angular, sizes)
}

fn scene(integrator: &str, damping: f64) -> String {
    let mut text = head(integrator, 5e-9)
        + &format!(
            "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = {damping:e}\n\
             [contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 0.5\nstiffness = 5e6\n\
             [bond.normal]\nstiffness = 1e7\ndamping = {damping:e}\n\
             [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e7\ndamping = {damping:e}\n"
        );
    for i in 0..7 {
        let n = f64::from(i);
        let (x, y) = (
            1.9e-3 * f64::from(i % 4),
            1.9e-3 * f64::from(i / 4) + 1e-4 * n,
        );
        text += &particle(
            [x, y],
            [0.3 - 0.1 * n, 0.05 * n],
            300.0 - 80.0 * n,
            0.9e-3 + 3e-5 * n,
        );
    }
    text + "[[bonds]]\nbetween = [0, 1]\n[[bonds]]\nbetween = [1, 2]\n[[bonds]]\nbetween = [2, 3]\n"
}

fn momentum() -> Outcome {
    let steps = 100_000;
    let mut worst = Vec::new();
    for integrator in ["symplectic-euler", "velocity-verlet"] {
        for damping in [0.0, 1.0] {
            let mut world = world(&scene(integrator, damping))?;
            let (linear, angular, sizes) = momenta(&world);
            advance(&mut world, steps)?;
            let (after, turned, later) = momenta(&world);
            let unit = |n: usize| f64::EPSILON * (steps as f64).sqrt() * sizes[n].max(later[n]);
            worst.push(Measurement::scaled(
                0.0,
                (after - linear).norm(),
                unit(0),
                8.0,
            ));
            worst.push(Measurement::scaled(angular, turned, unit(1), 8.0));
        }
    }
    Ok(Measurement::worst(worst).into())
}
