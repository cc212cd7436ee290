//! A world, and the number types for which worlds exist.

use super::execution::Execution;
use super::state::{Drive, State};
use super::workspace::Workspace;
use crate::balance::Energy;
use crate::bonds::Bonds;
use crate::contacts::Contacts;
use crate::error::StepError;
use crate::forces::{Bodies, Forces, Interaction, PartWorkspace};
use crate::model::{ContactNormal, Model};
use crate::particles::Particles;
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::neighbors::Neighbors;
use gouge_common::parts::Parts;

/// A model, its state, the buffers of a step, and how steps are executed.
///
/// `S` is the type of its numbers, `N` the choice of the normal law of contacts, or such a law.
/// Checkpoints hold only the state; the rest follows from the model, the state and the machine.
#[derive(Clone, Debug)]
pub struct World<S: Number = f64, N = ContactNormal> {
    pub(super) model: Model<N>,
    pub(super) state: State<S>,
    pub(super) workspace: Workspace<S>,
    pub(super) execution: Execution,
}

impl<S: Number, N> World<S, N> {
    /// The same world with another instruction set; the bits of the results do not depend on it.
    pub fn with_instructions(mut self, instructions: Instructions) -> Self {
        self.execution.instructions = instructions;
        self
    }

    /// The same world, divided among threads of the pool; the bits of the results do not depend on their number.
    ///
    /// With a ledger, contacts and bonds are computed in one part, so that sums of heat keep their order.
    pub fn with_threads(self, threads: usize) -> Self {
        let parts = Parts::new(self.state.particles.len(), threads);
        self.with_parts(parts)
    }

    pub(super) fn with_parts(mut self, parts: Parts) -> Self {
        let number = parts.number();
        self.execution.parts = parts;
        self.workspace.parts = vec![PartWorkspace::default(); number];
        self.workspace.stale_parts.resize(number, false);
        self.reserve();
        self
    }

    /// Reserve memory for broken bonds.
    pub(super) fn reserve(&mut self) {
        let breakable = self.model.bond.filter(|laws| laws.yielding.is_some());
        let bonds = breakable.and(self.state.bonds.as_ref());
        let bonds = bonds.map_or(0, Bonds::len);
        let particles = self.state.particles.len();
        let sizes = self.execution.parts.sizes();
        self.workspace.reserve(bonds, particles, sizes);
    }

    /// The model.
    pub fn model(&self) -> &Model<N> {
        &self.model
    }
    /// The state.
    pub fn state(&self) -> &State<S> {
        &self.state
    }
    /// The particles.
    pub fn particles(&self) -> &Particles<S> {
        &self.state.particles
    }
    /// The particles, and how forces move them.
    pub(super) fn bodies(&self) -> Bodies<'_, S> {
        Bodies {
            particles: &self.state.particles,
            inverse_mass: &self.workspace.inverse_mass,
        }
    }
    /// Inverse mass of a particle in 1/kg; zero if forces cannot move it.
    pub fn inverse_mass(&self, i: usize) -> S {
        self.workspace.inverse_mass[i]
    }
    /// The bonds, if the model has them.
    pub fn bonds(&self) -> Option<&Bonds<S>> {
        self.state.bonds.as_ref()
    }
    /// The contact list, if the model has contacts.
    pub fn contacts(&self) -> Option<&Contacts<S>> {
        self.state.contacts.as_ref()
    }
    /// The driving force.
    pub fn drive(&self) -> &Drive<S> {
        &self.state.drive
    }
    /// Forces and torques of the latest evaluation.
    pub fn forces(&self) -> &Forces<S> {
        &self.state.forces
    }
    /// Number of times the neighbour list was built.
    pub fn rebuilds(&self) -> u64 {
        self.workspace
            .neighbors
            .as_ref()
            .map_or(0, Neighbors::rebuilds)
    }
    /// Number of completed steps.
    pub fn steps(&self) -> u64 {
        self.state.steps
    }
    /// Time in s: number of steps times the time step.
    pub fn time(&self) -> f64 {
        self.state.steps as f64 * self.model.time_step
    }
}

/// A number type for which worlds exist; [`worlds_of!`](crate::worlds_of) implements it.
///
/// Generic functions are compiled in each crate that calls them, and those of a world contain every pass for every
/// choice of laws. They are therefore methods of the number type, so that they are compiled only once, with the crate
/// that implements it.
pub trait Number: Lanes {
    /// Implementation of [`World::step`].
    ///
    /// # Errors
    /// As for [`World::step`].
    fn step(world: &mut World<Self>) -> Result<(), StepError>;
    /// Implementation of [`World::evaluate_if_pending`] when an evaluation is pending.
    ///
    /// # Errors
    /// As for [`World::step`].
    fn evaluate(world: &mut World<Self>) -> Result<(), StepError>;
    /// Implementation of [`World::interactions`].
    fn interactions(world: &World<Self>) -> Vec<Interaction>;
    /// The energies of [`World::energy`] that are functions of state, in J.
    fn state_energy(world: &World<Self>) -> Energy<Self>;
}

/// Implements [`Number`] for a type, and compiles all that its worlds do.
#[macro_export]
macro_rules! worlds_of {
    ($number:ty) => {
        impl $crate::Number for $number {
            fn step(world: &mut $crate::World<Self>) -> Result<(), $crate::StepError> {
                world.take_step()
            }
            fn evaluate(world: &mut $crate::World<Self>) -> Result<(), $crate::StepError> {
                world.evaluate_first()
            }
            fn interactions(world: &$crate::World<Self>) -> Vec<$crate::forces::Interaction> {
                world.find_interactions()
            }
            fn state_energy(world: &$crate::World<Self>) -> $crate::estimators::Energy<Self> {
                world.sum_state_energy()
            }
        }
    };
}

worlds_of!(f64);
