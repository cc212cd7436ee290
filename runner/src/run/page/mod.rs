//! The page of a run: `run.html`, which needs no other file.

mod animation;
mod embedded;
mod figures;
mod player;

pub use animation::{Animation, DRIVEN, FIXED, Grain, NAME as ANIMATION, SINGLE};
pub use figures::Plan;
pub use player::Drawn;

use super::columns::Columns;
use super::folder::{PAGE, SERIES, write_soon};
use super::outcome::Summary;
use super::picture::draw_picture;
use crate::error::Error;
use crate::scene::{Scene, Trajectory, integrator_name};
use animation::Recording;
use figures::figure;
use gouge_dem::World;
use gouge_page::styled_page;
use maud::{Markup, PreEscaped, html};
use std::path::Path;

const STYLE: &str = include_str!("page.css");

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
    let body = html! {
        h1 { (title) }
        (verdict(summary))
        (facts(scene, summary))
        (figures::chapter(scene, summary, &series))
        h2 { "Final state" }
        (picture(scene, world))
        h2 { "Motion" }
        (animation(folder, scene, world))
        h2 { "Files" }
        (files(scene, world))
    };
    write_soon(&folder.join(PAGE), with_style(title, body).as_bytes())
}

/// A fact: its name and its text.
pub type Row = (&'static str, String);

/// What the page of a run shows besides the verdict.
pub struct Content<'a> {
    /// Title.
    pub title: &'a str,
    /// Facts; hash and version follow them.
    pub facts: Vec<Row>,
    /// The figures of the series, as far as it has their columns.
    pub plans: &'a [Plan],
    /// The picture of the final state as SVG.
    pub picture: String,
    /// What the picture shows.
    pub legend: &'a str,
    /// Another picture as SVG, and what it shows.
    pub other_picture: Option<(String, &'a str)>,
    /// The motion.
    pub motion: Markup,
    /// Names of files, what they contain, and whether they exist.
    pub files: Vec<(&'static str, &'static str, bool)>,
}

/// Write the page of a run that ended.
///
/// # Errors
/// Failures of the file system.
pub fn write_content(folder: &Path, summary: &Summary, content: &Content) -> Result<(), Error> {
    let series = Columns::read(&folder.join(SERIES));
    let plans = content.plans.iter();
    let figures: Vec<_> = plans.filter_map(|plan| figure(plan, &series)).collect();
    let version = format!("{} (commit {})", summary.version, summary.commit);
    let common = [("hash", summary.scene_sha256.clone()), ("version", version)];
    let body = html! {
        h1 { (content.title) }
        (verdict(summary))
        dl { @for (name, value) in content.facts.iter().chain(&common) { dt { (name) } dd { (value) } } }
        @if !figures.is_empty() {
            h2 { "Series" }
            div.figures { @for figure in &figures { (figure.html()) } }
        }
        h2 { "Final state" }
        figure.picture {
            (PreEscaped(&content.picture))
            figcaption { (content.legend) }
        }
        @if let Some((picture, legend)) = &content.other_picture {
            figure.picture { (PreEscaped(picture)) figcaption { (legend) } }
        }
        h2 { "Motion" }
        (content.motion)
        h2 { "Files" }
        ul.files {
            @for (name, about, exists) in &content.files {
                @if *exists { li { a href=(name) { (name) } ": " (about) } }
            }
        }
    };
    write_soon(
        &folder.join(PAGE),
        with_style(content.title, body).as_bytes(),
    )
}

/// A page as text.
fn with_style(title: &str, body: Markup) -> String {
    styled_page(title, STYLE, body).into_string()
}

/// The motion in the folder of a run, or a hint if it has no trajectory; `time` is that of a sample in s.
pub fn motion_or_hint(
    has_trajectory: bool,
    folder: &Path,
    drawn: &Drawn,
    time: &dyn Fn(u64) -> f64,
) -> Markup {
    match has_trajectory {
        true => player::show(&Recording::read(folder, drawn.radii.len()), drawn, time),
        false => html! {
            p.about { "With " code { "output.trajectory" } " the page shows the motion, too." }
        },
    }
}

/// How the run ended, and whether its results can be trusted.
fn verdict(summary: &Summary) -> Markup {
    let balance = match summary.balance_error {
        Some(error) => format!("The energy balance closes to {error:.1e} of the energy exchanged."),
        None => "The energy balance was not watched, because output.energy is false.".to_owned(),
    };
    let (class, words) = match summary.status.as_str() {
        "done" => ("good", "Done."),
        "untrusted" => (
            "bad",
            "Untrusted: the energy balance is off, so the results cannot be trusted. Try a smaller time step.",
        ),
        "interrupted" => ("bad", "Interrupted: continue it with --resume."),
        other => ("bad", other),
    };
    html! {
        p.verdict.(class) { b { (words) } " " (balance) }
        @if !summary.warnings.is_empty() {
            ul.warnings { @for warning in &summary.warnings { li { (warning) } } }
        }
    }
}

fn facts(scene: &Scene, summary: &Summary) -> Markup {
    let bonds = (summary.bonds_initial > 0).then(|| {
        let (broken, initial) = (summary.bonds_broken, summary.bonds_initial);
        format!("{broken} of {initial} broken")
    });
    let friction = summary.friction.as_ref().map(|friction| {
        let [low, high] = friction.interval;
        let slip = friction.slip;
        format!(
            "{:.3}, 95 % confidence interval {low:.3} to {high:.3}, from the work of the drive over a slip of {slip:.3e} m",
            friction.coefficient
        )
    });
    let rows = [
        (
            "time",
            Some(format!(
                "{:.6e} s in {} steps of {:e} s",
                summary.time, summary.steps, scene.step
            )),
        ),
        ("particles", Some(summary.particles.to_string())),
        ("bonds", bonds),
        ("friction", friction),
        (
            "integrator",
            Some(integrator_name(scene.integrator).to_owned()),
        ),
        ("scene", Some(scene.file.clone())),
        ("hash", Some(summary.scene_sha256.clone())),
        (
            "version",
            Some(format!("{} (commit {})", summary.version, summary.commit)),
        ),
    ];
    html! {
        dl {
            @for (name, value) in rows {
                @if let Some(value) = value { dt { (name) } dd { (value) } }
            }
        }
    }
}

fn picture(scene: &Scene, world: &World) -> Markup {
    html! {
        figure.picture {
            (PreEscaped(draw_picture(scene, world).to_string()))
            figcaption { "Fragments are coloured; single grains are white, driven and fixed grains grey." }
        }
    }
}

fn animation(folder: &Path, scene: &Scene, world: &World) -> Markup {
    let radii = &world.particles().radius;
    let time = |sample| scene.sample_step(sample) as f64 * scene.step;
    let drawn = Drawn {
        radii,
        sides: &[],
        label: "fragment",
        pressure: Some("that of contacts and bonds in a grain"),
        is_scale: false,
    };
    let has_trajectory = scene.output.trajectory != Trajectory::None;
    motion_or_hint(has_trajectory, folder, &drawn, &time)
}

fn files(scene: &Scene, world: &World) -> Markup {
    let all = [
        ("series.csv", "the samples shown above", true),
        ("particles.csv", "the final particles", true),
        ("bonds.csv", "the final bonds", world.bonds().is_some()),
        (
            "breaks.csv",
            "the bonds that broke",
            scene.bond.is_some_and(|laws| laws.yielding.is_some()),
        ),
        (
            "trajectory",
            "frames for ParaView or OVITO",
            scene.output.trajectory != Trajectory::None,
        ),
        (
            "restart.toml",
            "a scene that continues from the final state",
            true,
        ),
        ("summary.json", "status, warnings, energies, speed", true),
    ];
    html! {
        ul.files {
            @for (name, about, exists) in all {
                @if exists { li { a href=(name) { (name) } ": " (about) } }
            }
        }
    }
}
