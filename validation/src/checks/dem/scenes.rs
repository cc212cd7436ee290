//! Worlds of checks, and models without a scene.

use crate::checks::Failure;
use gouge_common::geometry::Vec2;
use gouge_dem::particles::{Particle, Role, SPHERE_INERTIA_FACTOR};
use gouge_dem::{Number, World};

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
