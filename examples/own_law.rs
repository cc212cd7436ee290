//! Grains fall onto a floor and form a pile, with a normal law of this program's own.
//!
//! Tsuji's damping lets grains rebound with the same restitution at any speed, which the linear law of the kernel also
//! does, but with the elastic force of Hertz:
//!
//! F = min(0, -(K xi^(3/2) + alpha sqrt(m K) xi^(1/4) d_xi))
//!
//! xi is the overlap in m, m the reduced mass in kg, K = 4/3 E sqrt(R) with the effective modulus E in Pa and the reduced
//! radius R in m, and alpha the dimensionless damping.

use gouge_dem::common::geometry::Vec2;
use gouge_dem::common::scalar::Real;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{CundallStrackTruncated, Gravity, NormalLaw, typical_overlap};
use gouge_dem::model::{ContactLaws, ContactTangential, External, Model};
use gouge_dem::particles::{Particle, Particles, Role};
use gouge_dem::{ModelError, Start, World};

/// Hertzian contact with Tsuji's damping.
#[derive(Clone, Copy, Debug)]
pub struct Tsuji {
    /// Effective modulus in Pa.
    pub modulus: f64,
    /// Damping, dimensionless.
    pub alpha: f64,
}

impl Tsuji {
    fn prefactor<S: Real>(self, radii: [S; 2]) -> S {
        (radii[0] * radii[1] / (radii[0] + radii[1])).sqrt() * (4.0 / 3.0 * self.modulus)
    }
}

impl NormalLaw for Tsuji {
    const SCALES_DAMPING: bool = true;
    fn damping_factor<S: Real>(self, _: [S; 2], reduced_mass: S) -> S {
        reduced_mass.sqrt()
    }
    #[inline(always)]
    fn force<S: Real>(self, radii: [S; 2], xi: S, d_xi: S) -> S {
        let (overlap, prefactor) = (xi.max(S::zero()), self.prefactor(radii));
        let viscous = prefactor.sqrt() * overlap.sqrt().sqrt() * d_xi * self.alpha;
        let force = S::zero().min(-(prefactor * overlap * overlap.sqrt() + viscous));
        if xi < S::zero() { S::zero() } else { force }
    }
    #[inline(always)]
    fn elastic_force<S: Real>(self, radii: [S; 2], xi: S) -> S {
        let overlap = xi.max(S::zero());
        -(self.prefactor(radii) * overlap * overlap.sqrt())
    }
    #[inline(always)]
    fn stored_energy<S: Real>(self, radii: [S; 2], xi: S) -> S {
        let overlap = xi.max(S::zero());
        self.prefactor(radii) * overlap * overlap * overlap.sqrt() * 0.4
    }
    fn linearised(self, radii: [f64; 2], reduced_mass: f64) -> [f64; 2] {
        let (overlap, prefactor): (f64, f64) = (typical_overlap(radii), self.prefactor(radii));
        let damping = self.alpha * (reduced_mass * prefactor).sqrt() * overlap.sqrt().sqrt();
        [1.5 * prefactor * overlap.sqrt(), damping]
    }
}

/// A floor of fixed grains and columns of free ones above it.
fn grains() -> Particles {
    let grain = |x: f64, y: f64| Particle::sphere(Vec2::new(x, y), 1e-3, 2700.0);
    let floor = (-30..=30).map(|n| Particle {
        role: Role::Fixed,
        ..grain(2e-3 * f64::from(n), 0.0)
    });
    // Each row is shifted a little, so that columns do not stay upright.
    let place = |n: i32| {
        [
            2.1e-3 * f64::from(n % 6) - 5e-3,
            2.1e-3 * f64::from(1 + n / 6),
        ]
    };
    let free = (0..60).map(|n| {
        let [x, y] = place(n);
        grain(x + 3e-4 * f64::from(n / 6 % 2), y)
    });
    floor.chain(free).collect()
}

/// The world of the pile.
fn pile() -> Result<World<f64, Tsuji>, ModelError> {
    let normal = Tsuji {
        modulus: 1e7,
        alpha: 0.5,
    };
    let tangential = CundallStrackTruncated {
        friction: 0.5,
        stiffness: 1e5,
    };
    let model = Model {
        contact: Some(ContactLaws {
            distance: ContactDistance::Mean,
            normal,
            tangential: Some(ContactTangential::CundallStrackTruncated(tangential)),
        }),
        external: Some(External::Gravity(Gravity { acceleration: 9.81 })),
        ledger: true,
        ..Model::new(Integrator::VelocityVerlet, 5e-7)
    };
    World::new(model, grains(), &Start::default())
}

/// Height of the pile above the centres of the floor in m.
fn height(world: &World<f64, Tsuji>) -> f64 {
    let heights = world.particles().position.iter().map(|place| place.y);
    heights.fold(0.0, f64::max)
}

/// Let the grains fall for half a second.
pub fn fallen() -> Result<World<f64, Tsuji>, Box<dyn std::error::Error>> {
    let mut world = pile()?;
    while world.time() < 0.5 {
        world.step()?;
    }
    Ok(world)
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("height {:.1} mm before", 1e3 * height(&pile()?));
    let world = fallen()?;
    let energy = world.energy();
    println!(
        "height {:.1} mm after {} s",
        1e3 * height(&world),
        world.time()
    );
    println!(
        "heat {:.3e} J, residual {:.1e} J",
        energy.friction, energy.residual
    );
    Ok(())
}
