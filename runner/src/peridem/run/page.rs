//! The page of a run: `run.html`, which needs no other file.

use super::super::Scene;
use super::frame::radii;
use crate::error::Error;
use crate::run::Summary;
use crate::run::page::{Content, Drawn, Plan, Row, motion_or_hint, write_content};
use crate::scene::Trajectory;
use gouge_peridem::world::World;
use std::path::Path;

/// The figures of every series, as far as it has their columns.
const PLANS: [Plan; 12] = [
    (
        "Energies of the grains.",
        ["energy", "J/m"],
        &[
            ("kinetic", "kinetic"),
            ("bonds", "bond"),
            ("contacts", "contact"),
            ("gravity and loads", "external"),
        ],
    ),
    (
        "Losses and work since t = 0.",
        ["energy", "J/m"],
        &[
            ("lost with broken bonds", "breaking"),
            ("damping", "damping"),
            ("friction", "friction"),
            ("work of walls", "wall_work"),
        ],
    ),
    (
        "Residual of the energy balance.",
        ["energy", "J/m"],
        &[("residual", "residual")],
    ),
    (
        "Momentum per metre of depth.",
        ["momentum", "kg/s"],
        &[("x", "momentum_x"), ("y", "momentum_y")],
    ),
    (
        "Broken bonds.",
        ["number", ""],
        &[("broken bonds", "broken_bonds")],
    ),
    ("Bulk damage.", ["damage", ""], &[("damage", "bulk_damage")]),
    (
        "Softened area: that of nodes that lost a bond.",
        ["area", "m²"],
        &[("area", "softened_area")],
    ),
    (
        "Pieces of more than 5 % of the nodes of their grain.",
        ["number", ""],
        &[("pieces", "pieces")],
    ),
    (
        "Share of the grains in the container.",
        ["solid fraction", ""],
        &[("solid fraction", "solid_fraction")],
    ),
    (
        "Forces on the walls along their normals.",
        ["force", "N/m"],
        &[
            ("left", "left_force_x"),
            ("right", "right_force_x"),
            ("top", "top_force_y"),
            ("bottom", "bottom_force_y"),
        ],
    ),
    (
        "Directions of the cracks.",
        ["angle", "rad"],
        &[
            ("crack 0", "crack_angle_0"),
            ("crack 1", "crack_angle_1"),
            ("crack 2", "crack_angle_2"),
            ("crack 3", "crack_angle_3"),
        ],
    ),
    (
        "Lengths of the cracks.",
        ["length", "m"],
        &[
            ("crack 0", "crack_length_0"),
            ("crack 1", "crack_length_1"),
            ("crack 2", "crack_length_2"),
            ("crack 3", "crack_length_3"),
        ],
    ),
];

const LEGEND: &str =
    "Nodes are coloured by their damage, the share of their bonds that broke. Lines are walls.";

/// Write the page of a run that ended, with the picture of its final state.
///
/// # Errors
/// Failures of the file system.
pub fn write(
    folder: &Path,
    scene: &Scene,
    (world, picture): (&World, String),
    summary: &Summary,
) -> Result<(), Error> {
    let drawn = Drawn {
        radii: &radii(world),
        sides: &[],
        label: "damage",
        pressure: None,
        is_scale: true,
    };
    let schedule = scene.schedule();
    let has_trajectory = scene.output.trajectory != Trajectory::None;
    let time = |sample| schedule.sample_time(sample);
    let content = Content {
        title: match scene.title.as_str() {
            "" => &scene.file,
            title => title,
        },
        facts: facts(scene, summary),
        plans: &PLANS,
        picture,
        other_picture: None,
        legend: LEGEND,
        motion: motion_or_hint(has_trajectory, folder, &drawn, &time),
        files: files(scene),
    };
    write_content(folder, summary, &content)
}

fn facts(scene: &Scene, summary: &Summary) -> Vec<Row> {
    let (broken, initial) = (summary.bonds_broken, summary.bonds_initial);
    let rows = [
        (
            "time",
            format!(
                "{:.6e} s in {} steps of {:e} s",
                summary.time, summary.steps, scene.step
            ),
        ),
        ("model", "peridynamic grains".to_owned()),
        ("nodes", summary.particles.to_string()),
        ("bonds", format!("{broken} of {initial} broken")),
        ("scene", scene.file.clone()),
    ];
    rows.into_iter().chain(summary.peridem_lines()).collect()
}

fn files(scene: &Scene) -> Vec<(&'static str, &'static str, bool)> {
    vec![
        ("series.csv", "the samples shown above", true),
        ("nodes.csv", "the final nodes", true),
        ("grains.csv", "the final grains", true),
        ("breaks.csv", "the bonds that broke, in order", true),
        ("bonds.csv", "the final bonds", scene.output.bonds),
        (
            "trajectory",
            "frames for ParaView or OVITO",
            scene.output.trajectory != Trajectory::None,
        ),
        (
            "summary.json",
            "status, warnings, energies, limits, speed",
            true,
        ),
    ]
}
