//! Runs that fail keep their last good state and report what happened.

use super::{fault, summary, text};
use crate::program::{run, stderr, write_draft};
use crate::worlds::INTEGRATORS;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, KelvinVoigt};
use gouge_validation::scenes::{Draft, Grain};
use std::fs;

/// Six grains that touch, of which the first three are bonded and the first one moves.
fn chain(integrator: &str, step: f64, end: f64) -> Draft {
    let grain = |i: usize| {
        let speed = if i == 0 { 1.0 } else { 0.0 };
        Grain::at([1.98e-3 * i as f64, 1e-4 * (i % 2) as f64], 1e-3).moving([speed, 0.0])
    };
    let (stiffness, damping) = (1e7, 10.0);
    Draft::open_box(integrator, step)
        .ending_at(end)
        .law(KelvinVoigt { stiffness, damping })
        .friction("cundall-strack", 0.7, 1e8)
        .law(AdjustedKelvinVoigt { stiffness, damping })
        .law(EulerBernoulli { stiffness, damping })
        .grains((0..6).map(grain))
        .bonded(0, 1)
        .bonded(1, 2)
        .with("output.interval", 1e-9)
}

#[test]
fn a_far_too_large_time_step_reports_its_cause_and_keeps_the_last_good_state() {
    for integrator in INTEGRATORS {
        for step in [1e-5, 1e-4] {
            let folder = tempfile::tempdir().expect("a folder");
            let scene = write_draft(folder.path(), &chain(integrator, step, 1e5 * step));
            let out = folder.path().join("out");
            let output = run(&["run", text(&scene), "--out", text(&out)]);
            let said = stderr(&output);
            assert_eq!(output.status.code(), Some(1), "{integrator} {step}: {said}");
            for part in [
                "in phase 'run'",
                "particle ",
                " s",
                "likely cause",
                "time step",
                "stability",
            ] {
                assert!(said.contains(part), "{integrator} {step}: {part}: {said}");
            }
            assert!(said.contains("bond is "), "{integrator} {step}: {said}");
            assert!(!out.join("restart.toml").exists(), "{integrator} {step}");
            let report = summary(&out);
            let status = report["status"].as_str().expect("a status");
            assert!(
                status.starts_with("failed: ") && said.contains(&status[8..]),
                "{status}"
            );
            let series = fs::read_to_string(out.join("series.csv")).expect("a series");
            let particles = fs::read_to_string(out.join("particles.csv")).expect("particles");
            let mut numbers = 0;
            for cell in series
                .lines()
                .chain(particles.lines())
                .flat_map(|line| line.split(','))
            {
                if let Ok(number) = cell.parse::<f64>() {
                    assert!(
                        number.is_finite(),
                        "{integrator} {step}: {series} {particles}"
                    );
                    numbers += 1;
                }
            }
            assert!(numbers >= 60, "{series}");
            assert!(series.lines().count() > 1 && particles.lines().count() == 7);
        }
    }
}

#[test]
fn overflowing_energies_are_not_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = Draft::open_box(Integrator::Euler, 1e-3)
        .ending_at(1.0)
        .grain(Grain::at([0.0; 2], 1e-3).moving([1e200, 0.0]));
    let scene = write_draft(folder.path(), &scene);
    let out = folder.path().join("out");
    let output = run(&["run", text(&scene), "--out", text(&out)]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.contains("the kinetic energy is not finite at 0.000000e0 s"),
        "{said}"
    );
    let series = fs::read_to_string(out.join("series.csv")).expect("a series");
    assert_eq!(series.lines().count(), 1);
    let status = summary(&out)["status"].as_str().map(str::to_owned);
    assert!(status.is_some_and(|status| status.starts_with("failed: ")));
}

#[test]
fn a_failing_set_up_reports_its_phase() {
    let folder = tempfile::tempdir().expect("a folder");
    let fault = fault("velocity-verlet", "cundall-strack", "none")
        .replacing("setup.settle.0.duration", 6e-3)
        .replacing("setup.settle.1.duration", 6e-3);
    let unstable = fault
        .clone()
        .replacing("setup.settle.0.step", 100e-6)
        .replacing("setup.settle.1.step", 100e-6);
    let cases = [
        (unstable, "phase 'settle 1'"),
        (
            fault.replacing("setup.roles.driven_above", 11.0),
            "no driven particle",
        ),
    ];
    for (draft, expected) in cases {
        let scene = write_draft(folder.path(), &draft);
        let out = folder.path().join("out");
        let output = run(&["run", self::text(&scene), "--out", self::text(&out)]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains(expected), "{said}");
        let status = summary(&out)["status"].as_str().map(str::to_owned);
        assert!(status.is_some_and(|status| status.starts_with("failed: ")));
        fs::remove_dir_all(&out).expect("ours");
    }
}
