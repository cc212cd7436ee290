//! The command `gouge calibrate`.

use crate::program::{gouge, run, stderr, stdout};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Two grains that collide, with few points.
pub const STUDY: &str = r#"
[[parameter]]
key = "contact.normal.damping"
range = [0.05, 20.0]

[[test]]
name = "rebound"
scene = "head-on"
set = ["time.step=1e-8", "time.end=12e-6"]
[[test.observe]]
quantity = "restitution"

[[target]]
quantity = "restitution"
value = 0.83
sd = 0.06
source = "Durda et al. 2011"
verified = true

[design]
points = 8
waves = 2
predictive = 2
"#;

/// A folder with a calibration.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new(text: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("study.toml"), text).expect("a file");
        Self(folder)
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn arguments(&self, out: &str, options: &[&str]) -> Vec<String> {
        let text = |path: PathBuf| path.to_str().expect("UTF-8").to_owned();
        let places = ["calibrate".to_owned(), text(self.path("study.toml"))];
        let out = [
            "--quiet".to_owned(),
            "--out".to_owned(),
            text(self.path(out)),
        ];
        let options = options.iter().map(|&option| option.to_owned());
        places.into_iter().chain(out).chain(options).collect()
    }

    /// Status, standard output and standard error.
    pub fn calibrate(&self, out: &str, options: &[&str]) -> (Option<i32>, String, String) {
        let arguments = self.arguments(out, options);
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let output = run(&arguments);
        (output.status.code(), stdout(&output), stderr(&output))
    }
}

/// The tables of a calibration, without what clocks measured.
fn tables(out: &Path) -> Option<[String; 3]> {
    let read = |name: &str| fs::read_to_string(out.join(name)).ok();
    let runs = read("runs.csv")?;
    let untimed = runs
        .lines()
        .map(|line| line.rsplit_once(',').expect("a row").0);
    let untimed: Vec<&str> = untimed.collect();
    Some([
        read("posterior.csv")?,
        read("material.toml")?,
        untimed.join("\n"),
    ])
}

