//! Pairs of particles, built without a scene.

use crate::checks::Failure;
use gouge_common::geometry::Vec2;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::KelvinVoigt;
use gouge_dem::model::{ContactLaws, ContactNormal, ContactTangential, Model};
use gouge_dem::particles::{Particle, Particles, Role, SPHERE_INERTIA_FACTOR};
use gouge_dem::{Start, World};
use std::f64::consts::PI;

/// Density of all particles in kg/m^3.
const DENSITY: f64 = 2700.0;

/// Mass of a sphere in kg.
pub fn mass(radius: f64) -> f64 {
    DENSITY * 4.0 * PI * radius * radius * radius / 3.0
}

/// A free particle without spin.
pub fn free(position: [f64; 2], velocity: [f64; 2], radius: f64) -> Particle {
    Particle {
        position: Vec2::new(position[0], position[1]),
        velocity: Vec2::new(velocity[0], velocity[1]),
        angle: 0.0,
        angular_velocity: 0.0,
        radius,
        density: DENSITY,
        inertia_factor: SPHERE_INERTIA_FACTOR,
        role: Role::Free,
    }
}

/// Kelvin-Voigt contacts with optional friction.
pub fn kelvin_voigt(
    stiffness: f64,
    damping: f64,
    distance: ContactDistance,
    tangential: Option<ContactTangential>,
) -> ContactLaws {
    ContactLaws {
        distance,
        normal: ContactNormal::KelvinVoigt(KelvinVoigt { stiffness, damping }),
        tangential,
    }
}

/// A model with contacts only, in an open box, with velocity Verlet.
pub fn model(contact: ContactLaws, step: f64) -> Model {
    Model {
        contact: Some(contact),
        ..Model::new(Integrator::VelocityVerlet, step)
    }
}

/// The world of a model and its particles.
///
/// # Errors
/// Models that the kernel refuses.
pub fn world(model: Model, particles: &[Particle]) -> Result<World, Failure> {
    let particles: Particles = particles.iter().copied().collect();
    Ok(World::new(model, particles, &Start::default())?)
}

/// Restitution of a collision along x, which runs until the pair separates or the given number of steps
/// is reached.
///
/// # Errors
/// Steps that fail.
pub fn restitution(world: &mut World, most: u64) -> Result<f64, Failure> {
    let closing = |world: &World| {
        let v = &world.particles().velocity;
        v[0].x - v[1].x
    };
    let before = closing(world);
    while world.number_of_contacts() > 0 && world.steps() < most {
        world.step()?;
    }
    Ok(-closing(world) / before)
}
