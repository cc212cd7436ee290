//! Values of peridynamic cases that cannot be used: errors name file, key, value and what is accepted.

use super::motions::{case, moved, refuse_all, repeated, replay, store, with};
use super::states::fork;
use crate::program::{stderr, stdout};
use serde_json::{Value, json};
use std::process::Output;

/// The output of the command for the case with a table beside it, and the frames.
fn beside(table: &str, text: &str) -> (Output, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("in/case.json");
    store(&file, &case());
    std::fs::write(folder.path().join("in").join(table), text).expect("writable");
    let output = replay(&file, &folder.path().join("out"), &[]);
    let frames = std::fs::read_to_string(folder.path().join("out/frames.csv"));
    (output, frames.unwrap_or_default())
}

#[test]
fn unusable_steps_of_tables_are_refused() {
    let whole = "must be a whole number from 0 to 4";
    let refusals = [
        ("step,grain\n-1,0\n", format!("line 2: step is -1: {whole}")),
        (
            "step,grain\n1,0\n1.5,0\n",
            format!("line 3: step is 1.5: {whole}"),
        ),
        ("step,grain\n5,0\n", format!("line 2: step is 5: {whole}")),
        ("step,grain\nx,0\n", format!("line 2: step is x: {whole}")),
        (
            "step,grain\n1,0\n\n2,0\n",
            format!("line 3: step is empty: {whole}"),
        ),
        (
            "step,grain\n3,0\n2,0\n",
            "line 3: step is 2: must be at least 3".to_owned(),
        ),
        (
            "2,0\n",
            "line 1: step is 2: must be the name of the first column, step".to_owned(),
        ),
        ("", "line 1: step is empty: must be".to_owned()),
    ];
    for (text, expected) in refusals {
        for table in ["frames.csv", "bonds.csv"] {
            let (output, frames) = beside(table, text);
            assert_eq!(output.status.code(), Some(2), "{text:?}");
            assert_eq!(frames, "");
            let said = stderr(&output);
            let expected = format!("{table}: {expected}");
            assert!(said.contains(&expected), "{said}");
        }
    }
}

#[test]
fn frames_are_written_at_the_steps_of_the_table() {
    let (output, frames) = beside("frames.csv", "step,grain\r\n0,0\r\n0,1\r\n3,0\r\n\r\n");
    assert!(output.status.success(), "{}", stderr(&output));
    let steps: Vec<_> = frames.lines().map(|line| line.split(',').next()).collect();
    assert_eq!(steps, ["step", "0", "0", "3", "3"].map(Some));
    let first = frames.lines().nth(1);
    assert_eq!(first, Some("0,0,0,0.0,0.0,-0.5,0.0"));
}

#[test]
fn empty_lists_are_refused_and_keys_of_grains_without_a_meaning_are_told() {
    refuse_all(&[
        (
            "/grains",
            json!([]),
            "grains is []: must be a list of at least one grain",
        ),
        (
            "/grains/0/x",
            json!([]),
            "grains[0].x is []: must be a list of at least one number",
        ),
    ]);
    let told = |key: &str, value: Value| {
        let (output, found) = moved(&with(&[(&format!("/grains/0/{key}"), value)]), &[]);
        assert!(output.status.success(), "{}", stderr(&output));
        assert_eq!(found, moved(&case(), &[]).1);
        stdout(&output).contains(&format!("keys of grains without a meaning here: {key}\n"))
    };
    assert!(told("densty", json!(3.0)) && told("frozen", json!(0)));
    assert!(!told("note", json!("left")) && !told("first_node", json!(0)));
    assert!(!told("frozen", Value::Null));
}

#[test]
fn unusable_numbers_of_motions_are_refused_with_their_keys() {
    let usable = "must be a number from 1e-100 to 1e100";
    let numbers = [
        ("/grains/0/rho", 1e-300, "grains[0].rho is 1e-300"),
        ("/grains/0/V", 1e-300, "grains[0].V is 1e-300"),
        ("/grains/0/eps", 1e300, "grains[0].eps is 1e+300"),
        ("/grains/0/c", 1e300, "grains[0].c is 1e+300"),
        ("/conf/dt", 1e300, "conf.dt is 1e+300"),
        ("/contact/K_n", 1e-300, "contact.K_n is 1e-300"),
        ("/contact/R_c", 1e300, "contact.R_c is 1e+300"),
    ];
    for (path, value, expected) in numbers {
        refuse_all(&[(path, json!(value), &format!("{expected}: {usable}"))]);
    }
    refuse_all(&[
        (
            "/contact/r_d",
            json!(2),
            "contact.r_d is 2: must be in [0, 1]",
        ),
        (
            "/contact/R_c",
            json!(1e-60),
            "contact.R_c is 1e-60: must be such that the square of the contact radius in m^2 is from 1e-100 to 1e100",
        ),
        (
            "/wall_left_right_top_bottom",
            json!([-1.0, -0.5, 1.0, -1.0]),
            "wall_left_right_top_bottom is [-1.0,-0.5,1.0,-1.0]: must be left, right, top and bottom of a container",
        ),
    ]);
}

