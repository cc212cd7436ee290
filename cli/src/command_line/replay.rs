//! `gouge replay`: worked examples of other programs.

use super::print;
use super::progress::StepProgress;
use super::terminal::say;
use clap::{Args, ValueEnum};
use gouge_replay::peridem::{self, Mode, Repeated};
use gouge_replay::{CaseError, ReplayError, contact_dynamics};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::path::{Path, PathBuf};

/// The cases, and where their results go.
#[derive(Args)]
pub struct ReplayArguments {
    /// Folder with any of geometry.json, local.json, onestep.json, siconos2d.json, dynamics.json and observables.json, or a
    /// file of peridynamic grains: the input of a motion, or constants, forces, bonds, contacts or walls to be computed;
    /// also compressed with gzip
    #[arg(value_name = "DIR|CASE.json")]
    cases: PathBuf,
    /// File for the results, as JSON; folder for those of a file of peridynamic grains. Results of an earlier replay are
    /// replaced
    #[arg(long, value_name = "RESULTS.json|DIR")]
    out: PathBuf,
    /// Reading of the source of peridynamic grains, only for their files [default: corrected]
    #[arg(long, value_enum, value_name = "MODE")]
    mode: Option<ModeName>,
    /// Show no progress, and do not print how many cases were solved; cases without a result are still listed
    #[arg(long, short)]
    quiet: bool,
}

/// Readings of the source of peridynamic grains.
#[derive(Clone, Copy, Debug, ValueEnum)]
#[value(rename_all = "snake_case")]
enum ModeName {
    /// Corrected; momentum is conserved
    Corrected,
    /// As printed
    Paper,
    /// What the program of the authors does
    Authors,
    /// The same with the centroid of the wall and sticking friction repaired
    TwoFixes,
}

impl ModeName {
    fn mode(self) -> Mode {
        match self {
            Self::Corrected => Mode::Corrected,
            Self::Paper => Mode::Paper,
            Self::Authors => Mode::Authors,
            Self::TwoFixes => Mode::TwoFixes,
        }
    }
}

/// Solve all cases, write what was found, and list the cases without a result.
///
/// # Errors
/// Files that cannot be read or written, an output that is an input, or cases without a result.
pub fn launch(arguments: &ReplayArguments) -> Result<(), Error> {
    let (folder, out) = (&arguments.cases, &arguments.out);
    if folder.is_file() {
        return repeat(arguments);
    }
    if let Some(mode) = arguments.mode {
        return Err(Error::Argument(format!(
            "--mode {}: has a meaning only for a file of peridynamic grains, not for {}",
            mode.mode().name(),
            folder.display()
        )));
    }
    require_output(folder, out)?;
    let outcome = contact_dynamics::replay(folder).map_err(error)?;
    write_whole(out, outcome.text().as_bytes())?;
    conclude(
        &outcome.failures,
        outcome.cases,
        &outcome.account(),
        arguments.quiet,
    )
}

/// List the cases without a result, and print how many have one.
fn conclude(failures: &[CaseError], cases: usize, account: &str, quiet: bool) -> Result<(), Error> {
    for failure in failures {
        say(&failure.to_string());
    }
    if !quiet {
        print(account)?;
    }
    match failures.len() {
        0 => Ok(()),
        failed => Err(Error::Cases(failed, cases)),
    }
}

fn error(error: ReplayError) -> Error {
    match error {
        ReplayError::Read { file, source } => Error::file("read", &file, source),
        other => Error::Argument(other.to_string()),
    }
}

/// Repeat a file of peridynamic grains.
fn repeat(arguments: &ReplayArguments) -> Result<(), Error> {
    let (file, folder) = (&arguments.cases, &arguments.out);
    if folder.canonicalize().ok()
        == file
            .canonicalize()
            .ok()
            .and_then(|file| Some(file.parent()?.to_owned()))
    {
        return Err(Error::Argument(format!(
            "--out {}: is the folder of the case, whose files would be replaced",
            folder.display()
        )));
    }
    let cases = ["case.json", "case.json.gz"].map(|name| folder.join(name));
    if let Some(case) = cases.iter().find(|case| case.exists()) {
        return Err(Error::Argument(format!(
            "--out {}: has {}, whose tables would be replaced",
            folder.display(),
            case.display()
        )));
    }
    let mode = arguments.mode.map_or(Mode::default(), ModeName::mode);
    let progress = StepProgress::new(arguments.quiet);
    let mut watch = |done, all| progress.report(done, all);
    let repeated = peridem::repeat(file, mode, &mut watch);
    progress.finish();
    let repeated = repeated.map_err(error)?;
    std::fs::create_dir_all(folder).map_err(|source| Error::file("create", folder, source))?;
    for (name, text) in &repeated.files {
        write_whole(&folder.join(name), text.as_bytes())?;
    }
    let Repeated {
        failures,
        cases,
        account,
        ..
    } = &repeated;
    conclude(failures, *cases, account, arguments.quiet)
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
