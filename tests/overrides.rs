//! Overrides of keys have the same effect as the same edits of the scene file.

use crate::program::{run, stderr, stdout, write_scene};
use gouge_runner::scene::{Overrides, Scene, builtin};
use sha2::{Digest, Sha256};
use std::path::Path;
use std::process::Output;

/// A run of a scene with overrides.
fn run_with(scene: &str, overrides: &[&str], out: &Path, more: &[&str]) -> Output {
    let out = out.to_str().expect("UTF-8");
    let mut arguments = vec!["run", scene, "--quiet", "--out", out];
    overrides
        .iter()
        .for_each(|text| arguments.extend(["--set", text]));
    run(&[&arguments, more].concat())
}

/// The final state and the series of a run of a scene with overrides.
fn results(scene: &str, overrides: &[&str]) -> [Vec<u8>; 2] {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let output = run_with(scene, overrides, &out, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    results_in(&out)
}

fn results_in(out: &Path) -> [Vec<u8>; 2] {
    ["particles.csv", "series.csv"].map(|name| std::fs::read(out.join(name)).expect(name))
}

/// The text of a built-in scene after replacements.
fn edited(name: &str, replacements: &[(&str, &str)]) -> String {
    let text = builtin::text(name).expect("built in").to_owned();
    replacements.iter().fold(text, |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text.replace(old, new)
    })
}

/// Check that a scene with overrides gives the results of the edited text, and that these differ from the results
/// without the overrides.
fn is_as_edited(name: &str, overrides: &[&str], text: &str) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = write_scene(folder.path(), text);
    let by_hand = results(path.to_str().expect("UTF-8"), &[]);
    assert!(results(name, overrides) == by_hand, "{overrides:?}");
    let alone = results(name, &overrides[..1]);
    assert!(alone != by_hand, "{overrides:?}");
}

/// Override that shortens the runs.
const SHORT: &str = "time.end=2e-6";

#[test]
fn numbers_in_tables_are_as_edited() {
    let overrides = [
        SHORT,
        "time.step=2e-9",
        "contact.tangential.friction=0.05",
        "particles.1.radius = 1.25e-3",
        "particles.0.position.1=-0.5e-3",
    ];
    let text = edited(
        "oblique",
        &[
            ("end = 20e-6", "end = 2e-6"),
            ("step = 1e-9", "step = 2e-9"),
            ("friction = 0.7", "friction = 0.05"),
            ("radius = 1.2e-3", "radius = 1.25e-3"),
            ("[-1.1e-3, -0.4e-3]", "[-1.1e-3, -0.5e-3]"),
        ],
    );
    is_as_edited("oblique", &overrides, &text);
}

#[test]
fn new_keys_and_tables_are_as_edited() {
    let overrides = [
        SHORT,
        "external={law=\"gravity\", acceleration=1e6}",
        "ambient.law=\"creeping\"",
        "ambient.viscosity=0.5",
        "particles.0.angular_velocity=1e3",
    ];
    let text = edited(
        "oblique",
        &[
            ("end = 20e-6", "end = 2e-6"),
            (
                "[output]",
                "[external]\nlaw = \"gravity\"\nacceleration = 1e6\n\
                 [ambient]\nlaw = \"creeping\"\nviscosity = 0.5\n[output]",
            ),
            ("radius = 1e-3\n", "radius = 1e-3\nangular_velocity = 1e3\n"),
        ],
    );
    is_as_edited("oblique", &overrides, &text);
}

#[test]
fn a_table_replaces_the_table_of_the_file() {
    let law = "{law=\"haff-werner\", friction=0.7, damping=3.0}";
    let overrides = [SHORT, &format!("contact.tangential={law}")];
    let text = edited(
        "oblique",
        &[
            ("end = 20e-6", "end = 2e-6"),
            ("cundall-strack-truncated", "haff-werner"),
            (
                "friction = 0.7\nstiffness = 1e7",
                "friction = 0.7\ndamping = 3.0",
            ),
        ],
    );
    is_as_edited("oblique", &overrides, &text);
}

#[test]
fn phases_of_a_set_up_are_as_edited() {
    let short = "setup.settle.0.duration=2e-6";
    let overrides = [short, "time.end=1e-6", "setup.seed=7"];
    let with = Overrides::parse(&overrides).expect("usable");
    let text = builtin::text("granite-fault-small").expect("built in");
    let scene = Scene::load_with("granite-fault-small", &with).expect("usable");
    let original = Scene::load("granite-fault-small").expect("usable");
    let settle = |scene: &Scene| {
        let setup = scene.setup.clone().expect("a set-up");
        (setup.settle[0].duration, setup.seed)
    };
    assert_eq!(settle(&scene), (2e-6, 7));
    assert_ne!(settle(&original), settle(&scene));
    assert_eq!(scene.end, 1e-6);
    assert!(text.contains("[[setup.settle]]"));
}

#[test]
fn files_beside_the_scene_are_found_from_the_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let text = edited("oblique", &[("end = 20e-6", "end = 2e-6")]);
    let (head, rest) = text.split_once("[[particles]]").expect("particles");
    let (_, output) = rest.split_once("[output]").expect("an output");
    let path = write_scene(
        folder.path(),
        &format!("particles_file = \"a.csv\"\n{head}[output]{output}"),
    );
    let rows = "x,y,radius,vx\n-1.1e-3,-0.4e-3,1e-3,50.0\n1.1e-3,0.4e-3,1.2e-3,-50.0\n";
    std::fs::create_dir(folder.path().join("below")).expect("writable");
    std::fs::write(folder.path().join("a.csv"), "x,y,radius\n0,0,1e-3\n").expect("writable");
    std::fs::write(folder.path().join("below/b.csv"), rows).expect("writable");
    let path = path.to_str().expect("UTF-8");
    let beside = results(path, &["particles_file=\"below/b.csv\""]);
    assert!(beside == results("oblique", &[SHORT]));
}

