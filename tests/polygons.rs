//! Scenes of contact dynamics: what their commands write, and that a run which was stopped ends with the same bits.

use crate::program::{gouge, run, stderr, stdout, write_scene};
use gouge_runner::any_scene::AnyScene;
use gouge_runner::contact_dynamics::Means;
use gouge_runner::run::{Event, Observer, RunOptions};
use gouge_runner::scene::Overrides;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

const FILES: [&str; 7] = [
    "series.csv",
    "network.csv",
    "particles.csv",
    "contacts.csv",
    "picture.svg",
    "trajectory/frame_000003.vtk",
    "trajectory/animation.bin",
];

const OPTIONS: RunOptions = RunOptions {
    resume: false,
    overwrite: false,
    data_only: false,
    checkpoint_interval: 0.0,
};

/// Forty pentagons for a short time, with everything that a run can write.
fn packing() -> AnyScene {
    let keys = [
        "setup.particles=40",
        "setup.sides=5",
        "setup.compaction.window=150",
        "box.width=9.0",
        "time.end=20.0",
        "output.interval=4.0",
        "output.trajectory=\"vtk\"",
    ];
    let overrides = Overrides::parse(&keys).expect("overrides");
    AnyScene::load_with("sheared-polygons", &overrides).expect("a scene")
}

