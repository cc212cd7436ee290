//! The page of a run: it needs no other file, and what it shows is what happened.

use crate::program::{gouge, run, stderr, write_draft};
use approx::assert_relative_eq;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use gouge_dem::estimators::{particle_pressures, specimen_size, specimen_stress};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::KelvinVoigt;
use gouge_validation::scenes::{Draft, Grain};
use serde_json::Value;
use std::f64::consts::PI;
use std::path::Path;

const RADIUS: f64 = 1e-3;

/// Run a draft in a folder and return its page.
fn page(folder: &Path, draft: &Draft, options: &[&str]) -> Option<String> {
    let (scene, out) = (write_draft(folder, draft), folder.join("out"));
    let [scene, out_text] = [&scene, &out].map(|path| path.to_str().expect("UTF-8"));
    let output = run(&[
        &["run", scene, "--out", out_text, "--accept-untrusted"],
        options,
    ]
    .concat());
    assert!(output.status.success(), "{}", stderr(&output));
    std::fs::read_to_string(out.join("run.html")).ok()
}

fn draft(step: f64, end: f64) -> Draft {
    Draft::open_box(Integrator::VelocityVerlet, step)
        .replacing("time.end", end)
        .with("title", "<grains> & \"walls\"")
}

/// The text between two others.
fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    let (_, rest) = text
        .split_once(start)
        .unwrap_or_else(|| panic!("no {start}"));
    rest.split_once(end).expect("an end").0
}

#[test]
fn a_page_needs_no_other_file_and_escapes_texts() {
    let folder = tempfile::tempdir().expect("a folder");
    let pair = draft(1e-9, 4e-6)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .with("output.trajectory", "extxyz")
        .grain(Grain::at([-RADIUS, 0.0], RADIUS).moving([0.5, 0.0]))
        .grain(Grain::at([RADIUS, 0.0], RADIUS).moving([-0.5, 0.0]));
    let page = page(folder.path(), &pair, &[]).expect("a page");
    assert!(page.contains("<b>Done.</b>"));
    assert!(page.contains("&lt;grains&gt; &amp; ") && !page.contains("<grains>"));
    let addresses = page.replace("http://www.w3.org/2000/svg", "");
    for outside in ["http:", "https:", "src=", "<link", "@import", "url("] {
        assert!(!addresses.contains(outside), "{outside}");
    }
    for figure in ["Energies of the grains.", "Residual of the energy balance."] {
        assert!(page.contains(figure), "{figure}");
    }
    assert!(
        !page.contains("Coefficient of friction."),
        "nothing is driven"
    );
}

#[test]
fn a_run_that_cannot_be_trusted_says_so_on_its_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let coarse = Draft::builtin("head-on").replacing("time.step", 4e-7);
    let page = page(folder.path(), &coarse, &[]).expect("a page");
    assert!(page.contains("Untrusted: the energy balance is off"));
    assert!(between(&page, "<ul class=\"warnings\">", "</ul>").contains("try a smaller time step"));
}

#[test]
fn data_only_leaves_neither_page_nor_restart() {
    let folder = tempfile::tempdir().expect("a folder");
    let still = draft(1e-6, 1e-5)
        .grain(Grain::at([0.0; 2], RADIUS))
        .with("output.trajectory", "vtk");
    assert_eq!(page(folder.path(), &still, &["--data-only"]), None);
    for name in [
        "restart.toml",
        "restart-particles.csv",
        "trajectory/animation.bin",
    ] {
        assert!(!folder.path().join("out").join(name).exists(), "{name}");
    }
}

#[test]
fn the_motion_on_the_page_is_that_of_the_grains() {
    let folder = tempfile::tempdir().expect("a folder");
    // One grain passes a still one at 0.8 m/s and turns by a quarter.
    let (end, turn) = (5e-3, 0.25);
    let grains = draft(1e-5, end)
        .with("output.interval", 1e-3)
        .with("output.trajectory", "extxyz")
        .grain(Grain::at([0.0, 0.0], RADIUS))
        .grain(
            Grain::at([0.0, 5e-3], 2.0 * RADIUS)
                .moving([0.8, 0.0])
                .spinning(turn * 2.0 * PI / end),
        );
    let page = page(folder.path(), &grains, &[]).expect("a page");
    let data = between(
        &page,
        "<script id=\"motion-data\" type=\"application/json\">",
        "</script>",
    );
    let motion: Value = serde_json::from_str(data).expect("JSON");
    let number = |key: &str| motion[key].as_f64().expect("a number");
    let bytes = |key: &str| {
        BASE64_STANDARD
            .decode(motion[key].as_str().expect("text"))
            .expect("base64")
    };
    let word = |bytes: &[u8], at: usize| f64::from(u16::from_le_bytes([bytes[at], bytes[at + 1]]));
    assert_eq!(motion["times"].as_array().map(Vec::len), Some(6));
    let samples = bytes("samples");
    assert_eq!(samples.len(), 6 * 2 * 8);
    let unit = number("extent") / 65534.0;
    for (k, sample) in samples.chunks(16).enumerate() {
        let apart = [
            word(sample, 2) - word(sample, 0),
            word(sample, 6) - word(sample, 4),
        ];
        let expected = [0.8 * 1e-3 * k as f64, 5e-3];
        for (apart, expected) in apart.into_iter().zip(expected) {
            assert!(
                (unit * apart - expected).abs() <= 1.5 * unit,
                "{k}: {apart} {expected}"
            );
        }
        let turned = f64::from(sample[9]) / 256.0;
        assert!(
            (turned - turn * k as f64 / 5.0).abs() <= 1.0 / 256.0,
            "{k}: {turned}"
        );
        assert_eq!([sample[10], sample[11]], [250, 250], "single grains");
        assert_eq!([sample[12], sample[13]], [0, 255], "speeds");
    }
    let radii = bytes("radii");
    assert_relative_eq!(unit * word(&radii, 2), 2.0 * RADIUS, max_relative = 1e-3);
}

