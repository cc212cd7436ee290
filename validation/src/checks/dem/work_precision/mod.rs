//! Error against run time.

mod advice;
pub mod case;
mod extrapolation;
mod fault;
mod lammps;
mod scenes;
mod show;
mod summary;
mod sweep;
mod verdict;

use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, Topic, thesis};
pub use extrapolation::limit_of;
use gouge_runner::scene::INTEGRATORS;
pub use scenes::{PACKING, PAIR};

use scenes::CASES;
use show::{Curves, OTHERS};
use std::ops::Range;
use std::sync::OnceLock;
use sweep::{Bench, Clock, Precision, Sweep};

/// Index of velocity Verlet among the integrators.
const VERLET: usize = 3;

/// The topic.
pub fn topic() -> Topic {
    let mut checks = vec![scalars(), orders()];
    checks.extend(diagrams());
    checks.push(summary::check());
    Topic {
        id: "work-precision",
        title: "Error against run time",
        about: "The cost of accuracy for each integrator and number type. Errors decide the checks. Times are shown as medians of at least five repetitions (21 for runs below 5 ms) after one warm-up run, one run at a time on one thread without the ledger; only stepping is timed.",
        checks,
    }
}

fn scalars() -> Check {
    Check {
        id: "work-precision.scalars",
        claim: "Where the error in single precision no longer falls with the time step, the errors in double and double-double still fall at order two towards the limit of zero time step.",
        equations: thesis("(43)-(45), (51)-(55)"),
        scene: "Two bonded grains, velocity Verlet, time steps from 1.25 to 0.16 ns; double-double from 40 to 5 ns",
        oracle: "Limit of zero time step in double-double, by extrapolation, the same for velocity Verlet and Beeman",
        norm: "Each over its tolerance: distance of the orders in double and double-double from two, order in single if it is positive, error in single over its rounding bound, and uncertainty of the reference in units of the smallest error",
        origin: Origin::Convergent,
        reason: "The next term of the error is smaller by the time step over the time scale, at most 0.05 here. Rounding is bounded by half a unit in the last place of the largest coordinate per step. The reference may be off by a tenth of the smallest error",
        effort: Effort::Quick,
        measure: || Ok(verdict::scalars(&Bench::new(CASES[0], Clock::Ignored)?)?.into()),
    }
}

fn orders() -> Check {
    Check {
        id: "work-precision.orders",
        claim: "In seven scenes, from two bonded grains to a sheared fault, each integrator reaches its expected order: the theoretical order where forces have at most kinks, at most 3/2 where they begin like a square root, and one where they jump.",
        equations: thesis("(35)-(45), (51)-(58)"),
        scene: "The seven scenes of the diagrams, four to eight time steps each",
        oracle: "High-order integration from event to event in double-double (bouncing, rolling, packings), or the limit of zero time step in double-double (bonded pair, beam, fault)",
        norm: "Largest distance of an observed order from the predicted one, and uncertainty of the reference in units of the smallest error, each over its tolerance",
        origin: Origin::Convergent,
        reason: ORDER_REASON,
        effort: Effort::Thorough,
        measure: || {
            let one = |case| verdict::orders(&Bench::new(case, Clock::Ignored)?);
            let all: Result<Vec<Measurement>, Failure> = CASES.into_iter().map(one).collect();
            Ok(Measurement::worst(all?).into())
        },
    }
}

const ORDER_REASON: &str = "The next term changes an order by less than 0.05 if the motion is smooth. The position of an event within a step scatters the error; half the distance between the orders 1, 3/2 and 2 distinguishes them. The reference may be off by a tenth of the smallest error";

/// A diagram: identifier, claim, scene, oracle and measurement.
type Diagram = (
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    fn() -> Outcome,
);

const LIMIT: &str = "Limit of zero time step in double-double: all powers that the runs allow are eliminated, for two methods";
const EVENTS: &str = "Integration from event to event in double-double, twice with different steps";

