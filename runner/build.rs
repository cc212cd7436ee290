//! Rebuilds the crate if the folder `references` changes, of which the programs contain a copy, and passes on the
//! commit that is built.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The root of the source tree.
const ROOT: &str = "..";

/// What the programs are built from.
const PARTS: [&str; 11] = [
    "Cargo.toml",
    "Cargo.lock",
    "page",
    "kernel",
    "runner",
    "validation",
    "studies",
    "cli",
    "references",
    "tools/equations",
    "docs/thesis",
];

/// Parts whose changes rebuild this crate. The checks are among them, because the report names the commit.
const WATCHED: [&str; 4] = ["Cargo.lock", "kernel", "runner", "validation/src"];

/// Files of git that change when another commit is checked out or made.
const GIT_FILES: [&str; 3] = ["HEAD", "logs/HEAD", "packed-refs"];

fn main() {
    println!("cargo::rerun-if-changed={ROOT}/references");
    // Other builds would be compiled anew after every commit, and tests need no commit.
    let is_release = std::env::var("PROFILE").is_ok_and(|profile| profile == "release");
    let commit = is_release.then(commit).flatten();
    if is_release {
        for part in WATCHED {
            println!("cargo::rerun-if-changed={ROOT}/{part}");
        }
    }
    println!(
        "cargo::rustc-env=GOUGE_COMMIT={}",
        commit.as_deref().unwrap_or("unknown")
    );
    if commit.is_some() {
        for file in GIT_FILES.iter().filter_map(|name| git_file(name)) {
            println!("cargo::rerun-if-changed={}", file.display());
        }
    }
}

/// The commit, with the ending `-dirty` if the programs are built from something else; none outside a repository of
/// this program.
fn commit() -> Option<String> {
    let top = PathBuf::from(git(&["rev-parse", "--show-toplevel"])?);
    let is_ours = top.canonicalize().ok()? == Path::new(ROOT).canonicalize().ok()?;
    let hash = git(&["rev-parse", "--short=12", "HEAD"])?;
    let changes = git(&[&["status", "--porcelain", "--"], &PARTS[..]].concat())?;
    let ending = if changes.is_empty() { "" } else { "-dirty" };
    is_ours.then(|| hash + ending)
}

/// An existing file of the repository.
fn git_file(name: &str) -> Option<PathBuf> {
    let path = Path::new(ROOT).join(git(&["rev-parse", "--git-path", name])?);
    path.exists().then_some(path)
}

/// What a command of git prints in the root, without the line end.
fn git(arguments: &[&str]) -> Option<String> {
    let mut command = Command::new("git");
    command.current_dir(ROOT).arg("--no-optional-locks");
    let output = command.args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}
