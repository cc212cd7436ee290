//! Folders, files and cases that cannot be used.

use super::{local, motion, near, replay, resting, shape, write};
use crate::program::{run, stderr};
use serde_json::{Value, json};
use std::path::Path;

/// What the command says to a folder of which nothing can be used; nothing may be written.
fn refused(folder: &Path) -> String {
    let (output, results) = replay(folder);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(results.is_none());
    stderr(&output)
}

#[test]
fn unusable_folders_and_files_are_refused_as_a_whole() {
    let folder = tempfile::tempdir().expect("a folder");
    let absent = folder.path().join("absent");
    let output = run(&[
        "replay",
        absent.to_str().expect("UTF-8"),
        "--out",
        "results.json",
    ]);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        stderr(&output).contains("absent: not a folder"),
        "{}",
        stderr(&output)
    );
    let said = refused(folder.path());
    assert!(
        said.contains("has none of geometry.json, local.json"),
        "{said}"
    );
    write(folder.path(), "geometry.json", &json!({"problems": []}));
    let said = refused(folder.path());
    assert!(
        said.contains("geometry.json: pairs is missing: must be a list"),
        "{said}"
    );
    std::fs::write(folder.path().join("geometry.json"), "{\"pairs\": [1, }").expect("writable");
    let said = refused(folder.path());
    assert!(
        said.contains("geometry.json: not JSON") && said.contains("line 1"),
        "{said}"
    );
}

#[test]
fn inputs_are_never_replaced() {
    let folder = tempfile::tempdir().expect("a folder");
    let cases = json!({"problems": [local("one", 0.0, 0.5, [-4.0, 0.5])]});
    write(folder.path(), "local.json", &cases);
    let path = folder.path().to_str().expect("UTF-8");
    for out in [
        format!("{path}/local.json"),
        format!("{path}/./local.json"),
        path.to_owned(),
    ] {
        let output = run(&["replay", path, "--out", &out]);
        assert_eq!(output.status.code(), Some(2), "{out}: {}", stderr(&output));
    }
    let kept = std::fs::read_to_string(folder.path().join("local.json")).expect("readable");
    assert_eq!(kept, cases.to_string());
    let output = run(&[
        "replay",
        path,
        "--out",
        &format!("{path}/absent/results.json"),
    ]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        stderr(&output).contains("cannot write"),
        "{}",
        stderr(&output)
    );
}

/// A case with a key replaced, or removed by null.
fn with(mut case: Value, key: &str, value: Value) -> Value {
    case[key] = value;
    case
}

