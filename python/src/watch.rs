//! Long work without the global interpreter lock, which Ctrl-C stops.

use crate::errors::raised;
use gouge::runner::error::Error;
use pyo3::prelude::*;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::Builder;
use std::time::Duration;

/// Time between looks for signals.
const PATIENCE: Duration = Duration::from_millis(5);

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
            .map_err(|error| raised(&Error::file("start", Path::new("a thread"), error)))?;
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
    let worker = Builder::new()
        .spawn(work)
        .map_err(|error| raised(&Error::file("start", Path::new("a thread"), error)))?;
    while !worker.is_finished() {
        py.check_signals()?;
        py.detach(|| std::thread::sleep(PATIENCE));
    }
    match worker.join() {
        Ok(outcome) => outcome.map_err(|error| raised(&error)),
        Err(panic) => std::panic::resume_unwind(panic),
    }
}
