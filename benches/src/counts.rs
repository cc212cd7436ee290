//! Instructions and memory traffic per step, counted by callgrind and compared with the limits of the machine.

use crate::folder::temporary_folder;
use crate::limits::{Limits, busy};
use crate::peers::{Timer, advance};
use crate::sample::Sample;
use crate::worlds::{Friction, fault, fault_again, pressed, pressed_again, rubbing};
use clap::{Subcommand, ValueEnum};
use gouge_dem::World;
use gouge_runner::error::Error;
use gouge_runner::machine::INSTRUCTIONS;
use gouge_runner::run::words_of_bytes;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A subcommand that this program runs under callgrind.
#[derive(Subcommand)]
pub enum Subtask {
    /// Advance a recorded state
    #[command(hide = true)]
    Steps {
        #[arg(long)]
        scene: Counted,
        #[arg(long)]
        state: PathBuf,
        #[arg(long)]
        steps: u64,
    },
    /// Execute instructions that need no memory
    #[command(hide = true)]
    Busy {
        #[arg(long)]
        turns: u64,
    },
}

impl Subtask {
    /// Run the subcommand.
    ///
    /// # Errors
    /// A file that does not hold a state of the scene.
    pub fn run(self) -> Result<(), Error> {
        match self {
            Self::Steps {
                scene,
                state,
                steps,
            } => scene.run(&state, steps),
            Self::Busy { turns } => {
                std::hint::black_box(busy(turns));
                Ok(())
            }
        }
    }
}

/// A scene whose steps are counted.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Counted {
    /// The granite fault.
    Bonded,
    /// Pressed grains with truncated Cundall-Strack friction.
    CundallStrack,
    /// Pressed grains with Haff-Werner friction.
    HaffWerner,
    /// Pressed grains without friction.
    Frictionless,
    /// Pressed grains with truncated Cundall-Strack friction, too many for any cache.
    Large,
}

/// Number of copies of the pressed grains in the large scene.
const TIMES: usize = 37;
/// Number of steps per measurement.
const STEPS: u64 = 500;

impl Counted {
    fn name(self) -> &'static str {
        match self {
            Self::Bonded => "bonded, Cundall-Strack",
            Self::CundallStrack => "pressed, Cundall-Strack",
            Self::HaffWerner => "pressed, Haff-Werner",
            Self::Frictionless => "pressed, frictionless",
            Self::Large => "pressed, Cundall-Strack, beyond the caches",
        }
    }
    /// The world that is counted, made from the prepared world.
    fn scene(self, prepared: &World) -> Result<World, Error> {
        match self {
            Self::Bonded => Ok(prepared.clone()),
            Self::CundallStrack => rubbing(prepared, Friction::CundallStrack, 1),
            Self::HaffWerner => rubbing(prepared, Friction::HaffWerner, 1),
            Self::Frictionless => rubbing(prepared, Friction::None, 1),
            Self::Large => rubbing(prepared, Friction::CundallStrack, TIMES),
        }
    }
    /// Two numbers of steps. The difference of their counts is due to steps alone, without start-up.
    fn steps(self) -> [u64; 2] {
        if self == Self::Large {
            [2, 8]
        } else {
            [50, 250]
        }
    }
    /// Advance a prepared state read from a file.
    fn run(self, file: &Path, steps: u64) -> Result<(), Error> {
        let bytes = std::fs::read(file).map_err(|error| Error::file("read", file, error))?;
        let words = words_of_bytes(&bytes);
        let prepared = match self {
            Self::Bonded => fault_again(&words)?,
            _ => pressed_again(&words)?,
        };
        advance(&mut self.scene(&prepared)?, steps)
    }
}

/// Counts of a scene.
#[derive(Serialize)]
pub struct Counts {
    /// Name of the scene.
    pub name: &'static str,
    /// Number of particles.
    pub particles: usize,
    /// Neighbour pairs and bonds per particle.
    pub links: f64,
    /// Instructions per particle-step.
    pub instructions: f64,
    /// Bytes per particle-step that miss the first-level cache of 32 KiB.
    pub bytes_beyond_first_cache: f64,
    /// Bytes per particle-step moved between the last-level cache of 16 MiB and memory, in both directions.
    pub bytes_of_memory: f64,
    /// Times per particle-step in ns, with the same instructions but without callgrind.
    pub ours: Sample,
}

/// Counts of all scenes and the limits of the machine.
#[derive(Serialize)]
pub struct Counting {
    /// The instructions that worlds used: the widest that callgrind supports.
    pub instructions: &'static str,
    /// Limits of the machine.
    pub limits: Limits,
    /// Counts per scene.
    pub scenes: Vec<Counts>,
}

/// Totals that callgrind reports for a run of this program.
struct Totals {
    instructions: f64,
    first_misses: f64,
    last_lines: f64,
}

/// Instructions that callgrind supports.
const KNOWN: [&str; 3] = ["avx2", "neon", "portable"];

