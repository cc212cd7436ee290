//! Two grains of granite collide head on; the energies before and after.
use gouge_dem::common::geometry::Vec2;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::KelvinVoigt;
use gouge_dem::model::{ContactLaws, ContactNormal, Model};
use gouge_dem::particles::{Particle, Particles};
use gouge_dem::{Start, World};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let normal = KelvinVoigt {
        stiffness: 1e7,
        damping: 5.0,
    };
    let model = Model {
        contact: Some(ContactLaws {
            distance: ContactDistance::Mean,
            normal: ContactNormal::KelvinVoigt(normal),
            tangential: None,
        }),
        ledger: true,
        ..Model::new(Integrator::VelocityVerlet, 1e-8)
    };
    let grain = |x: f64, speed: f64| Particle {
        velocity: Vec2::new(speed, 0.0),
        ..Particle::sphere(Vec2::new(x, 0.0), 1e-3, 2700.0)
    };
    let pair = [grain(-1.1e-3, 1.0), grain(1.1e-3, -1.0)];
    let grains: Particles = pair.into_iter().collect();
    let mut world = World::new(model, grains, &Start::default())?;
    println!("before: kinetic energy {:.3e} J", world.energy().kinetic);
    while world.time() < 5e-4 {
        world.step()?;
    }
    let after = world.energy();
    let (kinetic, heat) = (after.kinetic, after.friction);
    println!("after:  kinetic energy {kinetic:.3e} J, heat {heat:.3e} J");
    println!("residual of the balance: {:.1e} J", after.residual);
    Ok(())
}
