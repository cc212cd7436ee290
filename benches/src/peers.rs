//! Whole scenes compared with LAMMPS. Both programs take turns, so that both see the same load of the machine.

use crate::folder::temporary_folder;
use crate::lammps::{Lammps, data, roles};
use crate::parts::bytes;
use crate::sample::Sample;
use crate::worlds::{Friction, fault, fault_steps, pressed, rubbing};
use gouge_dem::World;
use gouge_runner::error::Error;
use serde::Serialize;
use std::path::Path;
use std::time::Instant;

/// Number of warm-up steps before the measurements.
const WARM_UP: u64 = 200;
/// Number of steps per measurement.
const STEPS: u64 = 1000;

/// A scene that was timed.
#[derive(Serialize)]
pub struct Case {
    /// Name of the scene.
    pub name: String,
    /// Number of particles.
    pub particles: usize,
    /// Contacts per particle.
    pub contacts: f64,
    /// Pairs in the neighbour list per particle.
    pub near_pairs: f64,
    /// Bonds per particle.
    pub bonds: f64,
    /// Bytes per particle that the world occupies.
    pub bytes: f64,
    /// Number of rebuilds of the neighbour list in the measured steps, and number of these steps.
    pub rebuilds: [u64; 2],
    /// Times per particle-step in ns.
    pub ours: Sample,
    /// Name of the other program, and its times per particle-step in ns.
    pub peer: Option<(String, Sample)>,
}

/// Times a world that is advanced further in every measurement.
pub struct Timer {
    world: World,
    rebuilds: u64,
    steps: u64,
}

impl Timer {
    /// A timer for a world, after warm-up steps.
    pub fn new(mut world: World, warm_up: u64) -> Result<Self, Error> {
        advance(&mut world, warm_up)?;
        let rebuilds = world.rebuilds();
        Ok(Self {
            world,
            rebuilds,
            steps: 0,
        })
    }
    /// The same world, advanced by the given number of threads from now on.
    pub fn with_threads(self, threads: usize) -> Self {
        Self {
            world: self.world.with_threads(threads),
            ..self
        }
    }
    /// Time per particle-step in ns over a number of further steps.
    pub fn time(&mut self, steps: u64) -> Result<f64, Error> {
        let began = Instant::now();
        advance(&mut self.world, steps)?;
        self.steps += steps;
        let particles = self.world.particles().len() as f64;
        Ok(began.elapsed().as_secs_f64() * 1e9 / (steps as f64 * particles))
    }
    /// The world in its current state.
    pub fn world(&self) -> &World {
        &self.world
    }
    /// The results of this world.
    pub fn case(&self, name: &str, ours: Sample, peer: Option<(String, Sample)>) -> Case {
        let world = &self.world;
        let number = world.particles().len();
        let of_each = |count: usize| count as f64 / number as f64;
        Case {
            name: name.to_owned(),
            particles: number,
            contacts: of_each(world.number_of_contacts()),
            near_pairs: of_each(world.contacts().map_or(0, |contacts| contacts.pairs.len())),
            bonds: of_each(world.bonds().map_or(0, |bonds| bonds.len())),
            bytes: bytes(world),
            rebuilds: [world.rebuilds() - self.rebuilds, self.steps],
            ours,
            peer,
        }
    }
}

/// Advance a world by a number of steps.
///
/// # Errors
/// A state that becomes invalid.
pub fn advance(world: &mut World, steps: u64) -> Result<(), Error> {
    gouge_runner::run::advance(world, steps, "measurement")
}

impl Case {
    /// A row of the printed table.
    pub fn words(&self) -> String {
        let ratio = self.peer.as_ref().map_or(String::new(), |(name, peer)| {
            format!(
                "  {name} {}  ratio {}",
                peer.words(),
                self.ours.over(peer).words()
            )
        });
        format!(
            "{:28} ns per particle-step {}, minimum {:.2}, {:.0} bytes{ratio}",
            self.name,
            self.ours.words(),
            self.ours.least(),
            self.bytes
        )
    }
}

/// The programs to compare with, if they are installed.
pub struct Programs {
    /// LAMMPS with bonded particles (BPM), for beams.
    pub beams: Option<Lammps>,
    /// The fastest build of LAMMPS, for contacts.
    pub contacts: Option<Lammps>,
}

