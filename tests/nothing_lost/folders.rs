//! Folders that hold something already: results are replaced only if the user says so.

use super::{Files, colliding_pair, complete, files, start, text};
use crate::program::{run, stderr, write_draft, write_scene};
use gouge_validation::scenes::Draft;
use std::fs;
use std::path::Path;
use std::process::Output;
use std::time::{Duration, Instant};

/// Run a scene and check that it is refused with some words, and that no file changes.
fn refused(arguments: &[&str], out: &Path, words: &[&str]) {
    let before = files(out);
    let output = run(&[&["run", "--out", text(out)], arguments].concat());
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    for word in words {
        assert!(said.contains(word), "{word}: {said}");
    }
    assert!(files(out) == before, "a file has changed: {said}");
}

/// A scene of a few steps.
fn brief(end: f64) -> Draft {
    colliding_pair(1e-8).replacing("time.end", end)
}

#[test]
fn the_same_finished_run_is_left_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let (scene, out) = (
        write_draft(folder.path(), &brief(1e-6)),
        folder.path().join("out"),
    );
    complete(&scene, &out, false);
    let before = files(&out);
    for resume in [false, true] {
        let output = start(&scene, &out, resume).output().expect("starts");
        assert!(output.status.success(), "{}", stderr(&output));
        assert!(
            stderr(&output).contains("nothing to do"),
            "{}",
            stderr(&output)
        );
        assert!(files(&out) == before);
    }
    // Without all of its results it is not called finished.
    for name in ["series.csv", "particles.csv", "picture.svg"] {
        let path = out.join(name);
        let bytes = fs::read(&path).expect(name);
        fs::remove_file(&path).expect("ours");
        refused(&[text(&scene)], &out, &[name, "--overwrite"]);
        fs::write(&path, bytes).expect("ours");
    }
}

