//! Long work without the global interpreter lock, which Ctrl-C stops.

use crate::errors::raised;
use gouge::runner::error::Error;
use pyo3::call::PyCallArgs;
use pyo3::prelude::*;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::Builder;
use std::time::Duration;

/// Time between looks for signals.
const PATIENCE: Duration = Duration::from_millis(5);

/// A function of Python that is told how far some work is.
pub struct Callback<'a> {
    function: Option<&'a Py<PyAny>>,
    /// The exception that it raised.
    failure: Mutex<Option<PyErr>>,
}

impl<'a> Callback<'a> {
    /// A function, or none that is told anything.
    pub fn new(function: Option<&'a Py<PyAny>>) -> Self {
        Self {
            function,
            failure: Mutex::default(),
        }
    }

    /// Call the function; if it raises an exception, the work is told to stop.
    pub fn call<A: for<'py> PyCallArgs<'py>>(&self, arguments: A, stop: &AtomicBool) {
        let Some(function) = self.function else {
            return;
        };
        let told = Python::attach(|py| function.call1(py, arguments));
        if let (Err(exception), Ok(mut failure)) = (told, self.failure.lock()) {
            *failure = Some(exception);
            stop.store(true, Ordering::Relaxed);
        }
    }

    /// What the work gave; first the exception of the function, then that of the work.
    pub fn outcome<T>(self, outcome: Result<T, Error>) -> PyResult<T> {
        match self.failure.into_inner().unwrap_or_default() {
            Some(failure) => Err(failure),
            None => outcome.map_err(|error| raised(&error)),
        }
    }
}

fn not_started(error: std::io::Error) -> PyErr {
    raised(&Error::file("start", Path::new("a thread"), error))
}

/// Do some work in a thread of its own. When Python receives a signal whose handler raises an exception, the switch is set,
/// and the exception is returned once the work has ended.
pub fn watched<T: Send>(
    py: Python<'_>,
    work: impl FnOnce(&AtomicBool) -> PyResult<T> + Send,
) -> PyResult<T> {
    let stop = AtomicBool::new(false);
    std::thread::scope(|scope| {
        let worker = Builder::new()
            .spawn_scoped(scope, || work(&stop))
            .map_err(not_started)?;
        let mut raised = None;
        while !worker.is_finished() {
            if let (None, Err(exception)) = (&raised, py.check_signals()) {
                stop.store(true, Ordering::Relaxed);
                raised = Some(exception);
            }
            py.detach(|| std::thread::sleep(PATIENCE));
        }
        let outcome = py.detach(|| worker.join());
        match (raised, outcome) {
            (Some(exception), _) => Err(exception),
            (None, Ok(outcome)) => outcome,
            (None, Err(panic)) => std::panic::resume_unwind(panic),
        }
    })
}

/// Do some work that cannot be stopped in a thread of its own. When Python receives a signal whose handler raises an
/// exception, the exception is returned at once, and the work goes on without anybody who waits for it.
pub fn abandonable<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> Result<T, Error> + Send + 'static,
) -> PyResult<T> {
    let worker = Builder::new().spawn(work).map_err(not_started)?;
    while !worker.is_finished() {
        py.check_signals()?;
        py.detach(|| std::thread::sleep(PATIENCE));
    }
    match worker.join() {
        Ok(outcome) => outcome.map_err(|error| raised(&error)),
        Err(panic) => std::panic::resume_unwind(panic),
    }
}
