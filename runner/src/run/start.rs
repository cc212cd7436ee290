//! The beginning of a run from the final state of another one: the key `start`.

use super::checkpoint::Checkpoint;
use super::outcome::Summary;
use crate::error::{Error, SceneError};
use crate::machine::with_chosen_execution;
use crate::scene::{Keys, Scene, StartFile, wrap};
use gouge_dem::World;
use std::path::Path;

/// Keys that must agree, because positions and bonds depend on them.
const BOX: [&str; 2] = ["box.width", "box.boundary"];
/// Keys on which the memory of contacts depends.
const MEMORY: [&str; 2] = ["contact.tangential.law", "contact.distance"];

/// The world of a scene at t = 0, from the final state of another run. Contacts keep their memory if the law of friction
/// is the same; otherwise they begin anew.
///
/// # Errors
/// A file that is not the checkpoint of a finished run, or whose state does not fit the scene.
pub fn continued(scene: &Scene, start: &StartFile) -> Result<World, Error> {
    let refusal = |reason: String| SceneError {
        accepted: reason,
        ..start.refusal.clone()
    };
    let bytes =
        std::fs::read(&start.path).map_err(|error| Error::file("read", &start.path, error))?;
    let (saved, _) = Checkpoint::parse(&bytes, scene).map_err(|reason| {
        refusal(format!(
            "must be the output folder of a run, but of its checkpoint: {reason}"
        ))
    })?;
    let folder = start.path.parent().unwrap_or(Path::new("."));
    let steps = saved
        .state
        .columns
        .iter()
        .find(|column| column.name == "steps");
    let steps = steps.and_then(|column| column.words.first());
    let is_of_end = |summary: &Summary| summary.is_finished() && Some(&summary.steps) == steps;
    if !Summary::read(folder).is_ok_and(|summary| is_of_end(&summary)) {
        return Err(refusal(
            "the run there is not finished; must be the output folder of a finished run".to_owned(),
        )
        .into());
    }
    let keys = saved.keys;
    if let Some(key) = BOX.iter().find(|key| differs(&keys, scene, key)) {
        return Err(refusal(format!("the run there has another {key}")).into());
    }
    let mut state = World::continuation_of_record(&saved.state)
        .ok_or_else(|| refusal("its checkpoint does not hold a state of this model".to_owned()))?;
    if scene.bond.is_none() && state.bonds() > 0 {
        let bonds = state.bonds();
        return Err(refusal(format!(
            "the state there has {bonds} bonds, so the scene needs the laws in [bond]"
        ))
        .into());
    }
    if MEMORY.iter().any(|key| differs(&keys, scene, key)) {
        state.forget_contacts();
    }
    wrap(&scene.domain, &mut state.particles);
    let model = scene.model(&state.particles.radius);
    Ok(state.begin(model).map(with_chosen_execution)?)
}

fn differs(keys: &Keys, scene: &Scene, key: &str) -> bool {
    keys.get(key) != scene.keys.get(key)
}
