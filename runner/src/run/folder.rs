//! The output folder of a run: its files, which are written completely or not at all.

use super::trajectory::remove_frames;
use crate::error::Error;
use crate::scene::Scene;
use std::io::Write;
use std::path::{Path, PathBuf};

/// The checkpoint.
pub const CHECKPOINT: &str = "checkpoint";
/// The summary; it exists only for finished and failed runs.
pub const SUMMARY: &str = "summary.json";
/// The series.
pub const SERIES: &str = "series.csv";
/// The final particles.
pub const PARTICLES: &str = "particles.csv";
/// The picture of the final state.
pub const PICTURE: &str = "picture.svg";

/// The files of a run, in the order in which a new run removes them. If the removal is interrupted, what remains
/// looks like a finished run or like no run.
const FILES: [&str; 5] = [CHECKPOINT, SUMMARY, SERIES, PARTICLES, PICTURE];

/// Check that the outputs would not replace a file that the scene reads.
///
/// # Errors
/// A folder with a file that would be replaced.
pub fn refuse_replacing_inputs(scene: &Scene, folder: &Path) -> Result<(), Error> {
    for name in FILES {
        let output = folder.join(name);
        let Ok(place) = output.canonicalize() else {
            continue;
        };
        let is_it = |file: &&PathBuf| file.canonicalize().is_ok_and(|file| file == place);
        if let Some(file) = scene.files.iter().find(is_it) {
            return Err(Error::Argument(format!(
                "the run would replace {}, which the scene reads; choose another output folder than {}",
                file.display(),
                folder.display()
            )));
        }
    }
    Ok(())
}

/// Remove the outputs of an earlier, finished run, so that outputs of different runs are never mixed.
///
/// # Errors
/// Failures of the file system.
pub fn remove_outputs(folder: &Path) -> Result<(), Error> {
    for name in FILES {
        let path = folder.join(name);
        if path.exists() {
            std::fs::remove_file(&path).map_err(|error| Error::file("replace", &path, error))?;
        }
    }
    remove_frames(folder)
}

/// Write a file atomically: afterwards it has either the new content or its old one.
///
/// # Errors
/// Failures of the file system.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let beside = path.with_extension("partial");
    let write = || -> std::io::Result<()> {
        let mut file = std::fs::File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        std::fs::rename(&beside, path)
    };
    write().map_err(|error| {
        let _ = std::fs::remove_file(&beside);
        Error::file("write", path, error)
    })
}
