//! Continuing from one phase of a scene to the next, and returning to an earlier state.

use super::begin::Start;
use super::choice::NormalChoice;
use super::simulation::World;
use super::state::State;
use super::workspace::Workspace;
use crate::bonds::{Bond, Bonds, Rest};
use crate::contacts::{ContactMemory, Contacts};
use crate::error::ModelError;
use crate::model::Model;
use crate::particles::{Particles, Role};
use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;

/// What one model takes over from the state of another.
#[derive(Clone, Debug)]
pub struct Continuation {
    /// The particles.
    pub particles: Particles,
    pub(super) bonds: Vec<Bond<f64>>,
    pub(super) contacts: Vec<(Pair, ContactMemory<f64>)>,
    /// Total driving force in N.
    pub(super) drive_force: Vec2,
}

impl Continuation {
    /// Number of bonds.
    pub fn bonds(&self) -> usize {
        self.bonds.len()
    }

    /// Let all contacts begin anew.
    pub fn forget_contacts(&mut self) {
        self.contacts.clear();
    }

    /// The world of a model at t = 0.
    ///
    /// # Errors
    /// As for [`World::new`].
    pub fn begin<N: NormalChoice<f64>>(self, model: Model<N>) -> Result<World<f64, N>, ModelError> {
        let start = Start {
            drive_force: self.drive_force,
            ..Start::default()
        };
        let mut world = World::new(model, self.particles, &start)?;
        world.adopt(self.bonds, self.contacts);
        world.make_edges_unbreakable();
        world.begin_ledger();
        Ok(world)
    }
}

impl<N: NormalChoice<f64>> World<f64, N> {
    /// Continue from the present state, at t = 0, with another model and, if given, other roles.
    ///
    /// Bonds, contact memories and the driving force are kept; the ledger starts again.
    ///
    /// # Errors
    /// As for [`World::new`].
    pub fn continue_with<L: NormalChoice<f64>>(
        mut self,
        model: Model<L>,
        roles: Option<Vec<Role>>,
    ) -> Result<World<f64, L>, ModelError> {
        let state = &mut self.state;
        if let Some(roles) = roles {
            state.particles.assign(roles);
        }
        let (bonds, contacts) = (state.bonds.take(), state.contacts.take());
        let continuation = Continuation {
            bonds: bonds.map_or_else(Vec::new, |bonds| bonds.iter().collect()),
            contacts: contacts.map_or_else(Vec::new, |contacts| contacts.remembered().collect()),
            drive_force: state.drive.force,
            particles: self.state.particles,
        };
        let world = continuation.begin(model)?;
        Ok(world
            .with_instructions(self.execution.instructions)
            .with_parts(self.execution.parts))
    }

    /// The same initial state, with all that is known of bonds and contacts that began earlier: the unstrained states of
    /// some bonds and, if given, the memories of all contacts. The ledger starts again.
    pub fn with_history(
        mut self,
        rests: &[(Pair, Rest<f64>)],
        memories: Option<Vec<(Pair, ContactMemory<f64>)>>,
    ) -> Self {
        let state = &self.state;
        let mut bonds: Vec<Bond<f64>> = state.bonds.iter().flat_map(Bonds::iter).collect();
        for (pair, rest) in rests {
            if let Ok(at) = bonds.binary_search_by_key(pair, |bond| bond.pair) {
                bonds[at].rest = *rest;
            }
        }
        let present = || {
            state
                .contacts
                .iter()
                .flat_map(Contacts::remembered)
                .collect()
        };
        let mut contacts = memories.unwrap_or_else(present);
        contacts.sort_by_key(|(pair, _)| *pair);
        self.adopt(bonds, contacts);
        self.begin_ledger();
        self
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