#[test]
fn results_of_another_scene_are_replaced_only_on_request() {
    let folder = tempfile::tempdir().expect("a folder");
    let (scene, out) = (
        write_draft(folder.path(), &brief(1e-6)),
        folder.path().join("out"),
    );
    complete(&scene, &out, false);
    let scene = text(&scene);
    let step = "time.step is 1e-8 there and 2e-8 here";
    refused(
        &[scene, "--set", "time.step=2e-8"],
        &out,
        &[step, "--overwrite"],
    );
    refused(
        &["oblique"],
        &out,
        &[text(&out), "another scene", "more keys differ"],
    );
    refused(&[scene, "--set", "time.end=0.5e-6"], &out, &["time.end"]);
    refused(&["no-such-scene"], &out, &["no-such-scene"]);
    // Resuming is refused with another status, because the arguments are right and the folder is not.
    let before = files(&out);
    let output = run(&[
        "run",
        scene,
        "--out",
        text(&out),
        "--resume",
        "--set",
        "time.step=2e-8",
    ]);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains(step), "{}", stderr(&output));
    assert!(files(&out) == before);
    // The title and the form of numbers do not make another scene.
    for same in ["title=\"other\"", "time.step=10e-9", "output.energy=true"] {
        let output = run(&["run", scene, "--out", text(&out), "--set", same]);
        assert!(
            stderr(&output).contains("nothing to do"),
            "{}",
            stderr(&output)
        );
    }
    let output = run(&["run", "oblique", "--out", text(&out), "--overwrite"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(files(&out) != before);
}

#[test]
fn the_content_of_files_counts_and_not_their_names() {
    let folder = tempfile::tempdir().expect("a folder");
    let list = |name: &str, speed: f64| {
        let rows = format!("x,y,radius,vx\n0,0,1e-3,{speed}\n1,0,1e-3,0\n");
        fs::write(folder.path().join(name), rows).expect("ours");
    };
    list("a.csv", 1.0);
    list("b.csv", 1.0);
    let named = |name: &str| {
        let text =
            "[time]\nstep = 1e-6\nend = 1e-5\nintegrator = \"euler\"\n[material]\ndensity = 1.0\n";
        write_scene(
            folder.path(),
            &format!("particles_file = \"{name}\"\n{text}"),
        )
    };
    let out = folder.path().join("out");
    complete(&named("a.csv"), &out, false);
    let output = run(&["run", text(&named("b.csv")), "--out", text(&out)]);
    assert!(
        stderr(&output).contains("nothing to do"),
        "{}",
        stderr(&output)
    );
    list("a.csv", 2.0);
    refused(
        &[text(&named("a.csv"))],
        &out,
        &["particles_file is \"a.csv\" with the hash"],
    );
}

#[test]
fn foreign_files_with_the_names_of_outputs_are_kept() {
    let folder = tempfile::tempdir().expect("a folder");
    let names = [
        "series.csv",
        "particles.csv",
        "picture.svg",
        "summary.json",
        "trajectory/frame_000003.vtk",
    ];
    for (number, name) in names.iter().enumerate() {
        let out = folder.path().join(number.to_string());
        let path = out.join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("ours");
        fs::write(&path, "precious").expect("ours");
        refused(&["head-on"], &out, &[name, "no checkpoint", "--overwrite"]);
        refused(&["head-on", "--resume"], &out, &[name, "no checkpoint"]);
    }
    let out = folder.path().join("foreign");
    fs::create_dir(&out).expect("ours");
    fs::write(out.join("checkpoint"), "precious").expect("ours");
    refused(&["head-on"], &out, &["a checkpoint", "--overwrite"]);
}

#[test]
fn inputs_in_the_output_folder_are_never_replaced() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in [
        "particles.csv",
        "trajectory/frame_000000.vtk",
        "trajectory/frame_start.csv",
    ] {
        let out = folder.path().join(name.replace('/', "-"));
        let list = out.join(name);
        fs::create_dir_all(list.parent().expect("a folder")).expect("ours");
        fs::write(&list, "x,y,radius\n0,0,1e-3\n").expect("ours");
        let scene = Draft::open_box(gouge_dem::integrators::Integrator::Euler, 1e-3)
            .ending_at(1e-2)
            .with("output.trajectory", "vtk")
            .with("particles_file", name);
        let scene = write_draft(&out, &scene);
        let output = run(&["run", text(&scene), "--out", text(&out), "--overwrite"]);
        let is_ours = !name.contains("start");
        assert_eq!(
            output.status.code(),
            Some(if is_ours { 2 } else { 0 }),
            "{}",
            stderr(&output)
        );
        assert_eq!(fs::read(&list).expect(name), b"x,y,radius\n0,0,1e-3\n");
    }
}

/// Outputs of two runs that were started together.
fn together(scenes: [&str; 2], out: &Path) -> [Output; 2] {
    let start = |scene: &str| {
        let mut command = crate::program::gouge();
        command.args(["run", scene, "--out", text(out), "-q"]);
        command.stderr(std::process::Stdio::piped());
        command.spawn().expect("the program starts")
    };
    let running = scenes.map(start);
    running.map(|child| child.wait_with_output().expect("it ends"))
}

#[test]
fn of_two_runs_in_one_folder_one_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &brief(1e-4));
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    complete(&scene, &reference, false);
    let rows = |out: &Path| fs::read(out.join("series.csv")).expect("a series");
    for _ in 0..10 {
        let outputs = together([text(&scene), "oblique"], &out);
        let ended = outputs.each_ref().map(|output| output.status.code());
        assert!(
            matches!(ended, [Some(0), Some(2)] | [Some(2), Some(0)]),
            "{ended:?} {}{}",
            stderr(&outputs[0]),
            stderr(&outputs[1])
        );
        if ended[0] == Some(0) {
            assert_eq!(rows(&out), rows(&reference));
        }
        fs::remove_dir_all(&out).expect("ours");
    }
}

