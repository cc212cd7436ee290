//! What a case compares, and the scenes of its runs.

use super::Recorded;
use include_dir::Dir;
use serde::Deserialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};

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
    files: Files,
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

/// A run: its name and the variables of the scene and the input.
#[derive(Clone, Debug, Deserialize)]
pub struct Run {
    /// Its name.
    pub name: String,
    /// Names and values of the variables.
    #[serde(flatten)]
    pub variables: toml::Table,
}

/// Texts of a folder.
#[derive(Clone, Debug, Default)]
struct Files {
    scene: String,
    /// SHA-256 of every file by its path in the folder.
    hashes: BTreeMap<String, String>,
    particles: Vec<(PathBuf, String)>,
    bonds: Vec<(PathBuf, String)>,
}

impl Case {
    /// The case in a folder.
    pub(super) fn read(root: &Dir, folder: &Path) -> Result<Self, String> {
        let text = |name: &str| {
            let path = folder.join(name);
            let file = root.get_file(&path).and_then(|file| file.contents_utf8());
            file.map(str::to_owned)
                .ok_or_else(|| format!("{name} is missing"))
        };
        let tables = |kind: &str| {
            let inside = root.get_dir(folder.join(kind));
            let files = inside.into_iter().flat_map(Dir::files);
            let read = |file: &include_dir::File| {
                Some((file.path().to_owned(), file.contents_utf8()?.to_owned()))
            };
            files.filter_map(read).collect()
        };
        let mut case: Self =
            toml::from_str(&text("case.toml")?).map_err(|e| format!("case.toml: {e}"))?;
        case.result =
            serde_json::from_str(&text("result.json")?).map_err(|e| format!("result.json: {e}"))?;
        case.files = Files {
            scene: text("scene.toml")?,
            hashes: root.get_dir(folder).map(hashes).unwrap_or_default(),
            particles: tables("particles"),
            bonds: tables("bonds"),
        };
        Ok(case)
    }

    /// The scene of a run.
    ///
    /// # Errors
    /// Variables that the run does not set, tables of particles that are not there.
    pub fn scene(&self, run: &Run) -> Result<String, String> {
        let mut text = filled(&self.files.scene, run)?;
        if let Some(table) = self.table(&self.files.particles, run) {
            text += &items("particles", table, particle)?;
        }
        if let Some(table) = self.table(&self.files.bonds, run) {
            text += &items("bonds", table, bond)?;
        }
        Ok(text)
    }

    /// Inputs of the engine that are not those that it was given.
    pub fn changed_inputs(&self) -> Vec<&str> {
        let recorded = self.result.inputs.iter();
        let is_other =
            |(path, hash): &(&String, &String)| self.files.hashes.get(*path) != Some(*hash);
        recorded
            .filter(is_other)
            .map(|(path, _)| path.as_str())
            .collect()
    }

    /// The table of a run's seed.
    fn table<'a>(&self, tables: &'a [(PathBuf, String)], run: &Run) -> Option<&'a str> {
        let seed = run.variables.get("seed")?.as_str()?;
        let named = |(path, _): &&(PathBuf, String)| path.file_stem().is_some_and(|s| s == seed);
        tables.iter().find(named).map(|(_, text)| text.as_str())
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

/// A text with every `${name}` replaced.
fn filled(text: &str, run: &Run) -> Result<String, String> {
    let mut filled = String::with_capacity(text.len());
    let mut parts = text.split("${");
    filled += parts.next().unwrap_or_default();
    for part in parts {
        let (name, rest) = part.split_once('}').unwrap_or((part, ""));
        match run.variables.get(name) {
            Some(toml::Value::String(value)) => filled += value,
            Some(toml::Value::Float(value)) => {
                let _ = write!(filled, "{value:?}");
            }
            Some(value) => {
                let _ = write!(filled, "{value}");
            }
            None => return Err(format!("run {} does not set {name}", run.name)),
        }
        filled += rest;
    }
    Ok(filled)
}

/// A CSV table as items of an array of tables.
fn items(
    key: &str,
    table: &str,
    item: impl Fn(&dyn Fn(&str) -> Option<String>) -> Option<String>,
) -> Result<String, String> {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let columns = reader.headers().map_err(|e| e.to_string())?.clone();
    let mut text = String::new();
    for row in reader.records() {
        let row = row.map_err(|e| e.to_string())?;
        let cell = |name: &str| {
            let place = columns.iter().position(|column| column == name)?;
            row.get(place).map(str::to_owned)
        };
        let entries = item(&cell).ok_or_else(|| format!("a table of {key} lacks a column"))?;
        let _ = write!(text, "\n[[{key}]]\n{entries}");
    }
    Ok(text)
}

/// Entries of a particle; a fixed one has no velocity.
fn particle(cell: &dyn Fn(&str) -> Option<String>) -> Option<String> {
    let role = cell("role")?;
    let velocity = if role == "fixed" {
        String::new()
    } else {
        let velocity = format!("velocity = [{}, {}]\n", cell("vx")?, cell("vy")?);
        velocity + &format!("angular_velocity = {}\n", cell("angular_velocity")?)
    };
    Some(format!(
        "position = [{}, {}]\n{velocity}radius = {}\ndensity = {}\nrole = \"{role}\"\n",
        cell("x")?,
        cell("y")?,
        cell("radius")?,
        cell("density")?,
    ))
}

/// Entries of a bond.
fn bond(cell: &dyn Fn(&str) -> Option<String>) -> Option<String> {
    Some(format!(
        "between = [{}, {}]\nstrength_factor = {}\n",
        cell("i")?,
        cell("j")?,
        cell("strength_factor")?,
    ))
}
