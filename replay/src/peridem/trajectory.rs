//! Motion of grains, step by step.

use super::inputs::{self, Input, Variant};
use super::series::{Tables, broken};
use super::steps::Steps;
use super::{Repeated, Watch, json, output_name};
use crate::error::{CaseError, Fault, ReplayError};
use crate::fields::Fields;
use gouge_peridem::limits::Limits;
use gouge_peridem::material::Weight;
use gouge_peridem::mode::Mode;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Keys of which a motion has one.
pub(super) const KEYS: [&str; 2] = ["grains", "same_input_as"];
/// Steps between two reports of progress.
const REPORT_INTERVAL: usize = 64;

/// Repeat the motion of a case, given by its file and its contents.
pub(super) fn repeat(
    file: &Path,
    case: &Value,
    mode: Mode,
    watch: Watch,
) -> Result<Repeated, ReplayError> {
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
    let steps = |table| Steps::beside(file, table, input.interval, input.steps);
    let steps = [steps("frames.csv")?, steps("bonds.csv")?];
    let mut motion = Motion::new(input, steps);
    let failures = motion.run(watch).err().map(|fault| CaseError {
        file: output_name(file),
        case: fields.text("case").unwrap_or("the motion").to_owned(),
        fault,
    });
    Ok(motion.repeated(mode, failures.into_iter().collect()))
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
    let Some(found) = names.iter().find(|file| file.is_file()) else {
        let accepted = "the name of a folder beside that of the case";
        let missing = format!(
            "{accepted}, with case.json or case.json.gz, but there is no {}",
            plain.display()
        );
        return Err(case.refuse_key("same_input_as", missing));
    };
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

/// A motion and what is written of it.
struct Motion {
    input: Input,
    /// When rows of frames and of bonds are written.
    steps: [Steps; 2],
    tables: Tables,
    broken: Vec<super::series::Broken>,
}

impl Motion {
    fn new(input: Input, steps: [Steps; 2]) -> Self {
        Self {
            tables: Tables::new(input.world.grains().rows.len()),
            input,
            steps,
            broken: Vec::new(),
        }
    }

    /// All steps, or those before one that fails.
    fn run(&mut self, watch: Watch) -> Result<(), Fault> {
        if self.steps[0].contain_beginning() {
            self.tables.add_frame(&self.input.world);
        }
        let all = self.input.steps;
        for step in 1..=all {
            self.input.world.step()?;
            self.write(step);
            if step.is_multiple_of(REPORT_INTERVAL) {
                watch(step as u64, all as u64);
            }
        }
        Ok(())
    }

    /// Rows of the tables after a step.
    fn write(&mut self, step: usize) {
        let input = &self.input;
        let now = input.world.broken().iter();
        self.broken
            .extend(now.map(|&pair| broken(&input.world, pair)));
        if step.is_multiple_of(input.interval) || step == input.steps {
            self.tables.add_sums(&input.world);
        }
        let [frames, bonds] = &self.steps;
        if frames.contain(step) {
            self.tables.add_frame(&input.world);
        }
        if bonds.contain(step) {
            self.broken.sort_unstable();
            self.tables.add_broken(&input.world, &self.broken);
        }
    }

    fn repeated(self, mode: Mode, failures: Vec<CaseError>) -> Repeated {
        let Self { input, tables, .. } = self;
        let steps = match failures.is_empty() {
            true => format!("{} steps", input.steps),
            false => format!(
                "failed in step {} of {}",
                input.world.state().steps,
                input.steps
            ),
        };
        let world = &input.world;
        let nodes = world.grains().nodes();
        let broken = self.broken.len();
        let limits = Limits::of(world.grains(), world.bonds(), world.settings());
        let (meaning, limit) = limits.smallest();
        let step = world.settings().time_step;
        let doubt = match step > limit {
            true => format!(
                "dt = {step:?} s is above a limit of stability at the end, {limit:.3e} s ({meaning})\n"
            ),
            false => String::new(),
        };
        Repeated {
            files: vec![
                ("frames.csv".to_owned(), tables.frames),
                ("series.csv".to_owned(), tables.series),
                ("bonds.csv".to_owned(), tables.bonds),
            ],
            account: format!(
                "{}: {nodes} nodes, {steps}, {broken} bonds broken\n{doubt}",
                mode.name()
            ),
            failures,
            cases: 1,
        }
    }
}
