//! A model with its state.

use super::execution::Execution;
use super::number::Number;
use super::state::{Drive, State};
use super::workspace::Workspace;
use crate::bonds::Bonds;
use crate::contacts::Contacts;
use crate::forces::{Forces, PartWorkspace};
use crate::model::Model;
use crate::particles::Particles;
use gouge_common::instructions::Instructions;
use gouge_common::neighbors::Neighbors;
use gouge_common::parts::Parts;

/// A model, its state, the buffers of a step, and how steps are executed.
///
/// Only the state is saved in checkpoints; the rest follows from the model, the state and the machine.
#[derive(Clone, Debug)]
pub struct World<S: Number = f64> {
    pub(super) model: Model,
    pub(super) state: State<S>,
    pub(super) workspace: Workspace<S>,
    pub(super) execution: Execution,
}

impl<S: Number> World<S> {
    /// The same world, computed with the given instructions; bits do not depend on them.
    pub fn with_instructions(mut self, instructions: Instructions) -> Self {
        self.execution.instructions = instructions;
        self
    }

    /// The same world, divided for so many threads of the pool; bits do not depend on their number.
    ///
    /// Worlds with a ledger compute contacts and bonds in one part, so that its sums keep their order.
    pub fn with_threads(self, threads: usize) -> Self {
        let parts = Parts::of(self.state.particles.len(), threads);
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

    /// Reserve room for broken bonds.
    pub(super) fn reserve(&mut self) {
        let bonds = self.state.bonds.as_ref().map_or(0, Bonds::len);
        let particles = self.state.particles.len();
        let sizes = self.execution.parts.sizes();
        self.workspace.reserve(bonds, particles, sizes);
    }

    /// The model.
    pub fn model(&self) -> &Model {
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
    /// The bonds, if the model has them.
    pub fn bonds(&self) -> Option<&Bonds<S>> {
        self.state.bonds.as_ref()
    }
    /// The pairs that may touch, if the model has contacts.
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
    /// How often the neighbour list was built.
    pub fn rebuilds(&self) -> u64 {
        self.workspace
            .neighbors
            .as_ref()
            .map_or(0, Neighbors::rebuilds)
    }
    /// Completed steps.
    pub fn steps(&self) -> u64 {
        self.state.steps
    }
    /// Time since the initial state in s.
    pub fn time(&self) -> f64 {
        self.state.steps as f64 * self.model.time_step
    }
}
