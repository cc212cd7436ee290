//! Files of single states of peridynamic grains: cases made by hand whose answers are closed forms.

use super::motions::{repeated, replayed};
use super::near;
use crate::program::{stderr, stdout};
use serde_json::{Value, json};
use std::f64::consts::{PI, SQRT_2};

/// What is computed for a file, all cases of which must have a result.
fn computed(file: &Value) -> Value {
    let (output, found) = repeated(file, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    found
}

/// Constants that are one for the constant weight.
fn material(weight: &str, plane: &str) -> Value {
    let (young, ratio) = match plane {
        "strain" => (5.0 * PI / 48.0, 0.25),
        _ => (PI / 9.0, 1.0 / 3.0),
    };
    json!({"name": weight, "weight": weight, "plane": plane, "E": young, "nu": ratio, "eps": 1.0,
        "Gc": 0.25, "rho": 1.0, "c": 99.0, "s0": 99.0, "G_over_c_s0sq_eps4": 99.0})
}

#[test]
fn constants_are_those_of_the_table() {
    let cases = json!([
        material("constant", "stress"),
        material("constant", "strain"),
        material("conic", "stress"),
        material("parabolic", "stress"),
    ]);
    let found = computed(&json!({"what": "table", "cases": cases,
        "authors_M2": {"E_right": 0.0, "note": "kept"}, "K_n_M2": {"scripts_eps4": 0.0}}));
    let constants = |c: f64, square: f64, ratio: f64| json!({"c": c, "s0": square.sqrt(), "G_over_c_s0sq_eps4": ratio});
    let expected = [
        constants(1.0, 1.0, 0.25),
        constants(1.0, 1.0, 0.25),
        constants(4.0, 1.25, 0.05),
        constants(2.5, 1.2, 1.0 / 12.0),
    ];
    near(&found["cases"], &json!(expected), 1e-14);
    assert_eq!(found["what"], "table");
    assert_eq!(found["authors_M2"]["note"], "kept");
    let moduli = &found["authors_M2"];
    near(
        moduli,
        &json!({"E_right": 2.394e19 / 7.33e9, "nu_of_k_G": 3.34 / 14.66}),
        1e-6,
    );
    near(
        &found["K_n_M2"],
        &json!({"scripts_eps4": 3.6e10 / (PI * 6.25e-14)}),
        1e9,
    );
}

/// Two nodes one apart, whose distance changes.
fn stretched(change: f64) -> Value {
    let constants =
        |c: f64, s0: f64| json!({"c": c, "s0": s0, "stretch": [99.0], "total_energy": 99.0});
    json!({"name": "two", "E": 1.0, "nu": 0.3, "eps": 2.0, "Gc": 1.0, "x": [0.0, 1.0], "y": [3.0, 3.0],
        "V": [2.0, 3.0], "ux": [0.0, change], "uy": [0.5, 0.5], "bonds": [[0, 1]],
        "weights": {"constant": constants(8.0, 0.25), "conic": constants(8.0, 0.75)}})
}

#[test]
fn a_bond_pulls_stores_energy_and_breaks() {
    let found = computed(&json!({"cases": [stretched(0.5), stretched(-0.5)]}));
    let zero = json!([[0.0, 0.0], [0.0, 0.0]]);
    let pulled = json!([[12.0, 0.0], [-8.0, 0.0]]);
    near(
        &found["cases"][0]["weights"]["constant"],
        &json!({"c": 8.0, "s0": 0.25, "stretch": [0.5], "pair_force_on_i": [[24.0, 0.0]], "bond_energy": [6.0],
            "node_energy_density": [1.5, 1.0], "total_energy": 6.0, "broken_tension_only": [0], "broken_two_sided": [0],
            "force_density": {"all": pulled, "surviving_tension_only": zero, "surviving_two_sided": zero},
            "sum_abs_pair_force_density": [12.0, 8.0], "max_force_density": 12.0}),
        1e-14,
    );
    // Half the weight, and a stretch below the critical one.
    let weak = json!([[6.0, 0.0], [-4.0, 0.0]]);
    near(
        &found["cases"][0]["weights"]["conic"],
        &json!({"stretch": [0.5], "broken_two_sided": [], "total_energy": 3.0, "force_density": {"surviving_two_sided": weak}}),
        1e-14,
    );
    let pushed = json!([[-12.0, 0.0], [8.0, 0.0]]);
    near(
        &found["cases"][1]["weights"]["constant"],
        &json!({"stretch": [-0.5], "broken_tension_only": [], "broken_two_sided": [0],
            "force_density": {"surviving_tension_only": pushed, "surviving_two_sided": zero}}),
        1e-14,
    );
}

/// A U with nodes at the tips of its arms and in its lower corners.
pub fn fork() -> Value {
    json!({"name": "fork", "outer": [[0, 0], [4, 0], [4, 4], [3, 4], [3, 1], [1, 1], [1, 4], [0, 4]],
        "holes": [], "cuts": [], "eps": 10.0, "h": 1.0, "x": [0.5, 3.5, 0.5, 3.5], "y": [3.5, 3.5, 0.5, 0.5],
        "removed_pairs": [[2, 3]], "bonds": 99})
}

#[test]
fn bonds_stay_in_the_shape() {
    let square = [[0, 0], [4, 0], [4, 4], [0, 4]];
    let node = json!({"eps": 3.5, "x": [0.5, 3.5, 0.5], "y": [1.0, 1.0, 3.0]});
    let with = |key: &str, value: Value| {
        let mut case = node.clone();
        case["name"] = key.into();
        case["outer"] = json!(square);
        case[key] = value;
        case
    };
    let hole = with("holes", json!([[[1, 0.5], [2, 0.5], [2, 1.5], [1, 1.5]]]));
    let cut = with("cuts", json!([[[2, 0.5], [2, 1.5]]]));
    let found = computed(&json!({"cases": [fork(), hole, cut]}));
    let nothing = json!({"kept_but_leaves_domain": [], "removed_but_inside": []});
    near(
        &found["cases"][0],
        &json!({"pairs_within_eps": 6, "bonds": 3, "removed_pairs": [[0, 1], [0, 3], [1, 2]],
            // Of the lines 0 2, 1 3, 2 3 without a line feed at the end.
            "sha256_of_bonds": "dcf32c980c1adb633a5a09be0e0cfe21400ffaca2b587d4466305c8fc4196044",
            // The slot is deeper than wide.
            "paper_method_bisectors_only": {"kept_but_leaves_domain": [[0, 1]], "removed_but_inside": []},
            "paper_method_bisectors_and_extended_boundary": nothing}),
        0.0,
    );
    // The pair 1, 2 is farther apart than the horizon.
    for case in [&found["cases"][1], &found["cases"][2]] {
        near(
            case,
            &json!({"pairs_within_eps": 2, "bonds": 1, "removed_pairs": [[0, 1]]}),
            0.0,
        );
        assert!(case.get("paper_method_bisectors_only").is_none());
    }
}

#[test]
fn nodes_repel_damp_and_rub() {
    let case = json!({"px": [0.0, 0.0], "py": [0.5, 0.0], "vx": [3.0, 4.0], "vy": [0.0, 0.0], "Vx": 1.0, "Vy": 1.0,
        "rho": 2.0, "K_n": 2.0, "R_c": 1.0, "mu": 0.5, "r_d": 0.5, "dt": 0.01});
    let mut slow = case.clone();
    slow["vx"] = json!([0.0, 0.002]);
    let mut apart = case.clone();
    apart["py"] = json!([3.0, 4.0]);
    let found = computed(&json!({"node_node": [case, slow, apart]}));
    let force = |damping: f64, friction: f64, branch: &str| json!({"d": 0.5, "repulsion": [-1.0, 0.0], "damping": [damping, 0.0], "friction": [0.0, friction], "branch": branch});
    // The reduced mass is 1, the mass of a node 2.
    let slip = json!({"symmetric": {"on_x": force(-3.0 * SQRT_2, -0.5, "slip")}, "one_sided": {"on_x": force(-6.0, -0.5, "slip")},
        "authors": {"on_x": force(-6.0, -0.5, "slip")}});
    near(&found["node_node"][0], &slip, 1e-14);
    let stick = json!({"symmetric": {"on_x": force(0.0, -0.2, "stick")}, "one_sided": {"on_x": force(0.0, -0.4, "stick")},
        "authors": {"on_x": force(0.0, -0.1, "stick")}});
    near(&found["node_node"][1], &stick, 1e-14);
    let opposite = &found["node_node"][0]["symmetric"]["on_y"];
    near(
        opposite,
        &json!({"repulsion": [1.0, 0.0], "damping": [3.0 * SQRT_2, 0.0], "friction": [0.0, 0.5]}),
        1e-14,
    );
    let none = json!({"d": 5.0, "repulsion": [0.0, 0.0], "damping": [0.0, 0.0], "friction": [0.0, 0.0], "branch": "none"});
    near(&found["node_node"][2]["symmetric"]["on_y"], &none, 0.0);
}

#[test]
fn nodes_of_a_grain_repel_below_their_distance() {
    let case = |reference: f64, distance: f64| json!({"c": 6.0, "R_c": 2.0, "reference_distance": reference, "distance": distance, "Vx": 0.5, "Vy": 3.0, "repulsion": 99.0});
    let found =
        computed(&json!({"self_contact": [case(1.0, 0.5), case(3.0, 0.5), case(1.0, 1.5)]}));
    let expected = [4.5, 6.75, 0.0].map(|repulsion| json!({"repulsion": repulsion}));
    near(&found["self_contact"], &json!(expected), 1e-14);
}

/// Nodes of masses 6 and 3 that meet with the frequency 3.
fn collision(reading: Option<&str>, damping: f64) -> Value {
    let mut case = json!({"R_c": 1.0, "K_n": 9.0, "rho": 3.0, "V": [2.0, 1.0], "relative_speed": 0.5, "r_d": damping,
        "restitution": 99.0});
    if let Some(reading) = reading {
        case["reading"] = reading.into();
    }
    case
}

/// An oscillator of frequency 3 with a reduced mass of 2, hit at 0.5.
fn rebound(ratio: f64) -> Value {
    let damped = (1.0 - ratio * ratio).sqrt();
    let restitution = (-PI * ratio / damped).exp();
    let turn = ratio.acos() / (3.0 * damped);
    json!({"omega": 3.0, "contact_duration_until_d_is_R_c": PI / (3.0 * damped), "restitution": restitution,
        "time_of_deepest": turn, "deepest": 0.5 / 3.0 * (-3.0 * ratio * turn).exp(),
        "energy_dissipated": 0.25 * (1.0 - restitution * restitution)})
}

#[test]
fn collisions_of_two_nodes_have_their_closed_forms() {
    let cases = [
        collision(Some("symmetric"), 0.0),
        collision(Some("symmetric"), 0.6),
        collision(Some("one_sided"), 0.3),
        collision(None, 0.3),
    ];
    let file = json!({"two_node_collision": cases});
    // Both nodes are damped by their own masses: the relative motion by 2 r_d sqrt(K V V) (1/sqrt(m) + 1/sqrt(M)).
    let one_sided = 0.3 * (1.0 / 6f64.sqrt() + 1.0 / 3f64.sqrt()) * 2f64.sqrt();
    for (mode, of_the_mode) in [("corrected", 0.3), ("two_fixes", one_sided)] {
        let (output, found) = repeated(&file, &["--mode", mode]);
        assert!(stdout(&output).starts_with(mode), "{}", stdout(&output));
        let expected = [0.0, 0.6, one_sided, of_the_mode].map(rebound);
        near(&found["two_node_collision"], &json!(expected), 1e-12);
    }
    // Nodes that are damped too much do not separate.
    let found = computed(&json!({"two_node_collision": [collision(Some("one_sided"), 0.9)]}));
    let stuck = &found["two_node_collision"][0];
    near(
        stuck,
        &json!({"restitution": 0.0, "energy_dissipated": 0.25}),
        1e-15,
    );
    assert!(stuck.get("contact_duration_until_d_is_R_c").is_none());
}

#[test]
fn a_bond_of_two_nodes_oscillates_and_breaks() {
    let case = |weight: &str, c: f64| json!({"weight": weight, "c": c, "s0": 0.02, "length": 1.0, "eps": 4.0, "V": [2.0, 1.0], "rho": 3.0, "period": 99.0});
    let cases = [case("constant", 9.0), case("conic", 12.0)];
    let found = computed(&json!({"two_node_bond": cases}));
    // The energy of the bond at the critical stretch is 0.5 * 18 * 0.02^2.
    let after = 0.06 * 0.69f64.sqrt();
    let broken = json!({"opening_speed": 0.078, "speed_after_break": after, "energy_lost": 0.0036,
        "time_of_break": (1.0f64 / 1.3).asin() / 3.0});
    let expected = json!({"omega": 3.0, "period": 2.0 * PI / 3.0, "opening_speed_that_just_breaks": 0.06, "at_1_3_times": broken});
    near(&found["two_node_bond"], &json!([expected, expected]), 1e-12);
}

#[test]
fn walls_push_as_far_as_the_disc_reaches_beyond() {
    let single = |d: f64| json!({"d": d, "S": "99", "paper": "99"});
    let corner =
        |a: f64, b: f64| json!({"a": a, "b": b, "overlap_area": "99", "overlap_counts": false});
    let (output, found) = replayed(
        "walls.json.gz",
        &json!({"single": [single(0.0), single(1.5)], "corner": [corner(0.0, 0.0), corner(0.8, 0.7)]}),
        &["--mode", "paper"],
    );
    assert!(output.status.success(), "{}", stderr(&output));
    assert_eq!(
        stdout(&output),
        "paper: walls.json\nsingle: 2 of 2 computed\ncorner: 2 of 2 computed\n"
    );
    near(
        &found["single"],
        &json!([{"d": 0.0, "S": PI / 2.0, "centroid": 4.0 / (3.0 * PI), "paper": PI / 2.0 - 2.0 / 3.0,
            "exact": 1.0 / 3.0, "authors": -PI / 2.0}, {"S": 0.0, "centroid": 1.0, "paper": 0.0, "exact": 0.0, "authors": 0.0}]),
        1e-15,
    );
    // The overlap is a quarter of the disc with its centroid at 4 sqrt(2)/(3 pi).
    let quarter = (PI / 4.0) * (1.0 - 4.0 * SQRT_2 / (3.0 * PI)) / SQRT_2;
    let push = PI / 2.0 - 2.0 / 3.0 - quarter;
    near(
        &found["corner"],
        &json!([{"overlap_area": PI / 4.0, "I_x": 1.0 / 3.0, "I_y": 1.0 / 3.0, "paper_force": [push, push],
            "exact_force": [1.0 / 6.0, 1.0 / 6.0], "overlap_counts": true},
            {"overlap_area": 0.0, "overlap_counts": false}]),
        1e-14,
    );
}
