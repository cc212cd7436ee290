//! Pulses through a chain when sweeps end too early.

use super::super::system::{System, exact_steps, law, moving};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::sweep::SweepOrder;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.convergence.sound",
        claim: "With too few sweeps a chain of rigid discs carries a pulse at a finite speed, one disc per sweep against the order of the points: an artificial sound. In their order one sweep reaches the end.",
        equations: azema("(A16)-(A17), (A27), C4"),
        scene: "A row of 60 touching discs without friction, the first or the last of which begins to move inwards; 1, 2, 5 or 10 forward sweeps per step",
        oracle: "One disc per sweep: a point hands on only what has reached it",
        norm: "Largest error of the number of discs that move after each step",
        origin: Origin::Exact,
        reason: "Counts",
        effort: Effort::Quick,
        measure: sound,
    }]
}

const DISCS: usize = 60;

/// Number of moving discs after each step.
fn front(sweeps: usize, is_against: bool) -> Result<Vec<usize>, Failure> {
    let mut settings = exact_steps(1e-3, law(0.0, 0.0, GapRule::Closed));
    settings.sweeps.order = SweepOrder::Forward;
    settings.sweeps.max_sweeps = sweeps;
    let mut system = System::new(settings);
    let pushed = if is_against { DISCS - 1 } else { 0 };
    for k in 0..DISCS {
        let speed = match (k == pushed, is_against) {
            (false, _) => 0.0,
            (true, true) => -1e-3,
            (true, false) => 1e-3,
        };
        // A small overlap keeps the points closed.
        let at = [(1.0 - 1e-6) * k as f64, 0.0];
        system.body(0, 0.5, at, 0.0, moving(speed, 0.0, 0.0))?;
    }
    let mut counts = Vec::new();
    for _ in 0..12 {
        system.step();
        let velocities = &system.state.configuration.velocity;
        let moving = velocities.iter().filter(|v| v.linear.x != 0.0);
        counts.push(moving.count());
    }
    Ok(counts)
}

fn sound() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for sweeps in [1, 2, 5, 10] {
        let counts = front(sweeps, true)?;
        let numbered = || counts.iter().enumerate().map(|(k, &count)| (k + 1, count));
        for (step, count) in numbered() {
            let expected = (1 + sweeps * step).min(DISCS);
            all.push(Measurement::absolute(expected as f64, count as f64, 0.0));
        }
        let points = numbered().map(|(step, count)| [step as f64, count as f64]);
        let label = format!("sweeps per step: {sweeps}, against the order");
        curves.push(Curve::marked_line(&label, points));
    }
    let counts = front(1, false)?;
    all.push(Measurement::absolute(DISCS as f64, counts[0] as f64, 0.0));
    let points = counts.iter().enumerate();
    let points = points.map(|(k, &count)| [k as f64 + 1.0, count as f64]);
    curves.push(Curve::marked_line(
        "sweeps per step: 1, in the order",
        points,
    ));
    let figure = Figure::new(
        "How far a pulse has gone through a chain of 60 discs: with early ends of sweeps, rigid bodies behave like an elastic medium whose sound goes as many discs per step as there are sweeps",
        Axis::linear("step", ""),
        Axis::linear("moving discs", ""),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure)]))
}
