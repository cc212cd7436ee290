//! Other programs' results.

mod beam;
mod differences;
mod ensemble;
mod motion;
mod observables;
mod overview;
mod stretched;

use crate::checks::{Check, Effort, Evidence, Failure, Origin, Outcome, Topic};
use crate::references::{Case, case};

/// The topic.
pub fn topic() -> Topic {
    let mut checks = vec![overview::check()];
    checks.extend(cases());
    checks.extend(differences::checks());
    checks.push(stretched::check());
    Topic {
        id: "references",
        title: "Other programs",
        about: "Results of LAMMPS and YADE from their own inputs, repeated by the kernel with their conventions for lever arms and time stepping. Nothing in references/ was computed by this program; references/regenerate runs the engines again.",
        checks,
    }
}

/// Checks of the cases: every folder of `references` is listed here.
fn cases() -> Vec<Check> {
    let mut checks = Vec::new();
    macro_rules! compare {
        ($words:ident, $compare:path, $($path:literal),* $(,)?) => {
            $(checks.push($words($path, concat!("references.", $path), || $compare(stored($path)?)));)*
        };
    }
    compare!(
        step_by_step,
        motion::compare,
        "lammps/bond-axial",
        "lammps/bond-bending",
        "lammps/bond-breaking",
        "lammps/bond-frame",
        "lammps/chain",
        "lammps/cundall-strack",
        "lammps/drop-and-bounce",
        "lammps/forces",
        "lammps/gran-hooke",
        "lammps/gran-hooke-history",
        "lammps/haff-werner",
        "lammps/hertz",
        "lammps/kelvin-voigt",
        "lammps/mass-damping",
        "lammps/rolling-to-slip",
        "lammps/viscoelastic",
        "lammps/viscoelastic-forces",
        "yade/cundall-strack",
        "yade/damped-cundall-strack",
        "yade/drop-and-bounce",
        "yade/granular-ratcheting",
        "yade/hertz",
        "yade/kelvin-voigt",
    );
    compare!(step_by_step, beam::compare, "lammps/bond-forces");
    macro_rules! average {
        ($($path:literal),* $(,)?) => {
            $(
                checks.push(on_average($path, concat!("references.", $path), || {
                    ensemble::compare(stored($path)?)
                }));
                checks.push(wrong_on_average($path, concat!("references.", $path, ".control"), || {
                    ensemble::compare_wrong(stored($path)?)
                }));
            )*
        };
    }
    average!(
        "lammps/settling",
        "lammps/sheared-cell",
        "lammps/torn-block"
    );
    checks
}

/// The stored case of a path.
fn stored(path: &str) -> Result<&'static Case, Failure> {
    case(path).map_err(Failure::Oracle)
}

/// The check of a case that is repeated step by step. Its texts come from the files of the case.
fn step_by_step(path: &'static str, id: &'static str, measure: fn() -> Outcome) -> Check {
    let text = |pick: fn(&'static Case) -> &'static str| case(path).map_or(path, pick);
    Check {
        id,
        claim: text(|case| &case.title),
        equations: Evidence::parse(text(|case| &case.equations)).unwrap_or_default(),
        scene: text(|case| &case.laws),
        oracle: text(|case| &case.settings),
        norm: "Largest error of a position, velocity, spin, force or torque at any recorded step, in units of the largest displacement, speed, spin, force or torque of the run; rotations are converted to translations at the smallest radius",
        origin: Origin::Exact,
        reason: text(|case| &case.reason),
        effort: Effort::Quick,
        measure,
    }
}

/// The check of a case that agrees on average.
fn on_average(path: &'static str, id: &'static str, measure: fn() -> Outcome) -> Check {
    Check {
        norm: "For the observable closest to its margin: mean difference of the runs plus the quantile of Student's t times its standard error, in units of the engine's mean",
        origin: Origin::Statistical,
        effort: Effort::Thorough,
        ..step_by_step(path, id, measure)
    }
}

/// The check that the tests of a case can fail.
fn wrong_on_average(path: &'static str, id: &'static str, measure: fn() -> Outcome) -> Check {
    let claim = case(path).ok().and_then(|case| case.control.as_ref());
    Check {
        claim: claim.map_or(path, |control| &control.claim),
        norm: "Number of observables that should be rejected and are not",
        reason: "The wrong parameter changes them by more than their margins",
        ..on_average(path, id, measure)
    }
}
