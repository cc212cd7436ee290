//! Cases of the kernel of contact dynamics.
//!
//! | file | list | identity | what is found |
//! |---|---|---|---|
//! | `geometry.json` | `pairs` | `id` | separation, normal and contact points of two shapes |
//! | `local.json` | `problems` | `id` | impulse and velocity of a single contact point |
//! | `onestep.json` | `problems` | `id` | velocities and impulses of bodies with given contact points |
//! | `siconos2d.json` | `problems` | `id` | impulses for an assembled operator, or one by rows |
//! | `dynamics.json` | `cases` | `id` | motion of a few bodies; the beginning of `id` is the kind |
//! | `observables.json` | `networks` | `network` | stress, anisotropies and coordination of a network of forces |
//!
//! No stored solution is read, except the forces of the networks in `observables.json`, which are impulses of
//! solutions in `onestep.json` over the time step.

mod assembled;
mod dynamics;
mod geometry;
mod local;
mod motion;
mod observables;
mod onestep;

use crate::error::{CaseError, Fault, ReplayError};
use crate::fields::Fields;
use crate::outcome::{Outcome, require_finite};
use serde_json::{Map, Value};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// A case with the files around it.
struct Case<'a> {
    id: &'a str,
    fields: Fields<'a>,
    /// The whole file that holds the case.
    file: Fields<'a>,
    others: &'a Files,
}

/// The parsed files of a folder, by name without ending.
type Files = BTreeMap<&'static str, Value>;

/// From a case to its result.
type Solve = fn(&Case) -> Result<Value, Fault>;

/// A file of cases.
struct Part {
    name: &'static str,
    list: &'static str,
    identity: &'static str,
    solve: Solve,
}

const fn part(
    name: &'static str,
    list: &'static str,
    identity: &'static str,
    solve: Solve,
) -> Part {
    Part {
        name,
        list,
        identity,
        solve,
    }
}

const PARTS: [Part; 6] = [
    part("geometry", "pairs", "id", geometry::solve),
    part("local", "problems", "id", local::solve),
    part("onestep", "problems", "id", onestep::solve),
    part("siconos2d", "problems", "id", assembled::solve),
    part("dynamics", "cases", "id", dynamics::solve),
    part("observables", "networks", "network", observables::solve),
];

/// The files that [`replay`] reads in a folder, whether they exist or not.
pub fn files(folder: &Path) -> Vec<PathBuf> {
    PARTS.iter().map(|part| path(folder, part)).collect()
}

fn path(folder: &Path, part: &Part) -> PathBuf {
    folder.join(format!("{}.json", part.name))
}

/// Solve all cases of all known files in a folder.
///
/// # Errors
/// No such folder, no known file in it, or a file that cannot be read or has no list of cases. What is wrong with a
/// single case is in [`Outcome::failures`].
pub fn replay(folder: &Path) -> Result<Outcome, ReplayError> {
    let files = read(folder)?;
    let mut outcome = Outcome::default();
    for part in &PARTS {
        let Some(value) = files.get(part.name) else {
            continue;
        };
        let structure = |fault| ReplayError::Structure {
            file: path(folder, part),
            fault,
        };
        let file = Fields::root(value);
        file.list(part.list).map_err(structure)?;
        let mut results = Map::new();
        let cases = value[part.list].as_array().map_or(&[][..], Vec::as_slice);
        for (place, case) in cases.iter().enumerate() {
            outcome.cases += 1;
            if let Err(error) = solve(part, place, case, &file, &files, &mut results) {
                outcome.failures.push(error);
            }
        }
        outcome.results.insert(part.name.to_owned(), results.into());
    }
    Ok(outcome)
}

fn read(folder: &Path) -> Result<Files, ReplayError> {
    if !folder.is_dir() {
        return Err(ReplayError::NotAFolder(folder.to_owned()));
    }
    let mut files = Files::new();
    for part in &PARTS {
        let file = path(folder, part);
        let bytes = match std::fs::read(&file) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => continue,
            Err(source) => return Err(ReplayError::Read { file, source }),
        };
        match serde_json::from_slice(&bytes) {
            Ok(value) => files.insert(part.name, value),
            Err(source) => return Err(ReplayError::Syntax { file, source }),
        };
    }
    if files.is_empty() {
        let names = PARTS.map(|part| format!("{}.json", part.name));
        return Err(ReplayError::NothingKnown {
            folder: folder.to_owned(),
            accepted: names.join(", "),
        });
    }
    Ok(files)
}

/// Solve a case, and keep its result.
fn solve<'a>(
    part: &Part,
    place: usize,
    value: &'a Value,
    file: &Fields<'a>,
    others: &'a Files,
    results: &mut Map<String, Value>,
) -> Result<(), CaseError> {
    let fields = Fields::root(value);
    let error = |case: String, fault| CaseError {
        file: format!("{}.json", part.name),
        case,
        fault,
    };
    let id = match fields.text(part.identity) {
        Ok(id) => id,
        Err(fault) => return Err(error(format!("{}[{place}]", part.list), fault)),
    };
    if results.contains_key(id) {
        let fault = Fault::Value {
            key: part.identity.to_owned(),
            value: format!("{id:?}"),
            accepted: "different in every case".to_owned(),
        };
        return Err(error(id.to_owned(), fault));
    }
    let case = Case {
        id,
        fields,
        file: file.clone(),
        others,
    };
    let solved = (part.solve)(&case).and_then(require_finite);
    match solved {
        Ok(result) => results.insert(id.to_owned(), result),
        Err(fault) => return Err(error(id.to_owned(), fault)),
    };
    Ok(())
}
