//! Finds the mutants that compile. All are compiled together; those for which the compiler reports errors are left out,
//! until there are no errors.

use super::mutant::Mutant;
use super::switches::{Planted, blamed, written};
use crate::gate::{cargo, complaint, errors};
use crate::kernel::Kernel;
use crate::workspace::{Source, library, plant};
use crate::{Outcome, operators::Searched};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeSet, HashMap};
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::process::Stdio;

/// Switches of the mutants of a sample that do not compile.
#[derive(Serialize, Deserialize)]
struct LeftOut {
    sample: u64,
    switches: BTreeSet<usize>,
}

/// Build the mutants into a copy of the workspace, without those that do not compile. Return the switches of the
/// latter. They are stored in the folder, so that a continued run finds the same copy.
///
/// # Errors
/// A file that cannot be read or written, or a compiler error that no mutant causes.
pub fn settle(
    root: &Path,
    folder: &Path,
    searched: &[Searched],
    sample: &[Mutant],
    kernel: Kernel,
) -> Outcome<BTreeSet<usize>> {
    let (copy, note) = (folder.join("copy"), folder.join("left-out.json"));
    let name = name(searched, sample);
    let known = fs::read(&note).ok();
    let known = known.and_then(|bytes| serde_json::from_slice::<LeftOut>(&bytes).ok());
    let known = known.filter(|left_out| left_out.sample == name);
    let mut switches = BTreeSet::new();
    if let Some(left_out) = known {
        switches = left_out.switches;
        plant(
            root,
            &copy,
            &texts(searched, sample, &switches),
            sample.len(),
        )?;
        return Ok(switches);
    }
    loop {
        let texts = texts(searched, sample, &switches);
        plant(root, &copy, &texts, sample.len())?;
        let new = complaints(&copy, &texts, kernel)?;
        if new.is_empty() {
            break;
        }
        println!("{} mutants do not compile", new.len());
        switches.extend(new);
    }
    let left_out = LeftOut {
        sample: name,
        switches,
    };
    fs::write(&note, serde_json::to_vec(&left_out)?)?;
    Ok(left_out.switches)
}

/// A hash that identifies a sample and its sources.
fn name(searched: &[Searched], sample: &[Mutant]) -> u64 {
    let mut hasher = DefaultHasher::new();
    for one in searched {
        one.source.text.hash(&mut hasher);
    }
    for mutant in sample {
        mutant.to_string().hash(&mut hasher);
    }
    hasher.finish()
}

/// The texts of all sources with the mutants of the sample, except those that are left out.
fn texts(
    searched: &[Searched],
    sample: &[Mutant],
    left_out: &BTreeSet<usize>,
) -> HashMap<PathBuf, String> {
    let text = |(number, one): (usize, &Searched)| {
        let Source { path, text, .. } = &one.source;
        let own = sample
            .iter()
            .filter(|mutant| mutant.place.0 == number && !left_out.contains(&mutant.switch));
        let own: Vec<&Mutant> = own.collect();
        let planted: Vec<Planted> = own
            .chunk_by(|a, b| a.place == b.place)
            .map(|mutants| Planted {
                place: &one.places[mutants[0].place.1],
                mutants: mutants.to_vec(),
            })
            .collect();
        (path.clone(), written(text, library(path), &planted))
    };
    searched.iter().enumerate().map(text).collect()
}

/// Switches of the mutants for which one run of the compiler reports errors.
fn complaints(
    copy: &Path,
    texts: &HashMap<PathBuf, String>,
    kernel: Kernel,
) -> Outcome<BTreeSet<usize>> {
    let output = cargo(copy)
        .args(["check", "--message-format=json", "--profile", "mutants"])
        .args(kernel.packages().iter().flat_map(|name| ["-p", name]))
        .stderr(Stdio::inherit())
        .output()?;
    if output.status.success() {
        return Ok(BTreeSet::new());
    }
    let errors = errors(&String::from_utf8_lossy(&output.stdout));
    let (mut sure, mut near) = (BTreeSet::new(), BTreeSet::new());
    for span in errors.iter().filter_map(primary) {
        let file = span["file_name"].as_str().map(Path::new);
        let (Some(text), Some(at)) = (
            file.and_then(|file| texts.get(file)),
            span["byte_start"].as_u64(),
        ) else {
            continue;
        };
        match blamed(text, usize::try_from(at)?) {
            (true, switches) => sure.extend(switches),
            (false, switches) => near.extend(switches),
        }
    }
    // A mutant that does not compile can cause an error elsewhere in its place.
    let found = if sure.is_empty() { near } else { sure };
    if found.is_empty() {
        return Err(complaint(&errors).into());
    }
    Ok(found)
}

/// Position of an error in the written code; that of the macro if the error is inside one.
fn primary(error: &Value) -> Option<&Value> {
    let spans = error["spans"].as_array()?;
    let mut span = spans.iter().find(|span| span["is_primary"] == true)?;
    while span["expansion"].is_object() {
        span = &span["expansion"]["span"];
    }
    Some(span)
}