/// Count all scenes and time them in the given number of rounds.
///
/// # Errors
/// A scene that cannot be set up, or a valgrind that does not run.
pub fn measure(valgrind: &Path, rounds: usize) -> Result<Counting, Error> {
    let folder = temporary_folder()?;
    let record = |name: &str, world: &World| -> Result<PathBuf, Error> {
        let file = folder.path().join(name);
        let bytes: Vec<u8> = world
            .to_words()
            .iter()
            .flat_map(|word| word.to_le_bytes())
            .collect();
        std::fs::write(&file, bytes).map_err(|error| Error::file("write", &file, error))?;
        Ok(file)
    };
    let (block, grains) = (fault(Friction::CundallStrack, false)?, pressed(0.1)?);
    let files = [record("block", &block)?, record("grains", &grains)?];
    let available = gouge_common::instructions::Instructions::available();
    let known = |name: &&'static str| available.iter().find(|set| set.name() == *name).copied();
    let instructions = KNOWN.iter().find_map(known).unwrap_or_default();
    let program = Program {
        valgrind,
        instructions: instructions.name(),
    };
    let mut scenes = Vec::new();
    for &counted in Counted::value_variants() {
        let (file, prepared) = match counted {
            Counted::Bonded => (&files[0], &block),
            _ => (&files[1], &grains),
        };
        let world = counted.scene(prepared)?.with_instructions(instructions);
        scenes.push(program.count(counted, file, world, rounds)?);
    }
    let limits = Limits::measured(program.instructions_of_busy()?);
    println!("{}", limits.words());
    Ok(Counting {
        instructions: program.instructions,
        limits,
        scenes,
    })
}

/// This program under callgrind.
struct Program<'a> {
    valgrind: &'a Path,
    instructions: &'static str,
}

impl Program<'_> {
    fn count(
        &self,
        counted: Counted,
        file: &Path,
        world: World,
        rounds: usize,
    ) -> Result<Counts, Error> {
        let particles = world.particles().len();
        let pairs = world.contacts().map_or(0, |contacts| contacts.pairs.len());
        let bonds = world.bonds().map_or(0, |bonds| bonds.len());
        let mut timer = Timer::new(world, 10)?;
        let steps = if counted == Counted::Large { 4 } else { 1 } * STEPS / 4;
        let mut ours = Sample::default();
        for _ in 0..rounds {
            ours.0.push(timer.time(steps)?);
        }
        let value = counted.to_possible_value();
        let scene = value.as_ref().map_or("", |value| value.get_name());
        let totals = |steps: u64| {
            let file = file.display().to_string();
            self.totals(&[
                "steps",
                "--scene",
                scene,
                "--steps",
                &steps.to_string(),
                "--state",
                &file,
            ])
        };
        let [few, many] = counted.steps();
        let (before, after) = (totals(few)?, totals(many)?);
        let of_each = |count: fn(&Totals) -> f64| {
            (count(&after) - count(&before)) / ((many - few) as f64 * particles as f64)
        };
        let counts = Counts {
            name: counted.name(),
            particles,
            links: (pairs + bonds) as f64 / particles as f64,
            instructions: of_each(|totals| totals.instructions),
            bytes_beyond_first_cache: LINE * of_each(|totals| totals.first_misses),
            bytes_of_memory: LINE * of_each(|totals| totals.last_lines),
            ours,
        };
        println!("{}", counts.words());
        Ok(counts)
    }

    /// Instructions per iteration of [`busy`].
    fn instructions_of_busy(&self) -> Result<f64, Error> {
        let totals = |turns: u64| self.totals(&["busy", "--turns", &turns.to_string()]);
        let (few, many) = (100_000, 1_100_000);
        let added = totals(many)?.instructions - totals(few)?.instructions;
        Ok(added / (many - few) as f64)
    }

    fn totals(&self, arguments: &[&str]) -> Result<Totals, Error> {
        let program = std::env::current_exe()
            .map_err(|error| Error::file("find", Path::new("this program"), error))?;
        let output = Command::new(self.valgrind)
            .args([
                "--tool=callgrind",
                "--callgrind-out-file=/dev/null",
                "--simulate-wb=yes",
            ])
            .args(["--cache-sim=yes", "--D1=32768,8,64", "--LL=16777216,16,64"])
            .arg(program)
            .args(arguments)
            .env(INSTRUCTIONS, self.instructions)
            .output()
            .map_err(|error| Error::file("run", self.valgrind, error))?;
        let text = String::from_utf8_lossy(&output.stderr);
        read_totals(&text)
            .filter(|_| output.status.success())
            .ok_or_else(|| {
                let last: Vec<&str> = text.lines().rev().take(5).collect();
                Error::Argument(format!(
                    "{} printed no counts; its last line was {last:?}",
                    self.valgrind.display()
                ))
            })
    }
}

/// Bytes per cache line.
const LINE: f64 = 64.0;

/// The totals that callgrind prints as one line of names and one line of numbers.
fn read_totals(text: &str) -> Option<Totals> {
    let entries = |title: &str| {
        let line = text.lines().find_map(|line| line.split_once(title))?;
        Some(line.1.trim_start_matches([' ', ':']).split_whitespace())
    };
    let names = entries("Events")?;
    let numbers = entries("Collected")?.map(|number| number.parse::<f64>().unwrap_or(f64::NAN));
    let counted: Vec<(&str, f64)> = names.zip(numbers).collect();
    let sum = |wanted: &[&str]| {
        let found = counted.iter().filter(|(name, _)| wanted.contains(name));
        found.map(|(_, number)| number).sum()
    };
    Some(Totals {
        instructions: sum(&["Ir"]),
        first_misses: sum(&["D1mr", "D1mw"]),
        last_lines: sum(&["DLmr", "DLmw", "DLdmr", "DLdmw", "ILdmr"]),
    })
}

impl Counts {
    fn words(&self) -> String {
        format!(
            "{:42} {:.1} instructions, {:.0} bytes from beyond the first cache, {:.0} from or to memory per particle-step; {:.2} links; {} ns",
            self.name,
            self.instructions,
            self.bytes_beyond_first_cache,
            self.bytes_of_memory,
            self.links,
            self.ours.words()
        )
    }
}
