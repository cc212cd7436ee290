//! Loads at which a beam breaks.

use super::{BEAM, STIFFNESS};
use crate::checks::scenes::{head, particle, world};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Plot,
};
use gouge_kernel::World;
use std::f64::consts::{PI, TAU};

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "beams.breaking",
        claim: "A beam of granite breaks on the ellipse of Zhang and Eckert: at 879.646 N along and 527.788 N across for 1 mm, in tension and compression alike.",
        equations: "(46)-(50)",
        scene: "Two bonded 1 mm beads at rest whose bond began at another distance and other angles, in 16 directions of the load; the load is brought to the break by bisection",
        oracle: "pi r^2 times the strengths, as the semi-axes of the ellipse",
        norm: "Relative difference of the load at break",
        origin: Origin::Exact,
        reason: "The elongation of up to 88 um and the bending of 0.05 rad are differences of numbers of order 2 mm and pi: 1e-14 each, and ten roundings",
        effort: Effort::Quick,
        measure: breaking,
    }]
}

const R: f64 = 1e-3;
const STRENGTH: [f64; 2] = [280e6, 168e6];

/// Whether a beam under a force along and across it breaks.
fn breaks(along: f64, across: f64) -> Result<bool, Failure> {
    // Both ends bent by alpha: torques k r^2 alpha each, and their sum over the distance 2 r.
    let (distance, bent) = (2.0 * R - along / STIFFNESS, across / (STIFFNESS * R));
    let text = head("euler", 1e-9)
        + BEAM
        + &format!(
            "[bond.yielding]\nlaw = \"zhang-eckert\"\nnormal_strength = {:e}\ntangential_strength = {:e}\n",
            STRENGTH[0], STRENGTH[1]
        )
        + &particle([0.0, 0.0], [0.0, 0.0], 0.0, R)
        + &particle([2.0 * R, 0.0], [0.0, 0.0], 0.0, R)
        + &format!(
            "[[bonds]]\nbetween = [0, 1]\ninitial_distance = {distance:e}\ninitial_angles = [{:e}, {:e}]\n",
            bent,
            bent - PI
        );
    let mut world: World = world(&text)?;
    world.evaluate_if_pending()?;
    Ok(world
        .strong_links()
        .is_some_and(|strong| strong.links.is_empty()))
}

fn breaking() -> Outcome {
    let axes = STRENGTH.map(|strength| PI * R * R * strength);
    let (mut worst, mut found) = (Vec::new(), Vec::new());
    for direction in 0..16 {
        let angle = TAU * f64::from(direction) / 16.0;
        let load = [axes[0] * angle.cos(), axes[1] * angle.sin()];
        let (mut low, mut high) = (0.5, 2.0);
        for _ in 0..48 {
            let middle = 0.5 * (low + high);
            if breaks(middle * load[0], middle * load[1])? {
                high = middle;
            } else {
                low = middle;
            }
        }
        worst.push(Measurement::relative(1.0, high, 2e-13));
        found.push([high * load[0], high * load[1]]);
    }
    let ellipse = (0..=120).map(|n| {
        let angle = TAU * f64::from(n) / 120.0;
        [axes[0] * angle.cos(), axes[1] * angle.sin()]
    });
    let plot = Plot {
        title: "Loads at which a beam of 1 mm granite breaks".to_owned(),
        x: Axis::linear("force along in N"),
        y: Axis::linear("force across in N"),
        curves: vec![
            Curve::line("pi r^2 times the strengths", ellipse),
            Curve::marks("kernel", found),
        ],
    };
    Ok(Measurement::worst(worst).showing([Exhibit::Plot(plot)]))
}
