//! A case: the scene, its time steps, its orders, and the source of its reference solution.

use crate::checks::{Failure, largest};
use crate::scenes::Draft;
use gouge_common::scalar::Real;
use gouge_dem::integrators::Integrator;
use gouge_dem::model::Model;
use gouge_dem::particles::{Particles, Role};
use gouge_dem::{Number, Start, World};
use std::ops::Range;
use xprec::Df64;

/// A scene of the diagrams.
pub struct Case {
    /// Name.
    pub name: &'static str,
    /// Theoretical orders of the integrators, in the order of `INTEGRATORS`.
    pub orders: [f64; 5],
    /// Largest admissible distance of an observed order from the theoretical one.
    pub margin: f64,
    /// The time step in s that corresponds to the thesis's 10 ns: the same fraction of the time scale
    /// of two equal grains in contact, sqrt(m / 2 k).
    pub thesis_step: f64,
    /// Number of these steps until the end.
    pub thesis_steps: u64,
    /// Number of doublings from that step to the coarsest one.
    pub doublings: u32,
    /// Number of time steps tried, each half the previous one.
    pub rungs: u32,
    /// Rungs from which the order is fitted: the error is asymptotic from the first one on, and the
    /// last one suffices for a quick check.
    pub brief: Range<u32>,
    /// The state from which all runs start.
    pub origin: fn() -> Result<Origin, Failure>,
    /// The state at the end, accurate enough for runs up to the given rung.
    pub truth: fn(&Case, &Origin, u32) -> Result<Truth, Failure>,
}

impl Case {
    /// Time step in s and number of steps of a rung; all rungs end at exactly the same time.
    pub fn rung(&self, rung: u32) -> (f64, u64) {
        let coarsest = self.thesis_step * f64::from(1 << self.doublings);
        let step = coarsest / (1_u64 << rung) as f64;
        (step, (self.thesis_steps >> self.doublings) << rung)
    }
    /// End in s.
    pub fn end(&self) -> f64 {
        self.thesis_step * self.thesis_steps as f64
    }
}

/// An initial state in plain doubles, from which runs in every number type start.
pub struct Origin {
    /// The model; integrator and time step are set for each run.
    pub model: Model,
    /// The particles.
    pub particles: Particles,
    /// Bonds, contacts and driving force.
    pub start: Start,
}

impl Origin {
    /// The origin that a draft describes.
    pub fn read(draft: &Draft) -> Result<Self, Failure> {
        let scene = draft.scene()?;
        let world = scene.initial_world()?;
        Ok(Self {
            model: *world.model(),
            particles: world.particles().clone(),
            start: Start {
                bonds: scene.bonds.iter().map(|(bond, _)| *bond).collect(),
                ..Start::default()
            },
        })
    }

    /// A world that starts here, in any number type, without the ledger.
    pub fn world<S: Number>(&self, integrator: Integrator, step: f64) -> Result<World<S>, Failure> {
        let model = Model {
            integrator,
            time_step: step,
            ledger: false,
            ..self.model
        };
        Ok(World::new(model, cast(&self.particles), &self.start)?)
    }

    /// Largest error of a position in units of the largest displacement of the reference solution.
    pub fn error<S: Real>(&self, particles: &Particles<S>, truth: &Truth) -> f64 {
        let pairs = particles.position.iter().zip(&truth.positions);
        let errors = pairs.map(|(x, end)| self.distance(*end, [wide(x.x), wide(x.y)]));
        largest(errors) / truth.scale
    }

    /// Distance of two positions in m, to the nearest image.
    pub fn distance(&self, a: [Df64; 2], b: [Df64; 2]) -> f64 {
        let [dx, dy] = [0, 1].map(|k| (a[k] - b[k]).hi());
        let dx = self.model.period().map_or(dx, |period| {
            ((a[0] - b[0]) - Df64::from(period) * (dx / period).round()).hi()
        });
        dx.hypot(dy)
    }

    /// The reference solution with the given positions and an estimate in m of their error.
    pub fn truth(&self, positions: Vec<[Df64; 2]>, uncertainty: f64) -> Truth {
        let start = &self.particles.position;
        let moved = start
            .iter()
            .zip(&positions)
            .enumerate()
            .map(|(i, (x, end))| {
                let from = [Df64::from(x.x), Df64::from(x.y)];
                let is_fixed = self.particles.role[i] == Role::Fixed;
                if is_fixed {
                    0.0
                } else {
                    self.distance(from, *end)
                }
            });
        let scale = largest(moved);
        Truth {
            positions,
            scale,
            uncertainty: uncertainty / scale,
        }
    }
}

/// Positions of the particles at the end.
pub struct Truth {
    /// Positions in m.
    pub positions: Vec<[Df64; 2]>,
    /// Largest displacement in m, the unit of errors.
    pub scale: f64,
    /// Estimated error, in that unit.
    pub uncertainty: f64,
}

/// A number of any type, with all its digits.
pub fn wide<S: Real>(number: S) -> Df64 {
    let high = number.to_f64();
    Df64::from(high) + (number - S::from_f64(high)).to_f64()
}

fn cast<S: Real>(particles: &Particles) -> Particles<S> {
    let column = |numbers: &[f64]| numbers.iter().map(|&x| S::from_f64(x)).collect();
    Particles {
        position: particles.position.iter().map(|x| x.cast()).collect(),
        velocity: particles.velocity.iter().map(|v| v.cast()).collect(),
        angle: column(&particles.angle),
        angular_velocity: column(&particles.angular_velocity),
        radius: column(&particles.radius),
        mass: column(&particles.mass),
        moment_of_inertia: column(&particles.moment_of_inertia),
        role: particles.role.clone(),
    }
}
