//! Scenes of peridynamic grains: what their commands write, and that a run which was stopped ends with the same bits.

use crate::program::{gouge, run, stderr, stdout, write_scene};
use gouge_runner::any_scene::AnyScene;
use gouge_runner::run::{Event, Observer, RunOptions};
use gouge_runner::scene::Overrides;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Stdio;

pub const OPTIONS: RunOptions = RunOptions {
    resume: false,
    overwrite: false,
    data_only: false,
    checkpoint_interval: 0.0,
};

const FILES: [&str; 7] = [
    "series.csv",
    "nodes.csv",
    "grains.csv",
    "breaks.csv",
    "bonds.csv",
    "picture.svg",
    "trajectory/frame_000003.vtk",
];

/// The built-in pair of grains until they break each other, with everything that a run can write.
const KEYS: [&str; 4] = [
    "time.end=6e-5",
    "output.interval=1.5e-5",
    "output.trajectory=\"vtk\"",
    "output.bonds=true",
];

pub fn pair(more: &[&str]) -> AnyScene {
    let overrides = Overrides::parse(&[&KEYS, more].concat()).expect("overrides");
    AnyScene::load_with("two-grains", &overrides).expect("a scene")
}

pub fn summary(folder: &Path) -> Value {
    let text = fs::read_to_string(folder.join("summary.json")).expect("a summary");
    serde_json::from_str(&text).expect("JSON")
}

/// The columns of a CSV file by name.
fn column(path: &Path, name: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_path(path).expect("a CSV file");
    let header = reader.headers().expect("a header").clone();
    let place = header.iter().position(|own| own == name).expect("a column");
    let rows = reader.records().map(|row| row.expect("a row"));
    rows.map(|row| row[place].parse().expect("a number"))
        .collect()
}

/// Stops at a given report of progress.
struct Stop(usize);

impl Observer for Stop {
    fn event(&mut self, event: Event<'_>) {
        if matches!(event, Event::Progress { .. }) {
            self.0 = self.0.saturating_sub(1);
        }
    }
    fn wants_stop(&self) -> bool {
        self.0 == 0
    }
}

fn same_files(folders: [&Path; 2]) {
    for name in FILES {
        let [one, other] = folders.map(|folder| fs::read(folder.join(name)).expect(name));
        assert!(one == other, "{name} differs");
    }
}

#[test]
fn a_stopped_run_ends_with_the_same_bits() {
    let (whole, parts) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let scene = pair(&[]);
    let ignore = &mut |_: Event<'_>| {};
    scene.run(whole.path(), OPTIONS, ignore).unwrap();
    // It ends earlier at first, with a sample that the longer run does not take.
    let shorter = pair(&["time.end=5e-5"]);
    let mut options = OPTIONS;
    let mut stops = 0;
    while shorter
        .run(parts.path(), options, &mut Stop(1 + 3 * stops))
        .is_err()
    {
        options.resume = true;
        stops += 1;
        assert!(stops < 100);
    }
    assert!(stops > 2, "{stops}");
    options.resume = true;
    scene.run(parts.path(), options, ignore).unwrap();
    same_files([whole.path(), parts.path()]);
    // A finished run is not run again, and another scene does not take its place.
    scene.run(parts.path(), options, ignore).unwrap();
    let other = pair(&["contact.friction=0.3"]);
    let refused = other.run(parts.path(), OPTIONS, ignore).unwrap_err();
    assert!(
        refused
            .to_string()
            .contains("contact.friction is 0.5 there and 0.3 here")
    );
}

#[test]
fn a_killed_run_ends_with_the_same_bits() {
    let folder = tempfile::tempdir().unwrap();
    let start = |out: &str| {
        let mut program = gouge();
        program.args(["run", "two-grains", "--quiet", "--checkpoint-interval", "0"]);
        program.arg("--out").arg(folder.path().join(out));
        for key in KEYS {
            program.args(["--set", key]);
        }
        program.stderr(Stdio::null());
        program
    };
    assert!(start("whole").status().unwrap().success());
    let mut killed = start("parts").spawn().unwrap();
    // After the second sample it is in the middle.
    let series = folder.path().join("parts/series.csv");
    let rows = || fs::read_to_string(&series).map_or(0, |text| text.lines().count());
    while rows() < 3 && killed.try_wait().unwrap().is_none() {
        std::thread::yield_now();
    }
    let _ = killed.kill();
    let _ = killed.wait();
    assert!(start("parts").arg("--resume").status().unwrap().success());
    same_files([&folder.path().join("whole"), &folder.path().join("parts")]);
}