/// A file and its list with one bad case, and what must be said about it.
type Bad = (&'static str, &'static str, Value, &'static str);

fn bad_points_and_shapes() -> Vec<Bad> {
    let point = |key: &str, value: Value| with(local("bad", 0.0, 0.5, [-4.0, 0.5]), key, value);
    let disc = || shape(0, 0.5, [0.0, 0.0], 0.0);
    let pair =
        |key: &str, value: Value| json!({"id": "bad", "a": with(disc(), key, value), "b": disc()});
    let of_point = |case, said| ("local", "problems", case, said);
    let of_pair = |case, said| ("geometry", "pairs", case, said);
    vec![
        of_point(point("mu", Value::Null), "mu is missing: must be a number"),
        of_point(
            point("mu", json!("high")),
            "mu is \"high\": must be a number",
        ),
        of_point(
            point("mu", json!(-1.0)),
            "mu is -1.0: must be a number that is not",
        ),
        of_point(
            point("W_nn", json!(0.0)),
            "W_nn is 0.0: must be a positive number",
        ),
        of_point(
            point("u_free", json!([1.0])),
            "u_free is [1.0]: must be 2 numbers",
        ),
        of_pair(pair("n", json!(2)), "a polygon needs at least 3 vertices"),
        of_pair(pair("n", json!(4.5)), "a.n is 4.5: must be a whole number"),
        of_pair(pair("R", json!([])), "a.R is []: must be a number"),
        of_pair(json!({"id": "bad", "a": 7}), "a is 7: must be an object"),
    ]
}

fn bad_systems() -> Vec<Bad> {
    let step = |key: &str, value: Value| with(resting("bad", 0.0, "closed"), key, value);
    let contact = |key: &str, value: Value| {
        let mut case = resting("bad", 0.0, "closed");
        case["contacts"][0][key] = value;
        case
    };
    let entries = json!({"row": [0, 2], "col": [0, 1], "val": [1.0, 1.0]});
    let assembled = json!({"id": "bad", "form": "assembled", "contacts": 1, "mu": [0.5], "q": [1.0, 0.0], "W": entries});
    let of_step = |case, said| ("onestep", "problems", case, said);
    vec![
        of_step(
            step("gap_mode", json!("soft")),
            "must be one of: closed, alert",
        ),
        of_step(step("e_n", json!(1.5)), "normal restitution is 1.5"),
        of_step(
            contact("b", json!(2)),
            "contacts[0].b is 2: must be an index of bodies",
        ),
        of_step(contact("b", json!(0)), "different dof"),
        of_step(contact("n", json!([0.0, 2.0])), "n is a unit vector"),
        (
            "siconos2d",
            "problems",
            assembled,
            "W.row[1] is 2: must be an index below 2",
        ),
    ]
}

fn bad_motions_and_networks() -> Vec<Bad> {
    let slide = json!({"side": 1.0, "v0": 1.0, "mu": 0.0, "dt": 0.1});
    let of_motion = |case, said| ("dynamics", "cases", case, said);
    let of_network = |case, said| ("observables", "networks", case, said);
    let empty = json!({"network": "bad", "pairs": [], "volume": 1.0});
    vec![
        of_motion(motion("pendulum", json!({})), "must be one of these kinds"),
        of_motion(json!({"id": "landing-1"}), "setup is missing"),
        of_motion(motion("block-stops-1", slide), "within 10000000 steps"),
        of_network(json!({"network": "bad"}), "unless the network has pairs"),
        of_network(empty, "is not finite"),
    ]
}

#[test]
fn bad_cases_are_listed_and_the_others_solved() {
    let all = [
        bad_points_and_shapes(),
        bad_systems(),
        bad_motions_and_networks(),
    ];
    for (name, list, case, said) in all.into_iter().flatten() {
        let folder = tempfile::tempdir().expect("a folder");
        let good = json!({"problems": [local("good", 0.0, 0.5, [-4.0, 0.5])]});
        write(folder.path(), "local.json", &good);
        let cases = match name {
            "local" => json!({"problems": [case, good["problems"][0]]}),
            _ => json!({list: [case], "g": 9.81}),
        };
        write(folder.path(), &format!("{name}.json"), &cases);
        let (output, results) = replay(folder.path());
        let errors = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}: {errors}");
        let of_case = cases[list][0].get("id").or(cases[list][0].get("network"));
        let id = of_case.and_then(Value::as_str).expect("an identity");
        assert!(
            errors.contains(&format!("{name}.json: {id}: ")),
            "{said}: {errors}"
        );
        assert!(errors.contains(said), "{said}: {errors}");
        assert!(errors.contains("1 of 2 cases have no result"), "{errors}");
        near(
            &results.expect("results")["local"]["good"]["P"],
            &json!([2.0, -0.5]),
            0.0,
        );
    }
}

#[test]
fn cases_need_different_identities() {
    let folder = tempfile::tempdir().expect("a folder");
    let one = local("one", 0.0, 0.5, [-4.0, 0.5]);
    let nameless = with(one.clone(), "id", Value::Null);
    write(
        folder.path(),
        "local.json",
        &json!({"problems": [one, one, nameless]}),
    );
    let (output, results) = replay(folder.path());
    let errors = stderr(&output);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        errors.contains("local.json: one: id is \"one\": must be different"),
        "{errors}"
    );
    assert!(
        errors.contains("local.json: problems[2]: id is missing"),
        "{errors}"
    );
    assert_eq!(
        results.expect("results")["local"]
            .as_object()
            .map(|all| all.len()),
        Some(1)
    );
}
