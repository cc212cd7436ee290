//! `gouge verify`: starts `gouge-verify`, a separate program, so that scenes run without compiling the checks.

use gouge_runner::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The program that runs the checks.
const PROGRAM: &str = "gouge-verify";
/// The sources from which this program was built.
const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml");

/// Run the checks and exit with their status.
///
/// # Errors
/// `gouge-verify` is missing and cannot be built, or cannot be started.
pub fn launch(only: Option<&str>, out: &Path) -> Result<(), Error> {
    let program = program()?;
    let mut command = Command::new(&program);
    command.arg("--out").arg(out);
    if let Some(pattern) = only {
        command.arg("--only").arg(pattern);
    }
    let status = command
        .status()
        .map_err(|error| Error::file("run", &program, error))?;
    std::process::exit(status.code().unwrap_or(1))
}

/// Path of `gouge-verify` beside this program. If it is missing and the sources are available, it is built first.
fn program() -> Result<PathBuf, Error> {
    let own =
        std::env::current_exe().map_err(|error| Error::file("find", Path::new("gouge"), error))?;
    let program = own.with_file_name(format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX));
    if !program.exists() {
        build(&own)?;
    }
    if program.exists() {
        return Ok(program);
    }
    Err(Error::Argument(format!(
        "{} is missing: install the checks with `cargo install --path validation`",
        program.display()
    )))
}

/// Build `gouge-verify` into the folder that holds this program, if that is a target folder of cargo.
fn build(own: &Path) -> Result<(), Error> {
    let profile = own.parent();
    let target = profile.and_then(Path::parent);
    let (Some(profile), Some(target)) = (profile.and_then(Path::file_name), target) else {
        return Ok(());
    };
    let profile = match profile.to_str() {
        // Without optimisation the checks are slow.
        Some("debug") => "test",
        Some(name) => name,
        None => return Ok(()),
    };
    if !target.join("CACHEDIR.TAG").exists() || !Path::new(SOURCES).exists() {
        return Ok(());
    }
    eprintln!("gouge: building the checks; this happens once and takes a few minutes");
    let cargo = Path::new("cargo");
    let status = Command::new(cargo)
        .args([
            "build",
            "-p",
            "gouge-validation",
            "--bin",
            PROGRAM,
            "--profile",
            profile,
        ])
        .args(["--manifest-path", SOURCES, "--target-dir"])
        .arg(target)
        .status()
        .map_err(|error| Error::file("run", cargo, error))?;
    match status.success() {
        true => Ok(()),
        false => Err(Error::Argument(
            "the checks could not be built; see what cargo printed above".to_owned(),
        )),
    }
}
