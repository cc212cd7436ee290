//! A row of beads, clamped at one end and loaded at the other.

use super::{BEAM, STIFFNESS};
use crate::checks::scenes::{head, particle, world};
use crate::checks::time_step::network::linearise;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Plot,
};
use crate::oracles::beads::deflection;
use gouge_kernel::World;
use nalgebra::{DMatrix, DVector};

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "beams.cantilever",
        claim: "A cantilever of N links bends under a load at its end by (2 N^3 + N) F D^2 / (3 k r^2), and so tends to the Euler-Bernoulli beam of bending stiffness k r^2 D / 2 with the error 1 / (2 N^2).",
        equations: "(32), (44), (45)",
        scene: "Rows of 1 mm beads in touch, the first fixed, 1 to 64 links, at rest; the kernel's own stiffness matrix by dual numbers is solved for a unit force across the last",
        oracle: "Balance of moments at each bead, summed by hand; a Timoshenko beam of shear stiffness 3 k r^2 / D has the same deflection for every N",
        norm: "Largest relative difference",
        origin: Origin::Exact,
        reason: "The condition of the matrix grows as N^4, 1.7e7 for 64 links: 4e-9 of rounding",
        effort: Effort::Quick,
        measure: cantilever,
    }]
}

fn tip(links: usize) -> Result<f64, Failure> {
    let mut text = head("euler", 1e-9)
        + BEAM
        + "[[particles]]\nposition = [0.0, 0.0]\nradius = 1e-3\nrole = \"fixed\"\n";
    for i in 1..=links {
        text += &particle([2e-3 * i as f64, 0.0], [0.0, 0.0], 0.0, 1e-3);
        text += &format!("[[bonds]]\nbetween = [{}, {i}]\n", i - 1);
    }
    let world: World = world(&text)?;
    let network = linearise(&world, *world.model())?.network;
    let size = 3 * links;
    let mut matrix = DMatrix::zeros(size, size);
    for &(row, column, value) in &network.stiffness {
        if row >= 3 && column >= 3 {
            matrix[(row - 3, column - 3)] += value;
        }
    }
    let mut load = DVector::zeros(size);
    load[size - 2] = 1.0;
    let moved = matrix
        .lu()
        .solve(&load)
        .ok_or_else(|| Failure::Oracle("the stiffness matrix is singular".to_owned()))?;
    Ok(moved[size - 2])
}

fn cantilever() -> Outcome {
    let (mut worst, mut found) = (Vec::new(), Vec::new());
    // F D^2 / (k r^2) is 4 F / k for beads in touch.
    let unit = 4.0 / STIFFNESS;
    for links in [1, 2, 4, 8, 16, 32, 64] {
        let n = links as f64;
        let bent = tip(links)? / unit;
        worst.push(Measurement::relative(deflection(n), bent, 4e-9));
        found.push([n, bent / (2.0 * n * n * n / 3.0) - 1.0]);
    }
    let plot = Plot {
        title: "Deflection of a cantilever of beads in excess of the Euler-Bernoulli beam"
            .to_owned(),
        x: Axis::logarithmic("number of links"),
        y: Axis::logarithmic("relative excess"),
        curves: vec![
            Curve::line("1 / (2 N^2)", [1.0, 64.0].map(|n| [n, 0.5 / (n * n)])),
            Curve::marks("kernel", found),
        ],
    };
    Ok(Measurement::worst(worst).showing([Exhibit::Plot(plot)]))
}
