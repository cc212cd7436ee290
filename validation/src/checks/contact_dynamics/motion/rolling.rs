//! Motion that is followed for a long time.

use super::super::system::{GRAVITY, System, exact_steps, law, moving};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use crate::oracles::contact_dynamics::bodies::steady_landing;
use gouge_contact_dynamics::law::GapRule;
use std::f64::consts::{FRAC_PI_2, PI};

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.motion.rolling-hexagon",
        claim: "A hexagon that rolls down an incline over its corners reaches a steady motion, whose angular velocity converges with the first order of the step.",
        equations: azema("(1), (A1)-(A3), (A28)-(A32), C3"),
        scene: "A regular hexagon of circumradius 1 m on an incline of 0.15 rad with friction 1, 24 corners, steps of 4 ms to 0.25 ms",
        oracle: "The limit cycle of a rimless wheel: energy gained from corner to corner, and angular momentum about the new corner",
        norm: "Largest error of the mean angular velocity before the last 12 landings, relative, in units of the angle per step",
        origin: Origin::Convergent,
        reason: "A landing is found with an uncertainty of one step, and the velocity changes by gravity meanwhile: the relative error is of the order of the angle per step, with a constant of order one; C = 1",
        effort: Effort::Quick,
        measure: rolling_hexagon,
    }]
}

const SLOPE: f64 = 0.15;

/// Angular velocities just before each landing.
fn landings(step: f64, number: usize) -> Result<Vec<f64>, Failure> {
    let settings = exact_steps(step, law(1.0, 0.0, GapRule::Predicted));
    let mut system = System::new(settings);
    let half = PI / 6.0;
    let start = 2.0;
    let velocity = moving(start * half.cos(), start * half.sin(), -start);
    system.body(6, 1.0, [0.0, half.cos()], half - FRAC_PI_2, velocity)?;
    system.floor()?;
    system.tilted(SLOPE);
    let mut found = Vec::new();
    // The largest angular velocity since the latest landing.
    let mut largest = start;
    for _ in 0..200_000 {
        system.step();
        let now = -system.velocity(0).angular;
        // A landing takes a third of the angular velocity, in one step or two; gravity takes less than a tenth.
        if now < 0.8 * largest {
            found.push(largest);
            largest = now;
        }
        if found.len() >= number {
            break;
        }
        largest = largest.max(now);
    }
    Ok(found)
}

fn rolling_hexagon() -> Outcome {
    let expected = steady_landing(GRAVITY, 6, SLOPE);
    let (mut all, mut errors, mut approach) = (Vec::new(), Vec::new(), Vec::new());
    for step in [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4] {
        let found = landings(step, 24)?;
        if found.len() < 24 {
            return Err(Failure::Oracle(format!("only {} landings", found.len())));
        }
        let mean = found[12..].iter().sum::<f64>() / 12.0;
        let turned = expected * step;
        all.push(Measurement::scaled(expected, mean, expected * turned, 1.0));
        errors.push([step, (mean / expected - 1.0).abs()]);
        if step == 1e-3 {
            approach = found;
        }
    }
    let bound = errors.iter().map(|&[step, _]| [step, expected * step]);
    let convergence = Figure::new(
        "Error of the steady angular velocity before landing",
        Axis::logarithmic("step", "s"),
        Axis::logarithmic("relative error", ""),
        vec![
            Curve::dashed("angle per step", bound.collect::<Vec<_>>()),
            Curve::marks("rolling hexagon", errors),
        ],
    );
    let numbered = approach.iter().enumerate();
    let marks = numbered.map(|(k, &speed)| [k as f64 + 1.0, speed]);
    let cycle = Figure::new(
        "A hexagon approaches its limit cycle on an incline of 0.15 rad",
        Axis::linear("landing", ""),
        Axis::linear("angular velocity before landing", "rad/s"),
        vec![
            Curve::line("limit cycle", [[1.0, expected], [24.0, expected]]),
            Curve::marks("steps of 1 ms", marks),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(cycle), Exhibit::Figure(convergence)]))
}
