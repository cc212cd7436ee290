//! Motions that the program of the authors of peridem computed, stored in `references/perigrain`, repeated with the same
//! input and order of operations.

use flate2::read::GzDecoder;
use gouge_replay::peridem::{Mode, repeat};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::{Path, PathBuf};

/// Largest difference of positions in m. Rounding makes them differ by up to 7e-18 m.
const POSITION: f64 = 1e-16;
/// Largest difference of velocities, and of sums, per largest one.
const RELATIVE: f64 = 1e-10;
/// Columns of the series that vanish in symmetric motions but for rounding.
const CANCELLING: [&str; 2] = ["px", "py"];

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../references/perigrain/motions")
}

fn unzipped(file: &Path) -> String {
    let mut text = String::new();
    let bytes = std::fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let mut reader = GzDecoder::new(&bytes[..]);
    reader.read_to_string(&mut text).expect("gzip");
    text
}

/// Rows of a table: numbers by column, by the first columns of the row.
fn table(text: &str, keys: usize) -> BTreeMap<String, BTreeMap<&str, f64>> {
    let mut lines = text.lines();
    let names: Vec<_> = lines.next().expect("names of columns").split(',').collect();
    let row = |line: &str| {
        let values: Vec<_> = line.split(',').collect();
        assert_eq!(values.len(), names.len(), "{line}");
        let numbers = values[keys..]
            .iter()
            .map(|value| value.parse().expect("a number"));
        let columns = names[keys..].iter().copied().zip(numbers);
        (values[..keys].join(","), columns.collect())
    };
    lines.map(row).collect()
}

/// Compare the columns of a reference; tolerances are absolute, by column and its largest magnitude.
fn compare(found: &str, reference: &str, keys: usize, tolerance: impl Fn(&str, f64) -> f64) {
    let (found, reference) = (table(found, keys), table(reference, keys));
    assert_eq!(found.len(), reference.len(), "rows");
    let columns = reference.values().next().expect("a row").keys().copied();
    for column in columns {
        let magnitudes = reference.values().map(|row| row[column].abs());
        let allowed = tolerance(column, magnitudes.fold(0.0, f64::max));
        for (key, row) in &reference {
            let apart = (found[key][column] - row[column]).abs();
            assert!(
                apart <= allowed,
                "{key}: {column} differs by {apart:e}, not by {allowed:e}"
            );
        }
    }
}

fn repeats(name: &str) {
    let result = std::fs::read_to_string(folder().join("result.json")).expect("readable");
    let result: Value = serde_json::from_str(&result).expect("JSON");
    let runs = result["runs"].as_array().expect("runs");
    let run = runs.iter().find(|run| run["name"] == name).expect("a run");
    let own = folder().join(name);
    let case = unzipped(&own.join("case.json.gz"));
    let hash: String = Sha256::digest(case)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect();
    assert_eq!(result["inputs"][format!("{name}/case.json")], hash.as_str());

    let mode = Mode::ALL
        .iter()
        .find(|(name, _)| run["mode"] == *name)
        .expect("a mode")
        .1;
    let repeated = repeat(&own.join("case.json.gz"), mode, &mut |_, _| {}).expect("a motion");
    assert!(repeated.failures.is_empty(), "{:?}", repeated.failures);
    let files: BTreeMap<_, _> = repeated.files.into_iter().collect();
    let stored = |table: &str| unzipped(&own.join(format!("{table}.gz")));
    compare(
        &files["frames.csv"],
        &stored("frames.csv"),
        3,
        |column, largest| match column {
            "x" | "y" => POSITION,
            _ => RELATIVE * largest,
        },
    );
    compare(
        &files["series.csv"],
        &stored("series.csv"),
        1,
        |column, largest| match CANCELLING.contains(&column) {
            true => f64::INFINITY,
            false => RELATIVE * largest,
        },
    );
    if own.join("bonds.csv.gz").is_file() {
        let reference = stored("bonds.csv");
        let [found, expected] =
            [&files["bonds.csv"], &reference].map(|text| text.lines().collect::<BTreeSet<_>>());
        assert!(found == expected, "the broken bonds differ");
    }
}

#[test]
fn bonds_and_steps_agree() {
    repeats("free-flight");
    repeats("bar-pull");
}

#[test]
fn bonds_break_in_the_same_order() {
    repeats("tear");
}

#[test]
fn collisions_agree() {
    repeats("head-on-elastic");
    repeats("oblique-friction");
}

#[test]
fn walls_agree() {
    repeats("wall-as-published");
    repeats("wall-two-fixes");
}

#[test]
fn a_notched_square_breaks_in_the_same_way() {
    repeats("notch");
}
