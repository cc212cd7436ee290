//! Runs that are interrupted by a signal, and finished runs that are extended.

use super::{assert_same, colliding_pair, complete, fault, start, summary, text};
use crate::program::{stderr, write_draft};
use gouge_validation::scenes::Draft;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// Start or continue a run and send it a signal as soon as its series has begun.
fn interrupt(scene: &Path, out: &Path, resume: bool, signal: &str) -> Option<i32> {
    let mut command = start(scene, out, resume);
    let running = command
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let began = Instant::now();
    // Resuming removes the summary, after signals are received.
    let is_running = || out.join("series.csv").exists() && !out.join("summary.json").exists();
    let has_begun = || is_running() || began.elapsed() > Duration::from_secs(10);
    while !has_begun() {
        std::thread::sleep(Duration::from_micros(100));
    }
    let sent = Command::new("kill")
        .args([signal, &running.id().to_string()])
        .status();
    assert!(sent.expect("a shell").success());
    let output = running.wait_with_output().expect("ours");
    if output.status.code() == Some(130) {
        assert!(stderr(&output).contains("--resume"), "{}", stderr(&output));
    }
    output.status.code()
}

#[test]
fn an_interrupted_run_says_so_and_continues_with_the_same_bits() {
    let folder = tempfile::tempdir().expect("a folder");
    let draft = fault("velocity-verlet", "cundall-strack-truncated", "vtk");
    let scene = write_draft(folder.path(), &draft.replacing("time.end", 400e-6));
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    complete(&scene, &reference, false);
    for (resume, signal) in [(false, "-INT"), (true, "-TERM"), (true, "-INT")] {
        assert_eq!(
            interrupt(&scene, &out, resume, signal),
            Some(130),
            "{signal}"
        );
        assert_eq!(summary(&out)["status"], "interrupted");
        for name in ["checkpoint", "series.csv", "particles.csv", "picture.svg"] {
            assert!(out.join(name).exists(), "{name}");
        }
        let output = start(&scene, &out, false)
            .output()
            .expect("the program starts");
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr(&output).contains("--resume"), "{}", stderr(&output));
    }
    complete(&scene, &out, true);
    assert_same(&out, &reference);
}

/// Runs in stages with later and later ends, compared with one run to the last end.
fn check_extension(draft: &Draft, ends: &[f64]) {
    let folder = tempfile::tempdir().expect("a folder");
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    let until = |end: f64| write_draft(folder.path(), &draft.clone().replacing("time.end", end));
    for (stage, &end) in ends.iter().enumerate() {
        let scene = until(end);
        if stage > 0 {
            let output = start(&scene, &out, false)
                .output()
                .expect("the program starts");
            assert_eq!(output.status.code(), Some(2));
            assert!(
                stderr(&output).contains("extend it with --resume"),
                "{}",
                stderr(&output)
            );
        }
        complete(&scene, &out, stage > 0);
        // The coarse step of the fault makes its runs untrusted, which are finished, too.
        let status = summary(&out)["status"].clone();
        assert!(status == "done" || status == "untrusted", "{status}");
    }
    complete(&until(ends[ends.len() - 1]), &reference, false);
    assert_same(&out, &reference);
}

#[test]
fn an_extended_run_has_the_bits_of_a_long_one() {
    // Samples at 10, 20, ... steps; the first and the third end lie between two samples.
    let pair = colliding_pair(1e-8).with("output.interval", 1e-7);
    check_extension(&pair, &[1.23e-6, 2e-6, 2.05e-6, 4e-6]);
    let fault = fault("beeman", "cundall-strack", "vtk");
    check_extension(&fault, &[20.1e-6, 21e-6, 30e-6]);
}

/// The last sample, which is not a regular one, is taken again; its residual counts once, and it counts.
#[test]
fn a_run_stopped_before_its_summary_says_the_same_of_itself() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &fault("beeman", "cundall-strack", "vtk"));
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    complete(&scene, &reference, false);
    complete(&scene, &out, false);
    fs::remove_file(out.join("summary.json")).expect("ours");
    complete(&scene, &out, true);
    assert_same(&out, &reference);
}

/// Without output.interval, samples are 200th parts of the run; an extended run keeps those of the shorter one.
#[test]
fn a_run_without_an_interval_is_extended() {
    let folder = tempfile::tempdir().expect("a folder");
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    let until = |end: f64| {
        let pair = colliding_pair(1e-8).without("output.interval");
        pair.replacing("time.end", end)
    };
    let given = until(4e-6).with("output.interval", 1e-8);
    complete(&write_draft(folder.path(), &given), &reference, false);
    complete(&write_draft(folder.path(), &until(2e-6)), &out, false);
    let longer = write_draft(folder.path(), &until(4e-6));
    complete(&longer, &out, true);
    for name in ["series.csv", "particles.csv"] {
        let read = |folder: &Path| fs::read(folder.join(name)).expect(name);
        assert!(read(&out) == read(&reference), "{name}");
    }
    let output = start(&longer, &out, false)
        .output()
        .expect("the program starts");
    assert!(
        stderr(&output).contains("nothing to do"),
        "{}",
        stderr(&output)
    );
}

#[test]
fn a_run_is_not_extended_if_anything_else_differs() {
    let folder = tempfile::tempdir().expect("a folder");
    let pair = colliding_pair(1e-8).with("output.interval", 1e-7);
    let until = |draft: &Draft, end: f64| {
        write_draft(folder.path(), &draft.clone().replacing("time.end", end))
    };
    let out = folder.path().join("out");
    complete(&until(&pair, 1e-6), &out, false);
    let other = pair.clone().replacing("output.interval", 2e-7);
    let output = start(&until(&other, 2e-6), &out, true)
        .output()
        .expect("the program starts");
    assert_eq!(output.status.code(), Some(1));
    let said = stderr(&output);
    for words in [
        "output.interval is 1e-7 there and 2e-7 here",
        "time.end is 1e-6 there",
    ] {
        assert!(said.contains(words), "{said}");
    }
    assert!(said.contains(text(&out)), "{said}");
}
