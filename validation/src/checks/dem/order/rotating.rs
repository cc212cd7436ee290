//! Order on a bonded pair that stretches, bends and rotates.

use crate::checks::dem::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::bonded_pair::{Beam, State};
use crate::oracles::flow::Flow;
use crate::scenes::{Bond, Draft, Grain};
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli};
use gouge_runner::scene::INTEGRATORS;
use std::f64::consts::PI;

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "order.rotating",
        claim: "On a bonded pair that rotates by one and a half radians while it stretches, shears and bends, with and without damping, the errors of all five integrators fall with the theoretical orders; extrapolated to zero time step, the results agree with theory.",
        equations: thesis("(29)-(34), (43)-(45), (54)-(58)"),
        scene: "Two grains of 1 mm with granite's bond, stretched by a twentieth, with a bending stiffness of 0.8 times the normal stiffness; duration four times sqrt(m/k)",
        oracle: "Lagrange's equations of the pair in polar coordinates, by extrapolated midpoint steps to 1e-13",
        norm: "Largest distance of an order, observed between 3200 and 6400 steps, from the theoretical order; error left after two extrapolations, in radii and rad, over 1e-3 of the error with 6400 steps plus 1e-11",
        origin: Origin::Convergent,
        reason: "The next term of the error is smaller by about the time step, 6e-4 of the time scale, with a factor of a few units; the term after it is smaller by the square of that",
        effort: Effort::Quick,
        measure: rotating,
    }]
}

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 1e7;
const BENDING: f64 = 0.8;
/// Length of the bond at rest in radii; the bond is initially stretched.
const REST: f64 = 1.9;
const END: f64 = 4.0;
/// Initial angle of the line of centres, so that the bond is not aligned with an axis.
const TILT: f64 = 0.3;
/// Initial rates of the distance, the line of centres and both spheres, in radii and rad per unit of
/// time.
const RATES: [f64; 4] = [0.2, 0.4, 0.1, -0.3];

/// Unit of time in s: sqrt(m/k).
fn unit() -> f64 {
    (4.0 / 3.0 * PI * 2700.0 * RADIUS.powi(3) / STIFFNESS).sqrt()
}

/// Distance, angle of the line of centres and angles of both spheres at the end, from the kernel.
fn end(integrator: &str, beam: Beam, steps: u64) -> Result<[f64; 4], Failure> {
    let time = unit();
    let [stretching, turning, spin, other] = RATES;
    let (sine, cosine) = TILT.sin_cos();
    // The centres are one radius from the origin; the relative velocity is split in halves.
    let (radial, transversal) = (0.5 * stretching * RADIUS / time, turning * RADIUS / time);
    let velocity = [
        radial * cosine - transversal * sine,
        radial * sine + transversal * cosine,
    ];
    let place = [RADIUS * cosine, RADIUS * sine];
    let damping = beam.damping * STIFFNESS * time;
    let bending = beam.bending_damping * STIFFNESS * time;
    let draft = Draft::open_box(integrator, END * time / steps as f64)
        .law(AdjustedKelvinVoigt {
            stiffness: STIFFNESS,
            damping,
        })
        .law(EulerBernoulli {
            stiffness: beam.bending * STIFFNESS,
            damping: bending,
        })
        .bond(Bond::between(0, 1).of_length(REST * RADIUS))
        .with("output.energy", false)
        .grain(
            Grain::at(place.map(|x| -x), RADIUS)
                .moving(velocity.map(|v| -v))
                .spinning(spin / time),
        )
        .grain(
            Grain::at(place, RADIUS)
                .moving(velocity)
                .spinning(other / time),
        );
    let mut world = draft.world()?;
    advance(&mut world, steps)?;
    let p = world.particles();
    let line = p.position[1] - p.position[0];
    Ok([
        line.norm() / RADIUS,
        line.y.atan2(line.x) - TILT,
        p.angle[0],
        p.angle[1],
    ])
}

/// The same from Lagrange's equations.
fn expected(beam: Beam) -> [f64; 4] {
    let [a, b, c, d] = RATES;
    let start: State = [2.0, 0.0, 0.0, 0.0, a, b, c, d];
    let flow = Flow {
        rate: |_: f64, state: &State| beam.rate(state),
        tolerance: 1e-14,
    };
    let [distance, line, first, second, ..] = flow.advance(start, END);
    [distance, line, first, second]
}

fn distance(a: [f64; 4], b: [f64; 4]) -> f64 {
    (0..4).map(|n| (a[n] - b[n]).powi(2)).sum::<f64>().sqrt()
}

/// Richardson extrapolation of results whose steps differ by a factor of two and whose error has the
/// given order.
fn extrapolated(order: f64, coarse: [f64; 4], fine: [f64; 4]) -> [f64; 4] {
    let weight = 1.0 / (2.0_f64.powf(order) - 1.0);
    std::array::from_fn(|n| fine[n] + weight * (fine[n] - coarse[n]))
}

fn rotating() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    let elastic = Beam {
        rest: REST,
        bending: BENDING,
        damping: 0.0,
        bending_damping: 0.0,
    };
    let damped = Beam {
        damping: 0.5,
        bending_damping: 0.3,
        ..elastic
    };
    for (beam, damping_name) in [(elastic, "elastic"), (damped, "damped")] {
        let exact = expected(beam);
        for ((name, _), order) in INTEGRATORS.iter().zip([1.0, 1.0, 1.0, 2.0, 2.0]) {
            let steps = [400, 800, 1600, 3200, 6400];
            let ends = steps
                .iter()
                .map(|&steps| end(name, beam, steps))
                .collect::<Result<Vec<_>, Failure>>()?;
            let errors: Vec<f64> = ends.iter().map(|&end| distance(end, exact)).collect();
            let found = (errors[3] / errors[4]).log2();
            all.push(Measurement::absolute(order, found, 0.01));
            let coarse = extrapolated(order, ends[2], ends[3]);
            let fine = extrapolated(order, ends[3], ends[4]);
            let limit = extrapolated(order + 1.0, coarse, fine);
            let left = distance(limit, exact);
            all.push(Measurement::absolute(0.0, left, 1e-3 * errors[4] + 1e-11));
            let points = steps
                .iter()
                .zip(&errors)
                .map(|(&n, &e)| [END / n as f64, e]);
            curves.push(Curve::marked_line(
                &format!("{name}, {damping_name}"),
                points,
            ));
        }
    }
    let plot = Figure::new(
        "Errors of a rotating bonded pair fall with the order of each integrator",
        Axis::logarithmic("time step in units of sqrt(m/k)", ""),
        Axis::logarithmic("error at the end in radii and rad", ""),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}
