//! The state of a scene and how it advances.

mod continuation;
mod dispatch;
mod evaluate;
mod number;
mod record;
mod guard;

pub use guard::stable_step_estimate;
pub use number::Number;

use crate::balance::{Energy, Ledger};
use crate::bonds::{BondStart, Bonds};
use crate::contacts::{ContactStart, Contacts};
use crate::error::{ModelError, StepError};
use crate::forces::{Forces, PartWorkspace, Tally};
use crate::integrators::{
    Advance, BeemanBegin, BeemanCorrect, BeemanPredict, Euler, HalfKick, HalfKickAndDrift,
    Integrator, Motion, Previous, Stage, SymplecticEuler, Taylor, VerletCorrect, VerletPredict,
};
use crate::model::Model;
use crate::particles::{Particles, Role};
use dispatch::with_metric;
use gouge_common::geometry::Vec2;
use gouge_common::instructions::Instructions;
use gouge_common::neighbors::{Neighbors, Staleness};
use gouge_common::parts::Parts;
use gouge_common::scalar::Real;

/// Total driving force and what it meets.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive<S> {
    /// Total driving force in N, for the next step.
    pub force: Vec2<S>,
    /// Total driving force in N in the step that led to the present state.
    pub applied: Vec2<S>,
    /// Sum of all other forces on the driven particles in N, at the latest evaluation.
    pub reaction: Vec2<S>,
    /// Mean horizontal velocity of the driven particles in m/s when the step began.
    pub known_velocity: S,
}

/// The initial state of a scene.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Bonds.
    pub bonds: Vec<BondStart>,
    /// Memory of contacts that began earlier.
    pub contacts: Vec<ContactStart>,
    /// Total driving force in N.
    pub drive_force: Vec2,
}

/// Everything that changes with time, and exactly the arrays that the model asks for.
#[derive(Clone, Debug)]
pub struct World<S: Number = f64> {
    model: Model,
    particles: Particles<S>,
    inverse_mass: Vec<S>,
    inverse_inertia: Vec<S>,
    forces: Forces<S>,
    strong: Option<Bonds<S>>,
    weak: Option<Contacts<S>>,
    driven: Vec<u32>,
    drive: Drive<S>,
    previous: Previous<S>,
    turns: bool,
    ledger: Option<Ledger<S>>,
    tally: Tally<S>,
    desks: Vec<PartWorkspace<S>>,
    verdicts: Vec<bool>,
    /// Whether the neighbour list is stale, where that is known.
    is_stale: Option<bool>,
    parts: Parts,
    instructions: Instructions,
    steps: u64,
    is_evaluated: bool,
}

impl<S: Number> World<S> {
    /// The world of a model, with its particles and links at t = 0.
    ///
    /// # Errors
    /// Links that cannot be, a periodic box narrower than two cells, driving without driven particles,
    /// masses or moments of inertia beyond all numbers or with inverses that are.
    pub fn new(model: Model, particles: Particles<S>, start: &Start) -> Result<Self, ModelError> {
        check_width(&model, &particles)?;
        check_inertia(&particles)?;
        let driven: Vec<u32> = match model.driving {
            Some(_) => particles
                .with_role(Role::Driven)
                .map(|i| i as u32)
                .collect(),
            None => Vec::new(),
        };
        if model.driving.is_some() && driven.is_empty() {
            return Err(ModelError::NothingDriven);
        }
        let inverse = |column: &[S], particles: &Particles<S>| {
            let one = S::from_f64(1.0);
            let of = |(i, &x): (usize, &S)| {
                if particles.is_fixed(i) {
                    S::zero()
                } else {
                    one / x
                }
            };
            column.iter().enumerate().map(of).collect::<Vec<S>>()
        };
        let mut world = Self {
            inverse_mass: inverse(&particles.mass, &particles),
            inverse_inertia: inverse(&particles.moment_of_inertia, &particles),
            forces: Forces::new(particles.len()),
            strong: None,
            weak: None,
            driven,
            drive: Drive {
                force: start.drive_force.cast(),
                ..Drive::default()
            },
            previous: Previous::new(model.integrator, particles.len()),
            turns: turns(&model, &particles),
            ledger: None,
            tally: Tally::default(),
            desks: vec![PartWorkspace::default()],
            verdicts: vec![false],
            is_stale: None,
            parts: Parts::of(particles.len(), 1),
            instructions: Instructions::default(),
            steps: 0,
            is_evaluated: false,
            model,
            particles,
        };
        world.drive.applied = world.drive.force;
        world.make_links(start)?;
        world.make_room();
        if model.ledger {
            world.ledger = Some(Ledger::starting_from(&S::state_energy(&world)));
        }
        Ok(world)
    }

