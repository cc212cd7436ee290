//! Times the same states with LAMMPS: writes a data file, runs an input of `peers/`, reads the loop time.

use gouge_dem::World;
use gouge_dem::particles::Role;
use gouge_runner::error::Error;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A build of LAMMPS.
#[derive(Clone)]
pub struct Lammps {
    /// The executable.
    pub program: PathBuf,
}

/// Density of a particle whose mass is that of a sphere, in kg/m^3.
fn density(mass: f64, radius: f64) -> f64 {
    mass / (4.0 / 3.0 * std::f64::consts::PI * radius.powi(3))
}

/// Atom types by role: free, fixed, driven.
pub fn roles(world: &World) -> Vec<usize> {
    let kind = |role: &Role| match role {
        Role::Free => 1,
        Role::Fixed => 2,
        Role::Driven => 3,
    };
    world.particles().role.iter().map(kind).collect()
}

/// Ends of the box, 0.1 m beyond the particles.
fn ends(places: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = places.fold((0.0_f64, 0.0_f64), |(a, b), x| (a.min(x), b.max(x)));
    (low - 0.1, high + 0.1)
}

/// The state as a data file, for atoms of the given types, with or without bonds.
pub fn data(world: &World, types: &[usize]) -> String {
    let p = world.particles();
    let bonds = world.bonds().map_or(&[][..], |bonds| bonds.pairs());
    let (left, right) = match world.model().period() {
        Some(width) => (0.0, width),
        None => ends(p.position.iter().map(|x| x.x)),
    };
    let (low, high) = ends(p.position.iter().map(|x| x.y));
    let mut text = format!(
        "state of a scene\n\n{} atoms\n{} atom types\n",
        p.len(),
        types.iter().max().unwrap_or(&1)
    );
    if !bonds.is_empty() {
        let _ = write!(
            text,
            "{} bonds\n1 bond types\n12 extra bond per atom\n20 extra special per atom\n",
            bonds.len()
        );
    }
    let _ = write!(
        text,
        "{left:e} {right:e} xlo xhi\n{low:e} {high:e} ylo yhi\n-5e-3 5e-3 zlo zhi\n\nAtoms\n\n"
    );
    for (i, kind) in types.iter().enumerate() {
        let molecule = if bonds.is_empty() { "" } else { "1 " };
        let (radius, position) = (p.radius[i], p.position[i]);
        let _ = writeln!(
            text,
            "{} {molecule}{kind} {:e} {:e} {:e} {:e} 0",
            i + 1,
            2.0 * radius,
            density(p.mass[i], radius),
            position.x,
            position.y
        );
    }
    let _ = write!(text, "\nVelocities\n\n");
    for i in 0..p.len() {
        let (v, spin) = (p.velocity[i], p.angular_velocity[i]);
        let _ = writeln!(text, "{} {:e} {:e} 0 0 0 {:e}", i + 1, v.x, v.y, spin);
    }
    if !bonds.is_empty() {
        let _ = write!(text, "\nBonds\n\n");
        for (k, pair) in bonds.iter().enumerate() {
            let _ = writeln!(text, "{} 1 {} {}", k + 1, pair.i + 1, pair.j + 1);
        }
    }
    text
}

impl Lammps {
    fn command(&self) -> Command {
        let mut command = Command::new(&self.program);
        command.env("OMP_NUM_THREADS", "1");
        if let Some(folder) = self.program.parent() {
            command.env("LD_LIBRARY_PATH", folder.join("../lib"));
        }
        command
    }

    /// Name of the program and date of its version, as it prints them.
    ///
    /// # Errors
    /// A program that cannot be run.
    pub fn name(&self) -> Result<String, Error> {
        let output = self.command().arg("-help").output();
        let output = output.map_err(|error| Error::file("run", &self.program, error))?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let date = text
            .lines()
            .find_map(|line| line.split_once("Simulator - "));
        Ok(date.map_or("LAMMPS".to_owned(), |(_, date)| format!("LAMMPS {date}")))
    }

    /// Loop time in s of the last `run` of an input, which gets variables by name.
    ///
    /// # Errors
    /// A program that cannot be run or prints no loop time.
    pub fn seconds(&self, input: &Path, variables: &[(&str, &str)]) -> Result<f64, Error> {
        let mut command = self.command();
        command.args(["-log", "none", "-in"]).arg(input);
        for (name, value) in variables {
            command.args(["-var", name, value]);
        }
        let output = command
            .output()
            .map_err(|error| Error::file("run", &self.program, error))?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let mut loops = text
            .lines()
            .rev()
            .filter_map(|line| line.strip_prefix("Loop time of "));
        let seconds = loops
            .next()
            .and_then(|rest| rest.split(' ').next()?.parse::<f64>().ok());
        seconds.filter(|_| output.status.success()).ok_or_else(|| {
            let last: Vec<&str> = text.lines().rev().take(5).collect();
            Error::Argument(format!(
                "{} failed on {}; its last line was {last:?}",
                self.program.display(),
                input.display()
            ))
        })
    }
}