#[test]
fn the_damping_of_granite_is_that_of_its_restitution() {
    let folder = Folder::new("");
    let out = folder.path("out");
    let out = out.to_str().expect("UTF-8");
    let output = run(&["calibrate", "rebound", "--quiet", "--out", out]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let said = stdout(&output);
    assert!(said.contains("answer          determined"), "{said}");
    let numbers = |start: &str| -> Vec<f64> {
        let line = said
            .lines()
            .find(|line| line.contains(start))
            .expect("a line");
        line.split_whitespace()
            .filter_map(|word| word.parse().ok())
            .collect()
    };
    // The damping ratios of restitutions of .83, .89 and .77, solved with mpmath from
    // e = exp(-2 z arccos(z) / sqrt(1 - z^2)), times 2 sqrt(k m).
    assert!(
        (numbers("damping  ")[0] / 0.9267 - 1.0).abs() < 2e-3,
        "{said}"
    );
    let profile = numbers("by the profile");
    for (found, expected) in profile.iter().zip(PROFILE) {
        assert!((found / expected - 1.0).abs() < 5e-3, "{said}");
    }
}

/// Dampings at restitutions one standard deviation above and below the measured one, in kg/s.
const PROFILE: [f64; 2] = [0.571_30, 1.320_28];

#[test]
fn bits_depend_neither_on_jobs_nor_on_kills() {
    let folder = Folder::new(STUDY);
    assert_eq!(folder.calibrate("one", &["--jobs", "1"]).0, Some(0));
    assert_eq!(folder.calibrate("two", &["--jobs", "2"]).0, Some(0));
    for patience in [10, 40, 80] {
        let arguments = folder.arguments("killed", &[]);
        let mut child = gouge().args(arguments).spawn().expect("starts");
        std::thread::sleep(Duration::from_millis(patience));
        child.kill().expect("ours");
        child.wait().expect("ours");
    }
    let expected = tables(&folder.path("one")).expect("done");
    assert!(tables(&folder.path("two")) == Some(expected.clone()));
    let began = Instant::now();
    // A run of a killed calibration may still be going on.
    while folder.calibrate("killed", &[]).0 != Some(0) {
        assert!(began.elapsed() < Duration::from_secs(60));
    }
    assert!(tables(&folder.path("killed")) == Some(expected));
}

#[test]
fn the_material_pastes_into_a_scene_and_its_command_runs() {
    let folder = Folder::new(STUDY);
    assert_eq!(folder.calibrate("out", &[]).0, Some(0));
    let material = fs::read_to_string(folder.path("out/material.toml")).expect("a material");
    let table: toml::Table = material.parse().expect("TOML");
    let damping = table["contact"]["normal"]["damping"]
        .as_float()
        .expect("a number");
    assert!((damping / 0.927 - 1.0).abs() < 0.05, "{material}");
    let line = material
        .lines()
        .find(|line| line.starts_with("# gouge run"));
    let line = line.expect("a command").trim_start_matches("# gouge ");
    let arguments: Vec<String> = line
        .split(' ')
        .map(|word| match word {
            "DIR" => folder.path("run").to_str().expect("UTF-8").to_owned(),
            word => word.trim_matches('\'').to_owned(),
        })
        .collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    assert_eq!(run(&arguments).status.code(), Some(0), "{line}");
    let energies = fs::read_to_string(folder.path("run/series.csv")).expect("a series");
    let kinetic: Vec<f64> = energies
        .lines()
        .skip(1)
        .map(|row| {
            row.split(',')
                .nth(1)
                .and_then(|cell| cell.parse().ok())
                .expect("a number")
        })
        .collect();
    let restitution = (kinetic[kinetic.len() - 1] / kinetic[0]).sqrt();
    assert!((restitution - 0.83).abs() < 0.005, "{restitution}");
}

#[test]
fn a_combination_is_told_where_only_it_is_determined() {
    let second = "[[parameter]]\nkey = \"contact.normal.stiffness\"\nrange = [3e6, 3e7]\n";
    let text = second.to_owned() + &STUDY.replace("points = 8", "points = 16");
    let folder = Folder::new(&text.replace("12e-6", "30e-6"));
    let (status, said, errors) = folder.calibrate("out", &[]);
    assert_eq!(status, Some(0), "{errors}");
    // Restitution depends on damping / (2 sqrt(stiffness mass)) alone.
    let answer = said
        .lines()
        .find(|line| line.starts_with("answer"))
        .expect("an answer");
    assert!(
        answer.contains("only this is determined: stiffness^-0."),
        "{answer}"
    );
    let exponent = answer
        .split("^-")
        .nth(1)
        .and_then(|rest| rest.split(' ').next());
    let exponent: f64 = exponent
        .and_then(|word| word.parse().ok())
        .expect("a number");
    assert!(
        (exponent - 0.5).abs() < 0.03 && answer.ends_with(" damping"),
        "{answer}"
    );
    assert!(said.contains("not bounded in its range"), "{said}");
}

#[test]
fn a_target_out_of_reach_refutes_the_model() {
    let folder = Folder::new(STUDY);
    assert_eq!(folder.calibrate("out", &[]).0, Some(0));
    let text = STUDY.replace("value = 0.83\nsd = 0.06", "value = 0.05\nsd = 0.005");
    fs::write(folder.path("study.toml"), text).expect("a file");
    let (status, said, errors) = folder.calibrate("out", &[]);
    assert_eq!(status, Some(1), "{errors}");
    assert!(
        said.contains("refuted: restitution = 0.05: the model attains"),
        "{said}"
    );
    // No parameters, not even those of an earlier answer.
    assert!(
        !said.contains("best  ") || !said.contains("90 %  "),
        "{said}"
    );
    assert!(!folder.path("out/material.toml").exists());
}

#[test]
fn failed_runs_are_counted_and_name_their_causes() {
    // Too short for the strongest dampings: there the grains still touch.
    let folder = Folder::new(&STUDY.replace("12e-6", "4e-6"));
    let (status, said, errors) = folder.calibrate("out", &[]);
    assert_eq!(status, Some(0), "{errors}");
    let rows = csv::Reader::from_path(folder.path("out/runs.csv")).expect("a table");
    let rows: Vec<BTreeMap<String, String>> = rows
        .into_deserialize()
        .map(|row| row.expect("a row"))
        .collect();
    let number = |row: &BTreeMap<String, String>| row["damping"].parse::<f64>().expect("a number");
    let (failed, fine): (Vec<_>, Vec<_>) = rows.iter().partition(|row| !row["cause"].is_empty());
    assert!(!failed.is_empty() && !fine.is_empty());
    assert!(
        failed
            .iter()
            .all(|row| row["cause"].contains("still touch") && number(row) > 5.0)
    );
    assert!(said.contains(&format!("{} failed", failed.len())), "{said}");
    // The ranges are even in the logarithm, and all dampings above some value between 5 and 20 kg/s fail.
    let answer = said.lines().find(|line| line.starts_with("answer"));
    let share = answer.and_then(|line| line.split("; about ").nth(1));
    let share = share
        .and_then(|rest| rest.split(' ').next())
        .expect("a share");
    let share: f64 = share.parse().expect("a number");
    let of = |row: &&BTreeMap<String, String>| (number(row) / 0.05).ln() / 400_f64.ln();
    let least = failed.iter().map(of).fold(1.0, f64::min);
    let most = fine.iter().map(of).fold(0.0, f64::max);
    let expected = 100.0 * (1.0 - 0.5 * (least + most));
    assert!((share - expected).abs() < 2.0, "{share} {expected}");
    let page = fs::read_to_string(folder.path("out/calibration.html")).expect("a page");
    assert!(page.contains("of the ranges could not be run"));
}

#[test]
fn no_two_points_share_a_packing() {
    let study = r#"
[[parameter]]
key = "contact.tangential.friction"
range = [0.1, 1.0]
[[test]]
name = "pile"
scene = "pile"
seeds = "3..5"
set = ["time.end=2e-5", "output={}"]
[[test.observe]]
quantity = "repose-angle"
[[target]]
quantity = "repose-angle"
value = 1.0
sd = 1.0
source = "nobody: a test of seeds"
[design]
points = 4
waves = 2
predictive = 1
"#;
    let folder = Folder::new(study);
    let (status, said, errors) = folder.calibrate("out", &[]);
    assert_eq!(status, Some(0), "{errors}");
    // Friction does not matter before the grains touch.
    assert!(said.contains("determine nothing"), "{said}");
    let rows = csv::Reader::from_path(folder.path("out/runs.csv")).expect("a table");
    let rows = rows.into_deserialize::<BTreeMap<String, String>>();
    let seeds: Vec<String> = rows
        .map(|row| row.expect("a row")["seed"].clone())
        .collect();
    let distinct: std::collections::BTreeSet<&String> = seeds.iter().collect();
    assert_eq!((seeds.len(), distinct.len()), (18, 18), "{seeds:?}");
}

#[test]
fn built_in_calibrations_are_listed_and_recover_known_truths() {
    let output = run(&["calibrate", "--list"]);
    assert!(stdout(&output).contains("rebound  "), "{}", stdout(&output));
    // The first test has no target: it is not run.
    let other = "[[test]]\nname = \"other\"\nscene = \"head-on\"\n\
                 [[test.observe]]\nquantity = \"contact-duration\"\n\n[[test]]\nname = \"rebound\"";
    let study = STUDY
        .replace("predictive = 2", "repetitions = 60")
        .replace("[[test]]\nname = \"rebound\"", other)
        .replace("[[target]]", "[[target]]\ntest = \"rebound\"");
    let folder = Folder::new(&study);
    let (status, said, errors) = folder.calibrate("out", &["--recover"]);
    assert_eq!(status, Some(0), "{errors}");
    assert!(
        said.contains("pass") && said.contains("60 repetitions (0 more failed), 76 runs"),
        "{said}"
    );
}

#[test]
fn the_printed_file_of_a_built_in_calibration_is_one_to_copy() {
    let printed = run(&["calibrate", "rebound", "--print"]);
    assert_eq!(printed.status.code(), Some(0), "{}", stderr(&printed));
    let folder = Folder::new(&stdout(&printed));
    let (status, said, errors) = folder.calibrate("out", &[]);
    assert_eq!(status, Some(0), "{errors}");
    assert!(said.contains("answer          determined"), "{said}");
    let unknown = run(&["calibrate", "granite", "--print"]);
    assert_eq!(unknown.status.code(), Some(2));
    let said = stderr(&unknown);
    assert!(
        said.contains("granite") && said.contains("rebound-ice"),
        "{said}"
    );
}

#[test]
fn a_folder_keeps_the_results_of_one_calibration() {
    let folder = Folder::new(STUDY);
    assert_eq!(folder.calibrate("out", &[]).0, Some(0));
    let before = tables(&folder.path("out"));
    let other = STUDY.replace("contact.normal.damping", "contact.normal.stiffness");
    let other = other.replace("[0.05, 20.0]", "[3e6, 3e7]");
    fs::write(folder.path("study.toml"), &other).expect("a file");
    let (status, _, said) = folder.calibrate("out", &[]);
    assert_eq!(status, Some(2), "{said}");
    assert!(
        said.contains("out holds the results of another study"),
        "{said}"
    );
    assert!(said.contains("contact.normal.damping"), "{said}");
    assert!(before.is_some() && tables(&folder.path("out")) == before);
    // Nor are the results of a sweep replaced.
    fs::create_dir(folder.path("sweep")).expect("ours");
    fs::write(folder.path("sweep/runs.csv"), "run\n").expect("a file");
    assert_eq!(folder.calibrate("sweep", &[]).0, Some(2));
}

#[test]
fn a_title_cannot_change_the_material() {
    let title = "title = \"one\\n[contact.normal]\\ndamping = 7\"\n";
    let folder = Folder::new(&(title.to_owned() + STUDY));
    assert_eq!(folder.calibrate("out", &[]).0, Some(0));
    let material = fs::read_to_string(folder.path("out/material.toml")).expect("a material");
    assert!(
        material.starts_with("# one\\n[contact.normal]\\ndamping = 7\n"),
        "{material}"
    );
    let table: toml::Table = material.parse().expect("TOML");
    let damping = table["contact"]["normal"]["damping"].as_float();
    assert!(damping.is_some_and(|damping| damping < 2.0), "{material}");
}
