//! Runs that fail keep their last good state and report what happened.

use super::{fault, summary, text};
use crate::program::{run, stderr, write_scene};
use crate::worlds::{INTEGRATORS, head, particle};
use std::fs;

/// Laws of a chain of bonded grains that touch other grains.
const LAWS: &str = "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 10.0\n\
    [contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.7\nstiffness = 1e8\n\
    [bond.normal]\nstiffness = 1e7\ndamping = 10.0\n\
    [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e7\ndamping = 10.0\n";

/// Six grains; the first three are bonded, and the first one moves.
fn chain(integrator: &str, step: f64, end: f64) -> String {
    let grain = |i: usize| {
        let speed = if i == 0 { 1.0 } else { 0.0 };
        particle(
            [1.98e-3 * i as f64, 1e-4 * (i % 2) as f64],
            [speed, 0.0],
            0.0,
            1e-3,
        )
    };
    let text = head(integrator, step) + LAWS + &(0..6).map(grain).collect::<String>();
    let line = text
        .lines()
        .find(|line| line.starts_with("end = "))
        .expect("an end");
    let text = text.replace(line, &format!("end = {end:e}"));
    text + "[[bonds]]\nbetween = [0, 1]\n[[bonds]]\nbetween = [1, 2]\n[output]\ninterval = 1e-9\n"
}

#[test]
fn a_far_too_large_time_step_reports_its_cause_and_keeps_the_last_good_state() {
    for integrator in INTEGRATORS {
        for step in [1e-5, 1e-4] {
            let folder = tempfile::tempdir().expect("a folder");
            let scene = write_scene(folder.path(), &chain(integrator, step, 1e5 * step));
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
    let scene = head("euler", 1e-3) + &particle([0.0; 2], [1e200, 0.0], 0.0, 1e-3);
    let scene = write_scene(folder.path(), &scene);
    let out = folder.path().join("out");
    let output = run(&["run", text(&scene), "--out", text(&out)]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(
        said.contains("the kinetic energy is not finite at 0 s"),
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
    let text = fault("velocity-verlet", "cundall-strack", "none");
    let cases = [
        ("step = 100e-9", "step = 100e-6", "phase 'settle 1'"),
        (
            "driven_above = 11e-3",
            "driven_above = 11.0",
            "no driven particle",
        ),
    ];
    for (old, new, expected) in cases {
        let scene = write_scene(
            folder.path(),
            &text.replace(old, new).replace("= 60e-6", "= 6e-3"),
        );
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