    fn make_links(&mut self, start: &Start) -> Result<(), ModelError> {
        let Self {
            model, particles, ..
        } = self;
        if let Some(bond) = model.bond {
            let edges = bond.has_unbreakable_edges();
            let period = model.period();
            self.strong = Some(with_metric!(model, metric => {
                Bonds::new(metric, particles, &start.bonds, edges, period)
            })?);
        }
        if let Some(contact) = model.contact {
            let neighbors = Neighbors::new(particles.reaching(), &model.domain);
            let mut weak = Contacts::new(neighbors, contact.remembers());
            with_metric!(model, metric => {
                weak.rebuild(metric, particles, self.strong.as_ref());
                weak.remember(metric, particles, &start.contacts)
            })?;
            self.weak = Some(weak);
        }
        Ok(())
    }

    /// The same world, computed with the given instructions; bits do not depend on them.
    pub fn with_instructions(mut self, instructions: Instructions) -> Self {
        self.instructions = instructions;
        self
    }

    /// The same world, divided for so many threads of the pool; bits do not depend on their number.
    ///
    /// Worlds with a ledger compute links in one part, so that its sums keep their order.
    pub fn with_threads(self, threads: usize) -> Self {
        let parts = Parts::of(self.particles.len(), threads);
        self.with_parts(parts)
    }

    fn with_parts(mut self, parts: Parts) -> Self {
        let number = parts.number();
        self.parts = parts;
        self.desks = vec![PartWorkspace::default(); number];
        self.verdicts.resize(number, false);
        self.make_room();
        self
    }

    /// Room for as many broken links as there are, so that a step allocates nothing.
    fn make_room(&mut self) {
        let number = self.strong.as_ref().map_or(0, Bonds::len);
        let particles = self.particles.len().max(1);
        for (desk, size) in self.desks.iter_mut().zip(self.parts.sizes()) {
            desk.broken.reserve(number * size / particles);
        }
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }
    /// The particles.
    pub fn particles(&self) -> &Particles<S> {
        &self.particles
    }
    /// Strong links, if the model has them.
    pub fn bonds(&self) -> Option<&Bonds<S>> {
        self.strong.as_ref()
    }
    /// Weak links, if the model has them.
    pub fn contacts(&self) -> Option<&Contacts<S>> {
        self.weak.as_ref()
    }
    /// The driving force.
    pub fn drive(&self) -> &Drive<S> {
        &self.drive
    }
    /// Forces and torques of the latest evaluation.
    pub fn forces(&self) -> &Forces<S> {
        &self.forces
    }
    /// How often the neighbour list was built.
    pub fn rebuilds(&self) -> u64 {
        self.weak
            .as_ref()
            .map_or(0, |weak| weak.neighbors().rebuilds())
    }
    /// Completed steps.
    pub fn steps(&self) -> u64 {
        self.steps
    }
    /// Time since the initial state in s.
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.model.time_step
    }

    /// Advance by one time step.
    ///
    /// # Errors
    /// A state that is no longer finite, or a particle that moved more than a cell. The state is then
    /// that of the failure, not of the last good step.
    pub fn step(&mut self) -> Result<(), StepError> {
        S::step(self)
    }

    fn take_step(&mut self) -> Result<(), StepError> {
        self.evaluate_if_pending()?;
        let before = self.tally;
        let step = self.model.time_step;
        match self.model.integrator {
            Integrator::Euler => self.advance::<Euler>(step),
            Integrator::SymplecticEuler => self.advance::<SymplecticEuler>(step),
            Integrator::Taylor => self.advance::<Taylor>(step),
            Integrator::VelocityVerlet => {
                self.go_and_return::<VerletPredict, VerletCorrect>(step)?
            }
            Integrator::VelocityVerletHalfStep => {
                self.go_and_return::<HalfKickAndDrift, HalfKick>(step)?;
            }
            Integrator::Beeman => {
                if !self.previous.is_set {
                    self.advance::<BeemanBegin>(step);
                    self.previous.is_set = true;
                }
                self.go_and_return::<BeemanPredict, BeemanCorrect>(step)?;
            }
        }
        self.steps += 1;
        self.is_evaluated = !self.model.integrator.evaluates_first();
        if let Some(ledger) = &mut self.ledger {
            let after = if self.is_evaluated {
                self.tally
            } else {
                before
            };
            ledger.advance(&before, &after, step);
        }
        Ok(())
    }

    /// Bring forces and links up to date with the positions, as the next step would.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn evaluate_if_pending(&mut self) -> Result<(), StepError> {
        if self.is_evaluated {
            return Ok(());
        }
        S::evaluate(self)
    }

    fn evaluate_first(&mut self) -> Result<(), StepError> {
        self.learn_velocity();
        self.evaluate(self.model.integrator.evaluates_first(), false)?;
        self.is_evaluated = true;
        Ok(())
    }

    /// Check that the state is finite and that no particle moves more than a cell a step.
    ///
    /// # Errors
    /// The first particle that violates either.
    pub fn check(&self) -> Result<(), StepError> {
        guard::check(self)
    }

    /// Note the mean velocity of the driven particles before it is predicted.
    fn learn_velocity(&mut self) {
        if !self.driven.is_empty() {
            let mut sum = S::zero();
            for &i in &self.driven {
                sum += self.particles.velocity[i as usize].x;
            }
            self.drive.known_velocity = sum * (1.0 / self.driven.len() as f64);
        }
    }

    /// Advance all particles by a stage of the method; rotations only where something turns.
    fn advance<T: Stage>(&mut self, step: f64) {
        let Self {
            model,
            particles: p,
            forces,
            previous,
            weak,
            verdicts,
            ..
        } = self;
        let linear = Motion {
            coordinate: &mut p.position,
            velocity: &mut p.velocity,
            force: &forces.force,
            inverse_inertia: &self.inverse_mass,
            previous: &mut previous.linear,
            older: &mut previous.older_linear,
        };
        let angular = self.turns.then_some(Motion {
            coordinate: &mut p.angle,
            velocity: &mut p.angular_velocity,
            force: &forces.torque,
            inverse_inertia: &self.inverse_inertia,
            previous: &mut previous.angular,
            older: &mut previous.older_angular,
        });
        let neighbors = weak.as_ref().map(Contacts::neighbors);
        with_metric!(model, metric => {
            let work = Advance {
                stage: core::marker::PhantomData::<fn() -> T>,
                step,
                linear,
                angular,
                staleness: Staleness::of(neighbors, metric),
            };
            self.parts.run(work, verdicts, self.instructions);
        });
        if T::MOVES {
            self.is_stale = Some(verdicts.contains(&true));
        }
        if T::KEEPS_FORCES {
            core::mem::swap(&mut forces.force, &mut previous.linear);
            core::mem::swap(&mut forces.torque, &mut previous.angular);
        }
    }

    /// A step in two stages, with an evaluation between them.
    fn go_and_return<T: Stage, U: Stage>(&mut self, step: f64) -> Result<(), StepError> {
        self.learn_velocity();
        self.advance::<T>(step);
        let outcome = self.evaluate(true, T::KEEPS_FORCES);
        self.advance::<U>(step);
        outcome
    }

    /// Every term of the energy balance (72) in J; those of the ledger are zero without one.
    pub fn energy(&self) -> Energy<S> {
        let energy = S::state_energy(self);
        match &self.ledger {
            Some(ledger) => ledger.balance(energy),
            None => energy,
        }
    }
}

