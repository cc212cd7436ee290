//! Motions that the program of the authors of peridem computed, repeated with the same input and order of operations.

use crate::checks::{
    Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, largest as most, peridem,
};
use flate2::read::GzDecoder;
use gouge_replay::peridem::{Mode, repeat};
use gouge_runner::references::{FOLDER, file_text};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::{Path, PathBuf};

const CASE: &str = "perigrain/motions";
/// Largest difference of positions and centres in m.
const POSITION: f64 = 1e-16;
/// Largest difference of velocities, and of sums, per largest one.
const RELATIVE: f64 = 1e-10;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "peridem.perigrain.motions",
        claim: "Motions of the authors' program are repeated: bonds, clamped nodes and loads, tearing, collisions with and without friction, walls, and a notched square; the same bonds break.",
        equations: peridem("(2.1), (3.1), (3.2), (4.1)-(4.6), section 6.1, section 6.4, Q6"),
        scene: "Eight motions, with the inputs of that program",
        oracle: "perigrain, commit b942b0f, stored in references/perigrain/motions",
        norm: "Largest difference of a position in units of 1e-6 m, of another number in units of the largest one of its column; number of bonds that broke in one program only",
        origin: Origin::Exact,
        reason: "Positions of millimetres round by 2e-19 m; up to a thousand steps that err in one direction stay below 1e-16 m. Rounding is 1e-16 of the largest number of a column for each of up to 300 bonds and contacts of a node in up to 3000 steps: 1e-10",
        effort: Effort::Thorough,
        measure: motions,
    }]
}