#[test]
fn impossible_bonds_are_refused_with_their_places() {
    refuse_all(&[
        (
            "/grains/0/bonds",
            json!([[0, 0]]),
            "grains[0].bonds[0] is [0,0]: must be two different nodes",
        ),
        (
            "/grains/0/bonds",
            json!([[0, 1], [1, 0]]),
            "grains[0].bonds[1] is [1,0]: must be a pair that is not listed twice, but item 0 is the same",
        ),
        (
            "/grains/0/x",
            json!([0.5, 0.5]),
            "grains[0].bonds[0] is [0,1]: must be two nodes at a positive, finite distance",
        ),
    ]);
    let unlisted = with(&[
        ("/grains/0/x", json!([0.5, 0.5])),
        ("/grains/0/bonds", Value::Null),
    ]);
    let said = super::motions::refused(&unlisted, &[]);
    let expected =
        "grains[0].x[1] is 0.5: must be such that the node has, with y, a place of its own";
    assert!(said.contains(expected), "{said}");
}

#[test]
fn a_missing_case_with_the_grains_is_refused() {
    let (output, _) = moved(&json!({"same_input_as": "absent"}), &[]);
    assert_eq!(output.status.code(), Some(2), "{}", stdout(&output));
    let said = stderr(&output);
    for part in [
        "case.json: same_input_as is \"absent\": must be the name of a folder beside that of the case",
        "there is no ",
        "absent/case.json",
    ] {
        assert!(said.contains(part), "{said}");
    }
}

/// Report the only case of a list if one value is wrong, with the given words.
fn report_all(list: &str, case: &Value, reports: &[(&str, Value, &str)]) {
    for (key, value, expected) in reports {
        let mut case = case.clone();
        case[*key] = value.clone();
        let (output, _) = repeated(&json!({list: [case]}), &[]);
        assert_eq!(output.status.code(), Some(1), "{}", stdout(&output));
        let said = stderr(&output);
        assert!(
            said.contains(&format!("cases.json: {list}[0]")) && said.contains(expected),
            "{said}"
        );
    }
}

#[test]
fn unusable_materials_and_clouds_are_reported_with_their_keys() {
    let material = json!({"weight": "constant", "plane": "stress", "E": 1.0, "nu": 0.3, "eps": 1.0, "Gc": 1.0,
        "rho": 1.0});
    let ratio = "nu is 1e+308: must be above -1 and below 0.5";
    report_all(
        "cases",
        &material,
        &[
            ("nu", json!(1e308), ratio),
            (
                "rho",
                json!(1e-300),
                "rho is 1e-300: must be such that the square of the speed of waves in m^2/s^2 is from 1e-100",
            ),
            (
                "eps",
                json!(1e-60),
                "eps is 1e-60: must be such that the stiffness of bonds",
            ),
        ],
    );
    let cloud = json!({"E": 1.0, "nu": 0.3, "eps": 2.0, "Gc": 1.0, "x": [0.0, 1.0], "y": [0.0, 0.0], "V": [2.0, 3.0],
        "ux": [0.0, 0.5], "uy": [0.0, 0.0], "bonds": [[0, 1]], "weights": {"constant": {}}});
    report_all(
        "cases",
        &cloud,
        &[
            ("nu", json!(1e308), ratio),
            (
                "bonds",
                json!([[0, 0]]),
                "bonds[0] is [0,0]: must be two different nodes",
            ),
            (
                "x",
                json!([]),
                "x is []: must be a list of at least one number",
            ),
        ],
    );
}

#[test]
fn unusable_pairs_of_nodes_are_reported_with_their_keys() {
    let usable = "must be a number from 1e-100 to 1e100";
    let collision = json!({"R_c": 1.0, "K_n": 9.0, "rho": 3.0, "V": [2.0, 1.0], "relative_speed": 0.5, "r_d": 0.0});
    let density = format!("rho is 1e-300: {usable}");
    report_all(
        "two_node_collision",
        &collision,
        &[
            ("r_d", json!(2), "r_d is 2: must be in [0, 1]"),
            ("rho", json!(1e-300), &density),
            ("V", json!([1, -1]), "V[1] is -1: must be a positive number"),
        ],
    );
    let bond = json!({"weight": "conic", "c": 12.0, "s0": 0.02, "length": 1.0, "eps": 4.0, "V": [2.0, 1.0], "rho": 3.0});
    report_all(
        "two_node_bond",
        &bond,
        &[
            ("eps", json!(-1), "eps is -1: must be a positive number"),
            ("s0", json!(1e300), &format!("s0 is 1e+300: {usable}")),
        ],
    );
}

#[test]
fn unusable_shapes_are_reported_with_their_keys() {
    report_all(
        "cases",
        &fork(),
        &[
            (
                "outer",
                json!([[0, 0], [4, 4], [4, 0], [0, 4]]),
                "outer is [[0,0],[4,4],[4,0],[0,4]]: must be a polygon",
            ),
            (
                "holes",
                json!([[[1, 1]]]),
                "holes[0] is [[1,1]]: must be a polygon",
            ),
            (
                "y",
                json!([3.5, 3.5, 3.5, 0.5]),
                "x[2] is 0.5: must be such that the node has, with y, a place of its own, but node 0 is there",
            ),
        ],
    );
}
