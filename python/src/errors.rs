//! Errors as exceptions of `gouge._errors`.

use gouge::runner::error::{Error, SceneError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::Path;

/// The name of a scene that is a dict, in messages.
pub const DICT: &str = "the scene";

/// The exception of an error, with what the error is about as attributes.
pub fn raised(error: &Error) -> PyErr {
    Python::attach(|py| exception(py, error).unwrap_or_else(|failure| failure))
}

/// The exception for an argument that cannot be used.
pub fn bad_argument(message: &str) -> PyErr {
    raised(&Error::Argument(message.to_owned()))
}

/// File, key and value at fault; an override and a dict have no file.
fn place_of(error: &SceneError) -> [Option<&str>; 3] {
    let given = |text| Some(text).filter(|text: &&str| !text.is_empty());
    let set = error.file.strip_prefix("--set ");
    match set.and_then(|set| set.split_once('=')) {
        Some((key, value)) => [None, given(key), given(value)],
        None if error.file == DICT => [None, given(&error.key), given(&error.value)],
        None => [&error.file, &error.key, &error.value].map(|text| given(text)),
    }
}

fn exception(py: Python<'_>, error: &Error) -> PyResult<PyErr> {
    let about = PyDict::new(py);
    let file = |path: &Path| about.set_item("file", path);
    let cause = |text: String| about.set_item("cause", text);
    let name = match error {
        Error::Scene(one) => {
            let [file, key, value] = place_of(one);
            about.set_item("file", file)?;
            about.set_item("line", (one.line > 0).then_some(one.line))?;
            about.set_item("key", key)?;
            about.set_item("value", value)?;
            cause(one.accepted.clone())?;
            "SceneError"
        }
        Error::Argument(_) => "ArgumentError",
        Error::File { path, source, .. } => {
            file(path)?;
            cause(source.to_string())?;
            "FileError"
        }
        Error::Checkpoint { path, reason } => {
            file(path)?;
            cause(reason.clone())?;
            "FileError"
        }
        Error::Step { source, .. } => {
            cause(source.to_string())?;
            "StateError"
        }
        Error::Setup(source) => {
            cause(source.to_string())?;
            "StateError"
        }
        Error::Energy { .. } => "StateError",
        Error::Interrupted(folder) | Error::Stopped(folder) => {
            file(folder)?;
            "Error"
        }
        _ => "Error",
    };
    let class = py.import("gouge._errors")?.getattr(name)?;
    let exception = class.call((in_python(&error.to_string()),), Some(&about))?;
    Ok(PyErr::from_value(exception))
}

/// A message with the words of Python instead of those of the command line.
fn in_python(message: &str) -> String {
    const WORDS: [[&str; 2]; 4] = [
        ["--set ", "overrides: "],
        ["--overwrite", "overwrite=True"],
        ["--resume", "resume=True"],
        ["run `gouge stability`", "gouge.stability"],
    ];
    let replace = |text: String, [from, to]: [&str; 2]| text.replace(from, to);
    WORDS.into_iter().fold(message.to_owned(), replace)
}
