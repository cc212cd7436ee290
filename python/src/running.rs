//! Whole runs, and the commands of a scene.

use crate::errors::raised;
use crate::tables::columns;
use crate::values::{dict_of_toml, scene_of};
use crate::watch::{Callback, abandonable, watched};
use gouge::runner::build;
use gouge::runner::commands;
use gouge::runner::run::{Event, Observer, RunOptions};
use gouge::runner::scene::builtin;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// Version of the program and the commit from which it was built.
#[pyfunction]
pub fn version() -> &'static str {
    build::VERSION
}

/// Names and purposes of the built-in scenes.
#[pyfunction]
pub fn scenes(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let dict = PyDict::new(py);
    for (name, purpose, _) in builtin::SCENES {
        dict.set_item(name, purpose)?;
    }
    Ok(dict)
}

/// A built-in scene as nested dicts.
#[pyfunction]
pub fn scene<'py>(py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    let text = commands::scenes(Some(name)).map_err(|error| raised(&error))?;
    dict_of_toml(py, &text)
}

/// All pairs that interact at t = 0 as columns.
#[pyfunction]
#[pyo3(signature = (scene, overrides = None))]
pub fn links<'py>(
    py: Python<'py>,
    scene: &Bound<'py, PyAny>,
    overrides: Option<&Bound<'py, PyDict>>,
) -> PyResult<Bound<'py, PyDict>> {
    let scene = scene_of(scene, overrides)?;
    let table = abandonable(py, move || scene.links());
    columns(py, table?)
}

/// The bounds of the time step of a scene as JSON.
#[pyfunction]
#[pyo3(signature = (scene, overrides = None))]
pub fn stability(
    py: Python<'_>,
    scene: &Bound<'_, PyAny>,
    overrides: Option<&Bound<'_, PyDict>>,
) -> PyResult<String> {
    let scene = scene_of(scene, overrides)?;
    abandonable(py, move || scene.stability())
}

/// Run a scene into a folder; the summary as JSON, the warnings, and the account of the run.
#[pyfunction]
#[pyo3(signature = (scene, out, overrides = None, resume = false, overwrite = false, checkpoint_interval = 5.0, progress = None))]
#[expect(clippy::too_many_arguments, reason = "they are named in Python")]
pub fn run(
    py: Python<'_>,
    scene: &Bound<'_, PyAny>,
    out: PathBuf,
    overrides: Option<&Bound<'_, PyDict>>,
    resume: bool,
    overwrite: bool,
    checkpoint_interval: f64,
    progress: Option<Py<PyAny>>,
) -> PyResult<(String, Vec<String>, String)> {
    let scene = scene_of(scene, overrides)?;
    let options = RunOptions {
        resume,
        overwrite,
        data_only: false,
        checkpoint_interval,
    };
    let warnings = Mutex::default();
    let summary = watched(py, |stop| {
        let told = Callback::new(progress.as_ref());
        let mut watcher = Watcher {
            stop,
            progress: &told,
            steps: Vec::new(),
            warnings: &warnings,
        };
        let outcome = scene.run(&out, options, &mut watcher);
        told.outcome(outcome)
    })?;
    let text = serde_json::to_string(&summary).unwrap_or_default();
    let account = gouge::account(&scene, &summary, &out);
    Ok((text, warnings.into_inner().unwrap_or_default(), account))
}

/// Tells Python of the progress of a run, and the run when to stop.
struct Watcher<'a> {
    stop: &'a AtomicBool,
    /// A function of the share that is done and the name of the phase.
    progress: &'a Callback<'a>,
    /// Names of all phases, and steps before and after each.
    steps: Vec<(String, u64, u64)>,
    warnings: &'a Mutex<Vec<String>>,
}

impl Watcher<'_> {
    fn tell(&self, phase: usize, steps: u64) {
        let Some((name, before, _)) = self.steps.get(phase) else {
            return;
        };
        let all = self.steps.last().map_or(1, |last| last.2.max(1));
        let share = (before + steps) as f64 / all as f64;
        self.progress.call((share, name.as_str()), self.stop);
    }
}

impl Observer for Watcher<'_> {
    fn event(&mut self, event: Event<'_>) {
        match event {
            Event::PhaseBegan { phases, .. } if self.steps.is_empty() => {
                let mut before = 0;
                for phase in phases {
                    let after = before + phase.steps;
                    self.steps.push((phase.name.clone(), before, after));
                    before = after;
                }
            }
            Event::Progress { phase, steps } => self.tell(phase, steps),
            Event::Warning(warning) => {
                if let Ok(mut warnings) = self.warnings.lock() {
                    warnings.push(warning.to_string());
                }
            }
            _ => {}
        }
    }

    fn wants_stop(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
