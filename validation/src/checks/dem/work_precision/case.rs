//! What is run: a scene, its steps, its orders, and where its truth comes from.

use crate::checks::dem::scenes::scene;
use crate::checks::{Failure, largest};
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
    /// Orders that theory predicts for the integrators, in the order of `INTEGRATORS`.
    pub orders: [f64; 5],
    /// Largest distance of an observed order from that of theory.
    pub margin: f64,
    /// The step in s that stands for the 10 ns of the thesis: the same fraction of the time scale of two
    /// equal grains in contact, sqrt(m / 2 k).
    pub thesis_step: f64,
    /// Number of these steps to the end.
    pub thesis_steps: u64,
    /// How often that step is doubled for the coarsest.
    pub doublings: u32,
    /// Number of steps tried, each half the one before.
    pub rungs: u32,
    /// Rungs that show the order: from the first the error is asymptotic, and the last is enough for a look
    /// in passing.
    pub brief: Range<u32>,
    /// The state from which all runs start.
    pub origin: fn() -> Result<Origin, Failure>,
    /// The state at the end, good enough for runs up to a rung.
    pub truth: fn(&Case, &Origin, u32) -> Result<Truth, Failure>,
}

impl Case {
    /// Step in s and number of steps of a rung; the same end for each, exactly.
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

/// An initial state in plain doubles, from which every number type starts.
pub struct Origin {
    /// The model; integrator and step are those of a run.
    pub model: Model,
    /// The particles.
    pub particles: Particles,
    /// Bonds, contacts and driving force.
    pub start: Start,
}

impl Origin {
    /// The origin that a scene's text describes.
    pub fn read(text: &str) -> Result<Self, Failure> {
        let scene = scene(text)?;
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

    /// Largest error of a position in units of the largest displacement of the truth.
    pub fn error<S: Real>(&self, particles: &Particles<S>, truth: &Truth) -> f64 {
        let pairs = particles.position.iter().zip(&truth.positions);
        let errors = pairs.map(|(x, end)| self.distance(*end, [wide(x.x), wide(x.y)]));
        largest(errors) / truth.scale
    }

    /// Distance of two places in m, that of the nearest image.
    pub fn distance(&self, a: [Df64; 2], b: [Df64; 2]) -> f64 {
        let [dx, dy] = [0, 1].map(|k| (a[k] - b[k]).hi());
        let dx = self.model.period().map_or(dx, |period| {
            ((a[0] - b[0]) - Df64::from(period) * (dx / period).round()).hi()
        });
        dx.hypot(dy)
    }

    /// The truth of the given places, with an estimate in m of how far off they are.
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

/// Where the particles are at the end.
pub struct Truth {
    /// Places in m.
    pub positions: Vec<[Df64; 2]>,
    /// Largest displacement in m, the unit of errors.
    pub scale: f64,
    /// Estimated error, in that unit.
    pub uncertainty: f64,
}

/// A number of any type here, all its digits.
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