fn summary(folder: &Path) -> Value {
    let text = fs::read_to_string(folder.join("summary.json")).expect("a summary");
    serde_json::from_str(&text).expect("JSON")
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

#[test]
fn a_stopped_run_ends_with_the_same_bits() {
    let (whole, parts) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let scene = packing();
    scene
        .run(whole.path(), OPTIONS, &mut |_: Event<'_>| {})
        .unwrap();
    let mut stops = 0;
    let mut options = OPTIONS;
    // The chunks grow, so that runs stop in the compaction, right after it and between samples.
    while scene
        .run(parts.path(), options, &mut Stop(1 + stops))
        .is_err()
    {
        options.resume = true;
        stops += 1;
        assert!(stops < 100);
    }
    assert!(stops > 3, "{stops}");
    for name in FILES {
        let [one, other] =
            [&whole, &parts].map(|folder| fs::read(folder.path().join(name)).unwrap());
        assert!(one == other, "{name} differs");
    }
    // A finished run is not run again, and another scene does not take its place.
    scene
        .run(parts.path(), options, &mut |_: Event<'_>| {})
        .unwrap();
    let overrides = Overrides::parse(&["contact.friction=0.3"]).unwrap();
    let other = AnyScene::load_with("sheared-polygons", &overrides).unwrap();
    assert!(
        other
            .run(parts.path(), OPTIONS, &mut |_: Event<'_>| {})
            .is_err()
    );
}

#[test]
fn a_killed_run_ends_with_the_same_bits() {
    let folder = tempfile::tempdir().unwrap();
    let start = |out: &str| {
        let mut program = gouge();
        program.args([
            "run",
            "sheared-polygons",
            "--quiet",
            "--checkpoint-interval",
            "0",
            "--out",
        ]);
        program.arg(folder.path().join(out));
        for key in [
            "setup.particles=40",
            "box.width=9.0",
            "time.end=10.0",
            "setup.compaction.window=150",
        ] {
            program.args(["--set", key]);
        }
        program.stderr(Stdio::null());
        program
    };
    assert!(start("whole").status().unwrap().success());
    let mut killed = start("parts").spawn().unwrap();
    std::thread::sleep(Duration::from_millis(400));
    let _ = killed.kill();
    let _ = killed.wait();
    assert!(start("parts").arg("--resume").status().unwrap().success());
    for name in ["series.csv", "network.csv", "particles.csv", "contacts.csv"] {
        let read = |out: &str| fs::read(folder.path().join(out).join(name)).unwrap();
        assert!(read("whole") == read("parts"), "{name} differs");
    }
}

/// The stress on the roof, the balance of energy and the means over the network of a short run.
#[test]
fn a_sheared_packing_bears_its_load_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    packing()
        .run(folder.path(), OPTIONS, &mut |_: Event<'_>| {})
        .unwrap();
    let summary = summary(folder.path());
    assert_eq!(summary["status"], "done");
    assert!(summary["balance_error"].as_f64().unwrap() < 1e-12);
    let energy = |name: &str| summary["energy"][name].as_f64().unwrap();
    assert!(energy("driving") > 0.0 && energy("friction") < 0.0 && energy("correction") >= 0.0);
    let means = Means::between(folder.path(), 10.0, 20.0).unwrap();
    let mean = |name: &str| means.get(name).unwrap();
    assert!(
        (mean("stress_ratio") - mean("stress_ratio_sv") - mean("stress_ratio_ss")).abs() < 1e-12
    );
    assert!((mean("side_side") + mean("side_vertex") - 1.0).abs() < 1e-12);
    assert!((0.7..0.9).contains(&mean("solid_fraction_cell")));
    // The load on the roof is 1. It passes from centre to centre of the glued bodies, about one diameter less than the
    // height of five.
    let stress = means.cell.stress();
    assert!((0.6..1.05).contains(&stress.yy), "{stress:?}");
    assert!(Means::between(folder.path(), 20.0, 30.0).is_none());
    assert_eq!(
        summary["network"]["coordination"].as_f64().unwrap(),
        mean("coordination")
    );
}

/// A square on an incline of slope 0.4 rad slides with g (sin - mu cos), as its series shows.
#[test]
fn a_square_slides_down_an_incline() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let output = run(&["run", "square-on-incline", "--out", out.to_str().unwrap()]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = fs::read_to_string(out.join("particles.csv")).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap();
    assert!(header.starts_with("id,x,y,vx,vy,angle,angular_velocity,radius,role"));
    let cells: Vec<&str> = lines.next().unwrap().split(',').collect();
    let acceleration = 9.81 * (0.4f64.sin() - 0.4 * 0.4f64.cos());
    let vx: f64 = cells[3].parse().unwrap();
    assert!((vx + acceleration).abs() < 1e-9, "{vx}");
    let still = folder.path().join("still");
    let set = [
        "--set",
        "contact.friction=0.43",
        "--out",
        still.to_str().unwrap(),
    ];
    let output = run(&[&["run", "square-on-incline"], &set[..]].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    let kinetic = summary(&still)["energy"]["kinetic"].as_f64().unwrap();
    assert!(kinetic < 1e-20, "{kinetic}");
}

#[test]
fn links_prints_the_contact_points_of_the_first_step() {
    let output = run(&[
        "links",
        "square-on-incline",
        "--set",
        "contact.friction=0.5",
    ]);
    assert!(output.status.success(), "{}", stderr(&output));
    let text = stdout(&output);
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| {
            line.split(',')
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect()
        })
        .collect();
    assert_eq!(rows.len(), 2);
    let [normal, tangential] = [8, 9].map(|k| rows.iter().map(|row| row[k]).sum::<f64>());
    assert!((normal - 9.81 * 0.4f64.cos()).abs() < 1e-9);
    // The residual of 1e-12 m/s is 1e-9 N over a step of 1 ms.
    assert!((tangential.abs() - 9.81 * 0.4f64.sin()).abs() < 1e-8);
    // The wall is counted after the body.
    assert!(rows.iter().all(|row| row[0] == 1.0 && row[1] == 0.0));
    assert!((rows[0][10] - rows[0][8] * 1e-3).abs() < 1e-15);
}

#[test]
fn stability_says_what_applies() {
    let output = run(&["stability", "square-on-incline"]);
    let json: Value = serde_json::from_str(&stdout(&output)).unwrap();
    assert!(json["smallest_bound"].is_null() && json["satisfied"] == true);
    let limit = json["friction_below_which_every_point_has_one_solution"]
        .as_f64()
        .unwrap();
    // 2 sqrt(j (1 + j)) with j = 1/3 for a square.
    assert!((limit - 4.0 / 3.0).abs() < 1e-12);
    let output = run(&["compare", "square-on-incline", "x.csv"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("needs a scene with model = \"dem\""));
}

#[test]
fn sweeps_observe_networks() {
    let folder = tempfile::tempdir().unwrap();
    let sweep = "scene = \"sheared-polygons\"\n\
        set = [\"setup.particles=40\", \"box.width=9.0\", \"time.end=8.0\", \"setup.compaction.window=150\"]\n\
        [[axis]]\nkey = \"contact.friction\"\nvalues = [0.0, 0.5]\n\
        [[observe]]\nnetwork = \"stress_ratio\"\nafter = 4.0\n\
        [[observe]]\ncolumn = \"height\"\nstatistic = \"mean\"\n";
    let file = folder.path().join("sweep.toml");
    fs::write(&file, sweep).unwrap();
    let out = folder.path().join("out");
    let arguments = [
        "sweep",
        file.to_str().unwrap(),
        "--out",
        out.to_str().unwrap(),
        "--quiet",
    ];
    let output = run(&arguments);
    assert!(output.status.success(), "{}", stderr(&output));
    let table = fs::read_to_string(out.join("runs.csv")).unwrap();
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let header = reader.headers().unwrap().clone();
    let place = header
        .iter()
        .position(|name| name == "stress_ratio")
        .unwrap();
    let ratios: Vec<f64> = reader
        .records()
        .map(|row| row.unwrap()[place].parse().unwrap())
        .collect();
    assert!(ratios[0] < ratios[1] && ratios[0] > 0.0, "{ratios:?}");
    fs::write(&file, sweep.replace("stress_ratio", "stress")).unwrap();
    let said = stderr(&run(&arguments));
    assert!(said.contains("sweep.toml:7: observe.network"), "{said}");
}

/// A scene that lists the bodies of another run goes on with its packing.
#[test]
fn the_final_bodies_can_be_read_back() {
    let folder = tempfile::tempdir().unwrap();
    packing()
        .run(folder.path(), OPTIONS, &mut |_: Event<'_>| {})
        .unwrap();
    let text = "model = \"contact-dynamics\"\nparticles_file = \"particles.csv\"\n\
        [time]\nstep = 0.05\nend = 0.5\n[box]\nwidth = 9.0\nboundary = \"periodic-x\"\n\
        [material]\ndensity = 1.0\n[contact]\nfriction = 0.4\n\
        [cell]\nheight = 6.0\nroof_mass = 3.0\n";
    let path = write_scene(folder.path(), text);
    let output = run(&["links", path.to_str().unwrap()]);
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(stdout(&output).lines().count() > 40);
}
