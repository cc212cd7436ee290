//! Scenes and overrides from Python's values.

use crate::errors::{bad_argument, raised};
use ::toml::{Table, Value};
use gouge::runner::scene::{Overrides, Scene};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use pythonize::{depythonize, pythonize};
use std::path::{Path, PathBuf};

/// A scene from a path, the name of a built-in scene, or a dict, with some keys overridden.
pub fn scene_of(
    scene: &Bound<'_, PyAny>,
    overrides: Option<&Bound<'_, PyDict>>,
) -> PyResult<Scene> {
    let overrides = overrides_of(overrides)?;
    match scene.cast::<PyMapping>() {
        Ok(mapping) => {
            let text = toml(mapping)?;
            let scene = Scene::parse_with("scene", text.as_bytes(), Path::new("."), &overrides);
            scene.map_err(|error| raised(&error.into()))
        }
        Err(_) => {
            let path: PathBuf = scene.extract()?;
            Scene::load_with(path, &overrides).map_err(|error| raised(&error))
        }
    }
}

/// A dict as TOML.
#[pyfunction]
pub fn toml(mapping: &Bound<'_, PyMapping>) -> PyResult<String> {
    let table: Table = depythonize(mapping)
        .map_err(|error| bad_argument(&format!("the dict has no form in TOML: {error}")))?;
    ::toml::to_string(&table)
        .map_err(|error| bad_argument(&format!("the dict has no form in TOML: {error}")))
}

/// TOML as nested dicts.
#[pyfunction]
pub fn dict_of_toml<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    let table: Table = text
        .parse()
        .map_err(|error| bad_argument(&format!("not TOML: {error}")))?;
    Ok(pythonize(py, &table)?)
}

fn overrides_of(overrides: Option<&Bound<'_, PyDict>>) -> PyResult<Overrides> {
    let mut texts = Vec::new();
    for (key, value) in overrides.into_iter().flatten() {
        let key: String = key.extract()?;
        let value: Value = depythonize(&value).map_err(|error| {
            bad_argument(&format!("{key}: the value has no form in TOML: {error}"))
        })?;
        texts.push(format!("{key}={value}"));
    }
    Overrides::parse(&texts).map_err(|error| raised(&error.into()))
}
