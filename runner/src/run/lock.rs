//! A lock on an output folder, so that no two runs write into it.

use crate::error::Error;
use same_file::Handle;
use std::fs::{File, TryLockError};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// The file that a run holds locked; it names the host and the process.
const LOCK: &str = ".gouge-lock";

/// A locked folder; it is unlocked when this value is dropped or the process ends, however it ends.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Lock a folder.
    ///
    /// # Errors
    /// A folder that another process has locked, or a failure of the file system.
    pub fn take(folder: &Path) -> Result<Self, Error> {
        let path = folder.join(LOCK);
        loop {
            if path.is_symlink() {
                return Err(Error::Argument(format!(
                    "{} is a link; a run locks its folder with a file of this name: remove the link",
                    path.display()
                )));
            }
            if let Some(file) = attempt(folder, &path)? {
                return Ok(Self { path, file });
            }
        }
    }
}

/// The locked file; none if its last holder removed it at the same moment.
fn attempt(folder: &Path, path: &Path) -> Result<Option<File>, Error> {
    let failed = |error| Error::file("lock", path, error);
    let mut options = File::options();
    let open = options.read(true).write(true).create(true).truncate(false);
    let mut file = open.open(path).map_err(failed)?;
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => return Err(in_use(folder, file)),
        Err(TryLockError::Error(error)) => return Err(failed(error)),
    }
    let ours = file.try_clone().and_then(Handle::from_file);
    if Handle::from_path(path).ok() != Some(ours.map_err(failed)?) {
        return Ok(None);
    }
    let host = gethostname::gethostname();
    let holder = format!("process {} on {}", std::process::id(), host.display());
    // The name is for people only; what counts is the lock.
    let _ = file.set_len(0);
    let _ = file.write_all(holder.as_bytes());
    Ok(Some(file))
}

fn in_use(folder: &Path, mut file: File) -> Error {
    let mut holder = String::new();
    let known = file.read_to_string(&mut holder).is_ok() && !holder.is_empty();
    let holder = if known { &holder } else { "another process" };
    Error::Argument(format!(
        "{} is in use by {holder}; wait for its end, or choose another folder",
        folder.display()
    ))
}

impl Lock {
    /// Check that the folder is still the locked one: it may have been moved away or replaced.
    ///
    /// # Errors
    /// A folder that is no longer locked by this run.
    pub fn check(&self) -> Result<(), Error> {
        match self.is_in_place() {
            true => Ok(()),
            false => Err(Error::Argument(format!(
                "the output folder was moved or replaced during the run: {} is not the lock of this run",
                self.path.display()
            ))),
        }
    }

    fn is_in_place(&self) -> bool {
        let ours = self.file.try_clone().and_then(Handle::from_file);
        ours.is_ok_and(|ours| Handle::from_path(&self.path).is_ok_and(|there| there == ours))
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        if !self.is_in_place() {
            return;
        }
        let _ = std::fs::remove_file(&self.path);
    }
}