#[test]
fn a_collision_keeps_its_energy_and_momentum_and_breaks_bonds() {
    let folder = tempfile::tempdir().unwrap();
    let scene = pair(&[]);
    scene
        .run(folder.path(), OPTIONS, &mut |_: Event<'_>| {})
        .unwrap();
    let summary = summary(folder.path());
    assert_eq!(summary["status"], "done");
    assert_eq!(summary["peridem"]["mode"], "corrected");
    // The error of velocity Verlet at a third of the limit.
    assert!(
        summary["balance_error"].as_f64().unwrap() < 5e-3,
        "{summary}"
    );
    let energy = |name: &str| summary["energy"][name].as_f64().unwrap();
    assert!(energy("damping") > 0.0 && energy("friction") > 0.0 && energy("breaking") > 0.0);
    let series = folder.path().join("series.csv");
    let momentum = column(&series, "momentum_x");
    let change = (momentum[0] - momentum[momentum.len() - 1]).abs();
    let scale = 20.0 * 1200.0 * 3e-6;
    assert!(change < 1e-11 * scale, "{change:e}");
    let broken = column(&series, "broken_bonds");
    let listed = column(&folder.path().join("breaks.csv"), "step");
    assert!(listed.is_sorted() && !listed.is_empty());
    assert_eq!(*broken.last().unwrap() as usize, listed.len());
    assert_eq!(summary["bonds_broken"], listed.len());
    let [area, damage] =
        ["area", "damage"].map(|name| column(&folder.path().join("nodes.csv"), name));
    let softened = area
        .iter()
        .zip(&damage)
        .filter(|(_, damage)| **damage > 0.0);
    let softened: f64 = softened.map(|(area, _)| area).sum();
    let last = *column(&series, "softened_area").last().unwrap();
    assert!((softened - last).abs() < 1e-12 * last);
    for name in ["run.html", "picture.svg"] {
        let text = fs::read_to_string(folder.path().join(name)).unwrap();
        assert!(text.contains("corrected"), "{name}");
        assert!(text.len() < 2_000_000, "{name}: {}", text.len());
    }
}

#[test]
fn frames_hold_nodes_and_whole_triangles() {
    let folder = tempfile::tempdir().unwrap();
    let ignore = &mut |_: Event<'_>| {};
    let out = |name: &str| folder.path().join(name);
    pair(&[]).run(&out("vtk"), OPTIONS, ignore).unwrap();
    let triangles = |sample: usize| {
        let path = out("vtk").join(format!("trajectory/frame_{sample:06}.vtk"));
        let text = fs::read_to_string(path).unwrap();
        for part in [
            "VECTORS displacement",
            "VECTORS velocity",
            "SCALARS damage",
            "SCALARS grain",
        ] {
            assert!(text.contains(part), "{part}");
        }
        assert!(text.contains("s, mode = \"corrected\""));
        let (_, rest) = text.split_once("POLYGONS ").unwrap();
        let number = rest.split(' ').next().unwrap();
        number.parse::<usize>().unwrap()
    };
    assert!(triangles(0) > triangles(4) && triangles(4) > 50);
    // Bonds are four times as stiff in this mode.
    let keys = [
        "output.trajectory=\"extxyz\"",
        "mode=\"authors\"",
        "time.step=2e-8",
        "time.end=1e-6",
    ];
    pair(&keys).run(&out("xyz"), OPTIONS, ignore).unwrap();
    let text = fs::read_to_string(out("xyz").join("trajectory/frame_000000.xyz")).unwrap();
    let mut lines = text.lines();
    let number: usize = lines.next().unwrap().parse().unwrap();
    let head = lines.next().unwrap();
    let columns = "displacement:R:3:velo:R:3:radius:R:1:damage:R:1:grain:I:1";
    assert!(
        head.contains(columns) && head.contains("mode=\"authors\""),
        "{head}"
    );
    assert_eq!(lines.count(), number);
}

#[test]
fn commands_state_limits_links_and_mode() {
    let output = run(&["stability", "two-grains", "--set", "mode=\"paper\""]);
    let json: Value = serde_json::from_str(&stdout(&output)).unwrap();
    assert_eq!(json["mode"], "paper");
    assert_eq!(json["satisfied"], true);
    let step = |place: usize| json["bounds"][place]["step"].as_f64().unwrap();
    // Row sums are between one and two times too small.
    assert!((1.0..2.0).contains(&(step(0) / step(1))), "{json}");
    assert!(json["bounds"][4]["step"].is_null());
    let output = run(&[
        "links",
        "two-grains",
        "--set",
        "grains.0.position=[-0.9e-3, 0.0]",
    ]);
    let text = stdout(&output);
    let kinds = |kind: &str| text.lines().filter(|line| line.contains(kind)).count();
    assert!(kinds(",bond,") > 1000 && kinds(",contact,") > 0);
    let forces = text.lines().filter(|line| line.contains(",contact,"));
    let force = |line: &str| line.split(',').nth(7).unwrap().parse::<f64>().unwrap();
    assert!(forces.map(force).all(|force| force < 0.0));
}

/// A grain between walls, one of which is moving: the forces, the share of the container, and a grain that is too fast.
pub const WALLED: &str = "model = \"peridem\"\n[time]\nstep = 5e-8\nend = 2e-5\n\
    [materials.a]\nyoung_modulus = 1e9\ndensity = 1200.0\n\
    [bonds]\nhorizon = 6.1e-4\nbreaking = \"none\"\n[mesh]\nkind = \"cells\"\nsize = 2e-4\n\
    [contact]\nradius = 3e-4\n\
    [walls]\nleft = -1.25e-3\nright = 1.25e-3\nbottom = -1.25e-3\ntop = 1.25e-3\nvelocity = { top = -5.0 }\n\
    [[grains]]\nshape = \"rectangle\"\nsize = [2e-3, 2e-3]\n";

#[test]
fn walls_push_and_are_pushed() {
    let folder = tempfile::tempdir().unwrap();
    let scene = write_scene(folder.path(), WALLED);
    let out = folder.path().join("out");
    let arguments = [
        "run",
        scene.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
    ];
    let output = run(&arguments);
    assert!(output.status.success(), "{}", stderr(&output));
    let series = out.join("series.csv");
    let share = column(&series, "solid_fraction");
    assert!((share[0] - 0.64).abs() < 1e-12 && share[200] > share[0]);
    let [top, left] = ["top_force_y", "left_force_x"].map(|name| column(&series, name));
    assert!(top[200] > 0.0 && left[200] <= 0.0);
    let work = *column(&series, "wall_work").last().unwrap();
    let residual = *column(&series, "residual").last().unwrap();
    assert!(
        work > 0.0 && residual.abs() < 2e-3 * work,
        "{work:e} {residual:e}"
    );
    let damped = ["--overwrite", "--set", "contact.damping_ratio=0.5"];
    let output = run(&[&arguments[..], &damped].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let [work, residual] =
        ["wall_work", "residual"].map(|name| *column(&series, name).last().unwrap());
    assert!(
        work > 0.0 && residual.abs() < 1e-2 * work,
        "{work:e} {residual:e}"
    );
    let fast = ["--overwrite", "--set", "grains.0.velocity=[0.0, 2900.0]"];
    let output = run(&[&arguments[..], &fast].concat());
    assert_eq!(output.status.code(), Some(1));
    assert!(
        stderr(&output).contains("behind the top wall"),
        "{}",
        stderr(&output)
    );
}

/// The last sample is early, and a run that was stopped before its summary takes it again.
#[test]
fn forces_on_walls_are_saved() {
    let folder = tempfile::tempdir().unwrap();
    let scene = write_scene(folder.path(), WALLED);
    let keys = [
        "time.end=2e-6",
        "output.interval=1.5e-6",
        "grains.0.position=[0.0, 1e-4]",
    ];
    let overrides = Overrides::parse(&keys).unwrap();
    let scene = AnyScene::load_with(scene.to_str().unwrap(), &overrides).unwrap();
    let (out, ignore) = (folder.path().join("out"), &mut |_: Event<'_>| {});
    scene.run(&out, OPTIONS, ignore).unwrap();
    let series = || fs::read_to_string(out.join("series.csv")).unwrap();
    let before = series();
    assert!(column(&out.join("series.csv"), "top_force_y")[2] > 0.0);
    fs::remove_file(out.join("summary.json")).unwrap();
    let resumed = RunOptions {
        resume: true,
        ..OPTIONS
    };
    scene.run(&out, resumed, ignore).unwrap();
    assert_eq!(series(), before);
}

#[test]
fn clamped_nodes_stay_and_loads_pull() {
    let folder = tempfile::tempdir().unwrap();
    let text = WALLED.replace("[walls]", "[unused]");
    let (before, rest) = text.split_once("[unused]").unwrap();
    let (_, grains) = rest.split_once("[[grains]]").unwrap();
    let grain = "clamped = [[-1.0, -1.0, 1.0, -8e-4]]\nloads = [{ box = [-1.0, 8e-4, 1.0, 1.0], force = [0.0, 10.0] }]\n";
    let scene = write_scene(folder.path(), &format!("{before}[[grains]]{grains}{grain}"));
    let out = folder.path().join("out");
    let output = run(&[
        "run",
        scene.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
    ]);
    assert!(output.status.success(), "{}", stderr(&output));
    let [y, uy] = ["y", "uy"].map(|name| column(&out.join("nodes.csv"), name));
    let lowest: Vec<f64> = y
        .iter()
        .zip(&uy)
        .filter(|(y, _)| **y < -8e-4)
        .map(|(_, u)| *u)
        .collect();
    assert!(lowest.len() == 10 && lowest.iter().all(|u| *u == 0.0));
    assert!(uy.iter().fold(0.0, |most: f64, u| most.max(*u)) > 1e-9);
    let clamp = text.replace("[unused]", "[walls]") + "clamped = [[1.0, 1.0, 2.0, 2.0]]\n";
    let scene = write_scene(folder.path(), &clamp);
    let said = stderr(&run(&["links", scene.to_str().unwrap()]));
    assert!(
        said.contains(
            "grains[0].clamped = [[array of 4]]: no node of the grain is in one of the boxes"
        ),
        "{said}"
    );
}

#[test]
fn sweeps_observe_the_series_of_grains() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = "scene = \"two-grains\"\nset = [\"time.end=5e-5\"]\n\
        [[axis]]\nkey = \"materials.glass.fracture_energy\"\nvalues = [60.0, 1000.0]\n\
        [[observe]]\ncolumn = \"broken_bonds\"\nstatistic = \"last\"\n\
        [[observe]]\ncolumn = \"pieces\"\nstatistic = \"last\"\n";
    let file = folder.path().join("sweep.toml");
    fs::write(&file, sweep).unwrap();
    let out = folder.path().join("out");
    let [file_text, out_text] = [&file, &out].map(|path| path.to_str().unwrap());
    let output = run(&["sweep", file_text, "--out", out_text, "--quiet"]);
    assert!(output.status.success(), "{}", stderr(&output));
    let broken = column(&out.join("runs.csv"), "broken_bonds_last");
    assert!(broken[0] > broken[1], "{broken:?}");
}

#[test]
fn a_run_whose_interval_follows_from_its_end_can_be_extended() {
    let load = |end: &str| {
        let overrides = Overrides::parse(&[end, "output.energy=false"]).expect("overrides");
        AnyScene::load_with("two-grains", &overrides).expect("a scene")
    };
    let (folder, ignore) = (tempfile::tempdir().unwrap(), &mut |_: Event<'_>| {});
    let path = folder.path();
    let first = load("time.end=1e-6");
    first.run(path, OPTIONS, ignore).unwrap();
    let times = column(&path.join("series.csv"), "time");
    let resumed = RunOptions {
        resume: true,
        ..OPTIONS
    };
    load("time.end=2e-6").run(path, resumed, ignore).unwrap();
    let extended = column(&path.join("series.csv"), "time");
    assert_eq!(extended[..times.len()], times[..]);
    assert_eq!(extended.last(), Some(&2e-6));
}
