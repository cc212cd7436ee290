//! `gouge verify`: the checks are a program of their own, so that scenes run without compiling them.

use gouge_runner::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The program that runs the checks.
const PROGRAM: &str = "gouge-verify";
/// The sources from which this program was built.
const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml");

/// Run the checks, and end with their status.
///
/// # Errors
/// A program that is not there and cannot be built.
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

/// The program beside this one; built first, if it is missing and the sources are at hand.
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

/// Build the checks into the folder that holds this program, if cargo put it there.
fn build(own: &Path) -> Result<(), Error> {
    let profile = own.parent();
    let target = profile.and_then(Path::parent);
    let (Some(profile), Some(target)) = (profile.and_then(Path::file_name), target) else {
        return Ok(());
    };
    let profile = match profile.to_str() {
        Some("debug") => "dev",
        Some(name) => name,
        None => return Ok(()),
    };
    if !target.join("CACHEDIR.TAG").exists() || !Path::new(SOURCES).exists() {
        return Ok(());
    }
    eprintln!("gouge: building the checks, once; this takes some minutes");
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
