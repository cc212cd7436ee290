//! Order of the integrators.

mod events;
mod rotating;

use super::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Topic,
    thesis,
};
use crate::oracles::oscillator::released;
use crate::scenes::events::oscillator;
use gouge_runner::scene::INTEGRATORS;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "order",
        title: "Order of the integrators",
        about: "Observed orders of the integrators, on smooth motion and through events.",
        checks: [vec![Check {
            id: "order.smooth",
            claim: "On a damped oscillator the error of each integrator falls with its theoretical order: one for both Euler methods and Taylor, two for velocity Verlet and Beeman.",
            equations: thesis("(54)-(58)"),
            scene: "A sphere of 1 kg in a harmonic well of angular frequency 1/s, with creeping drag of damping ratio 0.3, released from rest at 1 m",
            oracle: "Closed form of the damped oscillator",
            norm: "Largest distance of an order, observed between 3200 and 6400 steps, from the theoretical order",
            origin: Origin::Convergent,
            reason: "The next term of the error is smaller by about the time step, 1e-3 of the time scale",
            effort: Effort::Quick,
            measure: smooth,
        }], rotating::checks(), events::checks()]
            .into_iter()
            .flatten()
            .collect(),
    }
}

/// Least-squares slope of a line through points, with both axes logarithmic.
fn slope(points: &[[f64; 2]]) -> f64 {
    let number = points.len() as f64;
    let logs: Vec<[f64; 2]> = points.iter().map(|point| point.map(f64::ln)).collect();
    let mean = |axis: usize| logs.iter().map(|log| log[axis]).sum::<f64>() / number;
    let centre = [mean(0), mean(1)];
    let moment = |axis: usize| {
        let terms = logs
            .iter()
            .map(|log| (log[0] - centre[0]) * (log[axis] - centre[axis]));
        terms.sum::<f64>()
    };
    moment(1) / moment(0)
}

const ZETA: f64 = 0.3;
const END: f64 = 3.0;

fn error(integrator: &str, steps: u64) -> Result<f64, Failure> {
    let mut world = oscillator(integrator, END / steps as f64, ZETA).world()?;
    advance(&mut world, steps)?;
    Ok((world.particles().position[0].y - released(END, ZETA)).abs())
}

fn smooth() -> Outcome {
    let (mut orders, mut curves) = (Vec::new(), Vec::new());
    for ((name, _), order) in INTEGRATORS.iter().zip([1.0, 1.0, 1.0, 2.0, 2.0]) {
        let steps = [400, 800, 1600, 3200, 6400];
        let errors = steps
            .iter()
            .map(|&steps| error(name, steps))
            .collect::<Result<Vec<f64>, Failure>>()?;
        orders.push(Measurement::absolute(
            order,
            (errors[3] / errors[4]).log2(),
            0.01,
        ));
        let points = steps
            .iter()
            .zip(&errors)
            .map(|(&n, &e)| [END / n as f64, e]);
        curves.push(Curve::marked_line(name, points));
    }
    let plot = Figure::new(
        "Error at the end against the time step",
        Axis::logarithmic("time step in units of 1/w", ""),
        Axis::logarithmic("error in units of the amplitude", ""),
        curves,
    );
    Ok(Measurement::worst(orders).showing([Exhibit::Figure(plot)]))
}
