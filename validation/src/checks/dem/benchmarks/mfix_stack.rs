//! MFiX DEM03: two spheres compressed between walls.

use super::plane::linear;
use crate::checks::dem::scenes::advance;
use crate::checks::extrapolation::to_no_step;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};
use crate::oracles::bounce::Stack;
use crate::oracles::impact::damping_ratio;
use crate::scenes::{Draft, Grain};
use gouge_dem::integrators::Integrator;
use std::f64::consts::PI;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "benchmarks.mfix.03",
        claim: "DEM03: two spheres compressed between walls oscillate, and with damping come to rest, like the linear system of their contacts.",
        equations: thesis("(8)-(10), (26), (35)-(36)"),
        scene: "Spheres of 1 mm diameter, 20000 and 10000 kg/m^3, between walls 1.8 mm apart, k = 1000 N/m, damping for e = 1, 0.8 and 0.5 of the pair, 1 ms; walls are fixed spheres on the same line, which is the same geometry; 4000 to 16000 steps, extrapolated",
        oracle: "Matrix exponential of the linear system",
        norm: "Largest error of a height in units of the initial displacement from equilibrium, at eight times",
        origin: Origin::Convergent,
        reason: "No contact opens, so the error is a series in dt starting at dt^2. Extrapolation from three time steps leaves 0.018 of its term in dt^4; for the coarsest, (w dt)^4 = 8e-10, times at most the phase of 21",
        effort: Effort::Quick,
        measure: stack,
    }]
}

const GRAVITY: f64 = 9.81;

/// Initial heights of DEM03 in m.
const HEIGHTS: [f64; 2] = [0.45e-3, 1.35e-3];
/// Number of equally spaced comparison times within the millisecond.
const MOMENTS: u64 = 8;

fn stack() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    let mut table = Table::new(
        "Heights of the two spheres of DEM03",
        &[
            "restitution",
            "time (ms)",
            "lower (m)",
            "kernel",
            "upper (m)",
            "kernel",
        ],
    );
    for e in [1.0, 0.8, 0.5] {
        let stack = pressed(e);
        let levels = [500, 1000, 2000]
            .iter()
            .map(|&steps| stacked(&stack, steps))
            .collect::<Result<Vec<_>, Failure>>()?;
        let best = to_no_step(levels, &[2, 3]);
        for (n, measured) in best.iter().enumerate() {
            let time = 1e-3 * (n + 1) as f64 / MOMENTS as f64;
            let expected = stack.state(HEIGHTS, time);
            for at in 0..2 {
                all.push(Measurement::scaled(
                    expected[at],
                    measured[at],
                    FIRST_DISPLACEMENT,
                    3e-10,
                ));
            }
            table.push([
                format!("{e}"),
                format!("{:.3}", 1e3 * time),
                format!("{:.12e}", expected[0]),
                format!("{:.12e}", measured[0]),
                format!("{:.12e}", expected[1]),
                format!("{:.12e}", measured[1]),
            ]);
        }
        for (at, name) in ["lower", "upper"].iter().enumerate() {
            let label = format!("{name}, e = {e}");
            curves.extend(heights(&label, &stack, &best, at));
        }
    }
    let plot = Figure::new(
        "Two compressed spheres oscillate about equilibrium, and settle with damping",
        Axis::linear("time", "ms"),
        Axis::linear("height", "mm"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Table(table), Exhibit::Figure(plot)]))
}

/// Heights of one sphere in mm over time in ms, from the oracle and from the kernel.
fn heights(label: &str, stack: &Stack, measured: &[[f64; 2]], at: usize) -> [Curve; 2] {
    let line = (0..=100).map(|n| 1e-5 * f64::from(n));
    let marks = measured.iter().enumerate();
    [
        Curve::line(
            &format!("oracle: {label}"),
            line.map(|t| [1e3 * t, 1e3 * stack.state(HEIGHTS, t)[at]]),
        ),
        Curve::marks(
            &format!("kernel: {label}"),
            marks.map(|(n, y)| [(n + 1) as f64 / MOMENTS as f64, 1e3 * y[at]]),
        ),
    ]
}

/// Approximate initial distance of the lower sphere from equilibrium in m.
const FIRST_DISPLACEMENT: f64 = 1.7e-5;

/// DEM03 with the damping for which the pair alone would have the given restitution.
fn pressed(e: f64) -> Stack {
    let volume = 4.0 / 3.0 * PI * 0.5e-3_f64.powi(3);
    let masses = [2e4 * volume, 1e4 * volume];
    let reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
    Stack {
        masses,
        radius: 0.5e-3,
        height: 1.8e-3,
        stiffness: 1e3,
        damping: 2.0 * damping_ratio(e) * (1e3 * reduced).sqrt(),
        gravity: GRAVITY,
    }
}

/// The kernel's heights at every comparison time, with the given number of steps in between.
fn stacked(stack: &Stack, steps: u64) -> Result<Vec<[f64; 2]>, Failure> {
    let r = stack.radius;
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-3 / (MOMENTS * steps) as f64)
        .grain(Grain::at([0.0, HEIGHTS[0]], r).of_density(2e4))
        .grain(Grain::at([0.0, HEIGHTS[1]], r).of_density(1e4))
        .grain(Grain::at([0.0, -r], r).fixed())
        .grain(Grain::at([0.0, stack.height + r], r).fixed())
        .and(&linear(stack.stiffness, stack.damping))
        .gravity(GRAVITY);
    let mut world = draft.world()?;
    let mut rows = Vec::new();
    for _ in 0..MOMENTS {
        advance(&mut world, steps)?;
        let p = world.particles();
        rows.push([p.position[0].y, p.position[1].y]);
    }
    Ok(rows)
}
