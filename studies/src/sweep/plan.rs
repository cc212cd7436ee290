//! The runs of a sweep.

use super::file::{Axis, Sweep};
use super::state::State;
use gouge_runner::error::Error;
use gouge_runner::scene::{Overrides, Scene, hex};
use sha2::{Digest, Sha256};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// Most runs of a sweep.
const MOST: usize = 1_000_000;
/// Characters of the name of a run.
const NAME: usize = 16;

/// A run of a sweep.
#[derive(Clone, Debug)]
pub struct Planned {
    /// Name of its folder: a hash of the resolved scene and the version of the program.
    pub name: String,
    /// For each axis, the position of the value.
    pub places: Vec<usize>,
    /// The overrides, as `KEY=VALUE`.
    pub overrides: Vec<String>,
}

impl Planned {
    /// Folder of the run in that of the sweep.
    pub fn folder(&self, out: &Path) -> PathBuf {
        out.join("runs").join(&self.name)
    }

    /// The state of the run.
    pub fn state(&self, out: &Path) -> State {
        State::of(&self.folder(out))
    }

    /// The scene of the run.
    ///
    /// # Errors
    /// A scene that cannot be used.
    pub fn scene(&self, sweep: &Sweep) -> Result<Scene, Error> {
        Scene::load_with(&sweep.scene, &Overrides::parse(&self.overrides)?)
    }
}

/// All runs of a sweep, in the order of its axes, the last one fastest.
///
/// # Errors
/// A scene that refuses every combination of values, two runs that are the same, or too many runs.
pub fn plan(sweep: &Sweep) -> Result<Vec<Planned>, Error> {
    let axes: Vec<&Axis> = sweep.all_axes().collect();
    let lengths = axes.iter().map(|axis| axis.values.len());
    let number = lengths.fold(1_usize, usize::saturating_mul);
    if number > MOST {
        let file = &sweep.file;
        return Err(Error::Argument(format!(
            "{file}: the axes give {number} runs; at most {MOST} are accepted"
        )));
    }
    let runs: Vec<Planned> = (0..number)
        .map(|index| planned(sweep, &axes, index))
        .collect();
    let refusals = runs.iter().map_while(|run| run.scene(sweep).err());
    match refusals.enumerate().last() {
        Some((last, error)) if last + 1 == number => return Err(error),
        _ => {}
    }
    let mut seen = HashMap::new();
    let twice = runs
        .iter()
        .find_map(|run| seen.insert(&run.name, run).map(|other| [other, run]));
    match twice {
        None => Ok(runs),
        Some(both) => {
            let [one, other] = both.map(|run| run.overrides.join(", "));
            Err(Error::Argument(format!(
                "{}: {one} and {other} are the same run",
                sweep.file
            )))
        }
    }
}

fn planned(sweep: &Sweep, axes: &[&Axis], index: usize) -> Planned {
    let mut rest = index;
    let mut places: Vec<usize> = axes
        .iter()
        .rev()
        .map(|axis| {
            let place = rest % axis.values.len();
            rest /= axis.values.len();
            place
        })
        .collect();
    places.reverse();
    let chosen = axes.iter().zip(&places);
    let overrides: Vec<String> = chosen
        .map(|(axis, &place)| format!("{}={}", axis.key, axis.values[place]))
        .collect();
    let run = Planned {
        name: String::new(),
        places,
        overrides,
    };
    // A combination that the scene refuses is a run, too: it will say so when it is run.
    let keys = match run.scene(sweep) {
        Ok(scene) => scene.keys.to_text(),
        Err(_) => run.overrides.join("\n"),
    };
    let content = format!("{keys}{}", env!("CARGO_PKG_VERSION"));
    let name = hex(&Sha256::digest(content))[..NAME].to_owned();
    Planned { name, ..run }
}
