//! Azéma, Estrada and Radjai (Phys. Rev. E 86, 041301, 2012): does strength grow with angularity while density falls?

mod claims;
mod figures;
mod printed;
mod shapes;
mod sweeps;
mod tables;

use super::Study;
use super::illustration::each;
use super::pictures::Shown;
use maud::{Markup, html};

/// The study.
pub static STUDY: Study = Study {
    name: "polygons",
    title: "Strength and density of sheared polygons over their angularity",
    introduction,
    parts: sweeps::parts,
    order: &["shapes", "tolerance", "bias", "step", "number", "inertia"],
    rules: || claims::RULES.iter().collect(),
    curves: figures::CURVES,
    illustrations: |results, curves| each(figures::figures(results, curves)),
    tables: tables::tables,
    pictures: &[
        shown(&[("shape", "disc")]),
        shown(&[("shape", "10 sides")]),
        shown(&[("shape", "pentagon")]),
        shown(&[("shape", "triangle")]),
        Shown::directions(SHAPES, &[("shape", "hexagon")]),
    ],
};

/// Pictures as in figures 7 and 14 of the paper; the polar diagrams are those of figure 11.
const fn shown(axes: &'static [(&'static str, &'static str)]) -> Shown {
    Shown::final_state(SHAPES, axes)
}

/// The part with all shapes.
const SHAPES: &str = "shapes";

fn introduction() -> Markup {
    html! {
        p {
            "Azéma, Estrada and Radjai shear 10 000 rigid polygons of 3 to 60 sides, and discs, by contact dynamics. "
            "Here the samples are smaller: 2 000 bodies in boxes as high as wide, three samples of each shape, inertial number "
            "1e-3, strain 5e-5 per step, strain 3, means over 1.5 to 3. Friction is 0.4, the largest diameter four times the "
            "smallest. Sweeps end when no impulse changes by more than 0.003 of the mean one and the residual of the contact laws is "
            "below 2.5 strain rates times the mean diameter, or after 1000 in a step. A "
            "twentieth of the overlap beyond 0.002 mean diameters is removed in each step; the work that this does is part of "
            "the balance of energy. With " code { "--scale small" } " there are 300 bodies, two samples and strain 1.2."
        }
        p {
            "Printed values are those of the text and of the fits in the paper; figures without numbers in the text are "
            "compared by trend only. Error bars are standard errors over samples."
        }
    }
}
