//! Sweeps, calibrations, and the command line.

use crate::watch::{Callback, watched};
use gouge::runner::error::Error;
use gouge::studies::calibrate::{self as calibrations, Runner};
use gouge::studies::sweep::{
    Execution, Planned, Program, Sweep, collect, estimate, execute, open, plan,
};
use pyo3::prelude::*;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Do what a command line says, the first argument of which is the name of the program; its exit status. `program` starts
/// it for the runs of sweeps.
#[pyfunction]
pub fn command_line(py: Python<'_>, program: Vec<OsString>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| gouge::command_line(&program_of(program), arguments))
}

fn program_of(words: Vec<OsString>) -> Program {
    let mut words = words.into_iter();
    Program {
        file: words.next().map(PathBuf::from).unwrap_or_default(),
        arguments: words.collect(),
    }
}

/// Execute runs, and tell Python how many of them have ended.
fn execute_told(runs: &[Planned], execution: Execution, told: &Callback) -> Result<(), Error> {
    let ended = AtomicUsize::new(0);
    execute(runs, execution, &|_| {
        let number = 1 + ended.fetch_add(1, Ordering::Relaxed);
        told.call((number, runs.len()), execution.stop);
    })
}

/// Run the sweep of a file.
#[pyfunction]
#[pyo3(signature = (program, file, out, jobs, progress = None))]
pub fn sweep(
    py: Python<'_>,
    program: Vec<OsString>,
    file: PathBuf,
    out: PathBuf,
    jobs: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<()> {
    let program = program_of(program);
    watched(py, |stop| {
        let told = Callback::new(progress.as_ref());
        let execution = Execution {
            program: &program,
            out: &out,
            jobs,
            stop,
        };
        let outcome = run_sweep(&file, execution, &told);
        told.outcome(outcome)
    })
}

fn run_sweep(file: &Path, execution: Execution, told: &Callback) -> Result<(), Error> {
    let sweep = Sweep::load(file)?;
    let runs = plan(&sweep, execution.out)?;
    let open = open(&runs, execution.out);
    if sweep.core_hours.is_some() {
        sweep.within_budget(estimate(&open))?;
    }
    let open: Vec<Planned> = open.into_iter().cloned().collect();
    let outcome = execute_told(&open, execution, told);
    collect(&sweep, &runs, execution.out)?;
    outcome
}

/// Calibrate by a file or a built-in calibration: the answer in a word, and the account of it.
#[pyfunction]
#[pyo3(signature = (program, file, out, jobs, progress = None))]
pub fn calibrate(
    py: Python<'_>,
    program: Vec<OsString>,
    file: PathBuf,
    out: PathBuf,
    jobs: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, String)> {
    let program = program_of(program);
    watched(py, |stop| {
        let told = Callback::new(progress.as_ref());
        let executed = |_: &str, runs: &[Planned]| {
            let execution = Execution {
                program: &program,
                out: &out,
                jobs,
                stop,
            };
            execute_told(runs, execution, &told)
        };
        let runner = Runner {
            out: &out,
            execute: &executed,
        };
        let answer = || {
            let calibration = calibrations::load(&file)?;
            let outcome = calibrations::calibrate(&calibration, runner)?;
            outcome.write(&calibration, &out)?;
            let account = calibrations::account(&calibration, &outcome);
            Ok((outcome.answer.name().to_owned(), account))
        };
        let outcome = answer();
        told.outcome(outcome)
    })
}
