//! Times whole scenes at full size and compares them with other programs, if these are installed.

mod by_hand;
mod counts;
mod folder;
mod growth;
mod inertia;
mod lammps;
mod limits;
mod machine;
mod memory;
mod parts;
mod peers;
mod precision;
mod sample;
mod threads;
mod worlds;

use clap::{Parser, Subcommand};
use counts::{Counting, Subtask};
use gouge_runner::error::Error;
use gouge_runner::machine::{CallingThread, start_pool};
use lammps::Lammps;
use machine::Machine;
use parts::Part;
use peers::{Case, Programs};
use serde::Serialize;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::{SystemTime, UNIX_EPOCH};

/// Times whole scenes; keep the other cores idle
#[derive(Parser)]
struct Arguments {
    /// Number of measurements per scene; scenes take turns
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
    #[command(flatten)]
    Measure(Measurement),
    /// Print the friction of the small fault, with the moment of inertia of spheres and with that of the thesis's
    /// author, as CSV
    Inertia {
        /// Number of seeds
        #[arg(long, default_value_t = 16)]
        seeds: u64,
    },
    #[command(flatten)]
    Subtask(Subtask),
}

#[derive(Subcommand)]
enum Measurement {
    /// Time scenes with bonds, with friction and without friction, and compare them with LAMMPS
    Peers {
        /// Executable of LAMMPS with the package BPM
        #[arg(long)]
        lammps: Option<PathBuf>,
        /// Executable of LAMMPS built for this processor, to time contacts; default: the value of --lammps
        #[arg(long)]
        native: Option<PathBuf>,
        /// Time only scenes whose name contains this text
        #[arg(long, default_value = "")]
        only: String,
    },
    /// Time the whole shear phase of the fault with bonds, and compare it with LAMMPS
    Whole {
        /// Executable of LAMMPS with the package BPM
        #[arg(long)]
        lammps: Option<PathBuf>,
    },
    /// Measure error against run time of two small scenes, and compare them with LAMMPS
    Precision {
        /// Executable of LAMMPS with the packages BPM and GRANULAR
        #[arg(long)]
        lammps: PathBuf,
    },
    /// Time scenes with and without each optional part, and compare them with loops written by hand
    Parts,
    /// Count instructions and memory traffic per step with callgrind, and compare them with the limits of the machine
    Counts {
        /// Executable of valgrind
        #[arg(long, default_value = "valgrind")]
        valgrind: PathBuf,
    },
    /// Time pressed grains with one thread and with the default number of threads
    Threads,
    /// Time a thousand to a million pressed grains
    Growth {
        /// Largest number of particles
        #[arg(long, default_value_t = 1_100_000)]
        largest: usize,
    },
}

/// The raw results as written to the file.
#[derive(Serialize)]
struct Run {
    /// End of the run in seconds since 1970-01-01.
    seconds: u64,
    before: Machine,
    after: Machine,
    cases: Vec<Case>,
    parts: Vec<Part>,
    counting: Option<Counting>,
    precision: Vec<precision::Scene>,
}

fn execute(arguments: Arguments) -> Result<(), Error> {
    let measurement = match arguments.command {
        Command::Measure(measurement) => measurement,
        Command::Inertia { seeds } => return inertia::measure(seeds),
        Command::Subtask(subtask) => return subtask.run(),
    };
    let rounds = arguments.rounds;
    let instructions = start_pool(CallingThread::JoinsPool)?.instructions.name();
    let before = Machine::measured(instructions);
    let (mut cases, mut parts, mut counting) = (Vec::new(), Vec::new(), None);
    let mut precision = Vec::new();
    match measurement {
        Measurement::Peers {
            lammps,
            native,
            only,
        } => {
            let build = |program: Option<PathBuf>| program.map(|program| Lammps { program });
            let programs = Programs {
                contacts: build(native.or_else(|| lammps.clone())),
                beams: build(lammps),
            };
            cases = peers::measure(&programs, rounds, &only)?;
        }
        Measurement::Whole { lammps } => {
            let beams = lammps.map(|program| Lammps { program });
            cases.push(peers::whole(beams.as_ref(), rounds)?);
        }
        Measurement::Precision { lammps } => {
            precision = precision::measure(&Lammps { program: lammps }, rounds)?;
        }
        Measurement::Counts { valgrind } => counting = Some(counts::measure(&valgrind, rounds)?),
        Measurement::Threads => cases = threads::measure(rounds)?,
        Measurement::Parts => parts = parts::measure(rounds)?,
        Measurement::Growth { largest } => cases = growth::measure(rounds, largest)?,
    }
    let now = SystemTime::now().duration_since(UNIX_EPOCH);
    let run = Run {
        seconds: now.map_or(0, |since| since.as_secs()),
        before,
        after: Machine::measured(instructions),
        cases,
        parts,
        counting,
        precision,
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
