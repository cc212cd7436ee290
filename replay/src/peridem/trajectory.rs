//! Motion of grains, step by step.

use super::inputs::{self, Input, Variant, short_enough};
use super::series::{Tables, broken};
use super::steps::Steps;
use super::{Repeated, Watch, json, output_name};
use crate::error::{CaseError, Fault, ReplayError};
use crate::fields::Fields;
use gouge_peridem::error::{StepError, TooFast};
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
    let time_step = match &other {
        Some(other) => format!("conf.dt of {}", other.display()),
        None => "conf.dt".to_owned(),
    };
    let mut motion = Motion::new(input, steps, time_step);
    let failures = motion.run(mode, watch).err().map(|fault| CaseError {
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
    /// The key of the time step.
    time_step: String,
    tables: Tables,
    broken: Vec<super::series::Broken>,
    /// The first step in which contacts may be missed, and what moves too fast for it; none in a guarded world.
    missed: Option<(usize, Box<TooFast>)>,
    /// The latest step, also if it fails.
    step: usize,
}

impl Motion {
    fn new(input: Input, steps: [Steps; 2], time_step: String) -> Self {
        Self {
            tables: Tables::new(input.world.grains().rows.len()),
            input,
            steps,
            time_step,
            broken: Vec::new(),
            missed: None,
            step: 0,
        }
    }

    /// All steps, or those before one that fails.
    fn run(&mut self, mode: Mode, watch: Watch) -> Result<(), Fault> {
        if self.steps[0].contain_beginning() {
            self.tables.add_frame(&self.input.world)?;
        }
        let all = self.input.steps;
        for step in 1..=all {
            self.step = step;
            if mode != Mode::Corrected && self.missed.is_none() {
                let motion = self.input.world.too_fast();
                self.missed = motion.map(|motion| (step, motion));
            }
            let done = self.input.world.step();
            done.map_err(|error| self.fault(error))?;
            self.write(step)?;
            if step.is_multiple_of(REPORT_INTERVAL) {
                watch(step as u64, all as u64);
            }
        }
        Ok(())
    }

    /// The error about a step that fails.
    fn fault(&self, error: StepError) -> Fault {
        match error {
            StepError::TooFast { motion, .. } => Fault::Value {
                key: self.time_step.clone(),
                value: format!("{:?}", self.input.world.settings().time_step),
                accepted: short_enough(self.step, &motion),
            },
            error => error.into(),
        }
    }

    /// Rows of the tables after a step.
    fn write(&mut self, step: usize) -> Result<(), Fault> {
        let input = &self.input;
        let now = input.world.broken().iter();
        self.broken
            .extend(now.map(|&pair| broken(&input.world, pair)));
        if step.is_multiple_of(input.interval) || step == input.steps {
            self.tables.add_sums(&input.world)?;
        }
        let [frames, bonds] = &self.steps;
        if frames.contain(step) {
            self.tables.add_frame(&input.world)?;
        }
        if bonds.contain(step) {
            self.broken.sort_unstable();
            self.tables.add_broken(&input.world, &self.broken);
        }
        Ok(())
    }

    fn repeated(self, mode: Mode, failures: Vec<CaseError>) -> Repeated {
        let doubts = self.doubts();
        let Self { input, tables, .. } = self;
        let steps = match failures.is_empty() {
            true => format!("{} steps", input.steps),
            false => format!("failed in step {} of {}", self.step, input.steps),
        };
        let nodes = input.world.grains().nodes();
        let broken = self.broken.len();
        Repeated {
            files: vec![
                ("frames.csv".to_owned(), tables.frames),
                ("series.csv".to_owned(), tables.series),
                ("bonds.csv".to_owned(), tables.bonds),
            ],
            account: format!(
                "{}: {nodes} nodes, {steps}, {broken} bonds broken\n{doubts}",
                mode.name()
            ),
            failures,
            cases: 1,
        }
    }

    /// Lines about keys without a meaning, and about a time step that is too long.
    fn doubts(&self) -> String {
        let world = &self.input.world;
        let step = world.settings().time_step;
        let mut doubts = String::new();
        if !self.input.ignored.is_empty() {
            let ignored: Vec<&str> = self.input.ignored.iter().map(String::as_str).collect();
            doubts += &format!(
                "keys of grains without a meaning here: {}\n",
                ignored.join(", ")
            );
        }
        if let Some((first, motion)) = &self.missed {
            doubts += &format!("contacts may have been missed from step {first} on: {motion}\n");
        }
        let limits = Limits::of(world.grains(), world.bonds(), world.settings());
        let (meaning, limit) = limits.smallest();
        if step > limit {
            doubts += &format!(
                "dt = {step:?} s is above a limit of stability at the end, {limit:.3e} s ({meaning})\n"
            );
        }
        doubts
    }
}
