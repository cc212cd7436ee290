//! `gouge replay`: cases made by hand whose answers are closed forms, their symmetries, and what is refused.

mod bad_cases;
mod motions;
mod networks;
mod speeds;
mod states;
mod unusable;

use crate::program::{run, stderr, stdout};
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_4, PI};
use std::path::Path;
use std::process::Output;

fn write(folder: &Path, name: &str, value: &Value) {
    std::fs::write(folder.join(name), value.to_string()).expect("writable");
}

/// The output of the command in a folder of cases, and the file of results.
fn replay(folder: &Path) -> (Output, Option<Value>) {
    let out = folder.join("results.json");
    let [folder, file] = [folder, &out].map(|path| path.to_str().expect("UTF-8"));
    let output = run(&["replay", folder, "--out", file]);
    let text = std::fs::read_to_string(&out).ok();
    (
        output,
        text.map(|text| serde_json::from_str(&text).expect("JSON")),
    )
}

/// Results of a single file of cases, all of which must have one.
fn solved(name: &str, list: &str, cases: &Value) -> Value {
    let folder = tempfile::tempdir().expect("a folder");
    write(
        folder.path(),
        &format!("{name}.json"),
        &json!({list: cases, "g": 9.81}),
    );
    let (output, results) = replay(folder.path());
    assert!(output.status.success(), "{}", stderr(&output));
    let count = cases.as_array().expect("a list").len();
    assert_eq!(stdout(&output), format!("{name}.json: {count} solved\n"));
    results.expect("results")[name].clone()
}

/// Compare all numbers of the expected value with those of the same place.
fn near(found: &Value, expected: &Value, tolerance: f64) {
    match expected {
        Value::Object(keys) => {
            for (key, expected) in keys {
                near(&found[key], expected, tolerance);
            }
        }
        Value::Array(items) => {
            assert_eq!(found.as_array().map(Vec::len), Some(items.len()));
            for (k, expected) in items.iter().enumerate() {
                near(&found[k], expected, tolerance);
            }
        }
        Value::Number(_) => {
            let [x, y] = [found, expected].map(Value::as_f64);
            let apart = (x.expect("a number") - y.expect("a number")).abs();
            assert!(apart <= tolerance, "{found} instead of {expected}");
        }
        _ => assert_eq!(found, expected),
    }
}

fn shape(n: usize, radius: f64, at: [f64; 2], angle: f64) -> Value {
    json!({"n": n, "R": radius, "x": at[0], "y": at[1], "th": angle})
}

#[test]
fn shapes_touch_where_they_should() {
    let half = 0.5f64.sqrt();
    let square = |x: f64| shape(4, half, [x, 3.0], FRAC_PI_4);
    let disc = |x: f64, y: f64| shape(0, 0.5, [x, y], 0.3);
    let pairs = json!([
        {"id": "side", "a": square(0.0), "b": square(1.01)},
        {"id": "discs", "a": disc(0.0, 0.0), "b": disc(0.6, 0.8)},
        {"id": "far", "a": disc(0.0, 0.0), "b": disc(3.0, 0.0)},
        {"id": "image", "period_x": 10.0, "a": disc(9.5, 0.0), "b": disc(0.49, 0.0)},
    ]);
    let found = solved("geometry", "pairs", &pairs);
    let point = |y: f64| json!({"g": 0.01, "p": [0.505, y]});
    let side = &found["side"];
    near(side, &json!({"sep": 0.01, "normal": [1.0, 0.0]}), 1e-14);
    let mut points = side["points"].as_array().expect("points").clone();
    points.sort_by(|a, b| {
        a["p"][1]
            .as_f64()
            .partial_cmp(&b["p"][1].as_f64())
            .expect("numbers")
    });
    near(&points.into(), &json!([point(2.5), point(3.5)]), 1e-14);
    let discs = json!({"sep": 0.0, "normal": [0.6, 0.8], "points": [{"g": 0.0, "p": [0.3, 0.4]}]});
    near(&found["discs"], &discs, 1e-15);
    near(&found["far"], &json!({"sep": 2.0, "points": []}), 1e-15);
    near(
        &found["image"],
        &json!({"sep": -0.01, "normal": [1.0, 0.0]}),
        1e-14,
    );
}

/// A contact point with W_nn = 2, W_tt = 1.
fn local(id: &str, coupling: f64, friction: f64, free: [f64; 2]) -> Value {
    json!({"id": id, "W_nn": 2.0, "W_tt": 1.0, "W_nt": coupling, "mu": friction,
        "e_n": 0.0, "e_t": 0.0, "u_minus": [0.0, 0.0], "u_free": free})
}

