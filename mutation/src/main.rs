//! Scales every number of the kernel's formulas by 1 + 1e-6, one at a time, and asks whether the fast
//! part of the gate notices.
//!
//! A number is a literal, a named constant, or a coefficient where it is read: a parameter of a law, a
//! radius, a mass, the step. All are wrapped at once in a copy of the tree, so that one build serves the
//! whole campaign and an environment variable chooses the number.

mod campaign;
mod exempt;
mod sites;

use anyhow::{Result, ensure};
use campaign::{Target, build, noticed_by, targets};
use clap::Parser;
use exempt::EXEMPT;
use indicatif::ProgressBar;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Scale every number of the kernel's formulas, one at a time, and see which test notices.
#[derive(Parser)]
struct Arguments {
    /// Only list the sites
    #[arg(long)]
    list: bool,
    /// Only sites whose file, line and expression contain this
    #[arg(long)]
    only: Option<String>,
    /// Runs of the gate at a time
    #[arg(long, default_value = "2")]
    jobs: usize,
    /// File of results; sites that it holds are not run again
    #[arg(long, default_value = "out/perturbations.jsonl")]
    results: PathBuf,
}

/// What became of a site.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Verdict {
    site: String,
    caught_by: Option<String>,
}

/// File, line and expression, with a number where a line holds the same expression more than once.
fn names(targets: &[Target]) -> Vec<String> {
    let mut seen = BTreeMap::new();
    let name = |target: &Target| {
        let place = format!("{}:{} {}", target.file, target.site.line, target.site.text);
        let count = seen.entry(place.clone()).or_insert(0);
        *count += 1;
        if *count > 1 {
            format!("{place} #{count}")
        } else {
            place
        }
    };
    targets.iter().map(name).collect()
}

fn exemption(target: &Target) -> Option<&'static str> {
    let matches =
        |(file, text, _): &&(&str, &str, &str)| target.file == *file && target.site.text == *text;
    EXEMPT.iter().find(matches).map(|(_, _, reason)| *reason)
}

fn earlier(path: &Path) -> Result<Vec<Verdict>> {
    if !path.exists() {
        return Ok(Vec::new());
    }
    let lines = fs::read_to_string(path)?;
    Ok(lines
        .lines()
        .map(serde_json::from_str)
        .collect::<Result<_, _>>()?)
}

/// Run the gate for every site that has no verdict yet.
fn run(gate: &Path, wanted: &[(usize, &String)], arguments: &Arguments) -> Result<()> {
    let file = OpenOptions::new()
        .create(true)
        .append(true)
        .open(&arguments.results)?;
    let (file, next) = (Mutex::new(file), AtomicUsize::new(0));
    let bar = ProgressBar::new(wanted.len() as u64);
    let work = || -> Result<()> {
        while let Some(&(number, name)) = wanted.get(next.fetch_add(1, Ordering::Relaxed)) {
            let verdict = Verdict {
                site: name.clone(),
                caught_by: noticed_by(gate, Some(number))?,
            };
            let line = serde_json::to_string(&verdict)? + "\n";
            if let Ok(mut file) = file.lock() {
                file.write_all(line.as_bytes())?;
            }
            bar.inc(1);
        }
        Ok(())
    };
    std::thread::scope(|scope| {
        let workers: Vec<_> = (0..arguments.jobs).map(|_| scope.spawn(work)).collect();
        workers
            .into_iter()
            .try_for_each(|worker| worker.join().unwrap_or(Ok(())))
    })
}

/// Print every verdict; whether all sites were caught.
fn report(wanted: &[(usize, &String)], verdicts: &[Verdict]) -> bool {
    let mut survived = 0;
    for (_, name) in wanted {
        let verdict = verdicts.iter().find(|verdict| &verdict.site == *name);
        match verdict.and_then(|verdict| verdict.caught_by.as_deref()) {
            Some(test) => println!("caught    {name}  by {test}"),
            None => {
                survived += 1;
                println!("SURVIVED  {name}");
            }
        }
    }
    println!(
        "{} sites, {} caught, {survived} survived",
        wanted.len(),
        wanted.len() - survived
    );
    survived == 0
}

fn campaign(arguments: &Arguments) -> Result<bool> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let targets = targets(&root)?;
    let names = names(&targets);
    for (target, name) in targets.iter().zip(&names) {
        if let Some(reason) = exemption(target) {
            println!("exempt    {name}: {reason}");
        }
    }
    let chosen = |(number, name): &(usize, &String)| {
        let matches = arguments
            .only
            .as_ref()
            .is_none_or(|pattern| name.contains(pattern));
        matches && exemption(&targets[*number]).is_none()
    };
    let wanted: Vec<(usize, &String)> = names.iter().enumerate().filter(chosen).collect();
    if arguments.list {
        wanted.iter().for_each(|(_, name)| println!("{name}"));
        return Ok(true);
    }
    if let Some(folder) = arguments.results.parent() {
        fs::create_dir_all(folder)?;
    }
    let known = earlier(&arguments.results)?;
    let is_new = |(_, name): &&(usize, &String)| known.iter().all(|verdict| &verdict.site != *name);
    let open: Vec<(usize, &String)> = wanted.iter().filter(is_new).copied().collect();
    if !open.is_empty() {
        let folder = tempfile::tempdir()?;
        let gate = build(&root, folder.path(), &targets)?;
        let unscaled = noticed_by(&gate, None)?;
        ensure!(
            unscaled.is_none(),
            "the gate fails without any fault: {unscaled:?}"
        );
        run(&gate, &open, arguments)?;
    }
    Ok(report(&wanted, &earlier(&arguments.results)?))
}

fn main() -> Result<ExitCode> {
    let all_caught = campaign(&Arguments::parse())?;
    Ok(if all_caught {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}
