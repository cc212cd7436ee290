//! Bhattacharya and Lipton (SIAM J. Sci. Comput. 45, B1, 2023): single bodies of deformable, breakable grains.

mod claims;
mod figures;
mod sweeps;
mod tables;

use super::Study;
use super::curves::CurvePlan;
use super::pictures::Shown;
use crate::columns::Columns;
use maud::{Markup, html};
use std::ops::Range;

/// The study.
pub static STUDY: Study = Study {
    name: "peridem",
    title: "Collisions and cracks of single peridynamic grains",
    introduction,
    parts: sweeps::parts,
    order: &[KALTHOFF, CROSSES, CROSSES_FINE, NOTCH, PRINTED_NOTCH],
    rules: || claims::RULES.iter().collect(),
    curves: CurvePlan {
        names: ["broken_bonds", "softened_area"],
        is_shown: |_| true,
        numbers: last,
    },
    figures: figures::figures,
    tables: tables::tables,
    pictures: &[
        Shown {
            part: KALTHOFF,
            axes: &[
                ("grid", "1 mm, 4 h"),
                ("breaking", "tension only"),
                ("self contact", "off"),
            ],
        },
        Shown {
            part: KALTHOFF,
            axes: &[
                ("grid", "1 mm, 4 h"),
                ("breaking", "two-sided"),
                ("self contact", "off"),
            ],
        },
        Shown {
            part: CROSSES,
            axes: &[("horizon", "4 h")],
        },
        Shown {
            part: CROSSES,
            axes: &[("horizon", "15 h")],
        },
        Shown {
            part: CROSSES,
            axes: &[("horizon", "25 h")],
        },
        Shown {
            part: NOTCH,
            axes: &[("Gc", "135"), ("spacing", "0.19 mm")],
        },
        Shown {
            part: NOTCH,
            axes: &[("Gc", "13.5"), ("spacing", "0.19 mm")],
        },
    ],
};

/// The plate with two notches and its impactor.
const KALTHOFF: &str = "kalthoff";
/// Colliding crosses over horizons.
const CROSSES: &str = "crosses";
/// Colliding crosses over spacings of nodes.
const CROSSES_FINE: &str = "crosses-spacing";
/// The notched square between two planks, with the sizes of the public script.
const NOTCH: &str = "notch";
/// The same with the printed sizes.
const PRINTED_NOTCH: &str = "notch-printed";

/// Bonds that broke and the area of damaged nodes in m^2, at the end of some rows.
fn last(series: &Columns, rows: Range<usize>) -> Option<[f64; 2]> {
    let number = |name| Some(series.get(name)?[rows.end - 1]);
    Some([number("broken_bonds")?, number("softened_area")?])
}

fn introduction() -> Markup {
    html! {
        p {
            "Bhattacharya and Lipton let single grains collide before they come to beds of them: a plate with two notches under "
            "an impactor, two crosses, and a notched square between two planks. "
            "Every run here is in the corrected mode: constants of one row of table 1, contact that keeps momentum, bonds that "
            "break in tension only unless it is said otherwise. "
            "What the paper leaves open (the size of the plate, its fracture energy, meshes) is that of the public scripts or "
            "the usual one of the experiment."
        }
        p {
            "Verdicts: " i { "holds" } ", " i { "refuted" } ", and " i { "not reproducible as printed" } " where the printed "
            "numbers do not give the printed result, but others do."
        }
    }
}
