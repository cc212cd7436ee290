//! Motion of grains, step by step.

use super::Repeated;
use super::inputs::{self, Input, Variant};
use super::series::{Tables, broken};
use crate::error::{Fault, ReplayError};
use crate::fields::Fields;
use flate2::read::GzDecoder;
use gouge_peridem::material::Weight;
use gouge_peridem::mode::Mode;
use serde_json::Value;
use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Steps at which a table is written: those of the table beside the case, or all multiples of the interval and the last.
struct Steps(Option<BTreeSet<u64>>);

impl Steps {
    fn beside(case: &Path, table: &str) -> Result<Self, ReplayError> {
        let folder = case.parent().unwrap_or(Path::new("."));
        let names = [table.to_owned(), format!("{table}.gz")];
        for file in names.map(|name| folder.join(name)) {
            if file.is_file() {
                let text = text(&file)?;
                let step = |line: &str| line.split(',').next()?.parse().ok();
                return Ok(Self(Some(text.lines().filter_map(step).collect())));
            }
        }
        Ok(Self(None))
    }

    fn contains(&self, step: usize, input: &Input) -> bool {
        match &self.0 {
            Some(steps) => steps.contains(&(step as u64)),
            None => step.is_multiple_of(input.interval) || step == input.steps,
        }
    }
}

/// The text of a file, which may be compressed with gzip.
fn text(file: &Path) -> Result<String, ReplayError> {
    let read = |source| ReplayError::Read {
        file: file.to_owned(),
        source,
    };
    let bytes = std::fs::read(file).map_err(read)?;
    let mut text = String::new();
    if bytes.starts_with(&[0x1f, 0x8b]) {
        GzDecoder::new(&bytes[..]).read_to_string(&mut text)
    } else {
        (&bytes[..]).read_to_string(&mut text)
    }
    .map_err(read)?;
    Ok(text)
}

/// The JSON of a file, which may be compressed.
pub(super) fn json(file: &Path) -> Result<Value, ReplayError> {
    serde_json::from_str(&text(file)?).map_err(|source| ReplayError::Syntax {
        file: file.to_owned(),
        source,
    })
}

/// Repeat the motion of a case, given by its file and its contents.
pub(super) fn repeat(file: &Path, case: &Value, mode: Mode) -> Result<Repeated, ReplayError> {
    let structure = |file: &Path| {
        let file = file.to_owned();
        move |fault| ReplayError::Structure { file, fault }
    };
    let fields = Fields::root(case);
    let (other, variant) = variant(file, &fields).map_err(structure(file))?;
    let input = match &other {
        Some(other) => {
            let value = json(other)?;
            inputs::read(&Fields::root(&value), mode, variant).map_err(structure(other))?
        }
        None => inputs::read(&fields, mode, variant).map_err(structure(file))?,
    };
    let steps = [
        Steps::beside(file, "frames.csv")?,
        Steps::beside(file, "bonds.csv")?,
    ];
    run(input, &steps, mode).map_err(structure(file))
}

/// The case whose grains another one has, beside its folder, and what differs.
fn variant(file: &Path, case: &Fields) -> Result<(Option<PathBuf>, Variant), Fault> {
    if case.optional("same_input_as").is_none() {
        return Ok((None, Variant::default()));
    }
    let name = case.text("same_input_as")?;
    let folder = file
        .parent()
        .unwrap_or(Path::new("."))
        .join("..")
        .join(name);
    let names = ["case.json", "case.json.gz"].map(|file| folder.join(file));
    let [plain, _] = &names;
    let found = names.iter().find(|file| file.is_file()).unwrap_or(plain);
    let weight = match case.optional("weight") {
        None => Weight::Constant,
        Some(_) => match case.word("weight", &["constant", "conic", "parabolic"])? {
            "conic" => Weight::Conic,
            "parabolic" => Weight::Parabolic,
            _ => Weight::Constant,
        },
    };
    let steps = match case.optional("steps") {
        None => None,
        Some(_) => Some(case.count("steps", 0, 1 << 31)?),
    };
    Ok((Some(found.clone()), Variant { weight, steps }))
}

fn run(mut input: Input, steps: &[Steps; 2], mode: Mode) -> Result<Repeated, Fault> {
    let mut tables = Tables::new(input.world.grains().rows.len());
    let mut all_broken = Vec::new();
    for step in 1..=input.steps {
        input.world.step()?;
        let now = input.world.broken().iter();
        all_broken.extend(now.map(|&pair| broken(&input.world, pair)));
        if step.is_multiple_of(input.interval) || step == input.steps {
            tables.add_sums(&input.world);
        }
        if steps[0].contains(step, &input) {
            tables.add_frame(&input.world);
        }
        if steps[1].contains(step, &input) {
            all_broken.sort_unstable();
            tables.add_broken(&input.world, &all_broken);
        }
    }
    let account = format!(
        "{}: {} nodes, {} steps, {} bonds broken\n",
        mode.name(),
        input.world.grains().nodes(),
        input.steps,
        all_broken.len()
    );
    Ok(Repeated {
        files: vec![
            ("frames.csv".to_owned(), tables.frames),
            ("series.csv".to_owned(), tables.series),
            ("bonds.csv".to_owned(), tables.bonds),
        ],
        account,
    })
}
