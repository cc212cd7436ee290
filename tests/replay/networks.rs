//! Networks of forces.

use super::{near, replay, solved, write};
use crate::program::stderr;
use serde_json::{Value, json};
use std::f64::consts::PI;

/// A cell with a contact in each direction: 3 along x with friction 0.3, 1 along y with friction -0.3.
fn cell() -> Value {
    json!([
        {"n": [1.0, 0.0], "f": [3.0, 0.3], "l": [0.5, 0.0], "ss": true},
        {"n": [0.0, 1.0], "f": [1.0, -0.3], "l": [0.0, 0.5], "ss": false},
    ])
}

#[test]
fn a_cell_of_a_lattice_has_the_stress_of_its_forces() {
    let networks = json!([{"network": "cell", "volume": 0.25, "mu": 0.3, "pairs": cell()}]);
    let found = solved("observables", "networks", &networks);
    let q = 4.36f64.sqrt();
    near(
        &found["cell"],
        &json!({"sigma": [[6.0, 0.6], [0.6, 2.0]], "p": 4.0, "q_over_p": q / 4.0, "contacts": 2,
            "theta_s_deg": (0.5 * 0.3f64.atan()).to_degrees(), "antisymmetric_over_p": 0.0,
            "k_ss": 0.5, "k_slide": 0.5, "mean_fn_over_pd": 0.5, "mean_abs_ft_over_pd": 0.075}),
        1e-12,
    );
    let sum = |key: &str| {
        let parts =
            ["anisotropies_sv", "anisotropies_ss"].map(|part| found["cell"][part][key].as_f64());
        parts.into_iter().flatten().sum::<f64>()
    };
    for key in ["a_c", "a_fn", "a_ft", "a_ln", "a_lt"] {
        near(&found["cell"]["anisotropies"][key], &sum(key).into(), 1e-12);
    }
}

/// Discs of diameter 1 on top of each other: a fixed one, one in the middle, one glued to a wall. The forces are 2 N.
fn tower() -> Value {
    let unit = |free: f64, glued: bool| {
        json!({"inv_mass": [free, free, free], "velocity": [0.0, 0.0, 0.0], "force": [0.0, 0.0, 0.0],
            "composite": glued})
    };
    let disc =
        |y: f64, dof: usize| json!({"n": 0, "R": 0.5, "x": 0.2, "y": y, "th": 0.0, "dof": dof});
    let contact =
        |a: usize, y: f64| json!({"a": a, "b": a + 1, "n": [0.0, 1.0], "p": [0.2, y], "g": 0.0});
    json!({"id": "tower", "mu": 0.4, "e_n": 0.0, "e_t": 0.0, "dt": 0.5, "gap_mode": "closed", "period_x": 2.0,
        "dofs": [unit(0.0, true), unit(1.0, false), unit(0.0, true)],
        "bodies": [disc(0.0, 0), disc(1.0, 1), disc(2.0, 2)],
        "contacts": [contact(0, 0.5), contact(1, 1.5)],
        "solution": {"impulses": [[1.0, 0.0], [1.0, 0.0]]}})
}

#[test]
fn networks_take_the_forces_of_stored_solutions() {
    let folder = tempfile::tempdir().expect("a folder");
    write(
        folder.path(),
        "onestep.json",
        &json!({"problems": [tower()]}),
    );
    let networks = json!({"networks": [{"network": "tower"}, {"network": "absent"}]});
    write(folder.path(), "observables.json", &networks);
    let (output, results) = replay(folder.path());
    assert_eq!(output.status.code(), Some(1));
    let errors = stderr(&output);
    assert!(
        errors.contains("observables.json: absent: network is"),
        "{errors}"
    );
    assert!(errors.contains("1 of 3 cases have no result"), "{errors}");
    let results = results.expect("results");
    // Forces of 2 N along branches of 1 m in a volume of 4 m^2. The slab cuts the outer discs below their middle.
    near(
        &results["observables"]["tower"],
        &json!({"sigma": [[0.0, 0.0], [0.0, 1.0]], "p": 0.5, "q_over_p": 1.0, "contacts": 2,
            "volume": 4.0, "kappa": 1.0, "z": 2.0, "P_c": {"2": 1.0, "3": 0.0}, "sum_point_pairs": 2,
            "slab": [0.5, 1.5], "nu_slab": 0.25 * PI / 2.0, "mean_fn_over_pd": 4.0}),
        1e-12,
    );
    // Without a load nothing needs to be carried.
    near(
        &results["onestep"]["tower"],
        &json!({"impulses": [[0.0, 0.0], [0.0, 0.0]]}),
        0.0,
    );
}
