//! The sweeps of the study.

use super::super::{Part, Scale};
use super::shapes::{SIDES, TESTED, name, width};
use gouge_runner::contact_dynamics::Means;

/// Strain per unit of time.
pub const RATE: f64 = 1e-3;
/// Bodies of the samples whose sensitivity is tested.
const TESTED_BODIES: u32 = 400;

/// How large the samples are.
struct Size {
    bodies: u32,
    seeds: &'static str,
    strain: f64,
}

/// The parts of the study.
pub fn parts(scale: Scale) -> Vec<Part> {
    let size = match scale {
        Scale::Small => Size {
            bodies: 300,
            seeds: "0..2",
            strain: 1.2,
        },
        Scale::Full => Size {
            bodies: 2000,
            seeds: "0..3",
            strain: 3.0,
        },
    };
    let mut parts = vec![Part::new(
        super::SHAPES,
        &text(&size, &SIDES, ""),
        size.seeds,
    )];
    if scale == Scale::Full {
        let tested = Size {
            bodies: TESTED_BODIES,
            ..size
        };
        let changes = CHANGES.iter().map(|(name, axis)| {
            let text = text(&tested, &TESTED, &axis.replace("NUMBERS", &numbers()));
            Part::new(name, &text, tested.seeds)
        });
        parts.extend(changes);
    }
    parts
}

/// What is changed, one thing at a time; the shape is always an axis, too.
const CHANGES: [(&str, &str); 5] = [
    (
        "tolerance",
        r#"
[[axis]]
name = "tolerance"
keys = ["solver.tolerance", "solver.largest_residual"]
values = [[1e-2, 1.0], [3e-3, 2.5e-3], [1e-3, 1e-3]]
labels = ["1e-2", "3e-3", "1e-3"]
"#,
    ),
    (
        "bias",
        r#"
[[axis]]
name = "bias"
key = "contact.gap.fraction"
values = [0.0, 0.02, 0.05, 0.1]
"#,
    ),
    (
        "step",
        r#"
[[axis]]
name = "step"
keys = ["time.step", "setup.compaction.step", "setup.compaction.largest_speed"]
values = [[0.1, 0.1, 0.04], [0.05, 0.05, 0.08], [0.025, 0.025, 0.16]]
labels = ["1e-4", "5e-5", "2.5e-5"]
"#,
    ),
    (
        "number",
        r#"
[[axis]]
name = "bodies"
keys = ["setup.particles", "box.width"]
values = NUMBERS
labels = ["200", "400", "800"]
"#,
    ),
    (
        "inertia",
        r#"
[[axis]]
name = "inertia"
keys = ["shear.normal_stress", "time.step", "setup.compaction.normal_stress", "setup.compaction.step", "setup.compaction.largest_speed"]
values = [
    [0.1, 0.158, 0.1, 0.158, 0.0253],
    [1.0, 0.05, 1.0, 0.05, 0.08],
    [10.0, 0.0158, 10.0, 0.0158, 0.253],
    [100.0, 0.005, 100.0, 0.005, 0.8],
]
labels = ["3e-3", "1e-3", "3e-4", "1e-4"]
"#,
    ),
];

/// Numbers of bodies with widths of the box. A hexagon's width serves all shapes here.
fn numbers() -> String {
    let one = |bodies: u32| format!("[{bodies}, {:?}]", width(6, bodies));
    let all = [200, 400, 800].map(one);
    format!("[{}]", all.join(", "))
}

/// A sweep over shapes and, besides, over another axis.
fn text(size: &Size, shapes: &[u32], axis: &str) -> String {
    let end = size.strain / RATE;
    let half = 0.5 * end;
    // An axis that changes the number of bodies changes the width, too.
    let has_width = !axis.contains("box.width");
    let numbers = |sides: &u32| match has_width {
        true => format!("[{sides}, {:?}]", width(*sides, size.bodies)),
        false => format!("[{sides}]"),
    };
    let width_key = if has_width { ", \"box.width\"" } else { "" };
    let values: Vec<String> = shapes.iter().map(numbers).collect();
    let labels: Vec<String> = shapes
        .iter()
        .map(|&sides| format!("{:?}", name(sides)))
        .collect();
    let interval = end / 300.0;
    let steps = interval / 0.05;
    let mut text = format!(
        "scene = \"sheared-polygons\"\n\
         set = [\"setup.particles={}\", \"time.end={end:?}\", \"output.interval={interval:?}\"]\n\n\
         [[axis]]\nname = \"shape\"\nkeys = [\"setup.sides\"{width_key}]\nvalues = [{}]\nlabels = [{}]\n{}\n\
         [seeds]\nsetup = \"SEEDS\"\n",
        size.bodies,
        values.join(", "),
        labels.join(", "),
        axis
    );
    for name in Means::names() {
        text += &format!("\n[[observe]]\nnetwork = {name:?}\nafter = {half:?}\n");
    }
    let late = 0.75 * end;
    text += &format!(
        "\n[[observe]]\nnetwork = \"solid_fraction\"\nname = \"solid_fraction_late\"\nafter = {late:?}\n"
    );
    for (column, statistic, times) in COLUMNS {
        let times = if times { 1.0 / steps } else { 1.0 };
        text += &format!(
            "\n[[observe]]\ncolumn = {column:?}\nstatistic = {statistic:?}\nafter = {half:?}\ntimes = {times:?}\n"
        );
    }
    text
}

/// Columns of the series with their statistics; whether they count steps, whose share is wanted.
const COLUMNS: [(&str, &str, bool); 9] = [
    ("shear_stress", "mean", false),
    ("normal_stress", "mean", false),
    ("height", "mean", false),
    ("sweeps", "mean", false),
    ("unconverged", "mean", true),
    ("large_overlaps", "mean", true),
    ("largest_overlap", "maximum", false),
    ("velocity_residual", "mean", false),
    ("velocity_residual", "maximum", false),
];
