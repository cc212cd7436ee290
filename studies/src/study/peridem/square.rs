//! The notched square: its pieces, when they come, and what its mesh and its contacts have to do with it.

use super::{NOTCH, NOTCH_CONTACT, PRINTED_NOTCH};
use crate::study::claim::{Finding, Verdict};
use crate::study::results::{Results, Run};
use crate::study::sample::Sample;
use gouge_page::{Axis, Curve, Figure, Guide};

/// Fracture energies, pieces, the times in us by which the paper shows them, and the column of the time.
const SHOWN: [(&str, f64, f64, &str); 2] = [
    ("135", 2.0, 50.0, "two_pieces"),
    ("13.5", 3.0, 40.0, "three_pieces"),
];
/// Factor within which a time counts as that of the paper.
const FACTOR: f64 = 1.5;
/// Factor of the contact stiffness at which our mesh of 0.2 mm is as stiff as the public one.
const AS_PUBLIC: &str = "1.75";
/// Time in us of three pieces in the public program with its own mesh.
const PUBLIC_TIME: f64 = 35.0;

/// Pieces of the square without the two planks.
fn pieces_of_run(run: &Run) -> Option<f64> {
    Some(run.number("pieces_last")? - 2.0)
}

/// Runs with a fracture energy.
fn with<'a>(sample: &Sample<'a>, energy: &'static str) -> impl Iterator<Item = &'a Run> + use<'a> {
    sample.runs().filter(move |run| run.text("Gc") == energy)
}

/// Whether most meshes give two and three pieces, and all numbers.
fn pieces_of(sample: &Sample) -> Option<(bool, String)> {
    let mut is_met = true;
    let mut said = Vec::new();
    for (energy, expected, ..) in SHOWN {
        let runs = with(sample, energy);
        let all: Vec<(&str, f64)> = runs
            .filter_map(|run| Some((run.text("spacing"), pieces_of_run(run)?)))
            .collect();
        if all.is_empty() {
            return None;
        }
        let met = all.iter().filter(|(_, pieces)| *pieces == expected).count();
        is_met &= 2 * met > all.len();
        let numbers: Vec<String> = all
            .iter()
            .map(|(mesh, pieces)| format!("{pieces} ({mesh})"))
            .collect();
        said.push(format!("{energy} J/m²: {}", numbers.join(", ")));
    }
    Some((is_met, said.join("; ") + "."))
}

pub(super) fn pieces(sample: &Sample) -> Option<Finding> {
    let (is_met, numbers) = (sample.part == NOTCH).then(|| pieces_of(sample))??;
    Some(Finding::new(Verdict::of(is_met, false), numbers))
}

pub(super) fn printed_pieces(sample: &Sample) -> Option<Finding> {
    let (is_met, numbers) = (sample.part == PRINTED_NOTCH).then(|| pieces_of(sample))??;
    let verdict = if is_met {
        Verdict::Holds
    } else {
        Verdict::NotAsPrinted
    };
    Some(Finding::new(verdict, numbers))
}

pub(super) fn times(sample: &Sample) -> Option<Finding> {
    if sample.part != NOTCH {
        return None;
    }
    let mut is_met = true;
    let mut said = Vec::new();
    for (energy, _, printed, column) in SHOWN {
        for run in with(sample, energy) {
            let time = run.number(column);
            is_met &= time.is_some_and(|time| time <= FACTOR * printed);
            let time = time.map_or("none".to_owned(), |time| format!("{time:.1} us"));
            said.push(format!("{energy} J/m², {}: {time}", run.text("spacing")));
        }
    }
    let verdict = if is_met {
        Verdict::Holds
    } else {
        Verdict::NotAsPrinted
    };
    (!said.is_empty()).then(|| Finding::new(verdict, said.join("; ") + "."))
}

/// Times in us of three pieces for 13.5 J/m^2 in some runs, by spacing of nodes.
fn times_of_three<'a>(
    results: &'a Results,
    part: &'static str,
    is_meant: impl Fn(&Run) -> bool,
) -> Vec<(&'a str, f64)> {
    let sample = Sample { results, part };
    let runs = with(&sample, "13.5").filter(|run| is_meant(run));
    runs.filter_map(|run| Some((run.text("spacing"), run.number("three_pieces")?)))
        .collect()
}

/// Times of three pieces over the factor of the contact stiffness.
pub(super) fn over_stiffness(results: &Results) -> Figure {
    let meshes = ["0.18 mm", "0.19 mm", "0.2 mm", "0.21 mm"];
    let curve = |mesh: &'static str| {
        let base = times_of_three(results, NOTCH, |run| run.text("spacing") == mesh);
        let first = base.iter().map(|(_, time)| [1.0, *time]);
        let factors = ["1.3", AS_PUBLIC, "2.5"].into_iter();
        let others = factors.filter_map(|factor| {
            let is_meant = |run: &Run| run.text("contact") == factor && run.text("spacing") == mesh;
            let (_, time) = *times_of_three(results, NOTCH_CONTACT, is_meant).first()?;
            Some([factor.parse().ok()?, time])
        });
        Curve::marked_line(mesh, first.chain(others).collect::<Vec<[f64; 2]>>())
    };
    Figure::new(
        "Time at which the square is in three pieces for 13.5 J/m², over the stiffness of contacts in units of c/R_c, for \
         meshes of four spacings. With 1.75 our mesh of 0.2 mm has the contacts of the public mesh.",
        Axis::linear("contact stiffness over that of the scene", ""),
        Axis::linear("time of three pieces", "us"),
        meshes.map(curve).into(),
    )
    .with_guide(Guide::horizontal("public program on its mesh, stiffness 1", PUBLIC_TIME))
    .with_guide(Guide::horizontal("last frame of figure 9", 40.0))
}
