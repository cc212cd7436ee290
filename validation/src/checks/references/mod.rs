//! Other programs' results.

mod beam;
mod motion;
mod overview;

use super::{Check, Effort, Failure, Origin, Outcome, Topic};
use crate::references::{Case, case};

/// The topic.
pub fn topic() -> Topic {
    let mut checks = vec![overview::check()];
    checks.extend(cases());
    Topic {
        id: "references",
        title: "Other programs",
        about: "What LAMMPS and YADE computed with their own inputs, repeated by the kernel with their conventions for lever arms and their steps. Nothing of it was produced by this program; `references/regenerate` runs the engines again.",
        checks,
    }
}

/// The cases, and how each is compared: every folder of `references` stands here.
macro_rules! cases {
    ($($path:literal: $compare:path,)*) => {
        fn cases() -> Vec<Check> {
            vec![$(check($path, concat!("references.", $path), || $compare(stored($path)?)),)*]
        }
    };
}

cases! {
    "lammps/bond-axial": motion::compare,
    "lammps/bond-bending": motion::compare,
    "lammps/bond-breaking": motion::compare,
    "lammps/bond-forces": beam::compare,
    "lammps/bond-frame": motion::compare,
    "lammps/chain": motion::compare,
    "lammps/cundall-strack": motion::compare,
    "lammps/drop-and-bounce": motion::compare,
    "lammps/forces": motion::compare,
    "lammps/gran-hooke": motion::compare,
    "lammps/gran-hooke-history": motion::compare,
    "lammps/haff-werner": motion::compare,
    "lammps/hertz": motion::compare,
    "lammps/kelvin-voigt": motion::compare,
    "lammps/rolling-to-slip": motion::compare,
    "lammps/viscoelastic": motion::compare,
    "lammps/viscoelastic-forces": motion::compare,
    "yade/cundall-strack": motion::compare,
    "yade/damped-cundall-strack": motion::compare,
    "yade/drop-and-bounce": motion::compare,
    "yade/granular-ratcheting": motion::compare,
    "yade/hertz": motion::compare,
    "yade/kelvin-voigt": motion::compare,
}

/// A case of the folder.
fn stored(path: &str) -> Result<&'static Case, Failure> {
    case(path).map_err(Failure::Oracle)
}

/// The check of a case; what its files state stands in for the words of other checks.
fn check(path: &'static str, id: &'static str, measure: fn() -> Outcome) -> Check {
    let text = |pick: fn(&'static Case) -> &'static str| case(path).map_or(path, pick);
    Check {
        id,
        claim: text(|case| &case.title),
        equations: text(|case| &case.equations),
        scene: text(|case| &case.laws),
        oracle: text(|case| &case.settings),
        norm: "Largest difference of a position, velocity, spin, force or torque at any recorded step, in units of the largest displacement, speed, spin, force or torque of the run; rotation and translation count alike at the smallest radius",
        origin: Origin::Exact,
        reason: text(|case| &case.reason),
        effort: Effort::Quick,
        measure,
    }
}