/// Whether anything turns: a particle that spins already, or a law that exerts a torque.
fn turns<S: Real>(model: &Model, particles: &Particles<S>) -> bool {
    let spins = particles
        .angular_velocity
        .iter()
        .any(|spin| *spin != S::zero());
    let rubs = model
        .contact
        .is_some_and(|contact| contact.tangential.is_some());
    let bends = model.bond.is_some_and(|bond| bond.tangential.is_some());
    spins || rubs || bends
}

/// What can move has a mass and a moment of inertia that are finite, and so are their inverses.
fn check_inertia<S: Real>(particles: &Particles<S>) -> Result<(), ModelError> {
    let columns = [
        ("the mass of a particle", &particles.mass),
        (
            "the moment of inertia of a particle",
            &particles.moment_of_inertia,
        ),
    ];
    for (name, column) in columns {
        for (i, &inertia) in column.iter().enumerate() {
            let inverse = S::from_f64(1.0) / inertia;
            let is_usable = inertia.is_finite() && inverse.is_finite();
            if !particles.is_fixed(i) && !is_usable {
                return Err(ModelError::Parameter {
                    name,
                    value: inertia.to_f64(),
                    accepted: "finite, and so must be its inverse",
                });
            }
        }
    }
    Ok(())
}

/// A periodic box holds at least two cells across, so that a pair never meets twice.
fn check_width<S: Real>(model: &Model, particles: &Particles<S>) -> Result<(), ModelError> {
    let cell = 2.0 * particles.largest_radius();
    match model.period() {
        Some(width) if width < 2.0 * cell => Err(ModelError::NarrowBox { width, cell }),
        _ => Ok(()),
    }
}
