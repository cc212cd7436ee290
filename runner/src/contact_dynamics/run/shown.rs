//! The picture of a scene after a short run, without outputs.

use super::super::Scene;
use super::begin::{after_compaction, first, phases};
use super::picture::draw;
use crate::error::Error;
use crate::run::picture::Shown;
use gouge_contact_dynamics::world::World;

/// The picture of a scene after a number of steps, or at its end if that comes first.
///
/// # Errors
/// What the kernel refuses, a compaction that does not settle, or a state that becomes invalid.
pub fn shown(scene: &Scene, most_steps: u64) -> Result<Shown, Error> {
    let mut world = first(scene)?;
    if let Some(table) = &scene.packing {
        let most = table.compaction.max_steps;
        while !world.has_settled() {
            if world.steps() >= most {
                return Err(Error::Unsettled { steps: most });
            }
            step(scene, &mut world, 0)?;
        }
        world = after_compaction(scene, table, world)?;
    }
    let steps = scene.steps().min(most_steps);
    let last = phases(scene).len() - 1;
    for _ in 0..steps {
        step(scene, &mut world, last)?;
    }
    Ok(Shown {
        steps,
        time: world.time(),
        svg: draw(scene, &world).to_string(),
    })
}

fn step(scene: &Scene, world: &mut World, phase: usize) -> Result<(), Error> {
    let name = || phases(scene)[phase].name.clone();
    let stopped = |source| Error::ContactDynamicsStep {
        phase: name(),
        source,
    };
    world.step().map(drop).map_err(stopped)
}
