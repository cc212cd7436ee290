//! Sweeps, calibrations, and the command line.

use crate::errors::raised;
use crate::watch::watched;
use gouge::runner::error::Error;
use gouge::studies::calibrate::{self as calibrations, Runner};
use gouge::studies::sweep::{Execution, Planned, Program, Sweep, collect, estimate, execute, plan};
use pyo3::prelude::*;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

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

/// Tells Python how many of some runs have ended.
struct Counter<'a> {
    progress: Option<&'a Py<PyAny>>,
    ended: Mutex<usize>,
    /// The exception that the function raised.
    failure: Mutex<Option<PyErr>>,
}

impl<'a> Counter<'a> {
    fn new(progress: Option<&'a Py<PyAny>>) -> Self {
        Self {
            progress,
            ended: Mutex::default(),
            failure: Mutex::default(),
        }
    }

    /// What some work gave; first the exception of the function, then that of the work.
    fn outcome<T>(self, outcome: Result<T, Error>) -> PyResult<T> {
        match self.failure.into_inner().unwrap_or_default() {
            Some(failure) => Err(failure),
            None => outcome.map_err(|error| raised(&error)),
        }
    }

    fn execute(&self, runs: &[Planned], execution: Execution) -> Result<(), Error> {
        if let Ok(mut ended) = self.ended.lock() {
            *ended = 0;
        }
        execute(runs, execution, &|_| {
            let Ok(mut ended) = self.ended.lock() else {
                return;
            };
            *ended += 1;
            if let Some(function) = self.progress {
                let told = Python::attach(|py| function.call1(py, (*ended, runs.len())));
                if let (Err(exception), Ok(mut failure)) = (told, self.failure.lock()) {
                    *failure = Some(exception);
                    execution.stop.store(true, Ordering::Relaxed);
                }
            }
        })
    }
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
        let counter = Counter::new(progress.as_ref());
        let outcome = run_sweep(&file, &out, jobs, &program, stop, &counter);
        counter.outcome(outcome)
    })
}

fn run_sweep(
    file: &Path,
    out: &Path,
    jobs: usize,
    program: &Program,
    stop: &AtomicBool,
    counter: &Counter,
) -> Result<(), Error> {
    let sweep = Sweep::load(file)?;
    let runs = plan(&sweep, out)?;
    let is_open = |run: &&Planned| !run.state(out).status.is_final();
    let open: Vec<Planned> = runs.iter().filter(is_open).cloned().collect();
    if sweep.core_hours.is_some() {
        sweep.within_budget(estimate(&open.iter().collect::<Vec<_>>()))?;
    }
    let execution = Execution {
        program,
        out,
        jobs,
        stop,
    };
    let outcome = counter.execute(&open, execution);
    collect(&sweep, &runs, out)?;
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
        let counter = Counter::new(progress.as_ref());
        let executed = |_: &str, runs: &[Planned]| {
            let execution = Execution {
                program: &program,
                out: &out,
                jobs,
                stop,
            };
            counter.execute(runs, execution)
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
        counter.outcome(outcome)
    })
}
