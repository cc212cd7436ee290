//! The cases of the folder `references` as scenes: runs that other programs computed as well.
//!
//! A case is a folder `ENGINE/NAME`: `case.toml` lists the runs, and `scene.toml` is our scene with
//! `${variables}` of the runs. The program embeds a copy of all of them. Folders without `scene.toml` belong to kernels
//! without scenes, whose tests read them.

use include_dir::{Dir, include_dir};
use serde::Deserialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The folder `references`.
pub static FOLDER: Dir = include_dir!("$CARGO_MANIFEST_DIR/../references");

/// A run: its name, and the variables of our scene and of the other program's input.
#[derive(Clone, Debug, Deserialize)]
pub struct Run {
    /// Name of the run.
    pub name: String,
    /// Names and values of the variables.
    #[serde(flatten)]
    pub variables: toml::Table,
}

/// The part of `case.toml` that scenes need.
#[derive(Deserialize)]
struct Listed {
    runs: Vec<Run>,
}

/// The scene template of a case, its runs, and its tables of particles and bonds.
#[derive(Clone, Debug, Default)]
pub struct StoredScenes {
    runs: Vec<Run>,
    scene: String,
    particles: Vec<(PathBuf, String)>,
    bonds: Vec<(PathBuf, String)>,
}

/// The text of a file of the case in a folder such as `lammps/kelvin-voigt`.
///
/// # Errors
/// A file that is missing or not text.
pub fn file_text(folder: &Path, name: &str) -> Result<&'static str, String> {
    let file = FOLDER.get_file(folder.join(name));
    let text = file.and_then(|file| file.contents_utf8());
    text.ok_or_else(|| format!("{name} is missing"))
}

/// Paths of all cases that have a scene, in alphabetical order.
pub fn paths() -> impl Iterator<Item = String> {
    let folders = FOLDER.dirs().flat_map(Dir::dirs);
    let with_scene = folders.filter(|folder| folder.contains(folder.path().join("scene.toml")));
    let mut paths: Vec<String> = with_scene
        .map(|folder| folder.path().display().to_string())
        .collect();
    paths.sort();
    paths.into_iter()
}

/// Paths `ENGINE/NAME/RUN` of all runs.
pub fn names() -> impl Iterator<Item = String> {
    paths().flat_map(|path| {
        let scenes = StoredScenes::read(Path::new(&path)).unwrap_or_default();
        let runs = scenes.runs.into_iter();
        runs.map(move |run| format!("{path}/{}", run.name))
    })
}

/// The scene of the run with the path `ENGINE/NAME/RUN`.
pub fn scene_text(path: &str) -> Option<String> {
    let (path, name) = path.rsplit_once('/')?;
    let scenes = StoredScenes::read(Path::new(path)).ok()?;
    let run = scenes.runs.iter().find(|run| run.name == name)?;
    scenes.text(run).ok()
}

impl StoredScenes {
    /// Read the case in a folder such as `lammps/kelvin-voigt`.
    ///
    /// # Errors
    /// A file that is missing or cannot be read.
    pub fn read(folder: &Path) -> Result<Self, String> {
        let text = |name| file_text(folder, name);
        let tables = |kind: &str| {
            let inside = FOLDER.get_dir(folder.join(kind));
            let files = inside.into_iter().flat_map(Dir::files);
            let read = |file: &include_dir::File| {
                Some((file.path().to_owned(), file.contents_utf8()?.to_owned()))
            };
            files.filter_map(read).collect()
        };
        let listed: Listed =
            toml::from_str(text("case.toml")?).map_err(|e| format!("case.toml: {e}"))?;
        Ok(Self {
            runs: listed.runs,
            scene: text("scene.toml")?.to_owned(),
            particles: tables("particles"),
            bonds: tables("bonds"),
        })
    }

    /// The scene of a run.
    ///
    /// # Errors
    /// A variable that the run does not set, or a table that lacks a column.
    pub fn text(&self, run: &Run) -> Result<String, String> {
        let mut text = filled(&self.scene, run)?;
        if let Some(table) = table(&self.particles, run) {
            text += &items("particles", table, particle)?;
        }
        if let Some(table) = table(&self.bonds, run) {
            text += &items("bonds", table, bond)?;
        }
        Ok(text)
    }
}

/// The table that belongs to the seed of a run.
fn table<'a>(tables: &'a [(PathBuf, String)], run: &Run) -> Option<&'a str> {
    let seed = run.variables.get("seed")?.as_str()?;
    let named = |(path, _): &&(PathBuf, String)| path.file_stem().is_some_and(|s| s == seed);
    tables.iter().find(named).map(|(_, text)| text.as_str())
}

/// The text with every `${name}` replaced by the value of the run.
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

/// A CSV table as a TOML array of tables.
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

/// TOML entries of a particle; fixed particles get no velocity.
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

/// TOML entries of a bond.
fn bond(cell: &dyn Fn(&str) -> Option<String>) -> Option<String> {
    Some(format!(
        "between = [{}, {}]\nstrength_factor = {}\n",
        cell("i")?,
        cell("j")?,
        cell("strength_factor")?,
    ))
}
