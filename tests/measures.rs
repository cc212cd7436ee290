//! The columns that a scene asks for, where they are known beforehand.

use crate::program::{run, stderr, write_draft};
use approx::assert_relative_eq;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, Controller, KelvinVoigt};
use gouge_runner::scene::DrivingTable;
use gouge_validation::scenes::{Draft, Grain};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;
use toml::Value;

const RADIUS: f64 = 1e-3;

fn open(step: f64, end: f64) -> Draft {
    Draft::open_box(Integrator::VelocityVerlet, step).replacing("time.end", end)
}

fn with_contacts(draft: Draft, damping: f64) -> Draft {
    draft.law(KelvinVoigt {
        stiffness: 1e7,
        damping,
    })
}

/// All columns of the series of a run, with the given quantities.
fn series(draft: &Draft, measure: &[&str]) -> BTreeMap<String, Vec<f64>> {
    let folder = tempfile::tempdir().expect("a folder");
    let names = measure.iter().map(|&name| Value::from(name));
    let draft = draft
        .clone()
        .with("output.measure", names.collect::<Vec<Value>>());
    let (scene, out) = (
        write_draft(folder.path(), &draft),
        folder.path().join("out"),
    );
    let [scene, out_text] = [&scene, &out].map(|path| path.to_str().expect("UTF-8"));
    let output = run(&["run", scene, "--out", out_text]);
    assert!(output.status.success(), "{}", stderr(&output));
    let mut reader = csv::Reader::from_path(out.join("series.csv")).expect("a series");
    let names: Vec<String> = reader
        .headers()
        .expect("names")
        .iter()
        .map(str::to_owned)
        .collect();
    let mut columns: BTreeMap<String, Vec<f64>> = BTreeMap::new();
    for row in reader.records() {
        for (name, cell) in names.iter().zip(&row.expect("a row")) {
            columns
                .entry(name.clone())
                .or_default()
                .push(cell.parse().expect("a number"));
        }
    }
    columns
}

fn last(columns: &BTreeMap<String, Vec<f64>>, name: &str) -> f64 {
    *columns[name].last().expect("a sample")
}

/// Grains that do not interact, at irregular places, each with the velocity of a field.
fn dust(draft: Draft, velocity: impl Fn([f64; 2]) -> [f64; 2]) -> Draft {
    let places = (0..60).map(|k| {
        let part = |step: f64| (f64::from(k) * step).fract();
        [0.01 * part(0.618_034), 0.02 * part(0.754_878)]
    });
    draft.grains(places.map(|place| Grain::at(place, 1e-4).moving(velocity(place))))
}

#[test]
fn a_homogeneous_deformation_is_exact() {
    let end = 1e-2;
    let field = |[x, y]: [f64; 2]| [3.0 + 20.0 * x - 7.0 * y, 1.0 + 4.0 * x - 30.0 * y];
    let strain = series(&dust(open(1e-5, end), field), &["strain"]);
    for (name, rate) in [
        ("strain_xx", 20.0),
        ("strain_yy", -30.0),
        ("strain_xy", -1.5),
    ] {
        for (time, value) in strain["time"].iter().zip(&strain[name]) {
            assert!((value - rate * time).abs() < 1e-12, "{name} {time} {value}");
        }
    }
}

#[test]
fn displacements_continue_across_the_periodic_boundary() {
    // Grains cross the boundary between none and six times, in both directions.
    let draft = open(1e-6, 1e-2)
        .with("box.width", 0.01)
        .with("box.boundary", "periodic-x")
        .with("output.interval", 0.9e-2);
    let field = |[_, y]: [f64; 2]| [-3.0 + 400.0 * y, 0.0];
    let strain = series(&dust(draft, field), &["strain"]);
    for (name, expected) in [("strain_xx", 0.0), ("strain_yy", 0.0), ("strain_xy", 2.0)] {
        let found = last(&strain, name);
        assert!((found - expected).abs() < 1e-12, "{name} {found}");
    }
}

#[test]
fn grains_on_a_line_have_no_strain() {
    let grains = (0..4).map(|k| Grain::at([f64::from(k) * 0.3e-2, f64::from(k) * 0.1e-2], 1e-4));
    let strain = series(&open(1e-6, 1e-5).grains(grains), &["strain"]);
    assert!(strain["strain_xx"].iter().all(|value| value.is_nan()));
}

/// A square lattice, pressed or pulled from above onto fixed grains.
fn block(pressure: f64, columns: u32, rows: u32) -> Draft {
    let grains = (0..columns * rows).map(|k| {
        let place = [2 * (k % columns) + 1, 2 * (k / columns) + 1];
        let grain = Grain::at(place.map(|n| f64::from(n) * RADIUS), RADIUS);
        match k / columns {
            0 => grain.fixed(),
            row if row + 1 == rows => grain.driven(),
            _ => grain,
        }
    });
    let width = 2.0 * RADIUS * f64::from(columns);
    open(1e-7, 1e-3)
        .with("box.width", width)
        .driving(DrivingTable {
            controller: Controller::Exact,
            speed: 0.0,
            pressure,
            area: None,
            initial_force: [0.0; 2],
        })
        .grains(grains)
}

