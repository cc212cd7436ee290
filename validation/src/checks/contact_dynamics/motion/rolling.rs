//! Motion that is followed for a long time.

use super::super::system::{GRAVITY, System, exact_steps, law, moving};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use crate::oracles::contact_dynamics::bodies::{early_landing, steady_landing};
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
        reason: "A predicted gap stops a corner up to one and a half steps before it lands, and the angular velocity is read up to half a step earlier still: the acceleration at landing times two steps, and the losses of earlier landings in a geometric series; C = 4.2",
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
    // The latest three angular velocities, the newest first.
    let mut recent = [start; 3];
    for _ in 0..200_000 {
        system.step();
        recent = [-system.velocity(0).angular, recent[0], recent[1]];
        // A landing takes a third of the angular velocity, in one step or two; gravity takes little in two steps.
        if recent[0] < 0.8 * recent[2] {
            found.push(recent[1].max(recent[2]));
            recent = [recent[0]; 3];
        }
        if found.len() >= number {
            break;
        }
    }
    Ok(found)
}

fn rolling_hexagon() -> Outcome {
    let expected = steady_landing(GRAVITY, 6, SLOPE);
    let constant = early_landing(GRAVITY, 6, SLOPE);
    let (mut all, mut errors, mut approach) = (Vec::new(), Vec::new(), Vec::new());
    for step in [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4] {
        let found = landings(step, 24)?;
        if found.len() < 24 {
            return Err(Failure::Oracle(format!("only {} landings", found.len())));
        }
        let mean = found[12..].iter().sum::<f64>() / 12.0;
        let turned = expected * step;
        all.push(Measurement::scaled(
            expected,
            mean,
            expected * turned,
            constant,
        ));
        errors.push([step, (mean / expected - 1.0).abs()]);
        if step == 1e-3 {
            approach = found;
        }
    }
    let bound = errors
        .iter()
        .map(|&[step, _]| [step, constant * expected * step]);
    let convergence = Figure::new(
        "Error of the steady angular velocity before landing",
        Axis::logarithmic("step", "s"),
        Axis::logarithmic("relative error", ""),
        vec![
            Curve::dashed("bound", bound.collect::<Vec<_>>()),
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