fn motions() -> Outcome {
    let text = file_text(Path::new(CASE), "result.json").map_err(Failure::Oracle)?;
    let result: Value = serde_json::from_str(text).map_err(oracle)?;
    let folder = tempfile::tempdir().map_err(oracle)?;
    std::fs::create_dir_all(folder.path().join(CASE)).map_err(oracle)?;
    let stored = FOLDER.get_dir(CASE).ok_or_else(|| oracle("no motions"))?;
    stored.extract(folder.path()).map_err(oracle)?;
    let mut all = Vec::new();
    let mut table = Table::new(
        "Largest differences from the authors' program",
        &["motion", "position, m", "others, relative", "broken bonds"],
    );
    for run in result["runs"].as_array().map_or(&[][..], Vec::as_slice) {
        let found = Motion::read(folder.path(), &result, run)?.compare()?;
        table.push(found.row());
        all.extend(found.measurements());
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn oracle(error: impl std::fmt::Display) -> Failure {
    Failure::Oracle(error.to_string())
}

/// A stored motion.
struct Motion {
    name: String,
    folder: PathBuf,
    mode: Mode,
}

/// Largest differences of a motion.
struct Differences {
    name: String,
    /// In m.
    position: f64,
    /// In units of the largest number of its column.
    relative: f64,
    /// Number of bonds that broke in both programs, and in one only.
    broken: [usize; 2],
}

impl Differences {
    fn row(&self) -> [String; 4] {
        let [both, one] = self.broken;
        let broken = if one == 0 {
            both.to_string()
        } else {
            format!("{both} and {one} in one program only")
        };
        let [position, relative] = [self.position, self.relative].map(|size| format!("{size:.1e}"));
        [self.name.clone(), position, relative, broken]
    }

    fn measurements(&self) -> [Measurement; 3] {
        [
            Measurement::scaled(0.0, self.position, POSITION / RELATIVE, RELATIVE),
            Measurement::absolute(0.0, self.relative, RELATIVE),
            Measurement::count(self.broken[1]),
        ]
    }

    fn note(&mut self, column: &str, [difference, largest]: [f64; 2]) {
        match column {
            // Momentum vanishes in symmetric motions, but for rounding.
            "px" | "py" => {}
            "x" | "y" => self.position = most([self.position, difference]),
            _ if column.starts_with('c') && column != "contact" => {
                self.position = most([self.position, difference]);
            }
            _ if difference != 0.0 => self.relative = most([self.relative, difference / largest]),
            _ => {}
        }
    }
}

impl Motion {
    /// A run whose input is that of the result.
    fn read(root: &Path, result: &Value, run: &Value) -> Result<Self, Failure> {
        let name = run["name"].as_str().unwrap_or_default();
        let own = root.join(CASE).join(name);
        let digest = Sha256::digest(unzipped(&own.join("case.json.gz"))?);
        let hash: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        if result["inputs"][format!("{name}/case.json")] != hash.as_str() {
            return Err(oracle(format!("the input of {name} changed")));
        }
        let mode = Mode::ALL.iter().find(|(mode, _)| run["mode"] == *mode);
        let (_, mode) = mode.ok_or_else(|| oracle(format!("{name} has no mode")))?;
        Ok(Self {
            name: name.to_owned(),
            folder: own,
            mode: *mode,
        })
    }

    fn compare(&self) -> Result<Differences, Failure> {
        let repeated = repeat(&self.folder.join("case.json.gz"), self.mode, &mut |_, _| {});
        let repeated = repeated.map_err(oracle)?;
        if let Some(failure) = repeated.failures.first() {
            return Err(oracle(failure));
        }
        let files: BTreeMap<_, _> = repeated.files.into_iter().collect();
        let mut found = Differences {
            name: self.name.clone(),
            position: 0.0,
            relative: 0.0,
            broken: [0; 2],
        };
        for (file, keys) in [("frames.csv", 3), ("series.csv", 1)] {
            let stored = unzipped(&self.folder.join(format!("{file}.gz")))?;
            for (column, differences) in apart(&files[file], &stored, keys)? {
                found.note(column, differences);
            }
        }
        let bonds = self.folder.join("bonds.csv.gz");
        if bonds.is_file() {
            let stored = unzipped(&bonds)?;
            let [ours, theirs] = [&files["bonds.csv"], &stored]
                .map(|text| text.lines().skip(1).collect::<BTreeSet<_>>());
            let one = ours.symmetric_difference(&theirs).count();
            let bond = |row: &&&str| row.split_once(',').map(|(_step, bond)| bond.to_owned());
            let both: BTreeSet<_> = ours.intersection(&theirs).map(|row| bond(&row)).collect();
            found.broken = [both.len(), one];
        }
        Ok(found)
    }
}

fn unzipped(file: &Path) -> Result<String, Failure> {
    let bytes =
        std::fs::read(file).map_err(|error| oracle(format!("{}: {error}", file.display())))?;
    let mut text = String::new();
    let read = GzDecoder::new(&bytes[..]).read_to_string(&mut text);
    read.map_err(oracle)?;
    Ok(text)
}

/// Names of the columns of a table that are numbers, and its rows by their first columns.
type Rows<'a> = (Vec<&'a str>, BTreeMap<String, Vec<f64>>);

fn rows(text: &str, keys: usize) -> Result<Rows<'_>, Failure> {
    let mut lines = text.lines();
    let names: Vec<_> = lines.next().unwrap_or_default().split(',').collect();
    let row = |line: &str| {
        let values: Vec<_> = line.split(',').collect();
        let numbers = values.iter().skip(keys).map(|value| value.parse());
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().map_err(oracle)?;
        if values.len() != names.len() {
            return Err(oracle(format!("a row is not complete: {line}")));
        }
        Ok((values[..keys].join(","), numbers))
    };
    let all = lines.map(row).collect::<Result<_, _>>()?;
    Ok((names[keys..].to_vec(), all))
}

/// Largest difference of each column of two tables with the same rows, and the largest magnitude in the second.
fn apart<'a>(
    found: &str,
    stored: &'a str,
    keys: usize,
) -> Result<Vec<(&'a str, [f64; 2])>, Failure> {
    let ((our_names, ours), (names, theirs)) = (rows(found, keys)?, rows(stored, keys)?);
    if !ours.keys().eq(theirs.keys()) {
        return Err(oracle("the tables have other rows"));
    }
    let column = |(place, name): (usize, &&'a str)| {
        let own = our_names.iter().position(|one| one == name);
        let own = own.ok_or_else(|| oracle(format!("there is no column {name}")))?;
        let largest = theirs.values().map(|row| row[place].abs());
        let pairs = ours.values().zip(theirs.values());
        let differences = pairs.map(|(a, b)| (a[own] - b[place]).abs());
        Ok((*name, [most(differences), largest.fold(0.0, f64::max)]))
    };
    names.iter().enumerate().map(column).collect()
}
