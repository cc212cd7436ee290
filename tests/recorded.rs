//! Recorded outputs of this program: summaries of scenes, outputs and error messages.
//!
//! The recordings in `recorded/` are our own. They show that something changed, not that it is right; results of other
//! programs are in `references/`. `cargo insta review` accepts a change.

use crate::program::{run, stderr, stdout, write_draft, write_scene};
use gouge_validation::scenes::Draft;
use std::process::Output;

/// Compare a text with the recording of the given name.
pub fn record(name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path("recorded");
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}

/// Status, output and errors of a command, as a user sees them.
fn seen(output: &Output) -> String {
    format!(
        "status {}\n--- output\n{}--- errors\n{}",
        output.status.code().expect("a status"),
        stdout(output),
        stderr(output)
    )
}

/// The lines of a summary that depend neither on the machine nor on the build.
fn machine_independent(summary: &str) -> String {
    let varying = ["wall_seconds", "_per_second", "\"commit\""];
    let is_steady = |line: &&str| !varying.iter().any(|word| line.contains(word));
    let lines: Vec<&str> = summary.lines().filter(is_steady).collect();
    lines.join("\n")
}

#[test]
fn summaries_of_built_in_scenes() {
    for (name, end, shorter) in [
        ("head-on", "", ""),
        ("oblique", "", ""),
        ("rolling", "end = 0.3", "end = 0.03"),
        ("cantilever", "end = 4e-3", "end = 4e-5"),
        ("three-point-bend", "end = 3e-3", "end = 3e-5"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let text = stdout(&run(&["scenes", name]));
        assert!(
            text.contains(end),
            "{name} does not contain the expected end time"
        );
        let scene = write_scene(folder.path(), &text.replace(end, shorter));
        let out = folder.path().join("out");
        let [scene, out] = [&scene, &out].map(|path| path.to_str().expect("UTF-8"));
        let output = run(&["run", scene, "--out", out, "--quiet"]);
        assert!(output.status.success(), "{name}: {}", stderr(&output));
        let summary = std::fs::read_to_string(format!("{out}/summary.json")).expect("a summary");
        record(&format!("summary_{name}"), &machine_independent(&summary));
    }
}

/// Recorded before the writers of series and frames became independent of the model.
#[test]
fn series_particles_and_frames_of_a_chain() {
    let chain = include_str!("recorded/chain.toml");
    for (format, ending) in [("vtk", "vtk"), ("extxyz", "xyz")] {
        let folder = tempfile::tempdir().expect("a folder");
        let draft = Draft::parse(chain).with("output.trajectory", format);
        let scene = write_draft(folder.path(), &draft);
        let out = folder.path().join("out");
        let [scene, out] = [&scene, &out].map(|path| path.to_str().expect("UTF-8"));
        let output = run(&["run", scene, "--out", out, "--quiet"]);
        assert!(output.status.success(), "{}", stderr(&output));
        let read = |name: &str| std::fs::read_to_string(format!("{out}/{name}")).expect(name);
        let frame = read(&format!("trajectory/frame_000020.{ending}"));
        record(&format!("frame_{format}"), &frame);
        let series = read("series.csv");
        let rows: Vec<&str> = series.lines().take(25).collect();
        record("series_of_a_chain", &rows.join("\n"));
        record("particles_of_a_chain", &read("particles.csv"));
    }
}

#[test]
fn output_of_commands() {
    for (name, arguments) in [
        ("help", &["--help"][..]),
        ("help_run", &["run", "--help"]),
        ("help_verify", &["verify", "--help"]),
        ("scenes", &["scenes"]),
        (
            "scene_of_a_stored_run",
            &["scenes", "lammps/haff-werner/grazing"],
        ),
        ("links", &["links", "lammps/bond-forces/all"]),
        ("stability_head_on", &["stability", "head-on"]),
        ("stability_oblique", &["stability", "oblique"]),
    ] {
        record(name, &seen(&run(arguments)));
    }
}

#[test]
fn messages_of_errors() {
    for (name, arguments) in [
        ("no_command", &[][..]),
        ("no_such_command", &["simulate"]),
        ("no_scene", &["run"]),
        ("no_such_scene", &["scenes", "no-such-scene"]),
        ("no_such_file", &["links", "no-such-file.toml"]),
        (
            "no_such_stored_run",
            &["scenes", "lammps/haff-werner/no-such-run"],
        ),
    ] {
        record(name, &seen(&run(arguments)));
    }
    for (name, text, replace, with) in [
        ("error_syntax", "head-on", "[time]", "[time"),
        (
            "error_unknown_key",
            "head-on",
            "[time]",
            "[time]\nduration = 1.0",
        ),
        ("error_missing_key", "head-on", "step = ", "# step = "),
        ("error_integrator", "head-on", "velocity-verlet", "leapfrog"),
        (
            "error_type",
            "oblique",
            "stiffness = ",
            "stiffness = \"stiff\" # ",
        ),
        ("error_range", "oblique", "radius = ", "radius = -"),
        ("error_overflow", "head-on", "step = ", "step = 1.0 # "),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let scene = stdout(&run(&["scenes", text]));
        assert!(scene.contains(replace), "{text} has no '{replace}'");
        let path = write_scene(folder.path(), &scene.replacen(replace, with, 1));
        let [path, out] = [path, folder.path().join("out")].map(|path| path.display().to_string());
        let output = run(&["run", &path, "--out", &out, "--quiet"]);
        let folder = folder.path().display().to_string();
        record(name, &seen(&output).replace(&folder, "FOLDER"));
    }
}
