//! Motions of peridynamic grains: what a case may leave out, what is refused, and steps that fail.

use super::near;
use crate::program::{run, stderr, stdout};
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;
use std::process::Output;

/// Write a file, which is compressed if its name says so.
pub fn store(file: &Path, value: &Value) {
    let text = value.to_string().into_bytes();
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    let bytes = match file.extension().is_some_and(|ending| ending == "gz") {
        true => encoder
            .write_all(&text)
            .and_then(|()| encoder.finish())
            .expect("gzip"),
        false => text,
    };
    std::fs::create_dir_all(file.parent().expect("a folder")).expect("writable");
    std::fs::write(file, bytes).expect("writable");
}

/// Repeat a stored file into a folder.
pub fn replay(file: &Path, out: &Path, more: &[&str]) -> Output {
    let [file, out] = [file, out].map(|path| path.to_str().expect("UTF-8"));
    run(&[&["replay", file, "--out", out], more].concat())
}

/// The output of the command for a file with a name, and the JSON it wrote, null if there is none.
pub fn replayed(name: &str, file: &Value, more: &[&str]) -> (Output, Value) {
    let folder = tempfile::tempdir().expect("a folder");
    let (path, out) = (folder.path().join(name), folder.path().join("out"));
    store(&path, file);
    let output = replay(&path, &out, more);
    let found = std::fs::read_to_string(out.join(name.trim_end_matches(".gz"))).ok();
    let found = found.map_or(Value::Null, |text| {
        serde_json::from_str(&text).expect("JSON")
    });
    (output, found)
}

/// The same for any name.
pub fn repeated(file: &Value, more: &[&str]) -> (Output, Value) {
    replayed("cases.json", file, more)
}

/// The output of the command for a case, and its frames, series and bonds.
pub fn moved(case: &Value, more: &[&str]) -> (Output, [String; 3]) {
    let folder = tempfile::tempdir().expect("a folder");
    let (file, out) = (folder.path().join("case.json"), folder.path().join("out"));
    store(&file, case);
    let output = replay(&file, &out, more);
    let text = |name: &str| std::fs::read_to_string(out.join(name)).unwrap_or_default();
    (output, ["frames.csv", "series.csv", "bonds.csv"].map(text))
}

/// Two nodes with masses of one and a bond of stiffness 2, which move apart.
pub fn case() -> Value {
    json!({"case": "two", "contact": {"R_c": 0.5, "K_n": 1.0, "r_d": 0.0, "mu": 0.0},
        "conf": {"timesteps": 4, "modulo": 2, "dt": 0.125}, "wall_left_right_top_bottom": null,
        "grains": [{"rho": 1.0, "eps": 2.0, "c": 2.0, "s0": 0.5, "x": [0.0, 1.0], "y": [0.0, 0.0], "V": 1.0,
            "vx": [-0.5, 0.5], "bonds": [[0, 1]]}]})
}

pub fn with(changes: &[(&str, Value)]) -> Value {
    let mut case = case();
    for (path, value) in changes {
        let (parent, key) = path.rsplit_once('/').expect("a path");
        case.pointer_mut(parent).expect("a parent")[key] = value.clone();
    }
    case
}

/// Numbers of the last row of a table.
fn last(table: &str) -> Vec<f64> {
    let row = table.lines().last().expect("a row");
    row.split(',')
        .map(|number| number.parse().expect("a number"))
        .collect()
}

