//! Which numbers a world can be made of, and where its passes are compiled.

use super::simulation::World;
use crate::balance::Energy;
use crate::error::StepError;
use crate::forces::Interaction;
use gouge_common::lanes::Lanes;

/// A number type of which a world can be made.
///
/// Generic functions are compiled in every crate that calls them, and those of a world contain every pass for
/// every choice of laws. They are therefore methods of the number type: for `f64`, which all crates use, they
/// are compiled once, with the kernel. Other number types need no methods of their own.
pub trait Number: Lanes {
    /// What [`World::step`] does.
    ///
    /// # Errors
    /// Those of [`World::step`].
    fn step(world: &mut World<Self>) -> Result<(), StepError> {
        world.take_step()
    }
    /// What [`World::evaluate_if_pending`] does where forces are pending.
    ///
    /// # Errors
    /// Those of [`World::step`].
    fn evaluate(world: &mut World<Self>) -> Result<(), StepError> {
        world.evaluate_first()
    }
    /// What [`World::interactions`] finds.
    fn interactions(world: &World<Self>) -> Vec<Interaction> {
        world.find_interactions()
    }
    /// The energies of [`World::energy`] that are functions of the state, in J.
    fn state_energy(world: &World<Self>) -> Energy<Self> {
        world.sum_state_energy()
    }
}

impl Number for f64 {
    fn step(world: &mut World) -> Result<(), StepError> {
        world.take_step()
    }
    fn evaluate(world: &mut World) -> Result<(), StepError> {
        world.evaluate_first()
    }
    fn interactions(world: &World) -> Vec<Interaction> {
        world.find_interactions()
    }
    fn state_energy(world: &World) -> Energy<f64> {
        world.sum_state_energy()
    }
}
