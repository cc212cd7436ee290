//! Values of peridynamic cases that cannot be used: errors name file, key, value and what is accepted.

use super::motions::{case, moved, refuse_all, repeated, with};
use super::states::fork;
use crate::program::{stderr, stdout};
use serde_json::{Value, json};

#[test]
fn empty_lists_and_unknown_keys_of_grains_are_refused() {
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
        (
            "/grains/0/densty",
            json!(3.0),
            "grains[0].densty is 3.0: must be absent: only x, y, V, rho,",
        ),
        (
            "/grains/0/frozen",
            json!(0),
            "grains[0].frozen is 0: must be absent",
        ),
    ]);
    let notes = with(&[
        ("/grains/0/note", json!("left")),
        ("/grains/0/first_node", json!(0)),
        ("/grains/0/frozen", Value::Null),
    ]);
    let (output, found) = moved(&notes, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(found, moved(&case(), &[]).1);
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
