//! Long work without the global interpreter lock, which Ctrl-C stops.

use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
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
        let worker = scope.spawn(|| work(&stop));
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
