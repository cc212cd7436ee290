//! The runs of a sweep.

use super::file::{Axis, Sweep};
use super::state::State;
use crate::text::Place;
use gouge_runner::any_scene::AnyScene;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use gouge_runner::scene::{Overrides, hex};
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
    /// A scene file, or the name of a built-in scene.
    pub scene: PathBuf,
    /// For each axis, the position of the value.
    pub places: Vec<usize>,
    /// The overrides, as `KEY=VALUE`.
    pub overrides: Vec<String>,
}

impl Planned {
    /// A run of a scene with overrides.
    pub fn new(scene: &Path, overrides: Vec<String>) -> Self {
        let mut run = Self {
            name: String::new(),
            scene: scene.to_owned(),
            places: Vec::new(),
            overrides,
        };
        run.name = name(&run);
        run
    }

    /// Folder of the run in that of the sweep.
    pub fn folder(&self, out: &Path) -> PathBuf {
        out.join("runs").join(&self.name)
    }

    /// The state of the run.
    pub fn state(&self, out: &Path) -> State {
        State::of(&self.folder(out))
    }

    /// Number of steps of the run, those of its set-up included; zero if its scene is refused. Runs of a sweep differ
    /// in cost mainly by this.
    pub fn steps(&self) -> u64 {
        self.load().map_or(0, |scene| scene.steps())
    }

    /// The scene of the run.
    ///
    /// # Errors
    /// A scene that cannot be used.
    pub fn load(&self) -> Result<AnyScene, Error> {
        AnyScene::load_with(&self.scene, &Overrides::parse(&self.overrides)?)
    }
}

/// All runs of a sweep, in the order of its axes, the last one fastest. Their names are kept in the folder of the
/// sweep, because resolving the scenes of many runs takes a while.
///
/// # Errors
/// A scene that refuses every combination of values, an observation that no run can have, two runs that are the same,
/// too many runs, or a failure of the file system.
pub fn plan(sweep: &Sweep, out: &Path) -> Result<Vec<Planned>, Error> {
    let axes: Vec<&Axis> = sweep.all_axes().collect();
    let lengths = axes.iter().map(|axis| axis.values.len());
    let number = lengths.fold(1_usize, usize::saturating_mul);
    if number > MOST {
        let file = &sweep.file;
        let reason = format!("{file}: the axes give {number} runs; at most {MOST} are accepted");
        return Err(Error::Argument(reason));
    }
    let mut runs: Vec<Planned> = (0..number)
        .map(|index| nameless(sweep, &axes, index))
        .collect();
    let first = runs.iter().find_map(|run| run.load().ok());
    let Some(first) = first else {
        return Err(runs[0]
            .load()
            .err()
            .unwrap_or(Error::Argument(format!("{}: no run", sweep.file))));
    };
    refuse_unavailable(sweep, &runs, &first)?;
    let kept = Names::of(sweep, &first, out);
    match kept.read(number) {
        Some(names) => runs
            .iter_mut()
            .zip(names)
            .for_each(|(run, name)| run.name = name),
        None => {
            runs.iter_mut().for_each(|run| run.name = name(run));
            refuse_twins(sweep, &runs)?;
            kept.write(&runs)?;
        }
    }
    Ok(runs)
}

/// The runs that are not final: those that executing would run.
pub fn open<'a>(runs: &'a [Planned], out: &Path) -> Vec<&'a Planned> {
    let is_open = |run: &&Planned| !run.state(out).status.is_final();
    runs.iter().filter(is_open).collect()
}

/// Refuse an observation that no run can have; `first` is the first scene that accepts its values.
fn refuse_unavailable(sweep: &Sweep, runs: &[Planned], first: &AnyScene) -> Result<(), Error> {
    for observation in &sweep.observations {
        let check = |scene: &AnyScene| observation.get_ref().check_in(scene);
        let Err((key, accepted)) = check(first) else {
            continue;
        };
        let mut scenes = runs.iter().filter_map(|run| run.load().ok());
        if !scenes.any(|scene| check(&scene).is_ok()) {
            let place = Place {
                file: &sweep.file,
                text: &sweep.text,
            };
            let key = format!("observe.{key}");
            return Err(place.error(observation.span(), &key, &accepted).into());
        }
    }
    Ok(())
}

fn refuse_twins(sweep: &Sweep, runs: &[Planned]) -> Result<(), Error> {
    let mut seen = HashMap::new();
    let mut all = runs.iter();
    let twins = all.find_map(|run| seen.insert(&run.name, run).map(|other| [other, run]));
    match twins {
        None => Ok(()),
        Some(both) => {
            let [one, other] = both.map(|run| run.overrides.join(", "));
            let reason = format!("{}: {one} and {other} are the same run", sweep.file);
            Err(Error::Argument(reason))
        }
    }
}

/// The names of the runs of a sweep, kept in a file.
struct Names {
    path: PathBuf,
    /// Hash of all that determines them.
    hash: String,
}

impl Names {
    /// The names of a sweep; `scene` is one of its scenes.
    fn of(sweep: &Sweep, scene: &AnyScene, out: &Path) -> Self {
        let mut hash = Sha256::new_with_prefix(env!("CARGO_PKG_VERSION"));
        hash.update(format!(
            "{:?} {:?} {:?} {:?}",
            sweep.scene, sweep.set, sweep.axes, sweep.seeds
        ));
        hash.update(scene.sha256().as_bytes());
        let folder = sweep.scene.parent().unwrap_or(Path::new("."));
        let values = sweep
            .all_axes()
            .flat_map(|axis| axis.values.iter().flatten());
        let named = values.map(|value| folder.join(value.trim_matches('"')));
        for file in scene.files().iter().cloned().chain(named) {
            hash.update(std::fs::read(&file).unwrap_or_default());
        }
        Self {
            path: out.join("plan"),
            hash: hex(&hash.finalize()),
        }
    }

    /// The names, if they are those of this sweep.
    fn read(&self, number: usize) -> Option<Vec<String>> {
        let text = std::fs::read_to_string(&self.path).ok()?;
        let mut lines = text.lines().map(str::to_owned);
        let is_ours = lines.next()? == self.hash;
        let names: Vec<String> = lines.collect();
        (is_ours && names.len() == number).then_some(names)
    }

    fn write(&self, runs: &[Planned]) -> Result<(), Error> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
        let lines = runs.iter().map(|run| run.name.as_str());
        let lines: Vec<&str> = [self.hash.as_str()].into_iter().chain(lines).collect();
        write_whole(&self.path, (lines.join("\n") + "\n").as_bytes())
    }
}

/// Name of a run.
fn name(run: &Planned) -> String {
    // A combination that the scene refuses is a run, too: it will say so when it is run.
    let keys = match run.load() {
        Ok(scene) => scene.keys().to_text(),
        Err(_) => run.overrides.join("\n"),
    };
    let content = format!("{keys}{}", env!("CARGO_PKG_VERSION"));
    hex(&Sha256::digest(content))[..NAME].to_owned()
}

/// A run without its name.
fn nameless(sweep: &Sweep, axes: &[&Axis], index: usize) -> Planned {
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
    let overrides = chosen.flat_map(|(axis, &place)| axis.overrides(place));
    Planned {
        name: String::new(),
        scene: sweep.scene.clone(),
        overrides: sweep.set.iter().cloned().chain(overrides).collect(),
        places,
    }
}
