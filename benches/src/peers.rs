//! Whole scenes beside LAMMPS, in turns, so that both see the same moods of the machine.

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

/// Steps before a measurement.
const WARM_UP: u64 = 200;
/// Steps of a measurement.
const STEPS: u64 = 1000;

/// A scene that was timed.
#[derive(Serialize)]
pub struct Case {
    /// Its name.
    pub name: String,
    /// Number of particles.
    pub particles: usize,
    /// Contacts a particle.
    pub contacts: f64,
    /// Pairs in the neighbour list a particle.
    pub near_pairs: f64,
    /// Bonds a particle.
    pub bonds: f64,
    /// Bytes a particle that the world keeps.
    pub bytes: f64,
    /// Rebuilds of the neighbour list in the measured steps, and their number.
    pub rebuilds: [u64; 2],
    /// Times of a particle-step in ns.
    pub ours: Sample,
    /// The same of the other program, with its name.
    pub peer: Option<(String, Sample)>,
}

/// Times of a particle-step of a world in ns, advanced on and on.
pub struct Timer {
    world: World,
    rebuilds: u64,
    steps: u64,
}

impl Timer {
    /// A world after some steps to warm up.
    pub fn new(mut world: World, warm_up: u64) -> Result<Self, Error> {
        advance(&mut world, warm_up)?;
        let rebuilds = world.rebuilds();
        Ok(Self {
            world,
            rebuilds,
            steps: 0,
        })
    }
    /// The same world, advanced by so many threads from now on.
    pub fn with_threads(self, threads: usize) -> Self {
        Self {
            world: self.world.with_threads(threads),
            ..self
        }
    }
    /// Time of a particle-step in ns, over so many more steps.
    pub fn time(&mut self, steps: u64) -> Result<f64, Error> {
        let began = Instant::now();
        advance(&mut self.world, steps)?;
        self.steps += steps;
        let particles = self.world.particles().len() as f64;
        Ok(began.elapsed().as_secs_f64() * 1e9 / (steps as f64 * particles))
    }
    /// The world at present.
    pub fn world(&self) -> &World {
        &self.world
    }
    /// What was timed.
    pub fn case(&self, name: &str, ours: Sample, peer: Option<(String, Sample)>) -> Case {
        let world = &self.world;
        let number = world.particles().len();
        let of_each = |count: usize| count as f64 / number as f64;
        Case {
            name: name.to_owned(),
            particles: number,
            contacts: of_each(world.number_of_contacts()),
            near_pairs: of_each(world.contacts().map_or(0, |weak| weak.pairs.len())),
            bonds: of_each(world.bonds().map_or(0, |strong| strong.len())),
            bytes: bytes(world),
            rebuilds: [world.rebuilds() - self.rebuilds, self.steps],
            ours,
            peer,
        }
    }
}

/// Advance a world by so many steps.
///
/// # Errors
/// A state that becomes senseless.
pub fn advance(world: &mut World, steps: u64) -> Result<(), Error> {
    gouge_runner::run::advance(world, steps, "measurement")
}

impl Case {
    /// A line of a table.
    pub fn words(&self) -> String {
        let ratio = self.peer.as_ref().map_or(String::new(), |(name, peer)| {
            format!(
                "  {name} {}  ratio {}",
                peer.words(),
                self.ours.over(peer).words()
            )
        });
        format!(
            "{:28} ns a particle-step {}, least {:.2}, {:.0} bytes{ratio}",
            self.name,
            self.ours.words(),
            self.ours.least(),
            self.bytes
        )
    }
}

/// The programs to compare with, where they are there.
pub struct Programs {
    /// With beams of bonded particles.
    pub beams: Option<Lammps>,
    /// For contacts: the fastest build.
    pub contacts: Option<Lammps>,
}

/// Time all scenes beside the programs, in so many rounds.
///
/// # Errors
/// Scenes that cannot be set up, programs that fail.
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

/// Time the fault with Cundall-Strack friction from the beginning of its shear to the end, in so many turns
/// with the beams of LAMMPS.
///
/// # Errors
/// As [`measure`].
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
    /// Steps of ours before the first.
    warm_up: u64,
    /// Steps of ours in all of them.
    steps: u64,
}

impl Turns {
    /// Steps of ours in each turn, equal but for rounding.
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
