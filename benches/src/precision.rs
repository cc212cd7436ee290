//! Error against run time of LAMMPS, measured in turns with our velocity Verlet.

use crate::folder::temporary_folder;
use crate::lammps::{Lammps, data};
use crate::peers::advance;
use crate::sample::Sample;
use gouge_common::geometry::Vec2;
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::model::Ambient;
use gouge_dem::particles::Particles;
use gouge_runner::error::Error;
use gouge_validation::checks::Failure;
use gouge_validation::checks::dem::work_precision::case::{Case, Origin, Truth};
use gouge_validation::checks::dem::work_precision::{PACKING, PAIR, limit_of};
use serde::Serialize;
use std::f64::consts::PI;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A scene with all its runs.
#[derive(Serialize)]
pub struct Scene {
    /// Name of the scene in the chapter on error against run time.
    scene: &'static str,
    /// Name of the program and date of its version.
    peer: String,
    /// Whether errors are relative to the program's own limit of vanishing steps instead of to our reference solution.
    own_limit: bool,
    /// Estimated error of that limit or reference solution, in the unit of errors.
    uncertainty: f64,
    rungs: Vec<Rung>,
}

/// Runs with one time step.
#[derive(Serialize)]
struct Rung {
    /// Time step in s.
    step: f64,
    /// Number of steps.
    steps: u64,
    /// Largest error of a position at the end, divided by the largest displacement.
    error: f64,
    /// Times of the loop of the program in s.
    theirs: Sample,
    /// Times in s of our velocity Verlet in double precision.
    ours: Sample,
}

/// A case with the settings of LAMMPS.
struct Setting {
    case: &'static Case,
    input: &'static str,
    /// Number of time steps tried; LAMMPS takes about a second for the smallest.
    rungs: u32,
    /// Time steps from which the limit of LAMMPS is extrapolated, if its law differs from ours.
    own_limit: Option<Range<usize>>,
}

const SETTINGS: [Setting; 2] = [
    Setting {
        case: &PAIR,
        input: "pair.lammps",
        rungs: 16,
        // Large enough that the resolution of angles in LAMMPS has no effect, small enough for a power series.
        own_limit: Some(5..13),
    },
    Setting {
        case: &PACKING,
        input: "packing.lammps",
        rungs: 11,
        own_limit: None,
    },
];

/// Run the scenes with LAMMPS and with the kernel in the given number of rounds.
///
/// # Errors
/// A scene that cannot be set up, or a program that fails.
pub fn measure(lammps: &Lammps, rounds: usize) -> Result<Vec<Scene>, Error> {
    let one = |setting: &Setting| {
        let scene = compare(setting, lammps, rounds)?;
        scene
            .rungs
            .iter()
            .for_each(|rung| println!("{}", rung.words(scene.scene)));
        Ok(scene)
    };
    SETTINGS.iter().map(one).collect()
}

/// The failure of a case as an error of a command.
fn failed(failure: Failure) -> Error {
    Error::Argument(failure.to_string())
}

fn compare(setting: &Setting, lammps: &Lammps, rounds: usize) -> Result<Scene, Error> {
    let case = setting.case;
    let origin = (case.origin)().map_err(failed)?;
    let files = Files::new(setting, &origin)?;
    let mut endings = Vec::new();
    for rung in 0..setting.rungs {
        files.seconds(lammps, case.rung(rung))?;
        endings.push(files.ending()?);
    }
    let truth = match &setting.own_limit {
        Some(rungs) => limit_of(&origin, endings.get(rungs.clone()).unwrap_or_default()),
        None => (case.truth)(case, &origin, setting.rungs - 1).map_err(failed)?,
    };
    let errors = endings
        .into_iter()
        .map(|ending| error(&origin, ending, &truth));
    let mut rungs: Vec<Rung> = (0..)
        .zip(errors)
        .map(|(at, error)| Rung::new(case, at, error))
        .collect();
    for _ in 0..rounds {
        for rung in &mut rungs {
            rung.theirs
                .0
                .push(files.seconds(lammps, (rung.step, rung.steps))?);
            let start = origin.world(Integrator::VelocityVerlet, rung.step);
            rung.ours
                .0
                .push(seconds(&start.map_err(failed)?, rung.steps)?);
        }
    }
    Ok(Scene {
        scene: case.name,
        peer: lammps.name()?,
        own_limit: setting.own_limit.is_some(),
        uncertainty: truth.uncertainty,
        rungs,
    })
}

