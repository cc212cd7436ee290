//! What a sweep observes in its runs.

use crate::sweep::Folder;
use approx::assert_relative_eq;
use gouge_runner::run::Summary;
use gouge_studies::sweep::{Finished, Observation};
use std::fs;

#[test]
fn an_observation_that_some_runs_can_have_is_accepted() {
    let folder = Folder::new(
        r#"
scene = "head-on"
set = ["time.end=1e-6"]
[[axis]]
name = "measured"
key = "output.measure"
values = [[], ["coordination"]]
[[observe]]
column = "coordination"
statistic = "last"
"#,
    );
    let (status, _, said) = folder.sweep("out", &[]);
    assert_eq!(status, Some(0), "{said}");
    let rows = folder.rows("out");
    assert!(rows[0]["cause"].contains("the run has no coordination_last"));
    assert!(!rows[1]["coordination_last"].is_empty());
}

/// The summary of a run, with the keys that have no default.
const SUMMARY: &str = r#"{"status": "done", "steps": 3, "time": 3.0, "particles": 9, "bonds_initial": 20,
"bonds_broken": 2, "wall_seconds": 1.0, "particle_steps_per_second": 1.0, "link_steps_per_second": 1.0,
"version": "", "scene_sha256": "", "series_columns": []}"#;

#[test]
fn elastic_constants_are_those_of_the_whole_specimen() {
    // E = 70 GPa, nu = 0.25 under s_y = 70 MPa; then bonds break.
    let series = "time,bonds,stress_xx,stress_yy,strain_xx,strain_yy\n\
                  0.0,20,0.0,0.0,0.0,0.0\n1.0,20,0.0,70e6,-0.25e-3,1e-3\n2.0,18,0.0,9e6,-0.1,0.3\n";
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("series.csv"), series).expect("a file");
    fs::write(folder.path().join("summary.json"), SUMMARY).expect("a file");
    let summary = Summary::read(folder.path()).expect("a summary");
    let run = Finished::new(folder.path(), &summary, &|| None);
    for (name, expected) in [("youngs-modulus", 70e9), ("poissons-ratio", 0.25)] {
        let text = format!("quantity = {name:?}");
        let observation: Observation = toml::from_str(&text).expect("an observation");
        let found = observation.value(&run).expect("a value");
        assert_relative_eq!(found, expected, max_relative = 1e-12);
    }
}

/// A bonded pair whose bond is stretched or shortened at 1 m/s until it breaks.
const PAIR: &str = r#"
[time]
step = 1e-7
end = 120e-6
integrator = "velocity-verlet"
[box]
width = 0.1
height = 0.1
boundary = "open"
[material]
density = 2700.0
[bond.normal]
stiffness = 1e7
damping = 0.0
[bond.yielding]
law = "zhang-eckert"
normal_strength = 280e6
tangential_strength = 280e6
unbreakable_edges = false
[driving]
controller = "steady"
velocity = [1.0, 0.0]
[output]
interval = 1e-7
[[particles]]
position = [0.05, 0.05]
radius = 1e-3
role = "fixed"
[[particles]]
position = [0.052, 0.05]
radius = 1e-3
role = "driven"
[[bonds]]
between = [0, 1]
"#;

const BREAKS: &str = r#"
scene = "pair.toml"
[[axis]]
key = "driving.velocity"
values = [[1.0, 0.0], [-1.0, 0.0]]
labels = ["stretched", "shortened"]
[[observe]]
name = "strength"
column = "drive_force_x"
statistic = "at-change"
against = "bonds"
[[observe]]
name = "time of the largest force"
column = "time"
statistic = "at-peak"
against = "drive_force_x"
[[observe]]
name = "time of the smallest force"
column = "time"
statistic = "at-trough"
against = "drive_force_x"
[[observe]]
name = "force at 33.35 us"
column = "drive_force_x"
statistic = "at-level"
against = "time"
level = 33.35e-6
"#;

/// The force grows by the stiffness times the velocity, to the strength times the section of the bond.
#[test]
fn a_column_is_observed_where_another_one_peaks_reaches_a_level_or_changes() {
    let folder = Folder::new(BREAKS);
    fs::write(folder.path("pair.toml"), PAIR).expect("a file");
    let (status, _, errors) = folder.sweep("out", &["--quiet"]);
    assert_eq!(status, Some(0), "{errors}");
    let strength = 280e6 * std::f64::consts::PI * 1e-6;
    let (rate, interval) = (1e7, 1e-7);
    for row in folder.rows("out") {
        let number = |name: &str| row[name].parse::<f64>().expect("a number");
        let (sign, extreme) = match row["driving.velocity"].as_str() {
            "stretched" => (1.0, "time of the largest force"),
            _ => (-1.0, "time of the smallest force"),
        };
        let missing = strength - sign * number("strength");
        assert!((0.0..=1.01 * rate * interval).contains(&missing), "{row:?}");
        let early = strength / rate - number(extreme);
        assert!((0.0..=1.01 * interval).contains(&early), "{row:?}");
        let force = sign * number("force at 33.35 us");
        assert!((force / (rate * 33.35e-6) - 1.0).abs() < 1e-6, "{row:?}");
    }
}
