//! `gouge verify`: starts `gouge-verify`, a separate program, so that scenes run without compiling the checks.

use super::terminal::say;
use gouge_runner::error::Error;
use gouge_studies::sweep::Program;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The program that runs the checks.
const PROGRAM: &str = "gouge-verify";
/// The folder from which this program was built.
const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/..");
/// What the checks are built from, in that folder.
const PARTS: [&str; 8] = [
    "Cargo.toml",
    "Cargo.lock",
    "kernel",
    "runner",
    "validation",
    "references",
    "tools/equations",
    "docs/thesis",
];

/// Run the checks and exit with their status.
///
/// # Errors
/// `gouge-verify` is missing and cannot be built, or cannot be started.
pub fn launch(own: &Program, only: Option<&str>, out: &Path) -> Result<(), Error> {
    let program = program(&own.file)?;
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

/// Path of `gouge-verify` beside this program, or else on the path. If it is missing here or older than the sources, and
/// these are available, it is built first.
fn program(own: &Path) -> Result<PathBuf, Error> {
    let program = own.with_file_name(format!("{PROGRAM}{}", std::env::consts::EXE_SUFFIX));
    if is_stale(&program) {
        build(own)?;
    }
    if program.exists() {
        return Ok(program);
    }
    let name = program.file_name().unwrap_or_default();
    let folders = std::env::var_os("PATH").unwrap_or_default();
    let mut paths = std::env::split_paths(&folders).map(|folder| folder.join(name));
    paths.find(|path| path.is_file()).ok_or_else(|| {
        Error::Argument(format!(
            "{} is missing: install the checks with `cargo install --path validation`",
            program.display()
        ))
    })
}

/// Whether a program is missing, or older than a source of the checks.
fn is_stale(program: &Path) -> bool {
    let built = |path: &Path| path.metadata().and_then(|data| data.modified()).ok();
    let Some(built_at) = built(program) else {
        return true;
    };
    let root = Path::new(SOURCES);
    let is_newer = |path: &Path| built(path).is_some_and(|changed| changed > built_at);
    let mut waiting: Vec<PathBuf> = PARTS.iter().map(|part| root.join(part)).collect();
    while let Some(path) = waiting.pop() {
        match std::fs::read_dir(&path) {
            Ok(entries) => waiting.extend(entries.flatten().map(|entry| entry.path())),
            Err(_) if is_newer(&path) => return true,
            Err(_) => {}
        }
    }
    false
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
    let manifest = Path::new(SOURCES).join("Cargo.toml");
    if !target.join("CACHEDIR.TAG").exists() || !manifest.exists() {
        return Ok(());
    }
    say("building the checks from their sources; this takes up to a few minutes");
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
        .arg("--manifest-path")
        .arg(&manifest)
        .arg("--target-dir")
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