/// Error of the final positions of LAMMPS.
fn error(origin: &Origin, ending: Vec<Vec2>, truth: &Truth) -> f64 {
    let particles = Particles {
        position: ending,
        ..origin.particles.clone()
    };
    origin.error(&particles, truth)
}

/// Time in s of a number of steps from a state, after equally many warm-up steps.
fn seconds(start: &World, steps: u64) -> Result<f64, Error> {
    advance(&mut start.clone(), steps)?;
    let mut world = start.clone();
    let began = Instant::now();
    advance(&mut world, steps)?;
    Ok(began.elapsed().as_secs_f64())
}

impl Rung {
    fn new(case: &Case, rung: u32, error: f64) -> Self {
        let (step, steps) = case.rung(rung);
        Self {
            step,
            steps,
            error,
            theirs: Sample::default(),
            ours: Sample::default(),
        }
    }

    /// A row of the printed table.
    fn words(&self, scene: &str) -> String {
        format!(
            "{scene:14} {:.3e} s, {:7} steps: error {:.3e}, time {:.3e} s, ours {:.3e} s, ratio {}",
            self.step,
            self.steps,
            self.error,
            self.theirs.median(),
            self.ours.median(),
            self.theirs.over(&self.ours).words()
        )
    }
}

/// Files that LAMMPS reads and writes.
struct Files {
    input: PathBuf,
    drag: String,
    folder: tempfile::TempDir,
}

impl Files {
    /// Write the initial state; each particle has its own atom type.
    fn new(setting: &Setting, origin: &Origin) -> Result<Self, Error> {
        let folder = temporary_folder()?;
        let files = Self {
            input: Path::new(env!("CARGO_MANIFEST_DIR"))
                .join("peers")
                .join(setting.input),
            drag: drag(origin),
            folder,
        };
        let start = origin
            .world(Integrator::VelocityVerlet, setting.case.thesis_step)
            .map_err(failed)?;
        let types: Vec<usize> = (1..=origin.particles.len()).collect();
        let path = files.path("data");
        std::fs::write(&path, data(&start, &types))
            .map_err(|error| Error::file("write", &path, error))?;
        Ok(files)
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Time in s of a run of LAMMPS with a step and a number of steps.
    fn seconds(&self, lammps: &Lammps, (step, steps): (f64, u64)) -> Result<f64, Error> {
        let [data, end] =
            ["data", "end"].map(|name| self.path(name).to_string_lossy().into_owned());
        let (step, steps) = (format!("{step:e}"), steps.to_string());
        let variables = [
            ("data", &data),
            ("end", &end),
            ("drag", &self.drag),
            ("step", &step),
            ("steps", &steps),
        ];
        lammps.seconds(
            &self.input,
            &variables.map(|(name, value)| (name, value.as_str())),
        )
    }

    /// Final positions of the last run of LAMMPS.
    fn ending(&self) -> Result<Vec<Vec2>, Error> {
        let path = self.path("end");
        let text =
            std::fs::read_to_string(&path).map_err(|error| Error::file("read", &path, error))?;
        let rows = text
            .lines()
            .skip_while(|line| !line.starts_with("ITEM: ATOMS"))
            .skip(1);
        let place = |row: &str| {
            let mut numbers = row.split_whitespace().map(str::parse::<f64>);
            match (numbers.next(), numbers.next()) {
                (Some(Ok(x)), Some(Ok(y))) => Ok(Vec2::new(x, y)),
                _ => Err(Error::Argument(format!("{}: {row}", path.display()))),
            }
        };
        rows.map(place).collect()
    }
}

/// The drag of creeping flow on each atom type, as arguments of `fix viscous`.
fn drag(origin: &Origin) -> String {
    let Some(Ambient::Creeping(law)) = origin.model.ambient else {
        return String::new();
    };
    let radii = (1..).zip(&origin.particles.radius);
    let scale = |(kind, radius): (usize, &f64)| {
        format!(" scale {kind} {:e}", 6.0 * PI * law.viscosity * radius)
    };
    "1.0".to_owned() + &radii.map(scale).collect::<String>()
}
