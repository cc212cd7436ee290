//! Steps of many bodies against Siconos.

use super::one_step::Problem;
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, azema};
use crate::references::OneStep;
use gouge_contact_dynamics::sweep::SweepOrder;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.siconos.fixed-points",
            claim: "The solutions of Siconos satisfy the laws as this program states them, and sweeps leave them where they are.",
            equations: azema("(A1)-(A5), (A10)-(A22), E3, E4, E5"),
            scene: "13 steps of 8 to 200 bodies with up to 701 points: piles, columns, bricks, collisions with restitution, sheared cells, open gaps; sweeps begin with the impulses of Siconos",
            oracle: "Siconos 4.4.0, stored in references/siconos/one-step, each solution with a residual below 1e-11",
            norm: "Largest difference of a velocity after no sweep and after 20 sweeps, in units of the largest velocity without impulses",
            origin: Origin::Exact,
            reason: "Without sweeps, rounding of velocities of 1e3 impulses that are up to 1e3 times the largest momentum: 1e-10. Each of 20 sweeps may change a velocity by the residual of 1e-11: 1e-9",
            effort: Effort::Quick,
            measure: fixed_points,
        },
        Check {
            id: "contact-dynamics.siconos.from-nothing",
            claim: "Sweeps that begin without impulses find the velocities of Siconos, and its impulses where all its solves agree about them.",
            equations: azema("(A1)-(A5), (A10)-(A22), (A27), E3, E4, E5"),
            scene: "The same steps up to 130 points; sweeps end at a residual of 1e-12 of the largest velocity",
            oracle: "Siconos 4.4.0, stored in references/siconos/one-step",
            norm: "Largest difference of a velocity in units of the largest velocity without impulses, and of an impulse in units of the largest one",
            origin: Origin::Convergent,
            reason: "The certified solves of Siconos agree to 1e-9. A residual of 1e-12 is enlarged by the largest eigenvalue of the inverse response, n^2 for n points in a row: 1e4 for a hundred points, and 1e-8 with either solver's",
            effort: Effort::Thorough,
            measure: from_nothing,
        },
    ]
}

fn fixed_points() -> Outcome {
    let mut all = Vec::new();
    for stored in OneStep::all().map_err(Failure::Oracle)? {
        let problem = Problem::new(&stored);
        for (sweeps, bound) in [(0, 1e-10), (20, 1e-9)] {
            let found = problem.solve(true, 1e-15, sweeps, SweepOrder::Alternating);
            let error = problem.velocity_error(&found);
            all.push(Measurement::absolute(0.0, error, bound));
            all.push(Measurement::absolute(0.0, found.residual, bound));
        }
    }
    Ok(Measurement::worst(all).into())
}

/// Largest number of points that are solved from nothing.
const MOST_POINTS: usize = 130;

fn from_nothing() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Steps solved from nothing, to a residual of 1e-12",
        &[
            "step",
            "points",
            "sweeps",
            "velocity error",
            "impulse error",
            "spread of Siconos",
        ],
    );
    let stored = OneStep::all().map_err(Failure::Oracle)?;
    for stored in stored.iter().filter(|s| s.points.len() <= MOST_POINTS) {
        let problem = Problem::new(stored);
        let found = problem.solve(false, 1e-12, 200_000, SweepOrder::Alternating);
        let errors = [
            problem.velocity_error(&found),
            problem.impulse_error(&found),
        ];
        all.extend(errors.map(|error| Measurement::absolute(0.0, error, 1e-8)));
        let is_open = !found.report.has_converged;
        all.push(Measurement::count(usize::from(is_open)));
        table.push([
            stored.name.clone(),
            format!("{}", stored.points.len()),
            format!("{}", found.report.sweeps),
            format!("{:.1e}", errors[0]),
            format!("{:.1e}", errors[1]),
            format!("{:.1e}", stored.spread),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}
