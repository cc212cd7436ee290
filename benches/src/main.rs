//! Times whole scenes at full size, beside other programs where they are there.

mod by_hand;
mod growth;
mod lammps;
mod machine;
mod parts;
mod peers;
mod sample;
mod threads;
mod worlds;

use clap::{Parser, Subcommand};
use gouge_validation::error::Error;
use lammps::Lammps;
use machine::Machine;
use parts::Part;
use peers::{Case, Programs};
use serde::Serialize;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{SystemTime, UNIX_EPOCH};

/// Times whole scenes; the other core should be idle.
#[derive(Parser)]
struct Arguments {
    /// Number of measurements of each scene, in turns
    #[arg(long, default_value_t = 9, global = true)]
    rounds: usize,
    /// File for the raw results, as JSON
    #[arg(long, global = true)]
    out: Option<PathBuf>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// The scenes with bonds, friction and none, beside LAMMPS
    Peers {
        /// LAMMPS with the package BPM
        #[arg(long)]
        lammps: Option<PathBuf>,
        /// LAMMPS built for this processor; without it, contacts are timed with the other one
        #[arg(long)]
        native: Option<PathBuf>,
        /// Only scenes whose name contains this
        #[arg(long, default_value = "")]
        only: String,
    },
    /// Every optional part of a scene: with it, without it, and by hand
    Parts,
    /// Pressed grains in one thread and in as many as are chosen by default
    Threads,
    /// Pressed grains from a thousand to a million
    Growth {
        /// Most particles
        #[arg(long, default_value_t = 1_100_000)]
        largest: usize,
    },
}

/// What is written.
#[derive(Serialize)]
struct Run {
    /// Seconds since 1970 when the run ended.
    seconds: u64,
    before: Machine,
    after: Machine,
    cases: Vec<Case>,
    parts: Vec<Part>,
}

fn execute(arguments: Arguments) -> Result<(), Error> {
    let instructions = gouge_validation::machine::machine()?.instructions.name();
    let before = Machine::measured(instructions);
    let (mut cases, mut parts) = (Vec::new(), Vec::new());
    match arguments.command {
        Command::Peers {
            lammps,
            native,
            only,
        } => {
            let build = |program: Option<PathBuf>| program.map(|program| Lammps { program });
            let programs = Programs {
                contacts: build(native.or_else(|| lammps.clone())),
                beams: build(lammps),
            };
            cases = peers::measure(&programs, arguments.rounds, &only)?;
        }
        Command::Threads => cases = threads::measure(arguments.rounds)?,
        Command::Parts => parts = parts::measure(arguments.rounds)?,
        Command::Growth { largest } => cases = growth::measure(arguments.rounds, largest)?,
    }
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let run = Run {
        seconds: now.map_or(0, |since| since.as_secs()),
        before,
        after: Machine::measured(instructions),
        cases,
        parts,
    };
    if let Some(path) = arguments.out {
        let text = serde_json::to_string_pretty(&run).unwrap_or_default() + "\n";
        std::fs::write(&path, text).map_err(|error| Error::file("write", &path, error))?;
    }
    Ok(())
}

fn main() -> ExitCode {
    match execute(Arguments::parse()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("gouge-bench: {error}");
            ExitCode::from(error.status())
        }
    }
}
