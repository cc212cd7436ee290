//! What a case compares.

use super::Recorded;
use crate::scenes::Draft;
use gouge_runner::references::{FOLDER, Run, StoredScenes};
use include_dir::Dir;
use serde::Deserialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::path::Path;

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Compared {
    /// Positions, velocities and forces at the recorded steps.
    Motion,
    /// Forces of a bond, whose law differs by a known term.
    Beam,
    /// Spins of particles whose moment of inertia differs by a known factor.
    Inertia,
    /// Means over many runs, by tests of equivalence.
    Ensemble,
}

/// A case, as `case.toml` states it, with its scene and its result.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// What happens, a short phrase.
    pub title: String,
    /// Laws of the kernel that are compared.
    pub laws: String,
    /// Equations that the laws implement, such as `thesis (35), thesis (36)`.
    pub equations: String,
    /// Settings of the engine that mean these laws.
    pub settings: String,
    /// Where both coincide and where they differ.
    pub agreement: String,
    /// What is compared.
    pub compares: Compared,
    /// Largest difference that passes, in units of the largest value of its kind; for ensembles, the
    /// significance of each one-sided test.
    pub tolerance: f64,
    /// Why.
    pub reason: String,
    /// Change of a number on another machine that means nothing, in units of the largest of its column; for
    /// ensembles, change of a mean over the runs in units of its standard error.
    pub noise: f64,
    /// Ensembles: what is averaged, with its margins.
    #[serde(default)]
    pub observables: Vec<Observable>,
    /// Ensembles: a scene that the test must reject.
    pub control: Option<Control>,
    /// The runs.
    pub runs: Vec<Run>,
    #[serde(skip)]
    scenes: StoredScenes,
    /// SHA-256 of every file by its path in the folder.
    #[serde(skip)]
    hashes: BTreeMap<String, String>,
    /// What the engine computed.
    #[serde(skip)]
    pub result: Recorded,
}

/// What is taken of a series.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Statistic {
    /// The mean over time.
    Mean,
    /// The largest value.
    Largest,
    /// The value at the end.
    Last,
}

/// A number that both programs measure in a run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observable {
    /// Its column in the series.
    pub name: String,
    /// The column by whose mean its own is divided, if any.
    pub over: Option<String>,
    /// What is taken of the column.
    pub statistic: Statistic,
    /// First and last step of what is taken.
    pub steps: [u64; 2],
    /// Largest difference of means that counts as equivalent, in units of the engine's mean; fixed before
    /// the kernel ran.
    pub margin: f64,
    /// Why this margin.
    pub reason: String,
}

impl Observable {
    /// Its name in tables.
    pub fn label(&self) -> String {
        let name = match &self.over {
            Some(other) => format!("{} over {other}", self.name),
            None => self.name.clone(),
        };
        match self.statistic {
            Statistic::Mean => format!("{name}, mean"),
            Statistic::Largest => format!("{name}, largest"),
            Statistic::Last => format!("{name}, last"),
        }
    }
}

/// A kernel that is wrong on purpose: one line of the scene is replaced.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// That the tests do not find it equivalent, a sentence that says what is wrong.
    pub claim: String,
    /// Text of the scene.
    pub replace: String,
    /// What stands there instead.
    pub with: String,
    /// Observables whose equivalence must be rejected.
    pub rejects: Vec<String>,
}

impl Case {
    /// The case in a folder.
    pub(super) fn read(folder: &Path) -> Result<Self, String> {
        let text = |name: &str| {
            let file = FOLDER.get_file(folder.join(name));
            let text = file.and_then(|file| file.contents_utf8());
            text.ok_or_else(|| format!("{name} is missing"))
        };
        let mut case: Self =
            toml::from_str(text("case.toml")?).map_err(|e| format!("case.toml: {e}"))?;
        case.result =
            serde_json::from_str(text("result.json")?).map_err(|e| format!("result.json: {e}"))?;
        case.scenes = StoredScenes::read(folder)?;
        case.hashes = FOLDER.get_dir(folder).map(hashes).unwrap_or_default();
        Ok(case)
    }

    /// The scene of a run.
    ///
    /// # Errors
    /// Variables that the run does not set, tables of particles that are not there.
    pub fn scene(&self, run: &Run) -> Result<String, String> {
        self.scenes.text(run)
    }

    /// The scene of a run, to be changed.
    ///
    /// # Errors
    /// As [`Case::scene`].
    pub fn draft(&self, run: &Run) -> Result<Draft, String> {
        Ok(Draft::parse(&self.scene(run)?))
    }

    /// Inputs of the engine that are not those that it was given.
    pub fn changed_inputs(&self) -> Vec<&str> {
        let recorded = self.result.inputs.iter();
        let is_other = |(path, hash): &(&String, &String)| self.hashes.get(*path) != Some(*hash);
        recorded
            .filter(is_other)
            .map(|(path, _)| path.as_str())
            .collect()
    }
}

/// SHA-256 of all files of a folder, those of its own folders included.
fn hashes(folder: &Dir) -> BTreeMap<String, String> {
    let below = folder.dirs().flat_map(Dir::files);
    let files = folder.files().chain(below);
    let hash = |file: &include_dir::File| {
        let path = file
            .path()
            .strip_prefix(folder.path())
            .unwrap_or(file.path());
        let digest = Sha256::digest(file.contents());
        let text = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        (path.display().to_string(), text)
    };
    files.map(hash).collect()
}