#[test]
fn single_points_obey_the_laws() {
    let mut rebound = local("rebound", 0.0, 0.5, [-3.0, 4.0]);
    rebound["e_n"] = 0.5.into();
    rebound["u_minus"] = json!([-2.0, 0.0]);
    let problems = json!([
        local("sticks", 0.0, 0.5, [-4.0, 0.5]),
        rebound,
        local("leaves", 1.0, 0.5, [1.0, 0.5]),
        local("several", -1.2, 3.0, [0.1, -2.0]),
    ]);
    let found = solved("local", "problems", &problems);
    near(
        &found["sticks"],
        &json!({"P": [2.0, -0.5], "u_plus": [0.0, 0.0]}),
        0.0,
    );
    // 2 P_n - 3 - 1 = 0; friction 1 opposes 4 m/s.
    near(
        &found["rebound"],
        &json!({"P": [2.0, -1.0], "u_plus": [1.0, 3.0]}),
        0.0,
    );
    near(
        &found["leaves"],
        &json!({"P": [0.0, 0.0], "u_plus": [1.0, 0.5]}),
        0.0,
    );
    // Separation is a solution, and sticking with P = (0.1 - 2.4, ...) may be another.
    let several = &found["several"];
    assert!(several["error"].is_string(), "{several}");
    near(
        several,
        &json!({"P": [0.0, 0.0], "u_plus": [0.1, -2.0]}),
        0.0,
    );
}

/// A disc of mass 2 that rests on a fixed one, gap g, under a weight of 10.
fn resting(id: &str, gap: f64, mode: &str) -> Value {
    let fixed =
        json!({"inv_mass": [0.0, 0.0, 0.0], "velocity": [0.0, 0.0, 0.0], "force": [0.0, 0.0, 0.0]});
    let free = json!({"inv_mass": [0.5, 0.5, 4.0], "velocity": [0.0, -1.0, 0.0], "force": [0.0, -10.0, 0.0]});
    json!({"id": id, "mu": 0.4, "e_n": 0.0, "e_t": 0.0, "dt": 0.1, "gap_mode": mode,
        "dofs": [fixed, free],
        "bodies": [{"x": 0.0, "y": 0.0, "dof": 0}, {"x": 0.0, "y": 1.0 + gap, "dof": 1}],
        "contacts": [{"a": 0, "b": 1, "n": [0.0, 1.0], "p": [0.0, 0.5], "g": gap}]})
}

#[test]
fn one_step_stops_what_touches() {
    let problems = json!([
        resting("closed", 0.05, "closed"),
        resting("alert", 0.05, "alert"),
        resting("open", 0.5, "alert"),
    ]);
    let found = solved("onestep", "problems", &problems);
    let result = |v: f64, p: f64| json!({"velocities": [[0.0, 0.0, 0.0], [0.0, v, 0.0]], "impulses": [[p, 0.0]]});
    // Free: -1 - 10 * 0.1/2 = -1.5; a mass of 2 is stopped, or left the speed that closes the gap.
    near(&found["closed"], &result(0.0, 3.0), 1e-14);
    near(&found["alert"], &result(-0.5, 2.0), 1e-14);
    near(&found["open"], &result(-1.5, 0.0), 0.0);
}

#[test]
fn operators_by_entries_and_by_bodies_agree() {
    // Two points with W = diag(2, 1); the first sticks, the second slides.
    let w = json!({"row": [0, 1, 2, 3], "col": [0, 1, 2, 3], "val": [2.0, 1.0, 2.0, 1.0]});
    let mu = [0.5, 0.1];
    let q = [-4.0, 0.5, -4.0, 3.0];
    let row = |body: usize| json!({"bodies": [body], "normal_rows": [[1.0, 0.0, 0.0]], "tangent_rows": [[0.0, 1.0, 0.0]]});
    let mass = [0.5, 1.0, 1.0, 0.5, 1.0, 1.0];
    let problems = json!([
        {"id": "entries", "form": "assembled", "contacts": 2, "mu": mu, "q": q, "W": w},
        {"id": "bodies", "form": "global", "contacts": 2, "bodies": 2, "mu": mu, "mass": mass,
            "momentum_free": [-2.0, 0.5, 0.0, -1.0, 3.0, 0.0], "b": [0.0, 0.0, -2.0, 0.0],
            "rows": [row(0), row(1)]},
    ]);
    let found = solved("siconos2d", "problems", &problems);
    let impulses = json!({"impulses": [2.0, -0.5, 2.0, -0.2]});
    near(&found["entries"], &impulses, 1e-14);
    near(&found["bodies"], &impulses, 1e-14);
}

fn motion(id: &str, setup: Value) -> Value {
    json!({"id": id, "setup": setup})
}

