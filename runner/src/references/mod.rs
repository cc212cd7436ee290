//! Other programs' results, as the folder `references` holds them, and the scenes that repeat them.
//!
//! A case is a folder `ENGINE/NAME`: `case.toml` says what is compared and lists the runs, `scene.toml`
//! is our scene with `${variables}` of the runs, the engine's input stands beside it, and `result.json`
//! is what the engine computed. The program carries a copy of all of them.

mod case;
mod result;

pub use case::{Case, Compared, Control, Observable, Run, Statistic};
pub use result::{Recorded, RecordedRun, Table};

use include_dir::{Dir, include_dir};
use std::collections::BTreeMap;
use std::sync::LazyLock;

static FOLDER: Dir = include_dir!("$CARGO_MANIFEST_DIR/../references");

static CASES: LazyLock<BTreeMap<String, Result<Case, String>>> = LazyLock::new(|| {
    let engines = FOLDER.dirs();
    let folders = engines.flat_map(|engine| engine.dirs());
    let with_case = folders.filter(|folder| folder.contains(folder.path().join("case.toml")));
    let read = |folder: &Dir| {
        let path = folder.path().display().to_string();
        (path, Case::read(&FOLDER, folder.path()))
    };
    with_case.map(read).collect()
});

/// Paths of all cases, in alphabetical order.
pub fn paths() -> impl Iterator<Item = &'static str> {
    CASES.keys().map(String::as_str)
}

/// The case at a path such as `lammps/kelvin-voigt`.
///
/// # Errors
/// No such case, or files of it that cannot be read.
pub fn case(path: &str) -> Result<&'static Case, String> {
    match CASES.get(path) {
        Some(Ok(case)) => Ok(case),
        Some(Err(error)) => Err(format!("references/{path}: {error}")),
        None => Err(format!("there is no folder references/{path}")),
    }
}

/// The scene of a run, by the path `ENGINE/NAME/RUN`.
pub fn scene_text(path: &str) -> Option<String> {
    let (path, run) = path.rsplit_once('/')?;
    let case = case(path).ok()?;
    let run = case.runs.iter().find(|one| one.name == run)?;
    case.scene(run).ok()
}
