//! The error of velocities with the number of sweeps.

use super::super::one_step::Problem;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use crate::references::OneStep;
use gouge_contact_dynamics::sweep::SweepOrder;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.convergence.sweeps",
        claim: "Velocities converge to those of Siconos with the sweeps, and the residual of the laws bounds their error.",
        equations: azema("(A16)-(A22), (A27), E13"),
        scene: "Five stored steps of Siconos from impulses of zero, after 1, 2, 4, ... 8192 sweeps, or until the residual is 1e-12 of the largest velocity",
        oracle: "Siconos 4.4.0, stored in references/siconos/one-step",
        norm: "Largest ratio of the velocity error to the residual, in units of the square of the number of points",
        origin: Origin::Convergent,
        reason: "A residual is enlarged by the inverse of the response; in a row of n points, the largest eigenvalue of the inverse is (2n/pi)^2 < n^2, and a row is the slowest arrangement",
        effort: Effort::Thorough,
        measure: sweeps,
    }]
}

const NAMES: [&str; 5] = [
    "column-of-squares",
    "wall-of-bricks",
    "pile-of-discs",
    "pile-of-hexagons",
    "pushed-discs",
];

fn sweeps() -> Outcome {
    let (mut all, mut errors, mut by_cost) = (Vec::new(), Vec::new(), Vec::new());
    let mut residuals = Vec::new();
    let stored = OneStep::all().map_err(Failure::Oracle)?;
    for step in stored.iter().filter(|s| NAMES.contains(&s.name.as_str())) {
        let problem = Problem::new(step);
        let points = step.points.len() as f64;
        let mut curve: Vec<[f64; 3]> = Vec::new();
        for exponent in 0..14 {
            let most = 1 << exponent;
            let found = problem.solve(false, 1e-12, most, SweepOrder::Alternating);
            let error = problem.velocity_error(&found);
            // Below this, both programs differ by rounding.
            let judged = (error - 1e-11).max(0.0) / found.residual / (points * points);
            all.push(Measurement::absolute(0.0, judged, 1.0));
            curve.push([found.report.sweeps as f64, error, found.residual]);
            if found.report.has_converged {
                break;
            }
        }
        let pick = |column: usize, factor: f64| -> Vec<[f64; 2]> {
            curve.iter().map(|c| [factor * c[0], c[column]]).collect()
        };
        errors.push(Curve::marked_line(&step.name, pick(1, 1.0)));
        residuals.push(Curve::marked_line(&step.name, pick(2, 1.0)));
        by_cost.push(Curve::marked_line(&step.name, pick(1, points)));
    }
    let error = || Axis::logarithmic("largest velocity error", "largest velocity");
    let figures = [
        Figure::new(
            "Error of velocities with the number of sweeps",
            Axis::logarithmic("sweeps", ""),
            error(),
            errors,
        ),
        Figure::new(
            "Residual of the laws (natural map) with the number of sweeps",
            Axis::logarithmic("sweeps", ""),
            Axis::logarithmic("residual", "largest velocity"),
            residuals,
        ),
        Figure::new(
            "Error of velocities with the number of updates of single points, a cost that does not depend on the machine",
            Axis::logarithmic("updates of points", ""),
            error(),
            by_cost,
        ),
    ];
    Ok(Measurement::worst(all).showing(figures.map(Exhibit::Figure)))
}
