//! Random cases: finite or a typed error, never a panic.

use super::cases::{Draw, Range};
use crate::checks::{Check, Effort, Exhibit, Measurement, Origin, Outcome, Table, thesis};
use gouge_dem::forces::InteractionKind;
use gouge_dem::{StepError, World};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

pub(super) fn checks() -> Vec<Check> {
    let check = |id, scene, effort, measure| Check {
        id,
        claim: "Random pairs, laws and magnitudes, including zero, subnormal and huge ones, are evaluated and stepped without a panic. The result is finite or a typed error, and an evaluation of ordinary magnitudes never overflows.",
        equations: thesis("(26)-(67)"),
        scene,
        oracle: "Newton's third law to the last bit where only contacts and bonds act; contacts repel; below magnitudes of 1e12, an evaluation fails only for a particle that is too fast",
        norm: "Number of violations; a panic fails the check by itself",
        origin: Origin::Exact,
        reason: "No violation is allowed",
        effort,
        measure,
    };
    vec![
        check(
            "extremes.random",
            "2e4 random worlds of two particles, over every law, reading, lever arm, integrator and boundary; all are evaluated, one in sixteen makes four steps",
            Effort::Quick,
            || run_cases(20_000, 16),
        ),
        check(
            "extremes.random-million",
            "1e6 random worlds of two particles, over every law, reading, lever arm, integrator and boundary; all are evaluated, one in 64 makes four steps",
            Effort::Report,
            || run_cases(1_000_000, 64),
        ),
    ]
}

/// The outcome of a case.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Evaluated,
    Finite,
    Refused,
    NotFinite,
    TooFast,
    Wrong,
}

const ENDS: [(End, &str); 6] = [
    (End::Evaluated, "evaluated"),
    (End::Finite, "finite after four steps"),
    (End::Refused, "refused by the model"),
    (End::NotFinite, "stopped: not finite"),
    (End::TooFast, "stopped: too fast"),
    (End::Wrong, "wrong"),
];

fn end_of(error: &StepError) -> End {
    match error {
        StepError::NotFinite { .. } => End::NotFinite,
        StepError::TooFast { .. } => End::TooFast,
    }
}

/// Whether the forces of an evaluated world are wrong; forces that are not finite are wrong only for
/// ordinary magnitudes.
fn is_wrong(world: &World, range: Range) -> bool {
    let (force, torque) = (&world.forces().force, &world.forces().torque);
    let is_finite =
        force.iter().all(|f| f.is_finite()) && torque.iter().all(|torque| torque.is_finite());
    if !is_finite {
        return range == Range::Ordinary;
    }
    let model = world.model();
    let alone = model.ambient.is_none() && model.external.is_none() && model.driving.is_none();
    let unbalanced = alone && force[0] != -force[1];
    let attracts = world
        .interactions()
        .iter()
        .any(|link| link.kind == InteractionKind::Contact && link.normal_force > 0.0);
    unbalanced || attracts
}

fn outcome(case: u64, range: Range, stepped: u64) -> End {
    let Ok(mut world) = Draw::new(case, range).world() else {
        return End::Refused;
    };
    if let Err(error) = world.evaluate_if_pending() {
        let end = end_of(&error);
        let lost = range == Range::Ordinary && end == End::NotFinite;
        return if lost { End::Wrong } else { end };
    }
    if is_wrong(&world, range) {
        return End::Wrong;
    }
    if !case.is_multiple_of(stepped) {
        return End::Evaluated;
    }
    for _ in 0..4 {
        if let Err(error) = world.step() {
            return end_of(&error);
        }
    }
    world
        .check()
        .map_or_else(|error| end_of(&error), |()| End::Finite)
}

/// Runs random cases, half of them over the whole range; one in `stepped` continues after its
/// evaluation.
fn run_cases(cases: u64, stepped: u64) -> Outcome {
    let mut table = Table::new(
        "Outcomes of random cases",
        &["outcome", "ordinary magnitudes", "all magnitudes"],
    );
    let ends = [Range::Ordinary, Range::Whole].map(|range| -> Vec<End> {
        (0..cases / 2)
            .into_par_iter()
            .map(|case| outcome(case, range, stepped))
            .collect()
    });
    let count = |ends: &[End], wanted: End| ends.iter().filter(|&&end| end == wanted).count();
    for (end, name) in ENDS {
        let numbers = ends.each_ref().map(|ends| count(ends, end).to_string());
        table.push([name.to_owned()].into_iter().chain(numbers));
    }
    let wrong = ends.iter().map(|ends| count(ends, End::Wrong)).sum();
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}
