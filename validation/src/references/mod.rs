//! Results of other programs, as stored in the folder `references`.
//!
//! A case is a folder `ENGINE/NAME`: `case.toml` states what is compared and lists the runs,
//! `scene.toml` is our scene with `${variables}` of the runs, the engine's input is next to it, and
//! `result.json` is the engine's result. The runner contains a copy of all of them.

mod case;
mod one_step;
mod packing;
mod plate;
mod result;

pub use case::{Case, Compared, Control, Observable, Statistic};
pub use gouge_runner::references::{Run, paths};
pub use one_step::{OneStep, Point, Unit};
pub use packing::{Grain, Packing};
pub use plate::{Node, Plate};
pub use result::{Recorded, RecordedRun, Table};

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::LazyLock;

static CASES: LazyLock<BTreeMap<String, Result<Case, String>>> = LazyLock::new(|| {
    paths()
        .map(|path| (path.clone(), Case::read(Path::new(&path))))
        .collect()
});

/// The case at a path such as `lammps/kelvin-voigt`.
///
/// # Errors
/// No such case, or files of it that cannot be parsed.
pub fn case(path: &str) -> Result<&'static Case, String> {
    match CASES.get(path) {
        Some(Ok(case)) => Ok(case),
        Some(Err(error)) => Err(format!("references/{path}: {error}")),
        None => Err(format!("there is no folder references/{path}")),
    }
}