#[test]
fn a_grain_that_flies_away_does_not_shrink_the_others() {
    let folder = tempfile::tempdir().expect("a folder");
    let grains = draft(1e-5, 1e-3)
        .with("output.trajectory", "extxyz")
        .grain(Grain::at([0.0, 0.0], RADIUS))
        .grain(Grain::at([0.0, 5e-3], RADIUS).moving([1e4, 0.0]));
    let page = page(folder.path(), &grains, &[]).expect("a page");
    assert!(page.contains("Grains that fly far away are not shown."));
    let data = between(&page, "\"extent\":", ",");
    assert_relative_eq!(data.parse().unwrap_or(f64::NAN), 7e-3, max_relative = 1e-6);
}

#[test]
fn a_long_run_of_many_grains_has_a_small_page_that_says_what_it_leaves_out() {
    let folder = tempfile::tempdir().expect("a folder");
    let grains =
        (0..3000).map(|k| Grain::at([3e-3 * f64::from(k % 60), 3e-3 * f64::from(k / 60)], RADIUS));
    let many = draft(1e-6, 150e-6)
        .with("output.interval", 1e-6)
        .with("output.energy", false)
        .with("output.trajectory", "extxyz")
        .grains(grains);
    let page = page(folder.path(), &many, &[]).expect("a page");
    assert!(page.len() < 4_500_000, "{} bytes", page.len());
    assert!(page.contains("76 of 151 samples are shown"));
}

#[test]
fn pressures_of_grains_add_up_to_the_stress_of_the_specimen() {
    let places = [[0.0, 0.0], [1.9, 0.1], [1.1, 1.6], [3.0, 1.7], [2.0, 3.3]];
    let grains = places.iter().zip([1.0, 1.1, 0.9, 1.05, 1.0]);
    let cluster = draft(1e-9, 1e-6)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .grains(grains.map(|(place, size)| Grain::at(place.map(|x| x * RADIUS), size * RADIUS)));
    let world = crate::worlds::world(&cluster);
    let interactions = world.interactions();
    assert!(interactions.len() > 4);
    let thickness = 2e-3;
    let pressures = particle_pressures(world.particles(), &interactions, thickness);
    let radii = &world.particles().radius;
    let sum: f64 = pressures
        .iter()
        .zip(radii)
        .map(|(p, r)| p * PI * r * r)
        .sum();
    let ([[xx, _], [_, yy]], [width, height]) = (
        specimen_stress(&world, &interactions, thickness),
        specimen_size(&world),
    );
    assert_relative_eq!(sum, -0.5 * (xx + yy) * width * height, max_relative = 1e-12);
    assert!(sum > 0.0, "they are compressed");
}

#[test]
fn a_truncated_motion_is_noticed_when_the_run_is_continued() {
    let folder = tempfile::tempdir().expect("a folder");
    let until = |end: f64| {
        draft(1e-5, end)
            .with("output.interval", 1e-4)
            .with("output.trajectory", "extxyz")
            .grain(Grain::at([0.0, 0.0], RADIUS).moving([0.8, 0.0]))
    };
    assert!(page(folder.path(), &until(1e-3), &[]).is_some());
    let scene = write_draft(folder.path(), &until(2e-3));
    let resume = || {
        let mut program = gouge();
        program.arg("run").arg(&scene).arg("--resume").arg("--out");
        program
            .arg(folder.path().join("out"))
            .output()
            .expect("the program starts")
    };
    let motion = folder.path().join("out/trajectory/animation.bin");
    let bytes = std::fs::read(&motion).expect("a motion");
    std::fs::write(&motion, &bytes[..bytes.len() - 1]).expect("ours");
    let output = resume();
    assert_eq!(output.status.code(), Some(1));
    let said = stderr(&output);
    assert!(
        said.contains("animation.bin: it is shorter than") && said.contains("remove it"),
        "{said}"
    );
    std::fs::remove_file(&motion).expect("ours");
    let output = resume();
    assert!(output.status.success(), "{}", stderr(&output));
}
