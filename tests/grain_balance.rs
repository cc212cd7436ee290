//! How runs of peridynamic grains judge their balance of energy.

use crate::grains::{OPTIONS, pair};
use crate::program::write_scene;
use gouge_runner::any_scene::AnyScene;
use gouge_runner::run::{Event, RunOptions};
use gouge_runner::scene::Overrides;

#[test]
fn energies_that_are_no_numbers_are_not_trusted_and_said_so_once() {
    let folder = tempfile::tempdir().unwrap();
    let gravity = "external={law=\"gravity\",acceleration=1e300}";
    let until = |end: &str, resume: bool| {
        let overrides = Overrides::parse(&[end, gravity]).unwrap();
        let scene = AnyScene::load_with("two-grains", &overrides).unwrap();
        let options = RunOptions { resume, ..OPTIONS };
        let ignore = &mut |_: Event<'_>| {};
        scene.run(folder.path(), options, ignore).unwrap()
    };
    let short = until("time.end=2e-6", false);
    assert_eq!(short.status, "untrusted");
    let extended = until("time.end=4e-6", true);
    assert_eq!(extended.status, "untrusted");
    assert_eq!(extended.warnings, short.warnings);
}

#[test]
fn energy_out_of_friction_and_damping_is_not_trusted() {
    let folder = tempfile::tempdir().unwrap();
    let judged = |mode: &str| {
        let ignore = &mut |_: Event<'_>| {};
        let run = pair(&[mode]).run(&folder.path().join(mode), OPTIONS, ignore);
        let run = run.unwrap();
        (run.status, run.warnings.join("\n"))
    };
    let (status, warnings) = judged("mode=\"paper\"");
    assert_eq!(status, "untrusted");
    let expected = "damping and friction have given energy to the grains";
    assert!(warnings.contains(expected), "{warnings}");
    assert_eq!(
        judged("mode=\"corrected\""),
        ("done".to_owned(), String::new())
    );
}

#[test]
fn a_residual_counts_the_same_in_any_frame_and_beside_any_grain() {
    let folder = tempfile::tempdir().unwrap();
    let error = |name: &str, grains: &[(f64, f64)]| {
        let positions = [[-1.25e-3, 0.0], [1.1e-3, 2e-4], [0.0, 9e-3]];
        let grain = |(place, (vx, vy)): (&[f64; 2], &(f64, f64))| {
            format!("{{shape=\"disc\",radius=1e-3,position={place:?},velocity=[{vx:?},{vy:?}]}}")
        };
        let all: Vec<String> = positions.iter().zip(grains).map(grain).collect();
        let scene = pair(&[&format!("grains=[{}]", all.join(","))]);
        let out = folder.path().join(name);
        let ignore = &mut |_: Event<'_>| {};
        scene
            .run(&out, OPTIONS, ignore)
            .unwrap()
            .balance_error
            .unwrap()
    };
    let alone = error("alone", &[(20.0, 0.0), (-20.0, 0.0)]);
    assert!(alone > 1e-5, "{alone}");
    let together = error("together", &[(220.0, 300.0), (180.0, 300.0)]);
    let passing = error("passing", &[(20.0, 0.0), (-20.0, 0.0), (0.0, 400.0)]);
    for other in [together, passing] {
        assert!((other / alone - 1.0).abs() < 1e-2, "{other} {alone}");
    }
}

const BASE: &str = "model = \"peridem\"\nmode = \"MODE\"\n[time]\nforced = true\nstep = STEP\nend = END\n\
    [materials.a]\nyoung_modulus = 1.23e9\ndensity = 1200.0\n[bonds]\nhorizon = 6e-4\nbreaking = \"none\"\n\
    [mesh]\nsize = 2e-4\n[contact]\nradius = 3e-4\n";