#[test]
fn what_a_case_leaves_out_has_its_usual_value() {
    let (output, expected) = moved(&case(), &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(
        stdout(&output),
        "corrected: 2 nodes, 4 steps, 0 bonds broken\n"
    );
    assert_eq!(expected[0].lines().count(), 1 + 2 * 2);
    let same = [
        with(&[
            ("/grains/0/bonds", json!("all nodes within eps")),
            ("/grains/0/n_bonds", json!(1)),
        ]),
        with(&[("/grains/0/bonds", Value::Null)]),
        with(&[
            ("/grains/0/V", json!([1.0, 1.0])),
            ("/grains/0/vy", json!(0.0)),
            ("/grains/0/clamped", json!([])),
        ]),
        with(&[
            ("/conf/nl_bdry_only", json!(0)),
            ("/conf/enable_fracture", json!(false)),
            ("/conf/allow_friction", json!(1)),
        ]),
    ];
    for case in same {
        let (output, found) = moved(&case, &[]);
        assert!(output.status.success(), "{}", stderr(&output));
        assert_eq!(found, expected, "{case}");
    }
    let (_, held) = moved(&with(&[("/grains/0/clamped", json!([0]))]), &[]);
    let node = held[0].lines().nth(1).expect("a row");
    assert_eq!(node, "2,0,0,0.0,0.0,0.0,0.0");
}

#[test]
fn walls_move_at_their_speeds() {
    let walls = ("/wall_left_right_top_bottom", json!([-3.0, 4.0, 3.0, -3.0]));
    let speeds = [
        ("/conf/wall_speeds", json!([1.0, 0.0, -2.0, 0.0])),
        ("/conf/speed_wall_top", json!(-2.0)),
    ];
    // Half of the contact radius is farther than walls and nodes approach each other per step.
    let radius = ("/contact/R_c", json!(1.0));
    let lists = with(&[walls.clone(), speeds[0].clone(), radius.clone()]);
    let (_, [_, series, _]) = moved(&lists, &[]);
    let row = last(&series);
    assert_eq!(row[row.len() - 12..row.len() - 8], [-2.5, 4.0, 2.0, -3.0]);
    let (_, [_, series, _]) = moved(&with(&[walls, speeds[1].clone(), radius]), &[]);
    let row = last(&series);
    assert_eq!(row[row.len() - 12..row.len() - 8], [-3.0, 4.0, 2.0, -3.0]);
}

/// What the command says to a case that it refuses as a whole.
pub fn refused(case: &Value, more: &[&str]) -> String {
    let (output, files) = moved(case, more);
    assert_eq!(output.status.code(), Some(2), "{}", stderr(&output));
    assert!(files.iter().all(String::is_empty));
    stderr(&output)
}

/// Refuse cases in which one value is wrong, with the given words.
pub fn refuse_all(refusals: &[(&str, Value, &str)]) {
    for (path, value, expected) in refusals {
        let said = refused(&with(&[(path, value.clone())]), &[]);
        assert!(
            said.contains("case.json") && said.contains(expected),
            "{said}"
        );
    }
}

#[test]
fn unusable_grains_are_refused_with_key_and_accepted_values() {
    refuse_all(&[
        (
            "/grains/0/n_bonds",
            json!(2),
            "n_bonds is 2: must be the number of bonds, 1",
        ),
        (
            "/grains/0/bonds",
            json!("all"),
            "n_bonds is missing: must be the number of bonds",
        ),
        (
            "/grains/0/bonds",
            json!(7),
            "grains[0].bonds is 7: must be a list of pairs of nodes, or a rule in words",
        ),
        (
            "/grains/0/bonds",
            json!([[0, 2]]),
            "grains[0].bonds[0][1] is 2: must be a node below 2",
        ),
        (
            "/grains/0/V",
            json!([1.0]),
            "grains[0].V is [1.0]: must be a list of 2 items",
        ),
        (
            "/grains/0/V",
            Value::Null,
            "grains[0].V is missing: must be a positive number, or a list of 2 positive numbers",
        ),
        (
            "/grains/0/V",
            json!([1.0, -1.0]),
            "grains[0].V[1] is -1.0: must be a positive number",
        ),
        (
            "/grains/0/movable",
            json!(2),
            "grains[0].movable is 2: must be true or false, or 1 or 0",
        ),
        (
            "/grains/0/breakable",
            json!("x"),
            "grains[0].breakable is \"x\": must be true or false, or 1 or 0",
        ),
        (
            "/grains/0/clamped",
            json!([5]),
            "grains[0].clamped[0] is 5: must be a node below 2",
        ),
    ]);
}

#[test]
fn unusable_options_are_refused_with_key_and_accepted_values() {
    refuse_all(&[
        (
            "/conf/nl_bdry_only",
            json!(1),
            "conf.nl_bdry_only is 1: must be 0 or absent",
        ),
        (
            "/conf/enable_torque",
            json!(true),
            "conf.enable_torque is true: must be 0 or absent",
        ),
        (
            "/contact/nl_bdry_only",
            json!(1),
            "contact.nl_bdry_only is 1: must be 0 or absent",
        ),
        (
            "/conf/enable_fracture",
            json!("yes"),
            "conf.enable_fracture is \"yes\": must be true or false",
        ),
        (
            "/conf/dt",
            json!(0.0),
            "conf.dt is 0.0: must be a positive number",
        ),
        (
            "/conf/wall_speed",
            json!([1.0, 0.0]),
            "conf.wall_speed is [1.0,0.0]: must be 4 numbers",
        ),
        (
            "/contact/mu",
            json!(-0.5),
            "contact.mu is -0.5: must be a number that is not negative",
        ),
        (
            "/contact/R_c",
            json!("wide"),
            "contact.R_c is \"wide\": must be a number",
        ),
    ]);
    let said = refused(&json!({"conf": {}}), &[]);
    assert!(
        said.contains("case.json: must have a trajectory with grains or same_input_as"),
        "{said}"
    );
}

#[test]
fn a_failing_step_leaves_the_rows_before_it() {
    // Far beyond the longest stable step: the amplitude grows until it overflows.
    let case = with(&[
        ("/conf/dt", json!(1e6)),
        ("/conf/timesteps", json!(500)),
        ("/conf/modulo", json!(1)),
    ]);
    let (output, [frames, series, _]) = moved(&case, &[]);
    assert_eq!(output.status.code(), Some(1));
    let said = stderr(&output);
    assert!(
        said.contains("case.json: two: ") && said.contains("not finite"),
        "{said}"
    );
    let steps = series.lines().count() - 1;
    assert!(steps > 2 && steps < 500, "{steps}");
    assert_eq!(frames.lines().count() - 1, 2 * steps);
    let account = format!("failed in step {} of 500", steps + 1);
    for part in [&account, "dt = 1000000.0 s is above a limit of stability"] {
        assert!(stdout(&output).contains(part), "{}", stdout(&output));
    }
}

#[test]
fn another_case_gives_the_grains() {
    let folder = tempfile::tempdir().expect("a folder");
    store(&folder.path().join("given/case.json.gz"), &case());
    let file = folder.path().join("conic/case.json");
    store(
        &file,
        &json!({"same_input_as": "given", "weight": "conic", "steps": 2}),
    );
    let out = folder.path().join("out");
    let output = replay(&file, &out, &[]);
    assert_eq!(
        stdout(&output),
        "corrected: 2 nodes, 2 steps, 0 bonds broken\n",
        "{}",
        stderr(&output)
    );
    // A conic bond of half the horizon is twice as stiff: 4 c (1 - 1/2).
    let (_, [frames, ..]) = moved(
        &with(&[("/grains/0/c", json!(4.0)), ("/conf/timesteps", json!(2))]),
        &[],
    );
    let found = std::fs::read_to_string(out.join("frames.csv")).expect("readable");
    near(&json!(last(&found)), &json!(last(&frames)), 1e-15);
    store(&file, &json!({"same_input_as": "absent"}));
    let output = replay(&file, &out, &[]);
    assert!(
        stderr(&output).contains("absent/case.json"),
        "{}",
        stderr(&output)
    );
    assert!(!output.status.success());
}

#[test]
fn modes_belong_to_files_of_grains() {
    let folder = tempfile::tempdir().expect("a folder");
    store(&folder.path().join("local.json"), &json!({"problems": []}));
    let output = replay(
        folder.path(),
        &folder.path().join("results.json"),
        &["--mode", "paper"],
    );
    assert_eq!(output.status.code(), Some(2));
    let said = stderr(&output);
    assert!(
        said.contains("--mode paper: has a meaning only for a file of peridynamic grains"),
        "{said}"
    );
}

#[test]
fn single_states_that_cannot_be_used_do_not_keep_the_others_from_being_computed() {
    let collision = json!({"R_c": 1.0, "K_n": 9.0, "rho": 3.0, "V": [2.0, 1.0], "relative_speed": 50.0, "r_d": 0.0});
    let bad = |key: &str, value: Value| {
        let mut case = super::states::fork();
        case[key] = value;
        case
    };
    let cases = [
        bad("outer", json!([[0, 0], [1, 0]])),
        bad("x", json!([0.5])),
        bad("cuts", json!([[[0.5, 0], [0.5, 1]]])),
        super::states::fork(),
    ];
    let (output, found) = repeated(&json!({"cases": cases}), &[]);
    assert_eq!(output.status.code(), Some(1));
    assert!(
        stdout(&output).contains("cases: 1 of 4 computed"),
        "{}",
        stdout(&output)
    );
    let said = stderr(&output);
    for part in [
        "cases.json: cases[0] (fork): outer is [[0,0],[1,0]]: must be a polygon that does not touch itself (the outer polygon has 2 vertices",
        "cases.json: cases[1] (fork): y is [3.5,3.5,0.5,0.5]: must be a list of 1 items",
        "cases.json: cases[2] (fork): cuts[0] is [[0.5,0],[0.5,1]]: must be a segment on which there is no node (node 2 lies on cut 0",
        "3 of 4 cases have no result",
    ] {
        assert!(said.contains(part), "{said}");
    }
    assert!(found["cases"][0]["error"].is_string() && found["cases"][3]["bonds"] == 3);
    let (output, _) = repeated(
        &json!({"two_node_collision": [collision], "self_contact": [{"c": 1.0}]}),
        &[],
    );
    let said = stderr(&output);
    for part in [
        "two_node_collision[0]: relative_speed is 50.0: must be small enough that the nodes do not pass through each other",
        "self_contact[0]: distance is missing: must be a positive number",
    ] {
        assert!(said.contains(part), "{said}");
    }
}

#[test]
fn what_is_no_text_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("case.json.gz");
    let mut packed = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut packed, &[0xff, 0xfe, 0x80]).expect("packed");
    std::fs::write(&file, packed.finish().expect("packed")).expect("writable");
    let output = replay(&file, &folder.path().join("out"), &[]);
    assert_eq!(output.status.code(), Some(2));
    let said = stderr(&output);
    assert!(said.contains("case.json.gz: neither text nor"), "{said}");
}
