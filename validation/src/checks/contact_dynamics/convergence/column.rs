//! Sweeps over a column of discs.

use super::super::system::{System, exact_steps, law, moving};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use crate::oracles::contact_dynamics::bodies::column_rate;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::sweep::{StopCriterion, SweepOrder};

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.convergence.column",
        claim: "In a column of n discs, a forward sweep reduces the error by cos^2(pi/2n): the number of sweeps grows with the square of the height and the logarithm of the tolerance.",
        equations: azema("(A15), (A18), (A27), C4"),
        scene: "Columns of 4 to 32 discs on a floor without friction, from impulses of zero; residuals after 1.5 n^2 and 2.5 n^2 forward sweeps",
        oracle: "Gauss-Seidel iteration of a tridiagonal matrix: the square of the largest eigenvalue of the Jacobi iteration",
        norm: "Largest error of the rate, in units of 1 - rate",
        origin: Origin::Exact,
        reason: "After 1.5 n^2 sweeps the next eigenvector has decayed to exp(-30) of the first one; the last residual is 2e-3 of the first velocities of up to 1e-2 m/s, whose rounding error is 2e-18 m/s: 1e-13, and n^2 sweeps between them times 1 - rate are 2.5",
        effort: Effort::Quick,
        measure: column,
    }]
}

const GRAVITY: f64 = 1.0;
const STEP: f64 = 1e-2;

/// A column at rest whose sweeps end at a residual in m/s, or after a number of sweeps.
fn solve(discs: usize, order: SweepOrder, stop: f64, most: usize) -> Result<(usize, f64), Failure> {
    let mut settings = exact_steps(STEP, law(0.0, 0.0, GapRule::Predicted));
    settings.sweeps.order = order;
    settings.sweeps.stop = StopCriterion::NaturalMap { velocity: stop };
    settings.sweeps.max_sweeps = most;
    let mut system = System::new(settings);
    for k in 0..discs {
        let rest = moving(0.0, 0.0, 0.0);
        system.body(0, 0.5, [0.0, 0.5 + k as f64], 0.0, rest)?;
    }
    system.floor()?;
    system.gravity([0.0, -GRAVITY]);
    let report = system.step();
    let velocities = &system.state.configuration.velocity;
    let residual = system.workspace().map(|w| w.solver().residual(velocities));
    Ok((report.sweeps.sweeps, residual.unwrap_or(f64::NAN)))
}

fn column() -> Outcome {
    let mut all = Vec::new();
    for discs in [4_usize, 7, 12, 20, 32] {
        let (first, more) = (3 * discs * discs / 2, discs * discs);
        let order = SweepOrder::Forward;
        let (_, before) = solve(discs, order, 0.0, first)?;
        let (_, after) = solve(discs, order, 0.0, first + more)?;
        let rate = (after / before).powf(1.0 / more as f64);
        let expected = column_rate(discs);
        all.push(Measurement::scaled(expected, rate, 1.0 - expected, 1e-9));
    }
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure()?)]))
}

/// Sweeps against the height, for some tolerances.
fn figure() -> Result<Figure, Failure> {
    let heights = [3_usize, 5, 8, 12, 20, 32];
    let mut curves = Vec::new();
    for tolerance in [1e-2, 1e-6] {
        let stop = tolerance * GRAVITY * STEP;
        for (order, name) in [
            (SweepOrder::Forward, "forward"),
            (SweepOrder::Alternating, "alternating"),
        ] {
            let mut points = Vec::new();
            for discs in heights {
                let (sweeps, _) = solve(discs, order, stop, 1_000_000)?;
                points.push([discs as f64, sweeps as f64]);
            }
            let label = format!("{name}, residual {tolerance:.0e} g dt");
            curves.push(Curve::marks(&label, points));
        }
        let theory = heights.map(|discs| {
            let sweeps = tolerance.ln() / column_rate(discs).ln();
            [discs as f64, sweeps]
        });
        let label = format!("ln {tolerance:.0e}/ln cos^2(pi/2n)");
        curves.push(Curve::dashed(&label, theory));
    }
    Ok(Figure::new(
        "Sweeps from impulses of zero for a column of discs",
        Axis::logarithmic("discs", ""),
        Axis::logarithmic("sweeps", ""),
        curves,
    ))
}