#[test]
fn slow_motion_has_its_closed_forms() {
    let setup = json!({"mu": 0.5, "dt": 0.01, "g": 2.0, "R": 2.0, "side": 3.0, "mass": 5.0,
        "steps": 50, "incline": 0.3, "v0": 3.0, "w0": -4.5});
    let kinds = [
        "incline-disc",
        "incline-square",
        "block-stops",
        "disc-slide-roll",
    ];
    let found = solved(
        "dynamics",
        "cases",
        &kinds.map(|kind| motion(kind, setup.clone())).into(),
    );
    let rolling = 2.0 * 0.3f64.sin() * 2.0 / 3.0;
    near(
        &found["incline-disc"],
        &json!({"status": "roll", "speed_down": 0.5 * rolling, "distance_down": 0.125 * rolling,
            "spin_magnitude": 0.25 * rolling}),
        1e-12,
    );
    let [normal, along] = [0.3f64.cos(), 0.3f64.sin()].map(|part| 10.0 * part);
    near(
        &found["incline-square"],
        &json!({"status": "stick", "speed_down": 0.0, "distance_down": 0.0, "rotation": 0.0,
            "normal_resultant": normal, "friction_resultant": along,
            "difference_of_the_two_normal_forces": along,
            "larger_normal_force": 0.5 * (normal + along)}),
        1e-9,
    );
    // Steps of 0.01 m/s, and the trapezoidal rule.
    near(
        &found["block-stops"],
        &json!({"discrete": {"steps_to_stop": 300, "distance": 4.5, "speed_after_100_steps": 2.0},
            "continuum": {"time": 3.0, "distance": 4.5}}),
        1e-9,
    );
    // The angular momentum about the floor stays: v = (2 v0 - R w0)/3; the slip of 6 m/s falls by 0.03 per step, and
    // friction accelerates the centre by 1 m/s^2.
    near(
        &found["disc-slide-roll"],
        &json!({"rolling_speed": 5.0, "rolling_spin": -2.5, "discrete": {"first_rolling_step": 200},
            "time_to_roll": 2.0, "slip_distance": 8.0}),
        1e-9,
    );
}

#[test]
fn impacts_have_their_closed_forms() {
    let corner =
        json!({"n": 4, "R": 2.0, "mu": 0.3, "v": [0.0, -3.0], "w": 0.0, "corner_arm": [0.0, -2.0]});
    let arm = 2f64.sqrt();
    let land = json!({"n": 4, "R": 2.0, "mu": 0.8, "w": -3.0, "v": [3.0 * arm, -3.0 * arm],
        "arms": [[-arm, -arm], [arm, -arm]]});
    let discs = json!({"R1": 1.0, "R2": 1.0, "v2": [-2.0, 0.0], "w1": 0.0, "w2": 0.0,
        "mu": 0.3, "e_n": 1.0, "e_t": 0.0, "density": 7.0});
    let cases = json!([
        motion("corner-drop", corner),
        motion("landing", land),
        motion("two-discs", discs),
        motion("cradle-gaps", json!({"N": 4, "e_n": 1.0, "gaps": 0.25})),
        motion("cradle-touching", json!({"N": 2, "e_n": 0.5, "gaps": 0})),
    ]);
    let found = solved("dynamics", "cases", &cases);
    // A mass of 8, stopped through its centre.
    near(
        &found["corner-drop"],
        &json!({"status": "stick", "v": [0.0, 0.0], "w": 0.0, "P": [24.0, 0.0]}),
        1e-12,
    );
    // (1/3 + cos 90 deg)/(1/3 + 1)
    let ratio = json!({"no_slip_ratio": 0.25, "friction_needed_for_no_slip": 0.6, "w": -0.75});
    near(&found["landing"], &ratio, 1e-12);
    near(
        &found["two-discs"],
        &json!({"P_n": 14.0 * PI, "v1": [-2.0, 0.0], "v2": [0.0, 0.0], "u_n_plus": 2.0}),
        1e-12,
    );
    near(
        &found["cradle-gaps"],
        &json!({"velocities": [0.0, 0.0, 0.0, 1.0], "kinetic_energy_ratio": 1.0}),
        1e-12,
    );
    near(
        &found["cradle-touching"],
        &json!({"velocities": [0.25, 0.75], "impulses_over_m": [0.75]}),
        1e-12,
    );
}

#[test]
fn bodies_come_to_rest_and_tip() {
    let cases = json!([
        motion("gap-closes", json!({"gap": 0.5, "v": -4.0, "dt": 0.5})),
        motion("square-pushed", json!({"mu": 3.0, "side": 2.0})),
    ]);
    let found = solved("dynamics", "cases", &cases);
    near(
        &found["gap-closes"],
        &json!({"v_after_first_step": -1.0, "v_after_second_step": 0.0, "final_gap": 0.0,
            "gap_at_second_detection": 0.0}),
        1e-15,
    );
    // Torque (F - m g) side/2 about the corner, with the moment of inertia 2/3 m side^2.
    near(
        &found["square-pushed"],
        &json!({"tips_iff_F_over_mg_above": 1.0, "angular_acceleration_at_F_1.5mg": 9.81 * 0.1875}),
        1e-9,
    );
}
