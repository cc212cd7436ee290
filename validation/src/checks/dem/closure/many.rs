//! The balance of many grains: a collapsing pile, and a fault that is sheared and breaks.

use super::printed::fault;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    largest, thesis,
};
use crate::scenes::Draft;
use gouge_dem::World;
use gouge_dem::balance::Energy;
use gouge_runner::run::run_setup;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "closure.pile",
            claim: "The balance of a collapsing pile of grains closes at least with first order in the time step, the lowest order that its contacts cause.",
            equations: thesis("(72)-(79)"),
            scene: "Built-in scene pile, 216 grains on a floor, the first 40 ms, with time steps of 4, 2, 1 and 0.5 us; velocity Verlet",
            oracle: "Order one for sliding contacts, by closure.order-of-sliding, and two for impacts",
            norm: "Amount by which the lowest order between successive time steps falls below one",
            origin: Origin::Convergent,
            reason: "Impacts leave residuals of second order and random sign, sliding leaves residuals of first order; no mixture decreases more slowly than with first order",
            effort: Effort::Thorough,
            measure: pile,
        },
        Check {
            id: "closure.fault",
            claim: "The balance of a sheared fault with breaking bonds closes with first order in the time step, the order that breaking and sliding cause.",
            equations: thesis("(72)-(79)"),
            scene: "Built-in scene granite-fault-small at 15 mm, with a short set-up and bonds of a hundredth of the strength, for 20 us with time steps of 10, 5, 2.5 and 1.25 ns; velocity Verlet",
            oracle: "Order one, by closure.order-at-breaking and closure.order-of-sliding",
            norm: "Distance of the order observed between the two finest time steps from one",
            origin: Origin::Convergent,
            reason: REASON,
            effort: Effort::Thorough,
            measure: sheared,
        },
    ]
}

const REASON: &str = "If the second-order part is as large as the first-order part at the coarsest step, the order between the two finest steps is off by log2(20 / 9) - 1 = 0.152";
const TOLERANCE: f64 = 0.152;

/// Advances to a time; returns the largest residual, the largest energy exchanged, and the terms of the
/// balance at the end.
fn balance(mut world: World, time: f64) -> Result<(f64, f64, Energy), Failure> {
    let steps = (time / world.model().time_step).round() as u64;
    let (mut residual, mut turned) = (0.0_f64, 0.0_f64);
    let first = world.energy().mechanical();
    for look in 1..=20 {
        while world.steps() < steps * look / 20 {
            world.step()?;
        }
        let energy = world.energy();
        residual = largest([residual, energy.residual.abs()]);
        turned = turned
            .max(energy.friction.abs() + energy.kinetic)
            .max((energy.mechanical() - first).abs());
    }
    Ok((residual, turned, world.energy()))
}

/// Residuals of runs with several time steps, and the terms of the run with the finest.
fn converge(
    title: &str,
    time: f64,
    steps: [f64; 4],
    start: impl Fn(f64) -> Result<World, Failure>,
    judge: fn([f64; 3]) -> Measurement,
) -> Outcome {
    let mut points = Vec::new();
    let mut table = Table::new(
        &format!("Terms of (72) at the end, finest time step: {title}"),
        &["term", "energy in J"],
    );
    for step in steps {
        let (residual, turned, energy) = balance(start(step)?, time)?;
        points.push([step, residual / turned]);
        if step == steps[3] {
            for (name, value) in Energy::<f64>::NAMES.iter().zip(energy.values()) {
                table.push([(*name).to_owned(), format!("{value:.6e}")]);
            }
        }
    }
    let orders = [0, 1, 2].map(|n| (points[n][1] / points[n + 1][1]).log2());
    let finest = points[3];
    let line = steps.map(|step| [step, finest[1] * step / finest[0]]);
    let plot = Figure::new(
        format!("Largest residual against the time step: {title}"),
        Axis::logarithmic("time step", "s"),
        Axis::logarithmic("residual over the energy exchanged", ""),
        vec![
            Curve::line("first order", line),
            Curve::marks("kernel", points),
        ],
    );
    Ok(judge(orders).showing([Exhibit::Figure(plot), Exhibit::Table(table)]))
}

fn pile() -> Outcome {
    let start = |step: f64| {
        let draft = Draft::builtin("pile").replacing("time.step", step);
        Ok(run_setup(&draft.scene()?)?)
    };
    let steps = [4e-6, 2e-6, 1e-6, 0.5e-6];
    converge("a collapsing pile", 40e-3, steps, start, |orders| {
        // An undefined order is the lowest.
        let lower = |a: f64, b: f64| if b < a || b.is_nan() { b } else { a };
        let lowest = orders.into_iter().fold(f64::INFINITY, lower);
        let missing = if lowest >= 1.0 { 1.0 } else { lowest };
        Measurement {
            measured: lowest,
            ..Measurement::absolute(1.0, missing, 0.0)
        }
    })
}

fn sheared() -> Outcome {
    let steps = [10e-9, 5e-9, 2.5e-9, 1.25e-9];
    converge("a sheared fault", 20e-6, steps, fault, |orders| {
        Measurement::absolute(1.0, orders[2], TOLERANCE)
    })
}