#[test]
fn a_folder_in_use_is_refused_and_its_user_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let scene = write_draft(folder.path(), &brief(10.0));
    let mut running = start(&scene, &out, false)
        .spawn()
        .expect("the program starts");
    let began = Instant::now();
    while !out.join("series.csv").exists() && began.elapsed() < Duration::from_secs(10) {
        std::thread::sleep(Duration::from_millis(1));
    }
    let holder = format!("process {} on ", running.id());
    for flag in ["--resume", "--overwrite"] {
        let output = run(&["run", text(&scene), "--out", text(&out), flag]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(&holder), "{said}");
    }
    running.kill().expect("ours");
    running.wait().expect("ours");
    // A run that was killed locks nothing any more.
    let output = run(&["run", "head-on", "--out", text(&out), "--overwrite"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let left: Files = files(&out);
    assert!(
        !left.keys().any(|path| text(path).contains("gouge-")),
        "{:?}",
        left.keys()
    );
}

/// A run whose folder is moved away stops, and touches neither what is there now nor its lock.
#[test]
fn a_run_leaves_a_folder_that_took_the_place_of_its_own_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let long = write_draft(
        folder.path(),
        &colliding_pair(1e-8).replacing("time.end", 1.0),
    );
    let mut command = start(&long, &out, false);
    command.stderr(std::process::Stdio::piped());
    let running = command.spawn().expect("the program starts");
    let began = Instant::now();
    while !out.join("series.csv").exists() && began.elapsed() < Duration::from_secs(20) {
        std::thread::sleep(Duration::from_millis(1));
    }
    fs::rename(&out, folder.path().join("elsewhere")).expect("a new name");
    let short = folder.path().join("short.toml");
    let text_of = brief(1e-6).text().expect("a scene");
    fs::write(&short, text_of).expect("a scene");
    complete(&short, &out, false);
    let before = files(&out);
    fs::write(out.join(".gouge-lock"), "of another run").expect("a file");
    let output = running.wait_with_output().expect("it ends");
    // Either it notices before it writes, or the write fails because the folder is gone.
    let said = stderr(&output);
    let is_told = said.contains("moved or replaced") || said.contains("cannot write");
    assert!(!output.status.success() && is_told, "{said}");
    let lock = fs::read_to_string(out.join(".gouge-lock")).expect("still there");
    assert_eq!(lock, "of another run");
    fs::remove_file(out.join(".gouge-lock")).expect("ours");
    assert!(files(&out) == before);
}

#[cfg(unix)]
#[test]
fn links_in_an_output_folder_are_never_followed() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &brief(1e-6));
    let precious = folder.path().join("precious");
    fs::write(&precious, "precious").expect("a file");
    let frames = folder.path().join("frames");
    fs::create_dir(&frames).expect("a folder");
    fs::write(frames.join("frame_000000.vtk"), "precious").expect("a file");
    for (name, target) in [(".gouge-lock", &precious), ("trajectory", &frames)] {
        let out = folder.path().join(format!("out{name}"));
        fs::create_dir(&out).expect("a folder");
        std::os::unix::fs::symlink(target, out.join(name)).expect("a link");
        let output = start(&scene, &out, false)
            .arg("--overwrite")
            .output()
            .expect("starts");
        assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
        assert!(stderr(&output).contains("is a link"), "{}", stderr(&output));
    }
    // The temporary file of a checkpoint may be a link to anything: it is replaced, not followed.
    let out = folder.path().join("out");
    fs::create_dir(&out).expect("a folder");
    std::os::unix::fs::symlink(&precious, out.join(".checkpoint.gouge-partial")).expect("a link");
    complete(&scene, &out, false);
    let read = |path: &Path| fs::read_to_string(path).expect("a file");
    assert_eq!(read(&precious), "precious");
    assert_eq!(read(&frames.join("frame_000000.vtk")), "precious");
}
