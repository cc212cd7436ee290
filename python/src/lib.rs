//! The native part of the Python package `gouge`; `gouge/_gouge.pyi` describes it to Python.

mod errors;
mod many_runs;
mod running;
mod simulation;
mod tables;
mod values;
mod watch;

use mimalloc::MiMalloc;
use pyo3::prelude::*;

#[global_allocator]
static ALLOCATOR: MiMalloc = MiMalloc;

/// The native part of the package `gouge`.
#[pymodule]
mod _gouge {
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(_module: &Bound<'_, PyModule>) -> PyResult<()> {
        // Remembers the process, so that a fork of it is noticed.
        gouge::runner::machine::is_forked();
        Ok(())
    }

    #[pymodule_export]
    use super::many_runs::{calibrate, command_line, sweep};
    #[pymodule_export]
    use super::running::{links, run, scene, scenes, stability, version};
    #[pymodule_export]
    use super::simulation::Simulation;
    #[pymodule_export]
    use super::tables::load_numpy;
    #[pymodule_export]
    use super::values::{dict_of_toml, toml, toml_value};
}
