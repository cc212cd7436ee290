//! A cluster of eight grains that exercises every part of a scene: bonds, contacts with friction, drag
//! and gravity.

use crate::checks::Failure;
use gouge_common::geometry::Vec2;
use gouge_dem::bonds::BondStart;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, CreepingDrag, CundallStrackTruncated, EulerBernoulli, Gravity, HaffWerner,
    KelvinVoigt, ZhangEckert,
};
use gouge_dem::model::{
    Ambient, BondLaws, ContactLaws, ContactNormal, ContactTangential, External, Model, Yielding,
};
use gouge_dem::particles::{Particle, Particles, Role, SPHERE_INERTIA_FACTOR};
use gouge_dem::{Number, Start, World};

/// Factors by which the units of length, time and mass are smaller than the SI units.
#[derive(Clone, Copy)]
pub struct Units {
    pub length: f64,
    pub time: f64,
    pub mass: f64,
}

/// Metre, second and kilogram.
pub const SI: Units = Units {
    length: 1.0,
    time: 1.0,
    mass: 1.0,
};

/// Friction law of the contacts.
#[derive(Clone, Copy)]
pub enum Rubbing {
    Viscous,
    Spring,
}

/// Model, grains and bonds of the cluster.
#[derive(Clone)]
pub struct Cluster {
    pub model: Model,
    pub grains: Vec<Particle>,
    pub bonds: Vec<BondStart>,
}

impl Cluster {
    /// Eight grains: six are bonded, and two are thrown at the others.
    pub fn new(rubbing: Rubbing, damped: bool, units: Units) -> Self {
        let Units { length, time, mass } = units;
        let (k, c) = (mass / (time * time), if damped { mass / time } else { 0.0 });
        let mut model = Model::new(Integrator::VelocityVerlet, 1e-8 * time);
        model.contact = Some(ContactLaws {
            distance: ContactDistance::Radius,
            normal: ContactNormal::KelvinVoigt(KelvinVoigt {
                stiffness: 1e7 * k,
                damping: 2.0 * c,
            }),
            tangential: Some(match rubbing {
                Rubbing::Viscous => ContactTangential::HaffWerner(HaffWerner {
                    friction: 0.5,
                    damping: 30.0 * c,
                }),
                Rubbing::Spring => {
                    ContactTangential::CundallStrackTruncated(CundallStrackTruncated {
                        friction: if damped { 0.5 } else { 1e9 },
                        stiffness: 3e6 * k,
                    })
                }
            }),
        });
        model.bond = Some(BondLaws {
            normal: AdjustedKelvinVoigt {
                stiffness: 2e7 * k,
                damping: 3.0 * c,
            },
            tangential: Some(EulerBernoulli {
                stiffness: 1e7 * k,
                damping: 1.0 * c,
            }),
            yielding: damped.then_some(Yielding {
                law: ZhangEckert {
                    normal_strength: 4e6 * k / length,
                    tangential_strength: 2e6 * k / length,
                },
                tensile_strength: None,
                unbreakable_edges: true,
            }),
        });
        if damped {
            model.ambient = Some(Ambient::Creeping(CreepingDrag {
                viscosity: 0.5 * mass / (length * time),
            }));
            model.external = Some(External::Gravity(Gravity {
                acceleration: 1e4 * length / (time * time),
            }));
        }
        Self {
            model,
            grains: grains(units),
            bonds: bonds(),
        }
    }

    /// The world of this cluster at t = 0, in any number type.
    pub fn world<S: Number>(&self) -> Result<World<S>, Failure> {
        let particles: Particles<S> = self.grains.iter().copied().collect();
        let start = Start {
            bonds: self.bonds.clone(),
            ..Start::default()
        };
        Ok(World::new(self.model, particles, &start)?)
    }
}

fn grains(units: Units) -> Vec<Particle> {
    let Units { length, time, mass } = units;
    let table = [
        (0.0, 0.0, 1.0, 0.0),
        (2.1, 0.1, 1.1, 0.2),
        (4.1, -0.1, 0.9, -0.1),
        (1.0, 1.8, 1.0, 0.1),
        (3.1, 1.9, 1.05, 0.0),
        (5.2, 1.7, 0.95, 0.3),
        (2.0, 4.05, 1.2, -9.0),
        (-2.0, 1.25, 0.8, 7.0),
    ];
    let grain = |&(x, y, radius, speed): &(f64, f64, f64, f64)| {
        let v = if y > 4.0 {
            Vec2::new(1.0, speed)
        } else {
            Vec2::new(speed, -0.5)
        };
        Particle {
            position: Vec2::new(1e-3 * x * length, 1e-3 * y * length),
            velocity: v * (length / time),
            angle: 0.0,
            angular_velocity: 300.0 * speed / time,
            radius: 1e-3 * radius * length,
            density: 2700.0 * mass / (length * length * length),
            inertia_factor: SPHERE_INERTIA_FACTOR,
            role: Role::Free,
        }
    };
    table.iter().map(grain).collect()
}

fn bonds() -> Vec<BondStart> {
    [
        [0, 1],
        [1, 2],
        [0, 3],
        [1, 3],
        [1, 4],
        [3, 4],
        [2, 4],
        [4, 5],
        [2, 5],
    ]
    .map(|between| BondStart {
        between,
        strength_factor: 1.0,
        initial_distance: None,
        initial_angles: None,
    })
    .to_vec()
}
