//! Continuing from one phase of a scene to the next, and returning to an earlier state.

use super::begin::Start;
use super::simulation::World;
use super::state::State;
use super::workspace::Workspace;
use crate::error::ModelError;
use crate::model::Model;
use crate::particles::{Particles, Role};

impl World {
    /// Continue from the present state, at t = 0, with another model and, if given, other roles.
    ///
    /// Bonds, contact memories and the driving force are kept; the ledger starts again.
    ///
    /// # Errors
    /// As for [`World::new`].
    pub fn continue_with(
        mut self,
        model: Model,
        roles: Option<Vec<Role>>,
    ) -> Result<Self, ModelError> {
        let state = &mut self.state;
        if let Some(roles) = roles {
            state.particles.assign(roles);
        }
        let bonds = state.bonds.take();
        let contacts = state.contacts.take();
        let start = Start {
            drive_force: state.drive.force,
            ..Start::default()
        };
        let mut world = Self::new(model, self.state.particles, &start)?
            .with_instructions(self.execution.instructions)
            .with_parts(self.execution.parts);
        world.adopt(
            bonds.map_or_else(Vec::new, |bonds| bonds.iter().collect()),
            contacts.map_or_else(Vec::new, |contacts| contacts.remembered().collect()),
        );
        world.make_edges_unbreakable();
        world.begin_ledger();
        Ok(world)
    }

    /// The same world in an earlier state. Buffers and the neighbour list are rebuilt; no later bit depends on them.
    pub fn with_state(mut self, state: State) -> Self {
        self.workspace = Workspace::new(&self.model, &state.particles);
        self.state = state;
        let parts = self.execution.parts.clone();
        let mut world = self.with_parts(parts);
        world.find_neighbors();
        world
    }

    /// The particles only.
    pub fn into_particles(self) -> Particles {
        self.state.particles
    }

    /// Make bonds with a driven or fixed particle unbreakable, if the model requires it.
    fn make_edges_unbreakable(&mut self) {
        if let (Some(bonds), Some(laws)) = (&mut self.state.bonds, self.model.bond)
            && laws.has_unbreakable_edges()
        {
            bonds.make_edges_unbreakable(&self.state.particles);
        }
    }
}
