//! A bonded packing at rest, and runs that start from it.

use super::amplification::integrator;
use super::network::{Linearisation, linearise};
use super::running::grows;
use crate::checks::Failure;
use crate::checks::dem::remembered::start;
use crate::oracles::amplification::Method;
use crate::scenes::Draft;
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::model::{BondLaws, Model};
use gouge_runner::run::{PhaseKind, begin_phase, phases};
use rand::RngExt;
use rand_pcg::Pcg64;

/// A packing at rest: settled, clipped and bonded, without a fault, with bond forces only.
pub struct Packing {
    world: World,
    model: Model,
}

impl Packing {
    /// The packing of a built-in scene, settled for a fraction of the scene's duration.
    ///
    /// # Errors
    /// States that the kernel refuses.
    pub fn new(name: &str, part: u64) -> Result<Self, Failure> {
        let mut scene = Draft::builtin(name).scene()?;
        if let Some(setup) = &mut scene.setup {
            setup.fault = None;
        }
        let phases = phases(&scene);
        let mut world = None;
        for (index, phase) in phases.iter().enumerate() {
            let mut next = begin_phase(&scene, &phases, index, world)?;
            if !matches!(phase.kind, PhaseKind::Settle(_)) {
                let model = Model {
                    ambient: None,
                    external: None,
                    contact: None,
                    driving: None,
                    ledger: false,
                    ..*next.model()
                };
                let mut particles = next.particles().clone();
                particles.velocity.fill(Vec2::zero());
                particles.angular_velocity.fill(0.0);
                let world = World::new(model, particles, &start(&next))?;
                return Ok(Self { world, model });
            }
            for _ in 0..phase.steps / part {
                next.step().map_err(Failure::from)?;
            }
            world = Some(next);
        }
        Err(Failure::Oracle(format!("{name} has no bonded phase")))
    }

    /// The same packing with the damping of bending and shearing multiplied by a factor.
    pub fn damped(mut self, factor: f64) -> Self {
        self.model.bond = self.model.bond.map(|bond| BondLaws {
            tangential: bond.tangential.map(|mut beam| {
                beam.damping *= factor;
                beam
            }),
            ..bond
        });
        self
    }

    /// Its stiffness and damping.
    ///
    /// # Errors
    /// States that the kernel refuses.
    pub fn linearised(&self) -> Result<Linearisation, Failure> {
        linearise(&self.world, self.model)
    }

    /// A run with random initial speeds, with the given integrator and time step.
    ///
    /// # Errors
    /// States that the kernel refuses.
    pub fn set_off(&self, integrator: Integrator, step: f64) -> Result<World, Failure> {
        let mut random = Pcg64::new(7, 1);
        let mut speed = || 2e-9 * (random.random::<f64>() - 0.5);
        let mut particles = self.world.particles().clone();
        for i in 0..particles.len() {
            particles.velocity[i] = Vec2::new(speed(), speed());
            particles.angular_velocity[i] = speed() / particles.radius[i];
        }
        let bonds = start(&self.world);
        let model = Model {
            integrator,
            time_step: step,
            ..self.model
        };
        Ok(World::new(model, particles, &bonds)?)
    }

    /// Whether the forces of such a run grow.
    fn runs_away(&self, method: Method, step: f64) -> Result<bool, Failure> {
        let mut world = self.set_off(integrator(method), step)?;
        let mut scale = None;
        grows(|| {
            world.step()?;
            let squares = world.forces().force.iter().map(|f| f.norm_squared());
            let size = squares.sum::<f64>().sqrt();
            Ok(size / *scale.get_or_insert(size))
        })
    }

    /// Number of runs, of two, on the wrong side of a critical step.
    ///
    /// # Errors
    /// States that are no longer finite.
    pub fn wrong(&self, method: Method, critical: f64) -> Result<usize, Failure> {
        let below = self.runs_away(method, 0.995 * critical)?;
        let above = self.runs_away(method, 1.005 * critical)?;
        Ok(usize::from(below) + usize::from(!above))
    }
}
