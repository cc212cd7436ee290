//! Feeds damaged files to everything that reads files.
//!
//! Valid files are changed at random places, and the result is read. Any answer is right, except a panic, more than one
//! second, or more than 1 GiB of memory. Cases are read in a process of their own, so that one that kills it is found,
//! too. A case is repeated by its kind, seed and number.

mod damage;
mod kinds;
mod reader;

use cap::Cap;
use clap::Parser;
use indicatif::{ProgressBar, ProgressStyle};
use kinds::Kind;
use std::alloc::System;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, ExitCode, Stdio};

/// Counts the memory in use.
#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// A result or an error.
pub type Outcome<T> = Result<T, Box<dyn std::error::Error + Send + Sync>>;

/// Read damaged scenes, CSV files, checkpoints and dumps, and list those that panic, hang or take too much memory.
#[derive(Parser, Clone)]
pub struct Arguments {
    /// Kinds of files; all if none is given
    #[arg(value_enum)]
    kinds: Vec<Kind>,
    /// Number of cases of each kind
    #[arg(long, default_value_t = 1_000_000)]
    cases: u64,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Number of the first case
    #[arg(long, default_value_t = 0)]
    from: u64,
    /// Write the file of the first case to standard output, and stop
    #[arg(long)]
    show: bool,
    /// Read the cases in this process; the file keeps the number of the present one
    #[arg(long, hide = true)]
    here: Option<std::path::PathBuf>,
}

fn main() -> ExitCode {
    match execute(&Arguments::parse()) {
        Ok(0) => ExitCode::SUCCESS,
        Ok(faults) => {
            eprintln!("{faults} faults");
            ExitCode::FAILURE
        }
        Err(error) => {
            eprintln!("gouge-fuzz: {error}");
            ExitCode::from(2)
        }
    }
}

/// The number of faults.
fn execute(arguments: &Arguments) -> Outcome<u64> {
    let kinds = match arguments.kinds.is_empty() {
        true => Kind::ALL.to_vec(),
        false => arguments.kinds.clone(),
    };
    if arguments.show {
        let files = kinds::Files::of(kinds[0])?;
        let bytes = files.case(arguments.seed, arguments.from);
        std::io::Write::write_all(&mut std::io::stdout(), &bytes)?;
        return Ok(0);
    }
    if let Some(present) = &arguments.here {
        return reader::read_all(arguments, kinds[0], present);
    }
    let mut faults = 0;
    for kind in kinds {
        faults += supervise(arguments, kind)?;
    }
    Ok(faults)
}

/// Read all cases of a kind in other processes; the number of faults.
fn supervise(arguments: &Arguments, kind: Kind) -> Outcome<u64> {
    let folder = tempfile::tempdir()?;
    let present = folder.path().join("present");
    let end = arguments.from + arguments.cases;
    let bar = ProgressBar::new(arguments.cases).with_message(kind.name());
    if let Ok(style) = ProgressStyle::with_template("{msg:12} {wide_bar} {pos}/{len}  {eta} left") {
        bar.set_style(style);
    }
    let (mut next, mut faults) = (arguments.from, 0);
    while next < end {
        let status = run_reader(arguments, kind, &present, [next, end], &bar, &mut faults)?;
        if status {
            break;
        }
        let last = number_in(&present)?;
        report(
            kind,
            arguments.seed,
            last,
            "killed the process, or took too long or too much memory",
        );
        (next, faults) = (last + 1, faults + 1);
    }
    bar.finish_and_clear();
    println!(
        "{}: {} cases, {faults} faults",
        kind.name(),
        arguments.cases
    );
    Ok(faults)
}

/// Start a reader and count the faults that it prints; whether it came to its end.
fn run_reader(
    arguments: &Arguments,
    kind: Kind,
    present: &Path,
    [from, end]: [u64; 2],
    bar: &ProgressBar,
    faults: &mut u64,
) -> Outcome<bool> {
    let mut child = Command::new(std::env::current_exe()?)
        .args([kind.name(), "--seed", &arguments.seed.to_string()])
        .args([
            "--from",
            &from.to_string(),
            "--cases",
            &(end - from).to_string(),
        ])
        .arg("--here")
        .arg(present)
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let lines = child.stdout.take().map(|out| BufReader::new(out).lines());
    for line in lines.into_iter().flatten() {
        let line = line?;
        match line.parse::<u64>() {
            Ok(number) => bar.set_position(number - arguments.from),
            Err(_) => {
                bar.suspend(|| println!("{line}"));
                *faults += 1;
            }
        }
    }
    Ok(child.wait()?.code() == Some(0))
}

fn number_in(present: &Path) -> Outcome<u64> {
    let bytes = std::fs::read(present)?;
    Ok(u64::from_le_bytes(bytes.as_slice().try_into()?))
}

/// Print a fault and how to see its file.
pub fn report(kind: Kind, seed: u64, number: u64, what: &str) {
    println!(
        "{} {what}; its file: gouge-fuzz {} --seed {seed} --from {number} --show",
        kind.name(),
        kind.name()
    );
}