#[test]
fn commands_that_print_take_overrides() {
    let folder = tempfile::tempdir().expect("a folder");
    let change = ("[-1.1e-3, -0.4e-3]", "[-0.8e-3, -0.4e-3]");
    let path = write_scene(folder.path(), &edited("oblique", &[change]));
    let path = path.to_str().expect("UTF-8");
    let change = "particles.0.position=[-0.8e-3, -0.4e-3]";
    for command in ["links", "stability"] {
        let by_hand = run(&[command, path]);
        let output = run(&[command, "oblique", "--set", change]);
        assert!(output.status.success(), "{}", stderr(&output));
        assert_eq!(stdout(&output), stdout(&by_hand), "{command}");
    }
    let links = |arguments: &[&str]| stdout(&run(&[&["links", "oblique"], arguments].concat()));
    assert_ne!(links(&["--set", change]), links(&[]));
    let output = run(&["stability", "oblique", "--set", "time.step=3e-9"]);
    assert!(stdout(&output).contains("\"time_step\": 3e-9"));
}

/// The hash of a built-in scene with overrides.
fn hash(overrides: &[&str]) -> String {
    let overrides = Overrides::parse(overrides).expect("usable overrides");
    let scene = Scene::load_with("oblique", &overrides).expect("usable");
    scene.sha256
}

#[test]
fn overrides_enter_the_hash() {
    let text = builtin::text("oblique").expect("built in");
    let digest = Sha256::digest(text.as_bytes());
    let plain: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(hash(&[]), plain);
    let (step, end, title) = ("time.step=2e-9", "time.end=1e-6", "title=\"x\"");
    assert_eq!(hash(&[step, end]), hash(&[step, end]));
    // The order, white space around the equals sign and earlier values do not matter.
    assert_eq!(hash(&[end, step]), hash(&[step, end]));
    assert_eq!(hash(&["time.step = 2e-9", end]), hash(&[step, end]));
    assert_eq!(hash(&["time.step=3e-9", end, step]), hash(&[step, end]));
    let all: [&[&str]; 7] = [
        &[],
        &[step],
        &[end],
        &[title],
        &[step, end],
        &["time.step=3e-9"],
        // Even if the value equals that of the file.
        &["time.step=1e-9"],
    ];
    let hashes: Vec<String> = all.iter().map(|overrides| hash(overrides)).collect();
    for (i, one) in hashes.iter().enumerate() {
        assert!(!hashes[..i].contains(one), "{:?}", all[i]);
    }
}

#[test]
fn the_summary_has_the_hash() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let output = run_with("oblique", &[SHORT], &out, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    let summary = std::fs::read_to_string(out.join("summary.json")).expect("a summary");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    assert_eq!(summary["scene_sha256"], hash(&[SHORT]));
}

#[test]
fn the_last_of_several_overrides_wins() {
    let scene = |overrides: &[&str]| {
        let overrides = Overrides::parse(overrides).expect("usable overrides");
        Scene::load_with("oblique", &overrides).expect("usable")
    };
    assert_eq!(scene(&["time.step=2e-9", "time.step=3e-9"]).step, 3e-9);
    assert_eq!(scene(&["time.step=3e-9", "time.step=2e-9"]).step, 2e-9);
    // An invalid value that is overridden has no effect.
    assert_eq!(scene(&["time.step=\"x\"", "time.step=2e-9"]).step, 2e-9);
    let (table, key) = (
        "time={step=4e-9, end=1e-6, integrator=\"euler\"}",
        "time.step=2e-9",
    );
    assert_eq!(scene(&[key, table]).step, 4e-9);
    assert_eq!(scene(&[table, key]).step, 2e-9);
    assert_eq!(scene(&[table, key]).end, 1e-6);
    let particle = "particles.0={position=[-2e-3, 0.0], radius=0.5e-3}";
    let radii = |overrides: &[&str]| scene(overrides).particles[0].radius;
    assert_eq!(radii(&["particles.0.radius=0.7e-3", particle]), 0.5e-3);
    assert_eq!(radii(&[particle, "particles.0.radius=0.7e-3"]), 0.7e-3);
}

#[test]
fn only_the_same_overrides_resume_a_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let half = "contact.tangential.friction=0.5";
    let output = run_with("oblique", &[SHORT, half], &out, &[]);
    assert!(output.status.success(), "{}", stderr(&output));
    let finished = results_in(&out);
    // Without a summary the run counts as interrupted after its last checkpoint.
    let stop = || std::fs::remove_file(out.join("summary.json")).expect("a summary");
    stop();
    for other in [
        "contact.tangential.friction=0.6",
        "particles.0.radius=1.01e-3",
    ] {
        let output = run_with("oblique", &[SHORT, other], &out, &["--resume"]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("belongs to another scene"), "{said}");
    }
    let output = run_with("oblique", &[half, SHORT], &out, &["--resume"]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(results_in(&out) == finished);
}

#[test]
fn the_model_may_be_named() {
    let named = format!("model = \"dem\"\n{}", edited("oblique", &[]));
    let scene = Scene::parse("scene.toml", named.as_bytes(), Path::new("."));
    assert_eq!(
        scene.expect("usable").particles,
        Scene::load("oblique").expect("usable").particles
    );
}