/// Status and error of the balance of a scene with a mode, a step and an end in s, and more tables.
fn judged([mode, step, end]: [&str; 3], tables: &str) -> (String, f64) {
    let folder = tempfile::tempdir().unwrap();
    let base = BASE
        .replace("MODE", mode)
        .replace("STEP", step)
        .replace("END", end);
    let path = write_scene(folder.path(), &format!("{base}{tables}"));
    let scene = AnyScene::load_with(path, &Overrides::default()).unwrap();
    let ignore = &mut |_: Event<'_>| {};
    let run = scene
        .run(&folder.path().join("out"), OPTIONS, ignore)
        .unwrap();
    (run.status, run.balance_error.unwrap_or(f64::NAN))
}

fn disc(x: &str, y: &str, velocity: &str) -> String {
    format!(
        "[[grains]]\nshape = \"disc\"\nradius = 1e-3\nposition = [{x}, {y}]\nvelocity = [{velocity}, 0.0]\n"
    )
}

/// A step that is too long for damping and friction.
#[test]
fn nothing_else_hides_a_wrong_collision() {
    let two = |velocities: [&str; 2]| {
        let [first, second] = velocities;
        let grains = disc("-1.3e-3", "0.0", first) + &disc("1.3e-3", "1e-4", second);
        format!("friction = 0.5\ndamping_ratio = 0.9\n[output]\ninterval = 1e-4\nGRAVITY{grains}")
    };
    let of = |scene: &str, gravity: &str, more: &str| {
        let tables = scene.replace("GRAVITY", gravity) + more;
        judged(["corrected", "3e-7", "1e-4"], &tables)
    };
    let still = two(["5.0", "-5.0"]);
    let (status, alone) = of(&still, "", "");
    assert!(status == "untrusted" && alone > 0.1, "{alone}");
    let gravity = "[external]\nlaw = \"gravity\"\nacceleration = 1e5\n";
    let far = disc("5e-2", "0.0", "0.0");
    let held = format!(
        "{}clamped = [[-1.0, -1.0, 1.0, 1.0]]\n",
        far.replace("velocity = [0.0, 0.0]\n", "")
    );
    let loaded =
        format!("{far}loads = [{{ box = [-1.0, -1.0, 1.0, 1.0], force = [1e-9, 0.0] }}]\n");
    let common = two(["100005.0", "99995.0"]);
    for (scene, gravity, more) in [
        (&common, "", ""),
        (&still, gravity, ""),
        (&still, gravity, &held[..]),
        (&still, gravity, &loaded[..]),
        (&still, "", &format!("{far}angular_velocity = 1e4\n")[..]),
    ] {
        let (status, error) = of(scene, gravity, more);
        assert_eq!(status, "untrusted", "{more}");
        assert!((error / alone - 1.0).abs() < 0.2, "{error} {alone} {more}");
    }
}

#[test]
fn right_motions_are_trusted_however_few_samples_they_have() {
    let trusted = |(status, error): (String, f64)| {
        assert!(status == "done" && error < 0.03, "{status} {error}");
    };
    // The first acceleration of these modes is zero, which the whole motion remembers.
    let falling = "[external]\nlaw = \"gravity\"\nacceleration = 9.81\n".to_owned()
        + &disc("0.0", "0.0", "0.0");
    for end in ["1e-7", "1e-6", "1e-4"] {
        for mode in ["authors", "two_fixes", "corrected"] {
            trusted(judged([mode, "1e-7", end], &falling));
        }
    }
    // Two rebounds between the two samples.
    let walls = "[walls]\nleft = -1.35e-3\nright = 1.35e-3\n[output]\ninterval = 3e-4\n".to_owned();
    trusted(judged(
        ["corrected", "2e-7", "3e-4"],
        &(walls + &disc("0.0", "0.0", "20.0")),
    ));
}

#[test]
fn energies_that_overflow_are_not_trusted() {
    let spinning = "self_contact = false\n".to_owned()
        + &disc("0.0", "0.0", "0.0")
        + "angular_velocity = 10.0\n";
    let (status, error) = judged(["corrected", "6e-7", "8.4e-5"], &spinning);
    assert!(status == "untrusted" && error.is_nan(), "{status} {error}");
}
