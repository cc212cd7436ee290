//! The page of a run: `run.html`, which needs no other file.

use super::super::Scene;
use super::{frame, picture};
use crate::error::Error;
use crate::run::Summary;
use crate::run::columns::Columns;
use crate::run::folder::{PAGE, SERIES, write_soon};
use crate::run::page::{Drawn, Plan, figure, motion, verdict, with_style};
use crate::scene::Trajectory;
use gouge_contact_dynamics::world::World;
use gouge_page::Figure;
use maud::{Markup, PreEscaped, html};
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
pub fn write(folder: &Path, scene: &Scene, world: &World, summary: &Summary) -> Result<(), Error> {
    let title = match scene.title.as_str() {
        "" => &scene.file,
        title => title,
    };
    let series = Columns::read(&folder.join(SERIES));
    let figures: Vec<Figure> = PLANS
        .iter()
        .filter_map(|plan| figure(plan, &series))
        .collect();
    let body = html! {
        h1 { (title) }
        (verdict(summary))
        (facts(scene, summary))
        @if !figures.is_empty() {
            h2 { "Series" }
            div.figures { @for figure in &figures { (figure.html()) } }
        }
        h2 { "Final state" }
        figure.picture {
            (PreEscaped(picture::draw(scene, world).to_string()))
            figcaption { (LEGEND) }
        }
        h2 { "Motion" }
        (animation(folder, scene, world))
        h2 { "Files" }
        (files(scene))
    };
    write_soon(&folder.join(PAGE), with_style(title, body).as_bytes())
}

const LEGEND: &str = "Lines between centres are as wide as the normal force between the two bodies: orange at one point \
    (side-vertex), green at two (side-side). Bodies with fewer than two contacts are light grey, those that belong to a \
    wall dark grey.";

fn facts(scene: &Scene, summary: &Summary) -> Markup {
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
        ("hash", summary.scene_sha256.clone()),
        (
            "version",
            format!("{} (commit {})", summary.version, summary.commit),
        ),
    ];
    let rows = rows.into_iter().chain(summary.network_lines());
    html! { dl { @for (name, value) in rows { dt { (name) } dd { (value) } } } }
}

fn animation(folder: &Path, scene: &Scene, world: &World) -> Markup {
    if scene.output.trajectory == Trajectory::None {
        return html! {
            p.about { "With " code { "output.trajectory" } " the page shows the motion, too." }
        };
    }
    let bodies = world.assembly().shape.len();
    let diameters = (0..bodies).map(|body| super::statistics::diameter(world.assembly(), body));
    let radii: Vec<f64> = diameters.map(|diameter| 0.5 * diameter).collect();
    let drawn = Drawn {
        radii: &radii,
        sides: &frame::drawn_sides(scene, world),
        label: "role",
        pressure: "the mean stress in a body",
    };
    let step = scene.settings.time_step;
    motion(folder, &drawn, &|sample| {
        scene.sample_step(sample) as f64 * step
    })
}

fn files(scene: &Scene) -> Markup {
    let network = scene.measures_network();
    let all = [
        ("series.csv", "the samples shown above", true),
        (
            "network.csv",
            "sums over the contact network at every sample",
            network,
        ),
        ("particles.csv", "the final bodies", true),
        ("contacts.csv", "the contact points of the last step", true),
        (
            "trajectory",
            "frames for ParaView or OVITO",
            scene.output.trajectory != Trajectory::None,
        ),
        ("summary.json", "status, warnings, work, speed", true),
    ];
    html! {
        ul.files {
            @for (name, about, exists) in all {
                @if exists { li { a href=(name) { (name) } ": " (about) } }
            }
        }
    }
}
