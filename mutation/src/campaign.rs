//! One build of the gate that can scale any site, and a run of it for each.

use crate::sites::{Site, constants, sites};
use anyhow::{Context, Result, bail};
use std::collections::BTreeSet;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Environment variable that names the site to scale.
const ACTIVE: &str = "GOUGE_SITE";

/// What every site is wrapped in; added to the copy of the kernel, never to the kernel itself.
const MODULE: &str = include_str!("perturbation.rs.txt");

/// A site with its file.
#[derive(Clone, Debug)]
pub struct Target {
    /// File below `kernel/src`.
    pub file: String,
    /// The site.
    pub site: Site,
}

fn rust_files(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(rust_files(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

/// All sites of the kernel, in the order of files and lines.
pub fn targets(root: &Path) -> Result<Vec<Target>> {
    let source = root.join("kernel/src");
    let mut parsed = Vec::new();
    for path in rust_files(&source)? {
        let text = fs::read_to_string(&path)?;
        let file = syn::parse_file(&text).with_context(|| path.display().to_string())?;
        let name = path.strip_prefix(&source)?.to_string_lossy().into_owned();
        parsed.push((name, text, file));
    }
    let names: BTreeSet<String> = parsed
        .iter()
        .flat_map(|(_, _, file)| constants(file))
        .collect();
    let of_file = |(name, text, file): &(String, String, syn::File)| {
        let found = sites(text, file, &names).into_iter();
        found
            .map(|site| Target {
                file: name.clone(),
                site,
            })
            .collect::<Vec<_>>()
    };
    Ok(parsed.iter().flat_map(of_file).collect())
}

/// Copy the files that git knows into a folder.
fn copy(root: &Path, to: &Path) -> Result<()> {
    let listed = Command::new("git")
        .args(["ls-files", "-z"])
        .current_dir(root)
        .output()?;
    for name in String::from_utf8(listed.stdout)?.split_terminator('\0') {
        let target = to.join(name);
        if let Some(folder) = target.parent() {
            fs::create_dir_all(folder)?;
        }
        fs::copy(root.join(name), &target).with_context(|| name.to_owned())?;
    }
    Ok(())
}

/// Wrap every site of the copy.
fn instrument(copy: &Path, targets: &[Target]) -> Result<()> {
    let source = copy.join("kernel/src");
    for (number, target) in targets.iter().enumerate().rev() {
        let path = source.join(&target.file);
        let mut text = fs::read_to_string(&path)?;
        let wrapped = format!("crate::perturbation::at({number}, {})", target.site.text);
        text.replace_range(target.site.bytes.clone(), &wrapped);
        fs::write(&path, text)?;
    }
    let top = source.join("lib.rs");
    let text = fs::read_to_string(&top)?.replacen(
        "pub mod scalar;",
        "pub mod scalar;\nmod perturbation;",
        1,
    );
    fs::write(top, text)?;
    fs::write(source.join("perturbation.rs"), MODULE)?;
    Ok(())
}

/// The program of the gate, built from an instrumented copy of the tree.
pub fn build(root: &Path, folder: &Path, targets: &[Target]) -> Result<PathBuf> {
    copy(root, folder)?;
    instrument(folder, targets)?;
    let output = Command::new(env!("CARGO"))
        .args([
            "test",
            "--no-run",
            "--profile",
            "mutants",
            "--package",
            "gouge-validation",
        ])
        .args([
            "--test",
            "gate",
            "--message-format",
            "json-render-diagnostics",
        ])
        .env("RUSTFLAGS", "--cap-lints allow")
        .env("CARGO_TARGET_DIR", root.join("target/perturbations"))
        .current_dir(folder)
        .stderr(Stdio::inherit())
        .output()?;
    for line in output.stdout.lines() {
        let message: serde_json::Value = serde_json::from_str(&line?)?;
        let is_gate = message["target"]["name"] == "gate";
        if let (true, Some(path)) = (is_gate, message["executable"].as_str()) {
            return Ok(PathBuf::from(path));
        }
    }
    bail!("the instrumented copy does not build")
}

/// The sharpest tests, tried first.
const FIRST: &[&str] = &[
    "register::quick",
    "errata",
    "identities",
    "dual",
    "calibration",
    "distributions",
];
/// Tests that start processes, read the source tree, or belong to the slow part of the gate.
const NEVER: &[&str] = &[
    "nothing_lost",
    "bad_input",
    "commands",
    "thorough",
    "layering",
    "equations",
];

/// The first test of the gate that fails with a site scaled; none where nothing notices.
pub fn noticed_by(gate: &Path, site: Option<usize>) -> Result<Option<String>> {
    let skip = |names: &[&str]| {
        names
            .iter()
            .flat_map(|name| ["--skip".to_owned(), (*name).to_owned()])
            .collect::<Vec<_>>()
    };
    let first: Vec<String> = FIRST.iter().map(|name| (*name).to_owned()).collect();
    let rest = skip(FIRST);
    for chosen in [first, rest] {
        let failed = first_failure(gate, site, &[chosen, skip(NEVER)].concat())?;
        if failed.is_some() {
            return Ok(failed);
        }
    }
    Ok(None)
}

fn first_failure(gate: &Path, site: Option<usize>, arguments: &[String]) -> Result<Option<String>> {
    let mut command = Command::new(gate);
    command.args(arguments).args(["--test-threads", "1"]);
    if let Some(site) = site {
        command.env(ACTIVE, site.to_string());
    }
    let mut child = command
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let output = child.stdout.take().context("standard output")?;
    for line in BufReader::new(output).lines() {
        let line = line?;
        if let Some(name) = line
            .strip_suffix(" ... FAILED")
            .and_then(|line| line.strip_prefix("test "))
        {
            child.kill()?;
            child.wait()?;
            return Ok(Some(name.to_owned()));
        }
    }
    let status = child.wait()?;
    Ok((!status.success()).then(|| format!("the gate itself: {status}")))
}
