//! Scenes and overrides from Python's values.

use crate::errors::{DICT, bad_argument, raised};
use ::toml::{Table, Value};
use gouge::runner::any_scene::AnyScene;
use gouge::runner::error::{Error, SceneError};
use gouge::runner::machine;
use gouge::runner::scene::Overrides;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyMapping};
use pythonize::{depythonize, pythonize};
use std::path::{Path, PathBuf};

/// A scene from a path, the name of a built-in scene, or a dict, with some keys overridden.
pub fn scene_of(
    scene: &Bound<'_, PyAny>,
    overrides: Option<&Bound<'_, PyDict>>,
) -> PyResult<AnyScene> {
    // Refuses what the environment says wrongly about instructions and threads.
    machine::chosen().map_err(|error| raised(&error))?;
    let overrides = overrides_of(overrides)?;
    match scene.cast::<PyMapping>() {
        Ok(mapping) => {
            let text = toml(mapping)?;
            let scene = AnyScene::parse_with(DICT, text.as_bytes(), Path::new("."), &overrides);
            // A dict has no lines.
            scene.map_err(|error| match error {
                Error::Scene(error) => raised(&SceneError { line: 0, ..error }.into()),
                other => raised(&other),
            })
        }
        Err(_) => {
            let path: PathBuf = scene.extract()?;
            AnyScene::load_with(path, &overrides).map_err(|error| raised(&error))
        }
    }
}

/// A dict as TOML.
#[pyfunction]
pub fn toml(mapping: &Bound<'_, PyMapping>) -> PyResult<String> {
    let refusal = |error: &dyn std::fmt::Display| {
        bad_argument(&format!("the dict has no form in TOML: {error}"))
    };
    let table: Table = depythonize(mapping).map_err(|error| refusal(&error))?;
    ::toml::to_string(&table).map_err(|error| refusal(&error))
}

/// TOML as nested dicts.
#[pyfunction]
pub fn dict_of_toml<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    let table: Table = text
        .parse()
        .map_err(|error| bad_argument(&format!("not TOML: {error}")))?;
    Ok(pythonize(py, &table)?)
}

/// A value as TOML, as it stands behind a key.
#[pyfunction]
pub fn toml_value(value: &Bound<'_, PyAny>) -> PyResult<String> {
    Ok(value_of(value, "value")?.to_string())
}

fn value_of(value: &Bound<'_, PyAny>, key: &str) -> PyResult<Value> {
    depythonize(value)
        .map_err(|error| bad_argument(&format!("{key}: the value has no form in TOML: {error}")))
}

fn overrides_of(overrides: Option<&Bound<'_, PyDict>>) -> PyResult<Overrides> {
    let mut texts = Vec::new();
    for (key, value) in overrides.into_iter().flatten() {
        let key: String = key.extract()?;
        texts.push(format!("{key}={}", value_of(&value, &key)?));
    }
    Overrides::parse(&texts).map_err(|error| raised(&error.into()))
}
