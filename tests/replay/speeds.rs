//! Motions of peridynamic grains that are too fast: contacts that may be missed, and numbers that are not finite.

use super::motions::{case, moved, replay, store, with};
use crate::program::{stderr, stdout};
use serde_json::{Value, json};

/// The two nodes at rest, and a third grain of one node at a place, with a speed and a force density along x.
fn shot(place: f64, speed: f64, force: f64) -> Value {
    let mut case = with(&[("/grains/0/vx", json!(0.0))]);
    let shot = json!({"rho": 1.0, "eps": 2.0, "c": 2.0, "s0": 0.5, "x": [place], "y": [0.1], "V": 1.0,
        "vx": speed, "force_density_x": force, "bonds": []});
    case["grains"]
        .as_array_mut()
        .expect("a list of grains")
        .push(shot);
    case
}

#[test]
fn grains_that_pass_through_each_other_are_refused() {
    // 8 m/s move a node by 1 m in 0.125 s; half of the contact radius, 0.25 m, takes 0.03125 s.
    let (output, files) = moved(&shot(-0.5, 8.0, 0.0), &[]);
    assert_eq!(output.status.code(), Some(2), "{}", stdout(&output));
    assert!(files.iter().all(String::is_empty));
    let said = stderr(&output);
    for part in [
        "case.json: conf.dt is 0.125: must be short enough for contacts, but in step 1, node 0 of grain 1 has a speed of 8.0000e0 m/s",
        "the time step must be at most 3.1",
    ] {
        assert!(said.contains(part), "{said}");
    }
    let mut slow = shot(-0.5, 8.0, 0.0);
    slow["conf"]["dt"] = json!(0.02);
    let (output, _) = moved(&slow, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(!stdout(&output).contains("missed"), "{}", stdout(&output));
}

#[test]
fn the_other_modes_go_on_and_say_which_contacts_may_be_missed() {
    for mode in ["paper", "authors", "two_fixes"] {
        let (output, [frames, ..]) = moved(&shot(-0.5, 8.0, 0.0), &["--mode", mode]);
        assert!(output.status.success(), "{}", stderr(&output));
        assert_eq!(frames.lines().count(), 1 + 3 * 2);
        let said = stdout(&output);
        let expected = "contacts may have been missed from step 1 on: node 0 of grain 1 has a speed of 8.0000e0 m/s";
        assert!(said.contains(expected), "{said}");
    }
}

/// A grain far away gains 1.25 m/s per step: it moves by 0.078, 0.234 and 0.391 m in its first steps. The authors' program
/// starts without acceleration: the grain moves by 0, 0.156 and 0.313 m.
#[test]
fn grains_that_become_too_fast_are_stopped() {
    let mut case = shot(-30.0, 0.0, 10.0);
    case["conf"]["modulo"] = json!(1);
    let (output, [frames, series, _]) = moved(&case, &[]);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    assert_eq!(frames.lines().count(), 1 + 3 * 2);
    assert_eq!(series.lines().count(), 1 + 2);
    let said = stderr(&output);
    let expected = "case.json: two: conf.dt is 0.125: must be short enough for contacts, but in step 3, node 0 of grain 1 has a speed of 2.5000e0 m/s";
    assert!(said.contains(expected), "{said}");
    assert!(
        stdout(&output).contains("failed in step 3 of 4"),
        "{}",
        stdout(&output)
    );
    let (output, _) = moved(&case, &["--mode", "authors"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let said = stdout(&output);
    assert!(said.contains("missed from step 3 on"), "{said}");
}

#[test]
fn the_time_step_is_that_of_the_case_that_has_it() {
    let folder = tempfile::tempdir().expect("a folder");
    store(
        &folder.path().join("given/case.json"),
        &shot(-30.0, 0.0, 10.0),
    );
    let file = folder.path().join("same/case.json");
    store(&file, &json!({"same_input_as": "given"}));
    let output = replay(&file, &folder.path().join("out"), &[]);
    assert_eq!(output.status.code(), Some(1));
    let said = stderr(&output);
    assert!(said.contains("conf.dt of "), "{said}");
    assert!(said.contains("given/case.json is 0.125: must be"), "{said}");
}

#[test]
fn numbers_that_are_not_finite_end_a_motion() {
    // The speed grows by 2e153 m/s per step, alike for both nodes: m v^2 overflows above 1.3e154 m/s, in step 7.
    let case = with(&[
        ("/conf/timesteps", json!(20)),
        ("/conf/modulo", json!(1)),
        ("/grains/0/vx", json!(0.0)),
        ("/grains/0/bonds", json!([])),
        ("/grains/0/force_density_x", json!(1.6e154)),
    ]);
    let (output, [frames, series, _]) = moved(&case, &[]);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    let said = stderr(&output);
    let expected = "case.json: two: in step 7, kinetic of series.csv is inf";
    assert!(said.contains(expected), "{said}");
    assert!(
        stdout(&output).contains("failed in step 7 of 20"),
        "{}",
        stdout(&output)
    );
    assert_eq!(series.lines().count(), 1 + 6);
    assert_eq!(frames.lines().count(), 1 + 2 * 6);
    for table in [frames, series] {
        assert!(!table.contains("inf") && !table.contains("NaN"), "{table}");
    }
}

#[test]
fn positions_that_are_not_finite_end_a_motion() {
    // In 1e100 s a node at 1e209 m/s moves beyond all numbers; the series has no row of this step.
    let folder = tempfile::tempdir().expect("a folder");
    let mut case = case();
    case["conf"] = json!({"timesteps": 4, "modulo": 4, "dt": 1e100});
    case["grains"][0]["bonds"] = json!([]);
    case["grains"][0]["vx"] = json!([0.0, 1e209]);
    let file = folder.path().join("in/case.json");
    store(&file, &case);
    std::fs::write(folder.path().join("in/frames.csv"), "step\n0\n1\n").expect("writable");
    let output = replay(&file, &folder.path().join("out"), &[]);
    assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
    let said = stderr(&output);
    let expected = "in step 1, x of node 1 of grain 0 in frames.csv is inf";
    assert!(said.contains(expected), "{said}");
    let frames = folder.path().join("out/frames.csv");
    let frames = std::fs::read_to_string(frames).expect("frames");
    assert_eq!(frames.lines().count(), 1 + 2);
}
