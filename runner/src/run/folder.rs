//! The output folder of a run: its files, which are written completely or not at all.

use super::trajectory::{FOLDER, is_frame};
use crate::error::Error;
use crate::scene::SceneText;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// The checkpoint.
pub const CHECKPOINT: &str = "checkpoint";
/// The summary; it exists only for runs that ended: finished, failed or interrupted.
pub const SUMMARY: &str = "summary.json";
/// The series.
pub const SERIES: &str = "series.csv";
/// The final particles.
pub const PARTICLES: &str = "particles.csv";
/// The picture of the final state.
pub const PICTURE: &str = "picture.svg";
/// The page.
pub const PAGE: &str = "run.html";
/// The final bonds.
pub const BONDS: &str = "bonds.csv";
/// The bonds that broke.
pub const BREAKS: &str = "breaks.csv";
/// The scene that continues from the final state.
pub const RESTART: &str = "restart.toml";
/// The particles of that scene.
pub const RESTART_PARTICLES: &str = "restart-particles.csv";
/// The contacts of that scene.
pub const RESTART_CONTACTS: &str = "restart-contacts.csv";

/// Sums over the contact network of contact dynamics.
pub const NETWORK: &str = "network.csv";
/// The contact points of the last step of contact dynamics.
pub const CONTACTS: &str = "contacts.csv";
/// The final nodes of peridynamic grains.
pub const NODES: &str = "nodes.csv";
/// The final peridynamic grains.
pub const GRAINS: &str = "grains.csv";
/// What depends on the direction of contacts, as a table.
pub const DIRECTIONS_TABLE: &str = "directions.csv";
/// What depends on the direction of contacts, as polar diagrams.
pub const DIRECTIONS: &str = "directions.svg";
/// The picture of stresses over strains.
pub const STRESS_STRAIN: &str = "stress-strain.svg";

/// The files of a run outside the trajectory, in the order in which a new run removes them. If the removal is
/// interrupted, what remains looks like results without a checkpoint, which nothing replaces unasked.
const FILES: [&str; 18] = [
    CHECKPOINT,
    SUMMARY,
    SERIES,
    PARTICLES,
    PICTURE,
    PAGE,
    BONDS,
    BREAKS,
    RESTART,
    RESTART_PARTICLES,
    RESTART_CONTACTS,
    STRESS_STRAIN,
    NETWORK,
    DIRECTIONS_TABLE,
    DIRECTIONS,
    CONTACTS,
    NODES,
    GRAINS,
];

/// All files in a folder that have the name of an output.
///
/// # Errors
/// Failures of the file system.
pub fn outputs(folder: &Path) -> Result<Vec<PathBuf>, Error> {
    let files = FILES.map(|name| folder.join(name));
    let mut found: Vec<PathBuf> = files.into_iter().filter(|path| exists(path)).collect();
    let frames = folder.join(FOLDER);
    if frames.is_symlink() {
        return Err(Error::Argument(format!(
            "{} is a link; a run writes and removes frames only in a folder of its own: remove the link",
            frames.display()
        )));
    }
    let entries = match std::fs::read_dir(&frames) {
        Ok(entries) => entries,
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(found),
        Err(error) => return Err(Error::file("read", &frames, error)),
    };
    for entry in entries {
        let entry = entry.map_err(|error| Error::file("read", &frames, error))?;
        if is_frame(&entry.file_name()) {
            found.push(entry.path());
        }
    }
    Ok(found)
}

/// Whether something has this path, even a link that leads nowhere.
fn exists(path: &Path) -> bool {
    path.symlink_metadata().is_ok()
}

/// Check that the outputs would not replace a file that the scene reads.
///
/// # Errors
/// A folder with a file that would be replaced.
pub fn refuse_replacing_inputs(scene: &impl SceneText, folder: &Path) -> Result<(), Error> {
    for output in outputs(folder)? {
        let Ok(place) = output.canonicalize() else {
            continue;
        };
        let is_it = |file: &&PathBuf| file.canonicalize().is_ok_and(|file| file == place);
        if let Some(file) = scene.files().iter().find(is_it) {
            return Err(Error::Argument(format!(
                "the run would replace {}, which the scene reads; choose another output folder than {}",
                file.display(),
                folder.display()
            )));
        }
    }
    Ok(())
}

/// Remove the outputs of an earlier run, so that outputs of different runs are never mixed, and nothing else.
///
/// # Errors
/// Failures of the file system.
pub fn remove_outputs(folder: &Path) -> Result<(), Error> {
    for path in outputs(folder)? {
        std::fs::remove_file(&path).map_err(|error| Error::file("replace", &path, error))?;
    }
    // Fails, as intended, if the folder still contains other files.
    let _ = std::fs::remove_dir(folder.join(FOLDER));
    Ok(())
}

/// Remove what continues from the final state of an earlier run.
///
/// # Errors
/// Failures of the file system.
pub fn remove_restart(folder: &Path) -> Result<(), Error> {
    for name in [RESTART, RESTART_PARTICLES, RESTART_CONTACTS] {
        let path = folder.join(name);
        match std::fs::remove_file(&path) {
            Err(error) if error.kind() != ErrorKind::NotFound => {
                return Err(Error::file("remove", &path, error));
            }
            _ => {}
        }
    }
    Ok(())
}

/// Write a file atomically: afterwards it has either the new content or its old one, even after a power failure.
///
/// # Errors
/// Failures of the file system.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    replace(path, bytes, |file| file.sync_all())
}

/// Like [`write_whole`], but the content may be lost if the machine fails soon after.
///
/// # Errors
/// Failures of the file system.
pub fn write_soon(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    replace(path, bytes, |_| Ok(()))
}

fn replace(
    path: &Path,
    bytes: &[u8],
    finish: impl Fn(&std::fs::File) -> std::io::Result<()>,
) -> Result<(), Error> {
    let name = path.file_name().unwrap_or_default().display();
    let beside = path.with_file_name(format!(".{name}.gouge-partial"));
    let write = || -> std::io::Result<()> {
        // A new file, so that no link is followed.
        let _ = std::fs::remove_file(&beside);
        let mut file = std::fs::File::create_new(&beside)?;
        file.write_all(bytes)?;
        finish(&file)?;
        std::fs::rename(&beside, path)
    };
    write().map_err(|error| {
        let _ = std::fs::remove_file(&beside);
        Error::file("write", path, error)
    })
}
