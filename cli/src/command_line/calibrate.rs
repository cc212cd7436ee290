//! `gouge calibrate`: the parameters of scenes that agree with what was measured.

use super::print;
use super::sweep::{cores, run};
use super::terminal::{say, stopped_by_signals};
use clap::Args;
use gouge_runner::error::Error;
use gouge_studies::calibrate::{
    Answer, Runner, account, account_of_trial, calibrate, load, names, recover, text,
};
use gouge_studies::sweep::{Execution, Planned, Program};
use std::path::{Path, PathBuf};

/// A calibration and where it is done.
#[derive(Args)]
pub struct CalibrateArguments {
    /// A calibration file, or the name of a built-in calibration
    #[arg(required_unless_present = "list")]
    file: Option<PathBuf>,
    /// Folder of the calibration
    #[arg(long, value_name = "DIR", required_unless_present_any = ["list", "print"])]
    out: Option<PathBuf>,
    /// List the built-in calibrations
    #[arg(long)]
    list: bool,
    /// Print the file of a built-in calibration, as a start for one of your own
    #[arg(long, conflicts_with = "list")]
    print: bool,
    /// Recover known truths with synthetic measurements instead of calibrating
    #[arg(long)]
    recover: bool,
    /// Number of runs at a time; as many as there are cores if absent
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Show no progress
    #[arg(long, short)]
    quiet: bool,
}

/// The argument that stands for all built-in calibrations in a recovery.
const ALL: &str = "all";

/// Do what the arguments say.
///
/// # Errors
/// A calibration that cannot be used, failures of the file system, an interruption, a model that is refuted, a recovery
/// that failed.
pub fn launch(arguments: &CalibrateArguments, program: &Program) -> Result<(), Error> {
    if let (true, Some(file)) = (arguments.print, &arguments.file) {
        return print_builtin(file);
    }
    let (Some(file), Some(out)) = (&arguments.file, &arguments.out) else {
        return list();
    };
    let stop = stopped_by_signals()?;
    let jobs = usize::from(arguments.jobs.unwrap_or_else(cores));
    let execute = |purpose: &str, runs: &[Planned]| {
        if !arguments.quiet {
            say(purpose);
        }
        let execution = Execution {
            program,
            out,
            jobs,
            stop: &stop,
        };
        run(runs, execution, arguments.quiet)
    };
    let runner = Runner {
        out,
        execute: &execute,
    };
    match (arguments.recover, file.to_str()) {
        (false, _) => calibrate_one(file, runner),
        (true, Some(ALL)) => recover_all(names().map(PathBuf::from), runner),
        (true, _) => recover_all([file.clone()].into_iter(), runner),
    }
}

fn calibrate_one(file: &Path, runner: Runner) -> Result<(), Error> {
    let calibration = load(file)?;
    let outcome = calibrate(&calibration, runner)?;
    outcome.write(&calibration, runner.out)?;
    print(&account(&calibration, &outcome))?;
    match outcome.answer {
        Answer::Refuted(_) => Err(Error::Refuted(calibration.title)),
        _ => Ok(()),
    }
}

fn recover_all(files: impl Iterator<Item = PathBuf>, runner: Runner) -> Result<(), Error> {
    let (mut all, mut failed) = (0, 0);
    for file in files {
        let calibration = load(&file)?;
        let trial = recover(&calibration, runner)?;
        all += 1;
        failed += usize::from(!trial.recovery.passes());
        print(&(account_of_trial(&calibration, &trial) + "\n"))?;
    }
    match failed {
        0 => Ok(()),
        _ => Err(Error::Recoveries(failed, all)),
    }
}

fn print_builtin(name: &Path) -> Result<(), Error> {
    let text = name.to_str().and_then(text).ok_or_else(|| {
        let known: Vec<&str> = names().collect();
        let name = name.display();
        Error::Argument(format!(
            "{name}: no built-in calibration has this name; those are {}",
            known.join(", ")
        ))
    })?;
    print(text)
}

fn list() -> Result<(), Error> {
    let mut text = String::new();
    for name in names() {
        text += &format!("{name:24}{}\n", load(Path::new(name))?.title);
    }
    print(&text)
}
