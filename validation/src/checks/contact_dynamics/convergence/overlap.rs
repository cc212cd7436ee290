//! Overlaps of a sheared cell.

use super::super::cells::{settings, sheared};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use crate::references::Packing;
use gouge_contact_dynamics::law::GapRule;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.convergence.overlap",
        claim: "Overlaps of a sheared cell are made by sweeps that end too early: they fall with the tolerance of the sweeps at every step.",
        equations: azema("(A27), (A28)-(A32), C3"),
        scene: "400 discs sheared to a strain of 0.03 without a correction of overlaps, 5e-5 to 2e-4 of strain per step, tolerances from 1e-1 to 3e-3 of the mean impulse",
        oracle: "Bodies whose laws are satisfied do not overlap more",
        norm: "Number of steps and tolerances at which the largest overlap is not smaller than at a tolerance ten times as large",
        origin: Origin::Exact,
        reason: "A count; ten times the tolerance makes several times the overlap",
        effort: Effort::Report,
        measure: overlap,
    }]
}

fn largest(packing: &Packing, strain_per_step: f64, tolerance: f64) -> Result<f64, Failure> {
    let mut settings = settings(packing, strain_per_step, tolerance);
    settings.law.gap = GapRule::Predicted;
    let mut world = sheared(packing, settings)?;
    let mut found = 0.0_f64;
    for _ in 0..(0.03 / strain_per_step).round() as usize {
        found = found.max(world.step()?.largest_overlap);
    }
    Ok(found)
}

fn overlap() -> Outcome {
    let packing = Packing::read("discs").map_err(Failure::Oracle)?;
    let (mut wrong, mut curves) = (0, Vec::new());
    for strain in [2e-4, 1e-4, 5e-5] {
        let mut points = Vec::new();
        for tolerance in [1e-1, 3e-2, 1e-2, 3e-3] {
            points.push([tolerance, largest(&packing, strain, tolerance)?]);
        }
        let pairs = points.iter().zip(&points[2..]);
        wrong += pairs.filter(|(coarse, fine)| fine[1] >= coarse[1]).count();
        let label = format!("{strain:.0e} of strain per step");
        curves.push(Curve::marked_line(&label, points));
    }
    let figure = Figure::new(
        "Largest overlap while 400 discs are sheared to a strain of 0.03",
        Axis::logarithmic("tolerance of the sweeps", "mean impulse"),
        Axis::logarithmic("largest overlap", "mean diameter"),
        curves,
    );
    Ok(Measurement::count(wrong).showing([Exhibit::Figure(figure)]))
}