/// Time all scenes and compare them with the programs, in the given number of rounds.
///
/// # Errors
/// A scene that cannot be set up, or a program that fails.
pub fn measure(programs: &Programs, rounds: usize, only: &str) -> Result<Vec<Case>, Error> {
    let loose = |friction| rubbing(&pressed(0.1)?, friction, 1);
    type Make<'a> = &'a dyn Fn() -> Result<World, Error>;
    let scenes: [(&str, Make, &str, &Option<Lammps>); 6] = [
        (
            "bonded, Cundall-Strack",
            &|| fault(Friction::CundallStrack, false),
            "bonded.lammps",
            &programs.beams,
        ),
        (
            "bonded, Haff-Werner",
            &|| fault(Friction::HaffWerner, false),
            "bonded.lammps",
            &programs.beams,
        ),
        (
            "bonded, ledger",
            &|| fault(Friction::CundallStrack, true),
            "",
            &None,
        ),
        (
            "pressed, Cundall-Strack",
            &|| loose(Friction::CundallStrack),
            "frictional.lammps",
            &programs.contacts,
        ),
        (
            "pressed, Haff-Werner",
            &|| loose(Friction::HaffWerner),
            "frictional.lammps",
            &programs.contacts,
        ),
        (
            "pressed, frictionless",
            &|| loose(Friction::None),
            "frictionless.lammps",
            &programs.contacts,
        ),
    ];
    let mut cases = Vec::new();
    for (name, make, input, program) in scenes {
        if name.contains(only) {
            let turns = Turns {
                rounds,
                warm_up: WARM_UP,
                steps: STEPS * rounds as u64,
            };
            cases.push(compare(name, make()?, program.as_ref(), input, turns)?);
        }
    }
    Ok(cases)
}

/// Time the whole shear phase of the fault with Cundall-Strack friction, in the given number of turns with the beams
/// of LAMMPS.
///
/// # Errors
/// Like [`measure`].
pub fn whole(beams: Option<&Lammps>, rounds: usize) -> Result<Case, Error> {
    let turns = Turns {
        rounds,
        warm_up: 0,
        steps: fault_steps()?,
    };
    let world = fault(Friction::CundallStrack, false)?;
    let name = "bonded, Cundall-Strack, whole shear";
    compare(name, world, beams, "bonded.lammps", turns)
}

/// How a scene and a program take turns.
#[derive(Clone, Copy)]
struct Turns {
    rounds: usize,
    /// Our steps before the first turn.
    warm_up: u64,
    /// Our steps in all turns together.
    steps: u64,
}

impl Turns {
    /// Our steps in each turn, equal up to rounding.
    fn each(self) -> impl Iterator<Item = u64> {
        let end = move |turn: u64| self.steps * turn / self.rounds as u64;
        (0..self.rounds as u64).map(move |turn| end(turn + 1) - end(turn))
    }
}

fn compare(
    name: &str,
    world: World,
    program: Option<&Lammps>,
    input: &str,
    turns: Turns,
) -> Result<Case, Error> {
    let input = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("peers")
        .join(input);
    let folder = temporary_folder()?;
    let file = folder.path().join("data");
    std::fs::write(&file, data(&world, &roles(&world)))
        .map_err(|error| Error::file("write", &file, error))?;
    let number = world.particles().len();
    let mut timer = Timer::new(world, turns.warm_up)?;
    let (mut ours, mut theirs) = (Sample::default(), Sample::default());
    for of_ours in turns.each() {
        ours.0.push(timer.time(of_ours)?);
        if let Some(lammps) = program {
            let (steps, file) = (STEPS.to_string(), file.to_string_lossy());
            let seconds = lammps.seconds(&input, &[("steps", &steps), ("data", &file)])?;
            theirs
                .0
                .push(seconds * 1e9 / (STEPS as f64 * number as f64));
        }
    }
    let peer = match program {
        Some(lammps) => Some((lammps.name()?, theirs)),
        None => None,
    };
    let case = timer.case(name, ours, peer);
    println!("{}", case.words());
    Ok(case)
}