#[test]
fn the_stress_of_a_pressed_block_is_its_pressure() {
    let draft = with_contacts(block(1e5, 5, 6), 10.0).with("box.boundary", "periodic-x");
    let all = [
        "strain",
        "stress",
        "coordination",
        "packing-fraction",
        "unbalanced-force",
        "largest-overlap",
    ];
    let columns = series(&draft, &all);
    // The rectangle ends at the edges of the outermost free grains, half an overlap from the contact points.
    let overlap = last(&columns, "largest_overlap");
    assert_relative_eq!(last(&columns, "stress_yy"), -1e5, max_relative = overlap);
    for name in ["stress_xx", "stress_xy", "stress_yx"] {
        assert!(last(&columns, name).abs() < 1e-3, "{name}");
    }
    // Each spring carries the pressure on a square of the diameter.
    let expected = 1e5 * (2.0 * RADIUS).powi(2) / 1e7 / RADIUS;
    assert_relative_eq!(overlap, expected, max_relative = 1e-9);
    // The three distances between four rows of free grains shrink by an overlap each.
    assert_relative_eq!(
        last(&columns, "strain_yy"),
        -0.5 * overlap,
        max_relative = 1e-9
    );
    assert_relative_eq!(
        last(&columns, "coordination"),
        2.0 * 5.0 / 6.0,
        max_relative = 1e-15
    );
    let packing = FRAC_PI_4 / (1.0 - 0.375 * overlap);
    assert_relative_eq!(
        last(&columns, "packing_fraction"),
        packing,
        max_relative = 1e-12
    );
    assert!(last(&columns, "unbalanced_force") < 1e-9);
    let names: Vec<&String> = columns
        .keys()
        .filter(|name| name.starts_with("str"))
        .collect();
    assert_eq!(names.len(), 7);
}

#[test]
fn the_stress_of_a_pulled_bar_is_its_load_over_its_section() {
    let bar = (1..5).fold(block(-2e4, 1, 5), |bar, k| bar.bonded(k - 1, k));
    let bar = bar.law(AdjustedKelvinVoigt {
        stiffness: 1e7,
        damping: 10.0,
    });
    let columns = series(&bar, &["stress", "coordination", "largest-overlap"]);
    let stretch = 2e4 * 4.0 * RADIUS * RADIUS / 1e7 / RADIUS;
    assert_relative_eq!(last(&columns, "stress_yy"), 2e4, max_relative = stretch);
    assert_eq!(last(&columns, "largest_overlap"), 0.0);
    assert_relative_eq!(last(&columns, "coordination"), 8.0 / 5.0);
}

#[test]
fn two_free_grains_in_contact_are_fully_unbalanced() {
    let overlap = 0.02;
    for integrator in ["velocity-verlet", "euler"] {
        let draft = with_contacts(open(1e-8, 1e-7), 0.0)
            .replacing("time.integrator", integrator)
            .grain(Grain::at([0.0, 0.0], RADIUS))
            .grain(Grain::at([0.0, (3.0 - overlap) * RADIUS], 2.0 * RADIUS));
        let columns = series(&draft, &["unbalanced-force", "largest-overlap", "stress"]);
        for value in &columns["unbalanced_force"] {
            assert_relative_eq!(*value, 1.0, max_relative = 1e-12);
        }
        assert_relative_eq!(columns["largest_overlap"][0], overlap, max_relative = 1e-12);
        // Both push with 200 N over 2.98 mm; the rectangle is 4 mm by 5.98 mm, the thickness 3 mm.
        let stress = -200.0 * 2.98e-3 / (4e-3 * 5.98e-3 * 3e-3);
        assert_relative_eq!(columns["stress_yy"][0], stress, max_relative = 1e-12);
    }
}

#[test]
fn nothing_is_measured_of_nothing() {
    let draft = with_contacts(open(1e-6, 1e-5), 0.0).grain(Grain::at([0.0; 2], RADIUS).fixed());
    let columns = series(
        &draft,
        &["stress", "unbalanced-force", "packing-fraction", "strain"],
    );
    for name in ["stress_xx", "stress_yy", "unbalanced_force", "strain_xx"] {
        assert!(columns[name].iter().all(|value| value.is_nan()), "{name}");
    }
}

#[test]
fn a_specimen_that_does_not_span_a_periodic_box_ends_at_its_discs() {
    let packing = |width: f64, places: &[f64]| {
        let mut draft = open(1e-8, 1e-8)
            .with("box.width", width)
            .with("box.boundary", "periodic-x");
        for &place in places {
            draft = draft.grain(Grain::at([place, 0.0], RADIUS));
        }
        last(&series(&draft, &["packing-fraction"]), "packing_fraction")
    };
    // Two discs that touch, in the middle of a wide box and across its seam.
    for places in [[9e-3, 11e-3], [19e-3, 1e-3]] {
        assert_relative_eq!(packing(20e-3, &places), FRAC_PI_4, max_relative = 1e-12);
    }
    // Gaps of less than a diameter on both sides: they span the box.
    let spanning = 2.0 * FRAC_PI_4 * 2e-3 / 6e-3;
    assert_relative_eq!(
        packing(6e-3, &[1.5e-3, 4.5e-3]),
        spanning,
        max_relative = 1e-12
    );
}
