//! The balance of many grains: a pile that collapses, a fault that is sheared and breaks.

use super::printed::fault;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Plot, Table,
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
            claim: "The balance of a pile of grains that collapses closes at least with first order in the step, the lowest order that its contacts leave.",
            equations: thesis("(72)-(79)"),
            scene: "Built-in scene pile, 216 grains on a floor, the first 40 ms, with steps of 4, 2, 1 and 0.5 us; velocity Verlet",
            oracle: "Order one of sliding contacts, by closure.order-of-sliding, and two of impacts",
            norm: "What the lowest order between successive steps lacks of one",
            origin: Origin::Convergent,
            reason: "Impacts leave residuals of second order and of random sign, sliding those of first order: no mixture falls more slowly",
            effort: Effort::Thorough,
            measure: pile,
        },
        Check {
            id: "closure.fault",
            claim: "The balance of a sheared fault in which bonds break closes with first order in the step, the order that breaking and sliding leave.",
            equations: thesis("(72)-(79)"),
            scene: "Built-in scene granite-fault-small at 15 mm, set up briefly, with bonds of a hundredth of the strength, for 20 us with steps of 10, 5, 2.5 and 1.25 ns; velocity Verlet",
            oracle: "Order one, by closure.order-at-breaking and closure.order-of-sliding",
            norm: "Distance of the observed order, from the two finest steps, from one",
            origin: Origin::Convergent,
            reason: REASON,
            effort: Effort::Thorough,
            measure: sheared,
        },
    ]
}

const REASON: &str = "A part of second order as large as that of first order at the coarsest step leaves log2(20 / 9) - 1 = 0.152 between the two finest";
const TOLERANCE: f64 = 0.152;

/// Advance to a time; largest residual, the largest energy turned over, and the terms at the end.
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

/// Residuals of runs with several steps, and the terms of the finest.
fn converge(
    title: &str,
    time: f64,
    steps: [f64; 4],
    start: impl Fn(f64) -> Result<World, Failure>,
    judge: fn([f64; 3]) -> Measurement,
) -> Outcome {
    let mut points = Vec::new();
    let mut table = Table::new(
        &format!("Terms of (72) at the end, finest step: {title}"),
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
    let plot = Plot {
        title: format!("Largest residual against the step: {title}"),
        x: Axis::logarithmic("step in s"),
        y: Axis::logarithmic("residual over the energy turned over"),
        curves: vec![
            Curve::line("first order", line),
            Curve::marks("kernel", points),
        ],
    };
    Ok(judge(orders).showing([Exhibit::Plot(plot), Exhibit::Table(table)]))
}

fn pile() -> Outcome {
    let start = |step: f64| {
        let draft = Draft::builtin("pile").replacing("time.step", step);
        Ok(run_setup(&draft.scene()?)?)
    };
    let steps = [4e-6, 2e-6, 1e-6, 0.5e-6];
    converge("a pile that collapses", 40e-3, steps, start, |orders| {
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