const DIAGRAMS: [Diagram; 7] = [
    (
        "work-precision.pair",
        "On two bonded grains both Euler methods and Taylor have order one, and velocity Verlet and Beeman order two, down to rounding.",
        "Two bonded grains of 1 and 0.8 mm that oscillate, bend and rotate by half a radian, for 20.48 us",
        LIMIT,
        || diagram(0),
    ),
    (
        "work-precision.bouncing",
        "In collisions of viscoelastic spheres, whose force begins like the square root of time, velocity Verlet and Beeman have order 3/2.",
        "Four granite grains that each bounce between two fixed ones at 8 to 12 m/s, for 40.96 us",
        EVENTS,
        || diagram(1),
    ),
    (
        "work-precision.rolling",
        "When a rolling ball begins to slip, the force has a kink, and velocity Verlet and Beeman keep order two.",
        "A ball of radius 5 mm that rolls down a fixed one at 0.15 m/s until it slips, for 20.48 ms",
        EVENTS,
        || diagram(2),
    ),
    (
        "work-precision.beam",
        "On a beam of bonded grains velocity Verlet and Beeman have order two, the other integrators order one.",
        "Seven grains bonded in a row to a fixed one, tip at 20 m/s, bonds of the thesis, for 20.48 us",
        LIMIT,
        || diagram(3),
    ),
    (
        "work-precision.packing",
        "When damped grains collide, the force jumps at touch, and no integrator exceeds order one.",
        "Twelve grains that fall onto each other at up to 44 m/s in a harmonic well with drag, for 40.96 us, during which 26 contacts begin",
        EVENTS,
        || diagram(4),
    ),
    (
        "work-precision.viscoelastic-packing",
        "When viscoelastic grains fall onto each other, velocity Verlet and Beeman keep order 3/2.",
        "The same twelve grains with the viscoelastic law of work-precision.bouncing",
        EVENTS,
        || diagram(5),
    ),
    (
        "work-precision.fault",
        "On a compressed and sheared fault, while no contact begins, velocity Verlet and Beeman have order two.",
        "Two blocks of 32 grains with 71 bonds and 10 contacts between them, prepared by the thesis's protocol, under 28 MPa and sheared at 2 m/s by the exact controller, for 5.12 us; contacts slip, but none begins or ends, and no bond breaks",
        LIMIT,
        || diagram(6),
    ),
];

fn diagrams() -> impl Iterator<Item = Check> {
    DIAGRAMS.into_iter().map(|(id, claim, scene, oracle, measure)| Check {
        id,
        claim,
        equations: thesis("(35)-(45), (51)-(58)"),
        scene,
        oracle,
        norm: "Largest error of a position at the end over the largest displacement; the check uses the observed order farthest from the predicted one, and the uncertainty of the reference",
        origin: Origin::Convergent,
        reason: ORDER_REASON,
        effort: Effort::Report,
        measure,
    })
}

/// The result of a case: its verdict and its curves.
type Taken = (Measurement, Curves);

/// Curves of the cases; each is computed once per run of the program.
static TAKEN: [OnceLock<Taken>; CASES.len()] = [const { OnceLock::new() }; CASES.len()];

fn curves(at: usize) -> Result<&'static Taken, Failure> {
    if let Some(taken) = TAKEN[at].get() {
        return Ok(taken);
    }
    let fresh = take(at)?;
    Ok(TAKEN[at].get_or_init(|| fresh))
}

fn diagram(at: usize) -> Outcome {
    let (measurement, curves) = curves(at)?;
    Ok(measurement.showing(curves.exhibits()))
}

fn take(at: usize) -> Result<Taken, Failure> {
    let bench = Bench::new(CASES[at], Clock::Watched)?;
    let rungs = CASES[at].rungs;
    let methods: Vec<Sweep> = (0..INTEGRATORS.len())
        .map(|method| bench.sweep(method, Precision::Double, 0..rungs))
        .collect::<Result<_, _>>()?;
    let best = best(&methods);
    let range = |precision| -> Range<u32> {
        match precision {
            Precision::DoubleDouble => 0..rungs - verdict::DEARER,
            Precision::Single | Precision::Double => 0..rungs,
        }
    };
    let others = OTHERS
        .iter()
        .map(|&precision| bench.sweep(best, precision, range(precision)))
        .collect::<Result<_, _>>()?;
    let measurement = verdict::verdict(&bench, &methods);
    let curves = Curves {
        case: CASES[at],
        methods,
        others,
        uncertainty: bench.truth.uncertainty,
    };
    Ok((measurement, curves))
}

/// The fastest method for the smallest of the advised accuracies that any method reaches.
fn best(methods: &[Sweep]) -> usize {
    let mut targets = advice::TARGETS.iter().rev();
    let fastest = targets.find_map(|&error| advice::fastest(methods, error));
    let name = fastest.map(|(sweep, _)| sweep.integrator);
    let place = INTEGRATORS.iter().position(|(one, _)| Some(*one) == name);
    place.unwrap_or(VERLET)
}
