//! The page of a run: `run.html`, which needs no other file.

use super::super::Scene;
use super::{frame, picture};
use crate::error::Error;
use crate::run::Summary;
use crate::run::page::{Content, Drawn, Plan, Row, motion_or_hint, write_content};
use crate::scene::Trajectory;
use gouge_contact_dynamics::world::World;
use maud::Markup;
use std::path::Path;

/// The figures of every series, as far as it has their columns.
const PLANS: [Plan; 7] = [
    (
        "Stresses on the upper wall.",
        ["stress", "Pa"],
        &[
            ("shear stress", "shear_stress"),
            ("normal stress", "normal_stress"),
        ],
    ),
    (
        "Height of the upper wall.",
        ["height", "m"],
        &[("height", "height")],
    ),
    (
        "Work since t = 0.",
        ["energy", "J"],
        &[
            ("driving", "driving"),
            ("loads", "load"),
            ("friction", "friction"),
            ("collisions", "collision"),
            ("correction of overlaps", "correction"),
        ],
    ),
    (
        "Kinetic energy.",
        ["energy", "J"],
        &[("kinetic", "kinetic")],
    ),
    (
        "Mean number of sweeps per step.",
        ["sweeps", ""],
        &[("sweeps", "sweeps")],
    ),
    (
        "Largest overlap since the sample before.",
        ["overlap", "m"],
        &[("overlap", "largest_overlap")],
    ),
    (
        "Residual of the contact laws (natural map).",
        ["velocity", "m/s"],
        &[("residual", "velocity_residual")],
    ),
];

/// Write the page of a run that ended.
///
/// # Errors
/// Failures of the file system.
pub fn write(
    folder: &Path,
    scene: &Scene,
    world: &World,
    directions: Option<String>,
    summary: &Summary,
) -> Result<(), Error> {
    let content = Content {
        title: match scene.title.as_str() {
            "" => &scene.file,
            title => title,
        },
        facts: facts(scene, summary),
        plans: &PLANS,
        picture: picture::draw(scene, world).to_string(),
        legend: LEGEND,
        other_picture: directions.map(|picture| (picture, DIRECTIONS)),
        motion: animation(folder, scene, world),
        files: files(scene),
    };
    write_content(folder, summary, &content)
}

const LEGEND: &str = "Lines between centres are as wide as the normal force between the two bodies: orange at one point \
    (side-vertex), green at two (side-side). Bodies with fewer than two contacts are light grey, those that belong to a \
    wall dark grey.";

const DIRECTIONS: &str = "Contacts, forces and branch vectors by the direction of the normal, away from the walls, over the \
    second half of the run: measured (blue) and expanded to first order (orange), relative to the means over all \
    directions; tangential components relative to the normal means, with their magnitudes. Values at the rim are given.";

fn facts(scene: &Scene, summary: &Summary) -> Vec<Row> {
    let rows = [
        (
            "time",
            format!(
                "{:.6e} s in {} steps of {:e} s",
                summary.time, summary.steps, scene.settings.time_step
            ),
        ),
        ("bodies", summary.particles.to_string()),
        ("friction", scene.settings.law.friction.to_string()),
        ("model", "contact dynamics".to_owned()),
        ("scene", scene.file.clone()),
    ];
    rows.into_iter().chain(summary.network_lines()).collect()
}

fn animation(folder: &Path, scene: &Scene, world: &World) -> Markup {
    let bodies = world.assembly().shape.len();
    let diameters = (0..bodies).map(|body| super::statistics::diameter(world.assembly(), body));
    let radii: Vec<f64> = diameters.map(|diameter| 0.5 * diameter).collect();
    let drawn = Drawn {
        radii: &radii,
        sides: &frame::drawn_sides(scene, world),
        label: "role",
        pressure: Some("the mean stress in a body"),
        is_scale: false,
    };
    let schedule = scene.schedule();
    let has_trajectory = scene.output.trajectory != Trajectory::None;
    motion_or_hint(has_trajectory, folder, &drawn, &|sample| {
        schedule.sample_time(sample)
    })
}

fn files(scene: &Scene) -> Vec<(&'static str, &'static str, bool)> {
    vec![
        ("series.csv", "the samples shown above", true),
        (
            "network.csv",
            "sums over the contact network at every sample",
            scene.measures_network(),
        ),
        (
            "directions.csv",
            "what depends on the direction of contacts",
            scene.measures_network(),
        ),
        ("particles.csv", "the final bodies", true),
        ("contacts.csv", "the contact points of the last step", true),
        (
            "trajectory",
            "frames for ParaView or OVITO",
            scene.output.trajectory != Trajectory::None,
        ),
        ("summary.json", "status, warnings, work, speed", true),
    ]
}
