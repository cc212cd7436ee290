//! The balance of many grains: a pile that collapses, a fault that is sheared and breaks.

use super::super::scenes::scene;
use super::super::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Plot, Table,
};
use super::printed::fault;
use crate::run::{enter, phases};
use crate::scene::builtin;
use gouge_kernel::World;
use gouge_kernel::balance::Energy;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "closure.pile",
            claim: "The balance of a pile of grains that collapses closes with first order in the step, the order that its sliding contacts leave.",
            equations: "(72)-(79)",
            scene: "Built-in scene pile, 216 grains on a floor, the first 20 ms, with steps of 8, 4, 2 and 1 us; velocity Verlet",
            oracle: "Order one, by closure.order-of-sliding",
            norm: "Distance of the observed order, by regression over the steps, from one",
            origin: Origin::Convergent,
            reason: "PILE",
            effort: Effort::Thorough,
            measure: pile,
        },
        Check {
            id: "closure.fault",
            claim: "The balance of a sheared fault in which bonds break closes with first order in the step, the order that breaking and sliding leave.",
            equations: "(72)-(79)",
            scene: "Built-in scene granite-fault-small at 15 mm, set up briefly, with bonds of a hundredth of the strength, for 20 us with steps of 10, 5, 2.5 and 1.25 ns; velocity Verlet",
            oracle: "Order one, by closure.order-at-breaking and closure.order-of-sliding",
            norm: "Distance of the observed order, by regression over the steps, from one",
            origin: Origin::Convergent,
            reason: "FAULT",
            effort: Effort::Thorough,
            measure: sheared,
        },
    ]
}

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
        residual = residual.max(energy.residual.abs());
        turned = turned
            .max(energy.friction.abs() + energy.kinetic)
            .max((energy.mechanical() - first).abs());
    }
    Ok((residual, turned, world.energy()))
}

/// Slope of a straight line through the logarithms.
fn order(points: &[[f64; 2]]) -> f64 {
    let logs: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::ln)).collect();
    let n = logs.len() as f64;
    let mean = |c: usize| logs.iter().map(|p| p[c]).sum::<f64>() / n;
    let centre = [mean(0), mean(1)];
    let product = |c: usize| -> f64 {
        let of = |p: &[f64; 2]| (p[0] - centre[0]) * (p[c] - centre[c]);
        logs.iter().map(of).sum()
    };
    product(1) / product(0)
}

/// Residuals of runs with several steps, and the terms of the finest.
fn converge(
    title: &str,
    time: f64,
    steps: [f64; 4],
    tolerance: f64,
    start: impl Fn(f64) -> Result<World, Failure>,
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
    let observed = order(&points);
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
    Ok(Measurement::absolute(1.0, observed, tolerance)
        .showing([Exhibit::Plot(plot), Exhibit::Table(table)]))
}

fn pile() -> Outcome {
    let start = |step: f64| {
        let text = builtin::text("pile").unwrap_or_default();
        let text = text.replace("step = 2e-6", &format!("step = {step:e}"));
        let scene = scene(&text)?;
        Ok(enter(&scene, &phases(&scene), 0, None)?)
    };
    let steps = [8e-6, 4e-6, 2e-6, 1e-6];
    converge("a pile that collapses", 20e-3, steps, 0.2, start)
}

fn sheared() -> Outcome {
    let steps = [10e-9, 5e-9, 2.5e-9, 1.25e-9];
    converge("a sheared fault", 20e-6, steps, 0.2, fault)
}
