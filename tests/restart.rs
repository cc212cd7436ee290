//! Final states as text: a run that reads them continues with the same bits, and broken bonds are listed.

use crate::nothing_lost::fault;
use crate::program::{gouge, stderr};
use crate::start::{Folder, grains};
use approx::assert_relative_eq;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, ZhangEckert};
use gouge_dem::model::Yielding;
use gouge_validation::scenes::{Bond, Draft, Grain};
use std::f64::consts::PI;

/// Continue the run in the folder `before` from its text to `after`.
fn restart(folder: &Folder, before: &str, after: &str, more: &[&str]) {
    let scene = folder.path(before).join("restart.toml");
    let output = gouge()
        .arg("run")
        .arg(scene)
        .args(["--accept-untrusted", "--out"])
        .arg(folder.path(after))
        .args(more)
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", stderr(&output));
}

/// Files that tell every bit of two runs from the same state.
const FILES: [&str; 4] = [
    "series.csv",
    "particles.csv",
    "restart-particles.csv",
    "restart.toml",
];

/// Continue a run from its text and from its checkpoint. `remembers`: whether it ends with remembered contacts.
fn check_restart(first: &Draft, remembers: bool, more_files: &[&str]) {
    let folder = Folder::new();
    let (status, said) = folder.run(first, "first");
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(
        folder.path("first/restart-contacts.csv").exists(),
        remembers
    );
    restart(&folder, "first", "text", &[]);
    let (status, said) = folder.run(&first.clone().with("start", "first"), "state");
    assert_eq!(status, Some(0), "{said}");
    for name in FILES.iter().chain(more_files) {
        let of = |run: &str| folder.read(&format!("{run}/{name}"));
        assert!(of("text") == of("state"), "{name} differs: {first:?}");
    }
    let end = |run: &str| folder.read(&format!("{run}/particles.csv"));
    assert_ne!(end("first"), end("text"), "it goes on");
}

#[test]
fn a_fault_continues_from_text_with_the_same_bits() {
    for (integrator, friction) in [
        ("velocity-verlet", "cundall-strack-truncated"),
        ("beeman", "cundall-strack"),
        ("euler", "cundall-strack-truncated"),
    ] {
        let fault = fault(integrator, friction, "none").replacing("time.end", 20e-6);
        check_restart(
            &fault,
            true,
            &["bonds.csv", "breaks.csv", "restart-contacts.csv"],
        );
    }
}

#[test]
fn bonds_and_contacts_across_the_seam_continue_from_text() {
    let short = grains(1e-8).ending_at(3e-6);
    check_restart(&short, true, &["bonds.csv"]);
    // Lever arms that accumulate have no initial angles.
    let mixed: toml::Table = [
        ("kinematic", "focal"),
        ("translation", "levers"),
        ("torque", "focal"),
    ]
    .map(|(key, value)| (key.to_owned(), value.into()))
    .into_iter()
    .collect();
    check_restart(
        &short.clone().with("contact.distance", mixed),
        true,
        &["bonds.csv"],
    );
    let viscous = short
        .without("contact.tangential")
        .friction("haff-werner", 0.5, 1.0);
    check_restart(&viscous, false, &["bonds.csv"]);
}

#[test]
fn a_prescribed_motion_continues_from_text() {
    let pulled = pair("velocity-verlet", Grain::at([2.0 * RADIUS, 0.0], RADIUS))
        .grain(Grain::at([4.0 * RADIUS, 0.0], RADIUS).driven())
        .bond(Bond::between(1, 2))
        .with("driving.controller", "steady")
        .with("driving.velocity", vec![toml::Value::from(0.3), 0.1.into()])
        .replacing("time.end", 1e-6);
    check_restart(&pulled, false, &["bonds.csv", "breaks.csv"]);
}

#[test]
fn a_longer_run_and_a_continued_one_end_alike() {
    let folder = Folder::new();
    let until = |end: f64| grains(1e-8).ending_at(end);
    assert_eq!(folder.run(&until(3e-6), "half").0, Some(0));
    assert_eq!(folder.run(&until(6e-6), "whole").0, Some(0));
    restart(&folder, "half", "rest", &["--set", "time.end=3e-6"]);
    for name in ["particles.csv", "bonds.csv"] {
        assert_eq!(
            folder.read(&format!("rest/{name}")),
            folder.read(&format!("whole/{name}"))
        );
    }
}

#[test]
fn angles_that_contradict_each_other_are_refused() {
    let folder = Folder::new();
    assert_eq!(folder.run(&grains(1e-8).ending_at(3e-6), "run").0, Some(0));
    let path = folder.path("run/bonds.csv");
    let text = folder.read("run/bonds.csv");
    let mut rows = text.lines();
    let (header, row) = (rows.next().expect("a header"), rows.next().expect("a bond"));
    let mut cells: Vec<String> = row.split(',').map(str::to_owned).collect();
    cells[4] = "1.5".to_owned();
    std::fs::write(&path, format!("{header}\n{}\n", cells.join(","))).expect("writable");
    let scene = folder.path("run/restart.toml");
    let output = gouge()
        .arg("links")
        .arg(scene)
        .output()
        .expect("the program starts");
    assert_eq!(output.status.code(), Some(2));
    let said = stderr(&output);
    assert!(
        said.contains("bonds.csv:2: initial_angle_i = 1.5"),
        "{said}"
    );
}

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 1e6;
const NORMAL_STRENGTH: f64 = 20e6;
const TANGENTIAL_STRENGTH: f64 = 10e6;

