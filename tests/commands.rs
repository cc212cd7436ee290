//! The commands and their outputs, as specified by the contract.

use crate::program::{gouge, run, stderr, stdout, write_draft};
use approx::{abs_diff_eq, assert_abs_diff_eq};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, KelvinVoigt};
use gouge_validation::scenes::{Bond, Draft, Grain};
use serde_json::Value;

fn json(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn links_prints_every_pair_with_its_forces() {
    let folder = tempfile::tempdir().expect("a folder");
    let draft = Draft::open_box(Integrator::Euler, 1e-9)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .friction("cundall-strack", 0.7, 1e7)
        .law(AdjustedKelvinVoigt {
            stiffness: 2e7,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: 1e7,
            damping: 0.0,
        })
        .grain(Grain::at([0.0, 0.0], 1e-3).moving([1.0, 0.0]))
        .grain(Grain::at([1.9e-3, 0.0], 1e-3))
        .grain(Grain::at([1.9e-3, 2.1e-3], 1e-3))
        .bond(Bond::between(2, 1).of_length(2e-3))
        .touching_since(0, 1, [0.01, 3.1315926535897933]);
    let path = write_draft(folder.path(), &draft);
    let output = run(&["links", path.to_str().expect("UTF-8")]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = stdout(&output);
    let mut lines = text.lines();
    assert_eq!(
        lines.next(),
        Some(
            "i,j,kind,overlap_factor,focal_x,focal_y,normal_x,normal_y,normal_displacement,\
             adjusted_normal_displacement,tangential_displacement_i,tangential_displacement_j,\
             normal_velocity,tangential_velocity_i,tangential_velocity_j,normal_force,\
             tangential_force,torque_i,torque_j"
        )
    );
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert_eq!(rows.len(), 2);
    let number = |row: &[&str], column: usize| row[column].parse::<f64>().expect("a number");
    let near = |a: f64, b: f64| assert!(abs_diff_eq!(a, b, epsilon = 1e-9 * b.abs()), "{a} {b}");
    assert_eq!(rows[0][..3], ["0", "1", "weak"]);
    near(number(&rows[0], 8), 1e-4);
    near(number(&rows[0], 12), 1.0);
    near(number(&rows[0], 15), -1010.0);
    // psi was 0.01 and pi - 0.01 initially and is 0 and pi now: the displacements zeta = -+0.01 mm cancel.
    near(number(&rows[0], 10), -1e-5);
    near(number(&rows[0], 11), 1e-5);
    assert!(number(&rows[0], 16).abs() < 1e-6);
    assert_eq!(rows[1][..3], ["1", "2", "strong"]);
    near(number(&rows[1], 9), -1e-4);
    near(number(&rows[1], 15), 2000.0);
}

#[test]
fn stability_reports_bounds_and_whether_they_are_satisfied() {
    let output = run(&["stability", "granite-fault-small"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let report = json(&stdout(&output));
    assert_eq!(report["integrator"], "velocity-verlet");
    assert_eq!(report["time_step"], 1e-8);
    assert_eq!(report["satisfied"], true);
    let bounds = report["bounds"].as_array().expect("a list");
    let smallest = bounds
        .iter()
        .filter_map(|b| b["step"].as_f64())
        .fold(1.0, f64::min);
    assert_eq!(report["smallest_bound"].as_f64(), Some(smallest));
}

#[test]
fn stability_follows_the_moment_of_inertia() {
    let folder = tempfile::tempdir().expect("a folder");
    let (k, mass) = (3e6, 4.0 / 3.0 * std::f64::consts::PI * 2700.0e-9);
    let chosen = Draft::empty().with("material.inertia_factor", 0.6);
    for (body, factor) in [(Draft::empty(), 0.4), (chosen, 0.6)] {
        let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
            .and(&body)
            .law(KelvinVoigt {
                stiffness: 1e6,
                damping: 0.0,
            })
            .friction("cundall-strack", 0.5, 3e6)
            .law(AdjustedKelvinVoigt {
                stiffness: 1e6,
                damping: 0.0,
            })
            .law(EulerBernoulli {
                stiffness: 3e6,
                damping: 0.0,
            })
            .grain(Grain::at([0.0, 0.0], 1e-3))
            .grain(Grain::at([2e-3, 0.0], 1e-3))
            .bonded(0, 1);
        let path = write_draft(folder.path(), &draft);
        let output = run(&["stability", path.to_str().expect("UTF-8")]);
        assert!(output.status.success(), "{}", stderr(&output));
        let report = json(&stdout(&output));
        let bounds = report["bounds"].as_array().expect("a list");
        // Both rotations contribute to a contact; the ends of a beam rotate in the same sense or in opposite senses.
        let squares = [
            ("contact tangential", 2.0 * (1.0 + 1.0 / factor)),
            ("bond shear", 1.0 + 1.0 / factor),
            ("bond bending", 1.0 / factor),
        ];
        for (name, square) in squares {
            let bound = bounds.iter().find(|bound| bound["name"] == name);
            let found = bound.and_then(|bound| bound["angular_frequency"].as_f64());
            let expected = (square * k / mass).sqrt();
            let is_near = found.is_some_and(|found| (found / expected - 1.0).abs() < 1e-12);
            assert!(is_near, "{name} {factor}: {found:?}, {expected}");
        }
    }
}

#[test]
fn scenes_lists_all_scenes_and_prints_one() {
    let list = stdout(&run(&["scenes"]));
    for name in [
        "granite-fault",
        "granite-fault-small",
        "head-on",
        "oblique",
        "rolling",
        "pile",
        "cantilever",
        "three-point-bend",
    ] {
        assert!(
            list.lines()
                .any(|line| line.split_whitespace().next() == Some(name))
        );
        let text = stdout(&run(&["scenes", name]));
        let path = std::path::Path::new(".");
        let scene = gouge_runner::scene::Scene::parse(name, text.as_bytes(), path);
        assert!(scene.is_ok(), "{name}: {:?}", scene.err());
    }
}

#[test]
fn a_run_writes_all_outputs_of_the_contract() {
    let folder = tempfile::tempdir().expect("a folder");
    let draft = Draft::builtin("three-point-bend").replacing("time.end", 3e-5);
    let path = write_draft(folder.path(), &draft);
    let out = folder.path().join("out");
    let output = run(&[
        "run",
        path.to_str().expect("UTF-8"),
        "--out",
        out.to_str().expect("UTF-8"),
    ]);
    assert!(output.status.success(), "{}", stderr(&output));
    let read = |name: &str| std::fs::read_to_string(out.join(name)).expect(name);
    let summary = json(&read("summary.json"));
    for key in [
        "status",
        "steps",
        "time",
        "particles",
        "bonds_initial",
        "bonds_broken",
        "wall_seconds",
        "particle_steps_per_second",
        "link_steps_per_second",
        "version",
        "scene_sha256",
        "energy",
        "series_columns",
    ] {
        assert!(!summary[key].is_null(), "{key} is missing");
    }
    assert_eq!(summary["status"], "done");
    assert_eq!(summary["steps"], 1200);
    let columns = "time,kinetic,contact,external,ambient,friction,breaking,bonding,driving,residual,\
        friction_load,friction_feedback,drive_force_x,drive_force_y,bonds,fragments";
    let series = read("series.csv");
    assert_eq!(series.lines().next(), Some(columns));
    let times: Vec<f64> = series
        .lines()
        .skip(1)
        .map(|line| {
            line.split(',')
                .next()
                .and_then(|t| t.parse().ok())
                .expect("a time")
        })
        .collect();
    assert_eq!(times.first(), Some(&0.0));
    assert!(times.windows(2).all(|two| two[0] < two[1]));
    assert_abs_diff_eq!(times[times.len() - 1], 3e-5, epsilon = 1e-18);
    let particles = read("particles.csv");
    assert!(particles.starts_with("id,x,y,vx,vy,angle,angular_velocity,radius,role,density\n"));
    assert_eq!(particles.lines().count(), 1 + 183);
    assert!(read("picture.svg").contains("<circle"));
    assert!(out.join("checkpoint").exists());
    assert!(out.join("trajectory/frame_000000.vtk").exists());
}

#[test]
fn the_energy_terms_of_the_summary_balance_up_to_the_residual() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let output = run(&[
        "run",
        "head-on",
        "--quiet",
        "--out",
        out.to_str().expect("UTF-8"),
    ]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = std::fs::read_to_string(out.join("summary.json")).expect("summary");
    let energy = json(&text)["energy"].clone();
    let term = |name: &str| energy[name].as_f64().expect("a number");
    let left = term("kinetic")
        + term("contact")
        + term("external")
        + term("ambient")
        + term("friction")
        + term("breaking");
    let initial = 2.0 * 0.5 * 1.130973355292325e-5 * 0.25;
    let residual = left - initial - term("bonding") - term("driving");
    assert_abs_diff_eq!(residual, term("residual"), epsilon = 1e-20);
    assert!(term("residual").abs() < 1e-5 * initial);
}

#[test]
fn verify_runs_selected_checks_and_writes_reports() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let output = run(&["verify", "--only", "order.smooth", "--out", out]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = std::fs::read_to_string(folder.path().join("report.json")).expect("report");
    let report = json(&text);
    let checks = report["checks"].as_array().expect("a list");
    assert_eq!(stdout(&output).lines().count(), checks.len());
    for key in [
        "id",
        "claim",
        "equations",
        "status",
        "expected",
        "measured",
        "error",
        "tolerance",
        "tolerance_origin",
        "digits",
        "seconds",
    ] {
        assert!(!checks[0][key].is_null(), "{key}");
    }
    assert_eq!(
        run(&["verify", "--only", "nonsense", "--out", out])
            .status
            .code(),
        Some(2)
    );
}

/// The two reports of a run of some checks, without timings and the date.
fn timeless_reports() -> (Value, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().to_str().expect("UTF-8");
    let output = run(&["verify", "--only", "smooth", "--out", out]);
    assert!(output.status.success(), "{}", stderr(&output));
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).expect("report");
    let mut report = json(&read("report.json"));
    for check in report["checks"].as_array_mut().expect("a list") {
        check.as_object_mut().expect("an object").remove("seconds");
    }
    let fields = report.as_object_mut().expect("an object");
    let date = fields.remove("date").expect("a date");
    let date = date.as_str().expect("a string");
    assert_eq!(date.len(), "2026-11-29".len(), "{date}");
    let page = read("report.html").replacen(date, "", 1);
    let mut parts = page.split("<td class=\"n time\">");
    let first = parts.next().expect("the head").to_owned();
    let rest = parts.map(|part| part.split_once("</td>").expect("the end of a cell").1);
    (report, first + &rest.collect::<String>())
}

#[test]
fn two_verifications_differ_only_in_their_timings() {
    assert!(timeless_reports() == timeless_reports());
}

#[test]
fn the_report_needs_no_other_file() {
    let (_, page) = timeless_reports();
    for outside in ["src=", "<link", "@import", "import(", "url(", "fetch("] {
        assert!(!page.contains(outside), "{outside}");
    }
}

#[test]
fn a_closed_standard_error_is_no_reason_to_panic() {
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let mut program = gouge();
    let program = program.args(["links", "no-such-scene"]).stderr(writer);
    assert_eq!(
        program.status().expect("the program starts").code(),
        Some(2)
    );
}
