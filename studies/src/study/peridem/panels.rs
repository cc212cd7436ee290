//! Figures 4b, 6, 7 and 9: states of grains, coloured by damage.

use super::claims::from_notch;
use super::{CROSSES, CROSSES_EARLY, CROSSES_FINE, CROSSES_FINE_EARLY, KALTHOFF, NOTCH_FRAMES};
use crate::study::illustration::{Illustration, Panels};
use crate::study::pictures::Shown;
use crate::study::results::{Results, Run};
use crate::study::sample::Sample;

/// The states of a figure.
type States = &'static [Shown];

/// Figure 4b.
const PLATES: States = &[
    Shown::final_state(
        KALTHOFF,
        &[
            ("grid", "1 mm, 4 h"),
            ("breaking", "tension only"),
            ("self contact", "off"),
        ],
    ),
    Shown::final_state(
        KALTHOFF,
        &[
            ("grid", "0.5 mm, 4 h"),
            ("breaking", "tension only"),
            ("self contact", "off"),
        ],
    ),
    Shown::final_state(
        KALTHOFF,
        &[
            ("grid", "1 mm, 4 h"),
            ("breaking", "two-sided"),
            ("self contact", "off"),
        ],
    ),
];

const fn cross(part: &'static str, axes: &'static [(&'static str, &'static str)]) -> Shown {
    Shown::final_state(part, axes)
}

/// Figure 6.
const HORIZONS: States = &[
    cross(CROSSES_EARLY, &[("horizon", "4 h")]),
    cross(CROSSES_EARLY, &[("horizon", "15 h")]),
    cross(CROSSES_EARLY, &[("horizon", "25 h")]),
    cross(CROSSES, &[("horizon", "4 h")]),
    cross(CROSSES, &[("horizon", "15 h")]),
    cross(CROSSES, &[("horizon", "25 h")]),
];

/// Figure 7.
const SPACINGS: States = &[
    cross(CROSSES_FINE_EARLY, &[("spacing", "R/30")]),
    cross(CROSSES_FINE_EARLY, &[("spacing", "R/40")]),
    cross(CROSSES_FINE_EARLY, &[("spacing", "R/50")]),
    cross(CROSSES_FINE, &[("spacing", "R/30")]),
    cross(CROSSES_FINE, &[("spacing", "R/40")]),
    cross(CROSSES_FINE, &[("spacing", "R/50")]),
];

const fn frame(axes: &'static [(&'static str, &'static str)]) -> Shown {
    Shown::final_state(NOTCH_FRAMES, axes)
}

/// Figure 9.
const FRAMES: States = &[
    frame(&[("Gc", "135"), ("until", "30 us")]),
    frame(&[("Gc", "135"), ("until", "54 us")]),
    frame(&[("Gc", "135"), ("until", "66 us")]),
    frame(&[("Gc", "13.5"), ("until", "30 us")]),
    frame(&[("Gc", "13.5"), ("until", "64 us")]),
    frame(&[("Gc", "13.5"), ("until", "66 us")]),
];

fn panels(states: States, caption: &str, label: impl Fn(&Shown) -> String) -> Illustration {
    Illustration::Panels(Panels {
        caption: caption.to_owned(),
        panels: states.iter().map(|&shown| (shown, label(&shown))).collect(),
    })
}

/// Axes and their values.
fn values(shown: &Shown) -> String {
    let each = shown
        .axes
        .iter()
        .map(|(axis, value)| format!("{axis} {value}"));
    each.collect::<Vec<String>>().join(", ")
}

/// The run of a state, if it counts.
fn run_of<'a>(results: &'a Results, shown: &Shown) -> Option<&'a Run> {
    let sample = Sample {
        results,
        part: shown.part,
    };
    let is_meant = |run: &&Run| {
        shown
            .axes
            .iter()
            .all(|(axis, value)| run.text(axis) == *value)
    };
    sample.runs().find(is_meant)
}

/// The plate of Kalthoff and Winkler.
pub(super) fn plate(results: &Results) -> Illustration {
    let label = |shown: &Shown| {
        let run = run_of(results, shown);
        let angles = run.and_then(|run| Some([from_notch(run, 0)?, from_notch(run, 1)?]));
        let said = match angles {
            Some([left, right]) => format!("{left:.1} and {right:.1} degrees from the notches"),
            None => "no crack at the notches".to_owned(),
        };
        let grid = shown.axes[0].1;
        format!("Grid {grid}, {}: {said}.", shown.axes[1].1)
    };
    let caption = "Figure 4b: the plate after 90 us. Dashed: the lines whose angles and lengths are measured, from the \
        undeformed tips. Printed: 68 degrees. With two-sided breaking the zone under the impactor is crushed.";
    panels(PLATES, caption, label)
}

/// States of the crosses; those of the first half are earlier.
fn crosses(states: States, caption: &str) -> Illustration {
    let label = |shown: &Shown| {
        let is_early = shown.part == CROSSES_EARLY || shown.part == CROSSES_FINE_EARLY;
        let time = if is_early { "400 ns" } else { "1 us" };
        let what = values(shown);
        format!("{what}, after {time}")
    };
    panels(states, caption, label)
}

/// Crosses over horizons.
pub(super) fn horizons() -> Illustration {
    let caption = "Figure 6: damage of the crosses for horizons of 4, 15 and 25 h, with h = R/30 and one contact stiffness. \
        After 400 ns the zone grows with the horizon; after 1 us that for 25 h is a tenth smaller than that for 15 h.";
    crosses(HORIZONS, caption)
}

/// Crosses over spacings of nodes.
pub(super) fn spacings() -> Illustration {
    let caption = "Figure 7: damage of the crosses for spacings of R/30, R/40 and R/50, with a horizon of 0.134 R. The zone \
        stays where it is, at the arms that touch and at the inner corners next to them.";
    crosses(SPACINGS, caption)
}

/// The notched square over time.
pub(super) fn pieces(results: &Results) -> Illustration {
    let label = |shown: &Shown| {
        let pieces = run_of(results, shown).and_then(|run| run.number("pieces_last"));
        let said = match pieces.map(|pieces| pieces - 2.0) {
            Some(1.0) => "one piece".to_owned(),
            Some(pieces) => format!("{pieces} pieces"),
            None => "not run".to_owned(),
        };
        format!(
            "{} J/m², after {}: {said}.",
            shown.axes[0].1, shown.axes[1].1
        )
    };
    let caption = "Figure 9: the notched square on our mesh of 0.2 mm, with the sizes of the public script. Grey nodes have \
        all their bonds. The paper shows 29 to 50 us for 135 J/m² and 28 to 40 us for 13.5 J/m².";
    panels(FRAMES, caption, label)
}