/// Two bonded grains of which the second moves.
fn pair(integrator: &str, second: Grain) -> Draft {
    Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .replacing("time.integrator", integrator)
        .ending_at(5e-6)
        .law(AdjustedKelvinVoigt {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .law(Yielding {
            law: ZhangEckert {
                normal_strength: NORMAL_STRENGTH,
                tangential_strength: TANGENTIAL_STRENGTH,
            },
            tensile_strength: None,
            unbreakable_edges: false,
        })
        .grain(Grain::at([0.0; 2], RADIUS).fixed())
        .grain(second)
        .bond(Bond::between(0, 1))
}

/// The only row of the broken bonds of a run.
fn broken(draft: &Draft) -> Vec<String> {
    let folder = Folder::new();
    let (status, said) = folder.run(draft, "run");
    assert_eq!(status, Some(0), "{said}");
    let text = folder.read("run/breaks.csv");
    let rows: Vec<&str> = text.lines().collect();
    assert_eq!(
        rows[0],
        "time,i,j,x,y,normal_force,tangential_force,cause,share"
    );
    assert_eq!(rows.len(), 2, "{text}");
    assert_eq!(folder.read("run/bonds.csv").lines().count(), 1);
    rows[1].split(',').map(str::to_owned).collect()
}

#[test]
fn a_pulled_bond_breaks_when_its_spring_has_its_strength() {
    let speed = 20.0;
    // Euler gains energy, so that it is early by about a step.
    for (integrator, late) in [
        ("velocity-verlet", 0.0..1e-9),
        ("euler", -2e-9..0.0),
        ("beeman", 0.0..1e-9),
    ] {
        let second = Grain::at([2.0 * RADIUS, 0.0], RADIUS).moving([speed, 0.0]);
        let row = broken(&pair(integrator, second));
        let number = |at: usize| row[at].parse::<f64>().expect("a number");
        // A mass on a spring: k x = sigma A at x = (v / w) sin w t.
        let mass = 4.0 / 3.0 * PI * 2700.0 * RADIUS.powi(3);
        let rate = (STIFFNESS / mass).sqrt();
        let strength = NORMAL_STRENGTH * PI * RADIUS * RADIUS;
        let time = (strength * rate / (STIFFNESS * speed)).asin() / rate;
        assert!(
            late.contains(&(number(0) - time)),
            "{integrator}: {time} {row:?}"
        );
        assert_eq!(
            [&row[1], &row[2], &row[7], &row[8]],
            ["0", "1", "normal", "1.0"]
        );
        assert_relative_eq!(number(5), strength, max_relative = 2e-9 * rate);
        assert_relative_eq!(
            number(3),
            RADIUS + 0.5 * strength / STIFFNESS,
            max_relative = 1e-3
        );
        assert_eq!(number(6), 0.0);
    }
}

#[test]
fn a_bent_bond_breaks_by_its_tangential_term() {
    // The grain turns on the spot at first: each radian of it is a force k r / 2 across the bond.
    let second = Grain::at([0.0, 2.0 * RADIUS], RADIUS).spinning(-6e4);
    let row = broken(&pair("velocity-verlet", second));
    let number = |at: usize| row[at].parse::<f64>().expect("a number");
    let terms = [number(5) / NORMAL_STRENGTH, number(6) / TANGENTIAL_STRENGTH].map(|x| x * x);
    let section = PI * RADIUS * RADIUS;
    assert_relative_eq!(terms[0] + terms[1], section * section, max_relative = 1e-2);
    assert_eq!(row[7], "tangential");
    assert_relative_eq!(
        number(8),
        terms[1] / (terms[0] + terms[1]),
        max_relative = 1e-12
    );
    assert_relative_eq!(number(4), RADIUS, max_relative = 1e-2);
}

#[test]
fn every_broken_bond_is_listed_once_for_any_number_of_threads() {
    let folder = Folder::new();
    let draft =
        fault("velocity-verlet", "cundall-strack-truncated", "none").with("output.energy", false);
    let scene = crate::program::write_draft(&folder.path("."), &draft);
    for threads in ["1", "3"] {
        let output = gouge()
            .env("GOUGE_THREADS", threads)
            .arg("run")
            .arg(&scene)
            .arg("--out")
            .arg(folder.path(threads))
            .output()
            .expect("the program starts");
        assert!(output.status.success(), "{}", stderr(&output));
    }
    let breaks = folder.read("1/breaks.csv");
    assert_eq!(breaks, folder.read("3/breaks.csv"));
    let summary: serde_json::Value =
        serde_json::from_str(&folder.read("1/summary.json")).expect("JSON");
    let pair = |row: &str| row.split(',').skip(1).take(2).collect::<Vec<_>>().join(",");
    let mut pairs: Vec<String> = breaks.lines().skip(1).map(pair).collect();
    assert_eq!(Some(pairs.len() as u64), summary["bonds_broken"].as_u64());
    let left = folder.read("1/bonds.csv");
    let left = left
        .lines()
        .skip(1)
        .map(|row| row.split(',').take(2).collect::<Vec<_>>().join(","));
    pairs.extend(left);
    let all = pairs.len();
    assert_eq!(Some(all as u64), summary["bonds_initial"].as_u64());
    pairs.sort();
    pairs.dedup();
    assert_eq!(pairs.len(), all);
}
