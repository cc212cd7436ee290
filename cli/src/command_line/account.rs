//! What `gouge run` prints at its end: the files, what the run shows, and how to look at it.

use gouge_runner::any_scene::AnyScene;
use gouge_runner::contact_dynamics;
use gouge_runner::peridem;
use gouge_runner::run::{Friction, Summary};
use gouge_runner::scene::{Scene, Trajectory};
use std::fmt::Write;
use std::path::Path;

/// Number of intervals between samples below which there are no ten blocks of two in the second half of a run.
const MOST_SCARCE: f64 = 40.0;

/// The account of a finished run in a folder.
pub fn account(scene: &AnyScene, summary: &Summary, folder: &Path) -> String {
    match scene {
        AnyScene::Dem(scene) => account_of_grains(scene, summary, folder),
        AnyScene::ContactDynamics(scene) => account_of_bodies(scene, summary, folder),
        AnyScene::Peridem(scene) => account_of_nodes(scene, summary, folder),
    }
}

/// The account of a run of the thesis's model.
fn account_of_grains(scene: &Scene, summary: &Summary, folder: &Path) -> String {
    let mut text = String::new();
    let mut line = |name: &str, content: &str| {
        let _ = writeln!(text, "{name:16}{content}");
    };
    line("status", &summary.status);
    line(
        "run",
        &format!(
            "{} particles, {} steps until {:.4e} s, in {:.1} s of wall time",
            summary.particles, summary.steps, summary.time, summary.wall_seconds
        ),
    );
    if summary.bonds_initial > 0 {
        let (broken, initial) = (summary.bonds_broken, summary.bonds_initial);
        line("bonds", &format!("{broken} of {initial} broken"));
    }
    if let Some(friction) = &summary.friction {
        friction_lines(friction)
            .iter()
            .for_each(|(name, content)| line(name, content));
    } else if scene.driving.is_some() {
        line(
            "friction",
            &format!("not averaged: {}", without_friction(scene, summary)),
        );
    }
    line("energy balance", &balance(summary));
    line(
        "warnings",
        &match summary.warnings.len() {
            0 => "none".to_owned(),
            number => format!("{number}, listed in summary.json and above"),
        },
    );
    text.push('\n');
    text + &listed(files(scene), folder)
}

fn balance(summary: &Summary) -> String {
    match summary.balance_error {
        Some(error) => format!("closes to {:.1e} of the energy exchanged", error),
        None => "not watched, because output.energy is false".to_owned(),
    }
}

/// Why friction was not averaged.
fn without_friction(scene: &Scene, summary: &Summary) -> String {
    let intervals = summary.time / scene.output.interval;
    if !scene.output.energy {
        "the work of the drive is known only with output.energy = true".to_owned()
    } else if intervals < MOST_SCARCE {
        format!(
            "{intervals:.0} samples are too few for ten blocks; choose a smaller output.interval"
        )
    } else {
        "the driven grains do not slide under load all the time".to_owned()
    }
}

fn friction_lines(friction: &Friction) -> Vec<(&'static str, String)> {
    let [low, high] = friction.interval;
    let mut lines = vec![
        (
            "friction",
            format!(
                "{:.3}, 95 % interval {low:.3} to {high:.3}: work of the drive over load times slip",
                friction.coefficient
            ),
        ),
        (
            "",
            format!(
                "from {:.3e} s to the end, {:.3e} m of slip, interval from ten blocks",
                friction.since, friction.slip
            ),
        ),
        (
            "",
            format!(
                "instantaneous samples: mean {:.3}, standard deviation {:.3}",
                friction.samples_mean, friction.samples_deviation
            ),
        ),
    ];
    if low < 0.0 && high > 0.0 {
        let content = "not distinguishable from zero; run longer, or average over seeds".to_owned();
        lines.push(("", content));
    }
    if friction.is_correlated() {
        let content = format!(
            "neighbouring blocks are correlated ({:.2}): the interval is too narrow; run longer",
            friction.correlation
        );
        lines.push(("", content));
    }
    lines
}

fn files(scene: &Scene) -> Vec<(&'static str, &'static str)> {
    let mut files = vec![
        (
            "run.html",
            "verdict, figures and picture; opens in a browser",
        ),
        ("picture.svg", "final state; opens in a browser"),
        (
            "series.csv",
            "energies, friction and fragments over time; opens in pandas",
        ),
        (
            "particles.csv",
            "final particles; another scene can read them as particles_file",
        ),
        (
            "restart.toml",
            "a scene that continues from the final state, as text",
        ),
        ("summary.json", "this account and more"),
        (
            "checkpoint",
            "final state to the bit, for --resume and the key start",
        ),
    ];
    if scene.bond.is_some() {
        files.push((
            "bonds.csv",
            "final bonds; breaks.csv lists those that broke",
        ));
    }
    files.extend(frames(scene.output.trajectory));
    match (scene.output.links, scene.output.trajectory) {
        (true, Trajectory::Vtk) => {
            files.push((
                "trajectory/links.vtk.series",
                "contacts and bonds; opens in ParaView",
            ));
        }
        (true, _) => {
            files.push((
                "trajectory/links_000000.dump",
                "contacts and bonds; opens in OVITO",
            ));
        }
        _ => {}
    }
    files
}

