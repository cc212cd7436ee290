//! The order of the two schemes in smooth motion.

use super::super::system::{GRAVITY, System, exact_steps, law, moving};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use crate::oracles::contact_dynamics::bodies::sliding_down;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::step::Scheme;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.convergence.schemes",
        claim: "In smooth motion the scheme that detects contacts in the middle of the step has the second order, the one that detects them at its beginning the first.",
        equations: azema("(A8)-(A9), (A28)-(A32), C3"),
        scene: "A disc of radius 0.5 m slides without friction down a fixed disc of 2 m for 0.8 s from 0.3 rad, steps of 8 ms to 0.5 ms",
        oracle: "The pendulum equation of the angle, by a Runge-Kutta method with 1e-13 of error",
        norm: "Largest error of the observed order of the angle, from the last two halvings of the step",
        origin: Origin::Convergent,
        reason: "The next term of the error is smaller by the step over the time of the motion, at most 2 ms/0.8 s; with a constant of the order of ten it changes an order by 0.03. Twice that",
        effort: Effort::Quick,
        measure: schemes,
    }]
}

const DISTANCE: f64 = 2.5;
const START: f64 = 0.3;
const TIME: f64 = 0.8;

/// Angle of the disc from the vertical at the end.
fn angle(scheme: Scheme, steps: usize) -> Result<f64, Failure> {
    let mut settings = exact_steps(TIME / steps as f64, law(0.0, 0.0, GapRule::Predicted));
    settings.scheme = scheme;
    let mut system = System::new(settings);
    let at = [DISTANCE * START.sin(), DISTANCE * START.cos()];
    system.body(0, 0.5, at, 0.0, moving(0.0, 0.0, 0.0))?;
    system.fixed_disc(2.0, [0.0; 2])?;
    system.gravity([0.0, -GRAVITY]);
    system.steps(steps);
    let [x, y] = system.position(0);
    Ok(x.atan2(y))
}

fn schemes() -> Outcome {
    let expected = sliding_down(GRAVITY / DISTANCE, START, TIME);
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for (scheme, name, order) in [
        (Scheme::Midpoint, "middle", 2.0),
        (Scheme::Beginning, "beginning", 1.0),
    ] {
        let mut points = Vec::new();
        for steps in [100, 200, 400, 800, 1600] {
            let error = (angle(scheme, steps)? - expected).abs();
            points.push([TIME / steps as f64, error]);
        }
        for pair in points[2..].windows(2) {
            let observed = (pair[0][1] / pair[1][1]).log2();
            all.push(Measurement::absolute(order, observed, 0.06));
        }
        let last = points[4];
        let slope = points.iter().map(|&[step, _]| {
            let ratio: f64 = step / last[0];
            [step, last[1] * ratio.powf(order)]
        });
        curves.push(Curve::dashed(
            &format!("order {order}"),
            slope.collect::<Vec<_>>(),
        ));
        curves.push(Curve::marks(
            &format!("detection at the {name} of the step"),
            points,
        ));
    }
    let figure = Figure::new(
        "Error of the angle of a disc that slides down another one",
        Axis::logarithmic("step", "s"),
        Axis::logarithmic("error", "rad"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure)]))
}
