//! A stored case and what is compared in it.

use super::Recorded;
use crate::scenes::Draft;
use gouge_runner::references::{FOLDER, Run, StoredScenes, file_text};
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
    /// Means over many runs, by equivalence tests.
    Ensemble,
}

/// A case, as stated in `case.toml`, with its scene and its result.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// The claim, a short phrase.
    pub title: String,
    /// Laws of the kernel that are compared.
    pub laws: String,
    /// Equations that the laws implement, such as `thesis (35), thesis (36)`.
    pub equations: String,
    /// Settings of the engine that correspond to these laws.
    pub settings: String,
    /// Where the engine and the kernel agree and where they differ.
    pub agreement: String,
    /// What is compared.
    pub compares: Compared,
    /// Largest difference that passes, in units of the largest value of its kind; for ensembles, the
    /// level of each one-sided test.
    pub tolerance: f64,
    /// The reason for the tolerance.
    pub reason: String,
    /// Largest change of a number that may be expected on another machine, in units of the largest
    /// number of its column; for ensembles, change of a mean over the runs in units of its standard
    /// error.
    pub noise: f64,
    /// For ensembles: the observables, with their margins.
    #[serde(default)]
    pub observables: Vec<Observable>,
    /// For ensembles: a modified scene that the tests must reject.
    pub control: Option<Control>,
    /// The runs.
    pub runs: Vec<Run>,
    #[serde(skip)]
    scenes: StoredScenes,
    /// SHA-256 of every file by its path in the folder.
    #[serde(skip)]
    hashes: BTreeMap<String, String>,
    /// Result of the engine.
    #[serde(skip)]
    pub result: Recorded,
}

/// The statistic of a series.
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

/// A quantity that both programs measure in a run.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Observable {
    /// Its column in the series.
    pub name: String,
    /// The column by whose mean the statistic is divided, if any.
    pub over: Option<String>,
    /// The statistic of the column.
    pub statistic: Statistic,
    /// First and last step of the records used.
    pub steps: [u64; 2],
    /// Largest difference of means that counts as equivalent, in units of the engine's mean; fixed
    /// before the kernel was run.
    pub margin: f64,
    /// The reason for this margin.
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

/// A kernel that is deliberately wrong: one line of the scene is replaced.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Control {
    /// The claim that the tests reject it, a sentence that states what is wrong.
    pub claim: String,
    /// The text of the scene to replace.
    pub replace: String,
    /// The replacement.
    pub with: String,
    /// Observables for which equivalence must be rejected.
    pub rejects: Vec<String>,
}

impl Case {
    /// The case in a folder.
    pub(super) fn read(folder: &Path) -> Result<Self, String> {
        let text = |name| file_text(folder, name);
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
    /// Variables that the run does not set, missing tables of particles.
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
        self.result.changed_inputs(&self.hashes)
    }
}

/// SHA-256 of all files of a folder and of its subfolders.
pub(super) fn hashes(folder: &Dir) -> BTreeMap<String, String> {
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
