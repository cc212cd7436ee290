//! `gouge replay`: worked examples of other programs.

use super::print;
use super::terminal::say;
use clap::Args;
use gouge_replay::{ReplayError, contact_dynamics};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::path::{Path, PathBuf};

/// The cases, and where their results go.
#[derive(Args)]
pub struct ReplayArguments {
    /// Folder with any of geometry.json, local.json, onestep.json, siconos2d.json, dynamics.json and observables.json
    #[arg(value_name = "DIR")]
    folder: PathBuf,
    /// File for the results, as JSON
    #[arg(long, value_name = "RESULTS.json")]
    out: PathBuf,
    /// Do not print how many cases were solved; cases without a result are still listed
    #[arg(long, short)]
    quiet: bool,
}

/// Solve all cases, write what was found, and list the cases without a result.
///
/// # Errors
/// Files that cannot be read or written, an output that is an input, or cases without a result.
pub fn launch(arguments: &ReplayArguments) -> Result<(), Error> {
    let (folder, out) = (&arguments.folder, &arguments.out);
    require_output(folder, out)?;
    let outcome = contact_dynamics::replay(folder).map_err(|error| match error {
        ReplayError::Read { file, source } => Error::file("read", &file, source),
        other => Error::Argument(other.to_string()),
    })?;
    write_whole(out, outcome.text().as_bytes())?;
    for failure in &outcome.failures {
        say(&failure.to_string());
    }
    if !arguments.quiet {
        print(&outcome.account())?;
    }
    match outcome.failures.len() {
        0 => Ok(()),
        failed => Err(Error::Cases(failed, outcome.cases)),
    }
}

/// Refuse an output that would replace an input, by whatever path, or that is a folder.
fn require_output(folder: &Path, out: &Path) -> Result<(), Error> {
    let name = out.display();
    if out.is_dir() || out.file_name().is_none() {
        return Err(Error::Argument(format!("--out {name}: must be a file")));
    }
    let Ok(out) = out.canonicalize() else {
        return Ok(());
    };
    let inputs = contact_dynamics::files(folder).into_iter();
    match inputs
        .filter_map(|file| file.canonicalize().ok())
        .any(|file| file == out)
    {
        true => Err(Error::Argument(format!(
            "--out {name}: is one of the files with cases, and would be replaced"
        ))),
        false => Ok(()),
    }
}
