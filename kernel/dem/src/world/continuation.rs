//! Going on from one phase to the next.

use super::{Number, Start, World};
use crate::balance::Ledger;
use crate::error::ModelError;
use crate::model::Model;
use crate::particles::{Particles, Role};

impl World {
    /// Go on from the present state at t = 0 with another model and, if given, other roles.
    ///
    /// Bonds, contacts that remember and the driving force are kept; the ledger begins anew.
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn continue_with(
        mut self,
        model: Model,
        roles: Option<Vec<Role>>,
    ) -> Result<Self, ModelError> {
        if let Some(roles) = roles {
            self.particles.assign(roles);
        }
        let links = self
            .strong
            .map_or_else(Vec::new, |strong| strong.iter().collect());
        let contacts = self
            .weak
            .map_or_else(Vec::new, |weak| weak.remembered().collect());
        let start = Start {
            drive_force: self.drive.force,
            ..Start::default()
        };
        let mut world = Self::new(model, self.particles, &start)?
            .with_instructions(self.instructions)
            .with_parts(self.parts);
        world.adopt_links(links, contacts);
        world.strengthen_edges();
        if model.ledger {
            world.ledger = Some(Ledger::starting_from(&Number::state_energy(&world)));
        }
        Ok(world)
    }

    /// The particles alone.
    pub fn into_particles(self) -> Particles {
        self.particles
    }

    /// Make the bonds of driven and fixed particles unbreakable, if the model wants them so.
    fn strengthen_edges(&mut self) {
        if let (Some(strong), Some(bond)) = (&mut self.strong, self.model.bond)
            && bond.has_unbreakable_edges()
        {
            strong.strengthen_edges(&self.particles);
        }
    }
}
