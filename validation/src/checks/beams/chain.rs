//! Waves in a chain.

use super::{BEAM, STIFFNESS};
use crate::checks::scenes::{head, particle, world};
use crate::checks::time_step::network::linearise;
use crate::checks::{Axis, Check, Curve, Effort, Exhibit, Measurement, Origin, Outcome, Plot};
use crate::oracles::beads;
use gouge_kernel::World;
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "beams.chain",
        claim: "Waves in a ring of beads have the three branches of the closed form: w = 2 sqrt(k/m) |sin(q D/2)| along it, and two of bending and turning; long waves along it travel at D sqrt(k/m).",
        equations: "(43)-(45), (64)",
        scene: "Twenty-four 1 mm beads in touch around a periodic box, at rest; eigenvalues of the kernel's own stiffness matrix by dual numbers",
        oracle: "Squared frequencies of plane waves from the energy, a number and a two-by-two matrix for each wave number",
        norm: "Largest difference of a squared frequency in units of the largest",
        origin: Origin::Exact,
        reason: "Rounding of entries, and of an eigenvalue decomposition of 72 unknowns: some ten units of the largest",
        effort: Effort::Quick,
        measure: chain,
    }]
}

const BEADS: usize = 24;

fn chain() -> Outcome {
    let mut text = head("euler", 1e-9)
        + BEAM
        + &format!(
            "[box]\nwidth = {:e}\nboundary = \"periodic-x\"\n",
            2e-3 * BEADS as f64
        );
    for i in 0..BEADS {
        text += &particle([2e-3 * i as f64, 0.0], [0.0, 0.0], 0.0, 1e-3);
        text += &format!("[[bonds]]\nbetween = [{i}, {}]\n", (i + 1) % BEADS);
    }
    let world: World = world(&text)?;
    let (mass, inertia) = (
        world.particles().mass[0],
        world.particles().moment_of_inertia[0],
    );
    let found = linearise(&world, *world.model())?
        .network
        .squared_frequencies();
    let exact = beads::ring(BEADS, STIFFNESS, mass, inertia, 1e-3);
    let largest = exact[exact.len() - 1];
    let pairs = exact.iter().zip(&found);
    let measured = pairs.map(|(&exact, &found)| Measurement::scaled(exact, found, largest, 1e-14));
    let branch = |which: usize| {
        let at = move |n: usize| {
            let phase = PI * n as f64 / 60.0;
            let mut squared = beads::branches(phase, STIFFNESS, mass, inertia, 1e-3);
            squared[1..].sort_by(f64::total_cmp);
            [phase, squared[which].max(0.0).sqrt()]
        };
        (0..=60).map(at)
    };
    // Each frequency of the ring stands at the wave number at which a branch comes closest to it.
    let plot = Plot {
        title: "Waves in a chain of beads: three branches, and the frequencies of a ring of twenty-four".to_owned(),
        x: Axis::linear("phase per bead in rad"),
        y: Axis::linear("angular frequency in 1/s"),
        curves: vec![
            Curve::line("along the chain", branch(0)),
            Curve::line("across the chain, soft", branch(1)),
            Curve::line("across the chain, stiff", branch(2)),
            Curve::marks("kernel", marks(&found, mass, inertia)),
        ],
    };
    Ok(Measurement::worst(measured).showing([Exhibit::Plot(plot)]))
}

fn marks(found: &[f64], mass: f64, inertia: f64) -> Vec<[f64; 2]> {
    let waves = (0..=BEADS / 2).map(|n| 2.0 * PI * n as f64 / BEADS as f64);
    let candidates: Vec<[f64; 2]> = waves
        .flat_map(|phase| {
            beads::branches(phase, STIFFNESS, mass, inertia, 1e-3).map(|squared| [phase, squared])
        })
        .collect();
    let nearest = |&squared: &f64| {
        let distance = |candidate: &&[f64; 2]| (candidate[1] - squared).abs();
        let best = candidates
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)));
        best.map(|candidate| [candidate[0], squared.max(0.0).sqrt()])
    };
    found.iter().filter_map(nearest).collect()
}
