//! A sphere against a rigid plane: the scene and the kernel's result.

use crate::checks::Failure;
use crate::oracles::impact::{Impact, Motion, Normal, Tangential};
use crate::scenes::{Draft, Grain};
use gouge_common::scalar::Real;
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{Bshp, KelvinVoigt};
use gouge_scalars::DoubleDouble;
use std::f64::consts::PI;

/// An isotropic solid of a benchmark.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Name.
    pub name: &'static str,
    /// Young's modulus in Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio.
    pub poissons_ratio: f64,
    /// Density in kg/m^3.
    pub density: f64,
}

/// A material: name, Young's modulus, Poisson's ratio, density.
pub const fn material(name: &'static str, elastic: [f64; 2], density: f64) -> Material {
    let [youngs_modulus, poissons_ratio] = elastic;
    Material {
        name,
        youngs_modulus,
        poissons_ratio,
        density,
    }
}

impl Material {
    /// Mass of a sphere in kg.
    pub fn mass(&self, radius: f64) -> f64 {
        4.0 / 3.0 * PI * self.density * radius.powi(3)
    }
    /// Factor of the overlap to the power 3/2 for a sphere on a rigid plane, in N/m^(3/2).
    ///
    /// 4/3 E* sqrt(r) with E* = Y / (1 - nu^2): only the sphere deforms.
    pub fn factor_on_plane(&self, radius: f64) -> f64 {
        let nu = self.poissons_ratio;
        4.0 / 3.0 * self.youngs_modulus / (1.0 - nu * nu) * radius.sqrt()
    }
    /// The scene's normal law of a viscoelastic contact, with the modulus multiplied by a factor.
    ///
    /// The law describes two deformable spheres of the same material. If one is rigid, or of another
    /// size than in the scene, only the product of the modulus and the square root of the reduced
    /// radius matters, and the factor restores it.
    pub fn hertzian(&self, factor: f64, dissipation: f64) -> Draft {
        Draft::empty().law(Bshp {
            youngs_modulus: factor * self.youngs_modulus,
            poissons_ratio: self.poissons_ratio,
            dissipative_constant: dissipation,
        })
    }
}

/// The scene's linear normal law.
pub fn linear(stiffness: f64, damping: f64) -> Draft {
    Draft::empty().law(KelvinVoigt { stiffness, damping })
}

/// The scene's tangential law.
pub fn tangential(law: Tangential) -> Draft {
    let (name, friction, value) = match law {
        Tangential::Viscous([mu, gamma]) => ("haff-werner", mu, gamma),
        Tangential::Spring([mu, k]) => ("cundall-strack-truncated", mu, k),
    };
    Draft::empty().friction(name, friction, value)
}

/// Radius of the fixed sphere in radii of the moving one. The normal rotates by the path along it over
/// its radius, 1e-12 here. In doubles the overlap would have no digits left; in double-double it keeps
/// seventeen.
pub const FLATNESS: f64 = 1e12;

/// An impact of a sphere on a plane.
#[derive(Clone, Copy, Debug)]
pub struct OnPlane {
    /// Material of the sphere.
    pub material: Material,
    /// Its radius in m.
    pub radius: f64,
    /// Normal law.
    pub normal: Normal,
    /// Tangential law.
    pub tangential: Tangential,
}

/// Motion of the sphere: velocity along the plane to the right and normal speed, in m/s, and angular
/// velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flight {
    /// Velocity along the plane in m/s.
    pub along: f64,
    /// Speed towards the plane before the collision, away from it afterwards, in m/s.
    pub normal: f64,
    /// Angular velocity in rad/s, counter-clockwise.
    pub spin: f64,
}

impl OnPlane {
    /// Mass in kg.
    pub fn mass(&self) -> f64 {
        self.material.mass(self.radius)
    }
    /// The oracle for its collision.
    pub fn impact(&self) -> Impact {
        Impact {
            normal: self.normal,
            tangential: self.tangential,
            mass: self.mass(),
            compliance: [2.5 / self.mass(), 0.0],
            inverse_reach: 0.0,
        }
    }
    /// Duration without dissipation in s.
    pub fn duration(&self, speed: f64) -> f64 {
        self.normal.elastic(self.mass(), speed)[0]
    }
    /// The motion before the collision, for the oracle.
    pub fn motion(&self, before: Flight) -> Motion {
        Motion {
            approach: before.normal,
            shear: -before.along,
            surface: [self.radius * before.spin, 0.0],
        }
    }
    /// The motion after the collision, from the oracle.
    ///
    /// # Errors
    /// A collision that does not end.
    pub fn expected(&self, before: Flight) -> Result<Flight, Failure> {
        let end = self.impact().rebound(self.motion(before));
        let end = end.ok_or_else(|| Failure::Oracle("the collision does not end".to_owned()))?;
        Ok(Flight {
            along: -end.shear,
            normal: -end.approach,
            spin: end.surface[0] / self.radius,
        })
    }
    /// The scene, with the given number of steps in the duration without dissipation.
    pub fn scene(&self, before: Flight, steps: u64) -> Draft {
        self.scene_with_step(before, self.duration(before.normal) / steps as f64)
    }
    /// The scene with a time step in s.
    pub fn scene_with_step(&self, before: Flight, step: f64) -> Draft {
        let radius = self.radius;
        let law = match self.normal {
            Normal::Linear([stiffness, damping]) => linear(stiffness, damping),
            // A rigid plane: half the compliance of two equal solids.
            Normal::Hertzian([_, dissipation]) => self.material.hertzian(2.0, dissipation),
        };
        let velocity = [before.along, -before.normal];
        Draft::open_box(Integrator::VelocityVerlet, step)
            .grain(
                Grain::at([0.0, radius.next_down()], radius)
                    .moving(velocity)
                    .spinning(before.spin)
                    .of_density(self.material.density),
            )
            .grain(Grain::at([0.0, -FLATNESS * radius], FLATNESS * radius).fixed())
            .and(&law)
            .and(&tangential(self.tangential))
    }
    /// The motion after the collision, from the kernel; `watch` is called after every step.
    ///
    /// # Errors
    /// Scenes that cannot be run.
    pub fn watched(
        &self,
        before: Flight,
        steps: u64,
        mut watch: impl FnMut(&World<DoubleDouble>),
    ) -> Result<Flight, Failure> {
        let mut world = self.scene(before, steps).world_in::<DoubleDouble>()?;
        let radius = DoubleDouble::from_f64(self.radius);
        for _ in 0..LONGEST * steps {
            world.step()?;
            watch(&world);
            let p = world.particles();
            if p.position[0].y > radius {
                return Ok(Flight {
                    along: p.velocity[0].x.to_f64(),
                    normal: p.velocity[0].y.to_f64(),
                    spin: p.angular_velocity[0].to_f64(),
                });
            }
        }
        Err(Failure::Oracle("the sphere does not come back".to_owned()))
    }
    /// The motion after the collision, from the kernel.
    ///
    /// # Errors
    /// As [`watched`](Self::watched).
    pub fn measured(&self, before: Flight, steps: u64) -> Result<Flight, Failure> {
        self.watched(before, steps, |_| {})
    }
}

/// Number of durations without dissipation after which a collision counts as stuck.
const LONGEST: u64 = 20;