/// The account of a run of contact dynamics.
fn account_of_bodies(scene: &contact_dynamics::Scene, summary: &Summary, folder: &Path) -> String {
    let run = format!(
        "{} bodies, {} steps until {:.4e} s, in {:.1} s of wall time",
        summary.particles, summary.steps, summary.time, summary.wall_seconds
    );
    let lines = [
        ("status", summary.status.clone()),
        ("run", run),
        ("energy balance", balance(summary)),
        ("warnings", warnings(summary)),
    ];
    let lines = lines.into_iter().chain(summary.network_lines());
    written(lines) + &listed(files_of_bodies(scene), folder)
}

fn warnings(summary: &Summary) -> String {
    match summary.warnings.len() {
        0 => "none".to_owned(),
        number => format!("{number}, listed in summary.json"),
    }
}

/// One line per name and content, then an empty line.
fn written(lines: impl Iterator<Item = (&'static str, String)>) -> String {
    let mut text = String::new();
    for (name, content) in lines {
        let _ = writeln!(text, "{name:16}{content}");
    }
    text.push('\n');
    text
}

/// The account of a run of peridynamic grains.
fn account_of_nodes(scene: &peridem::Scene, summary: &Summary, folder: &Path) -> String {
    let run = format!(
        "{} nodes, {} steps until {:.4e} s, in {:.1} s of wall time",
        summary.particles, summary.steps, summary.time, summary.wall_seconds
    );
    let (broken, initial) = (summary.bonds_broken, summary.bonds_initial);
    let lines = [
        ("status", summary.status.clone()),
        ("run", run),
        ("bonds", format!("{broken} of {initial} broken")),
    ];
    let last = [
        ("energy balance", balance(summary)),
        ("warnings", warnings(summary)),
    ];
    let own = summary.peridem_lines();
    let lines = lines.into_iter().chain(own).chain(last);
    written(lines) + &listed(files_of_nodes(scene), folder)
}

fn files_of_nodes(scene: &peridem::Scene) -> Vec<(&'static str, &'static str)> {
    let files = [
        (
            "run.html",
            "verdict, figures and picture; opens in a browser",
        ),
        (
            "picture.svg",
            "final state coloured by damage; opens in a browser",
        ),
        (
            "series.csv",
            "energies, damage, pieces, cracks and wall forces over time; opens in pandas",
        ),
        ("nodes.csv", "final nodes; opens in pandas"),
        ("grains.csv", "final grains; opens in pandas"),
        ("breaks.csv", "the bonds that broke, in order"),
        ("bonds.csv", "the final bonds"),
        ("summary.json", "this account and more"),
        ("checkpoint", "final state to the bit, for --resume"),
    ];
    let frames = frames(scene.output.trajectory);
    files.into_iter().chain(frames).collect()
}

/// The files of frames in a format.
fn frames(trajectory: Trajectory) -> Option<(&'static str, &'static str)> {
    match trajectory {
        Trajectory::None => None,
        Trajectory::Vtk => Some(("trajectory/run.vtk.series", "frames; opens in ParaView")),
        Trajectory::Extxyz => Some(("trajectory/frame_000000.xyz", "frames; opens in OVITO")),
    }
}

fn files_of_bodies(scene: &contact_dynamics::Scene) -> Vec<(&'static str, &'static str)> {
    let files = [
        (
            "run.html",
            "verdict, figures and picture; opens in a browser",
        ),
        (
            "picture.svg",
            "final state with its forces; opens in a browser",
        ),
        (
            "series.csv",
            "stresses, work, sweeps and overlap over time; opens in pandas",
        ),
        (
            "network.csv",
            "sums over the contact network over time; opens in pandas",
        ),
        (
            "particles.csv",
            "final bodies; another scene can read them as particles_file",
        ),
        (
            "contacts.csv",
            "contact points of the last step, with forces and impulses",
        ),
        ("summary.json", "this account and more"),
        ("checkpoint", "final state to the bit, for --resume"),
    ];
    let frames = frames(scene.output.trajectory);
    files.into_iter().chain(frames).collect()
}

/// The files that exist, with their paths.
fn listed(mut files: Vec<(&'static str, &'static str)>, folder: &Path) -> String {
    files.retain(|(name, _)| folder.join(name).exists());
    let path = |name: &str| folder.join(name).display().to_string();
    let width = files.iter().map(|(name, _)| path(name).len()).max();
    let width = width.unwrap_or_default();
    let line = |(name, content): &(&str, &str)| format!("{:width$}  {content}\n", path(name));
    files.iter().map(line).collect()
}
