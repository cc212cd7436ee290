//! The picture of a scene after a short run, without outputs.

use super::super::Scene;
use super::begin::checked;
use super::picture::draw;
use super::scene_run::stopped;
use crate::error::Error;
use crate::run::picture::Shown;

/// The picture of a scene after a number of steps, or at its end if that comes first.
///
/// # Errors
/// What the kernel refuses, or a state that becomes invalid.
pub fn shown(scene: &Scene, most_steps: u64) -> Result<Shown, Error> {
    let mut built = checked(scene)?;
    let steps = scene.schedule().steps().min(most_steps);
    for _ in 0..steps {
        built.world.step().map_err(stopped)?;
    }
    Ok(Shown {
        steps,
        time: built.world.time(),
        svg: draw(scene, &built.world, &built.cells).to_string(),
    })
}
