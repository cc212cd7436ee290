//! MFiX DEM05: a sphere on linear springs hits a plane obliquely.

use super::literature;
use super::plane::{Flight, OnPlane, material};
use super::sweep::step_errors;
use crate::checks::dem::scenes::advance;
use crate::checks::extrapolation::to_no_step;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};
use crate::oracles::impact::{Normal, Tangential};
use gouge_common::scalar::Real;
use gouge_scalars::DoubleDouble;
use std::f64::consts::PI;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.mfix.05-stick",
            claim: "DEM05: if a linear contact sticks throughout, the velocity of the contact point changes by the factor cos(pi sqrt((7/2) k_t / k_n)).",
            equations: thesis("(35)-(36), (42)"),
            scene: "A sphere of aluminium oxide on a plane at 45 degrees, undamped Kelvin-Voigt, truncated Cundall-Strack with mu = 1e15; k_t / k_n = 2/7, 0.8605, 1 and 10; time steps chosen so that the contact ends on a step",
            oracle: "Two springs: half a period of one is sqrt((7/2) k_t / k_n) half periods of the other",
            norm: "Error of the ratio, extrapolated to zero time step from 64 to 1024 steps",
            origin: Origin::Convergent,
            reason: "If half a period is a whole number of steps, w dt = 2 sin(pi / 2 n), the error is a series in n^-2. Extrapolation from five runs leaves 1e-6 of its term in (18.6 / n)^10, 4e-12 with 64 steps. Ending the contact 1e-13 early, to keep it closed, adds 2e-12. The tolerance is ten times that, for the coefficients",
            effort: Effort::Quick,
            measure: sticking,
        },
        Check {
            id: "benchmarks.mfix.05",
            claim: "DEM05: whole curves of oblique impact with linear springs, and 1 - 0.184 cot(theta) where the contact slides throughout.",
            equations: thesis("(35)-(36), (42)"),
            scene: "A sphere of 5 mm diameter and 4000 kg/m^3 at 3.9 m/s, 5 to 65 degrees, k_n = 1.72e7, k_t = 1.48e7 N/m, mu = 0.092, e = 1; 1500 steps per collision",
            oracle: "High-order integration between located events; above 35 degrees the closed form",
            norm: "Error of normal and tangential velocity and surface speed, in units of the normal speed; the one closest to its tolerance",
            origin: Origin::Convergent,
            reason: "As in test 4 of Chung and Ooi. Where the contact slides throughout, the closed form to 1e-8: without damping, half a sine wave of steps loses speed only in the step in which it ends, (pi / n)^3 / 6",
            effort: Effort::Quick,
            measure: oblique,
        },
    ]
}

const NORMAL: f64 = 1.72e7;
const TANGENTIAL: f64 = 1.48e7;

fn contact(ratio: f64, friction: f64) -> OnPlane {
    OnPlane {
        material: material("aluminium oxide", [3.8e11, 0.23], 4000.0),
        radius: 0.0025,
        normal: Normal::Linear([NORMAL, 0.0]),
        tangential: Tangential::Spring([friction, ratio * NORMAL]),
    }
}

/// Slip after half a period over slip before, with the given number of steps.
fn stuck(ratio: f64, steps: u64) -> Result<f64, Failure> {
    let contact = contact(ratio, 1e15);
    let before = Flight {
        along: 2.0,
        normal: 2.0,
        spin: 0.0,
    };
    let phase = 2.0 * (0.5 * PI / steps as f64).sin();
    let step = phase * (contact.mass() / NORMAL).sqrt() * (1.0 - 1e-13);
    let mut world = contact
        .scene_with_step(before, step)
        .world_in::<DoubleDouble>()?;
    advance(&mut world, steps)?;
    let p = world.particles();
    let slip = p.velocity[0].x.to_f64() + contact.radius * p.angular_velocity[0].to_f64();
    Ok(slip / before.along)
}

fn sticking() -> Outcome {
    let mut table = Table::new(
        "Slip after a collision without sliding, over slip before",
        &["k_t / k_n", "expected", "kernel, extrapolated"],
    );
    let mut all = Vec::new();
    for ratio in [2.0 / 7.0, TANGENTIAL / NORMAL, 1.0, 10.0] {
        let levels = [64, 128, 256, 512, 1024]
            .iter()
            .map(|&steps| Ok(vec![[stuck(ratio, steps)?]]))
            .collect::<Result<Vec<_>, Failure>>()?;
        let best = to_no_step(levels, &[2, 4, 6, 8])[0][0];
        let expected = (PI * (3.5 * ratio).sqrt()).cos();
        all.push(Measurement::absolute(expected, best, 6e-11));
        table.push([
            format!("{ratio:.6}"),
            format!("{expected:.12}"),
            format!("{:.12}", best),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn oblique() -> Outcome {
    const STEPS: u64 = 1500;
    let contact = contact(TANGENTIAL / NORMAL, 0.092);
    let (mut all, mut line, mut marks) = (Vec::new(), Vec::new(), Vec::new());
    let mut table = Table::new(
        "Tangential restitution of DEM05",
        &["angle (deg)", "expected", "kernel", "1 - 0.184 cot(theta)"],
    );
    for n in 1..=13 {
        let degrees = 5.0 * f64::from(n);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let before = Flight {
            along: 3.9 * sin,
            normal: 3.9 * cos,
            spin: 0.0,
        };
        let (a, b) = (contact.expected(before)?, contact.measured(before, STEPS)?);
        let step = contact.duration(before.normal) / STEPS as f64;
        let [normal, along] = step_errors(&contact.impact(), before.normal, before.along, step);
        let turning = before.normal / contact.radius;
        all.push(Measurement::scaled(
            a.normal,
            b.normal,
            before.normal,
            normal,
        ));
        all.push(Measurement::scaled(a.along, b.along, before.normal, along));
        all.push(Measurement::scaled(a.spin, b.spin, turning, 2.5 * along));
        let slides = 1.0 - 0.184 / degrees.to_radians().tan();
        let restitution = b.along / before.along;
        if degrees > 35.0 {
            all.push(Measurement::absolute(slides, restitution, 1e-8));
        }
        line.push([degrees, a.along / before.along]);
        marks.push([degrees, restitution]);
        table.push([
            format!("{degrees:.0}"),
            format!("{:.10}", a.along / before.along),
            format!("{restitution:.10}"),
            format!("{slides:.10}"),
        ]);
    }
    let measured = literature::OBLIQUE_MEASURED;
    let plot = Figure::new(
        "Below the angle of sliding, linear springs do not reproduce the minimum seen in the experiment",
        Axis::linear("angle of impact", "deg"),
        Axis::linear("tangential restitution", ""),
        vec![
            Curve::line("oracle", line),
            Curve::marks("kernel", marks),
            Curve::marks(
                "literature: experiment of Kharaz et al., digitised",
                measured,
            ),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Table(table), Exhibit::Figure(plot)]))
}
