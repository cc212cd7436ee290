//! `gouge sweep`: many runs of one scene.

use crate::program::{gouge, run, stderr, stdout};
use gouge_studies::words::duration;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// A folder with a sweep over two steps and three dampings of two grains that collide, one of them refused.
pub struct Folder(tempfile::TempDir);

const SWEEP: &str = r#"
scene = "head-on"

[[axis]]
key = "time.step"
values = [1e-8, 2e-8]
unit = "s"

[[axis]]
key = "contact.normal.damping"
times = 10.0
values = [0.0, 0.1, -1.0]
labels = ["elastic", "damped", "nonsense"]

[[observe]]
column = "kinetic"
statistic = "last"
unit = "J"

[[observe]]
name = "most"
column = "contact"
statistic = "maximum"
after = 1e-6
"#;

impl Folder {
    pub fn new(sweep: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("sweep.toml"), sweep).expect("a file");
        Self(folder)
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn arguments(&self, out: &str, options: &[&str]) -> Vec<String> {
        let text = |path: PathBuf| path.to_str().expect("UTF-8").to_owned();
        let files = [
            text(self.path("sweep.toml")),
            "--out".to_owned(),
            text(self.path(out)),
        ];
        let options = options.iter().map(|&option| option.to_owned());
        ["sweep".to_owned()]
            .into_iter()
            .chain(options)
            .chain(files)
            .collect()
    }

    /// Status, standard output and standard error of a sweep.
    pub fn sweep(&self, out: &str, options: &[&str]) -> (Option<i32>, String, String) {
        let arguments = self.arguments(out, options);
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let output = run(&arguments);
        (output.status.code(), stdout(&output), stderr(&output))
    }

    /// The rows of the table by the names of their columns.
    pub fn rows(&self, out: &str) -> Vec<BTreeMap<String, String>> {
        let reader = csv::Reader::from_path(self.path(out).join("runs.csv"));
        let rows = reader.expect("a table").into_deserialize();
        rows.map(|row| row.expect("a row")).collect()
    }
}

/// The series and particles of all runs.
fn results(out: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let runs = fs::read_dir(out.join("runs")).expect("runs");
    let folders = runs.map(|entry| entry.expect("readable").path());
    let files =
        folders.flat_map(|folder| ["series.csv", "particles.csv"].map(|name| folder.join(name)));
    let read = |path: PathBuf| {
        Some((
            path.strip_prefix(out).ok()?.to_owned(),
            fs::read(&path).ok()?,
        ))
    };
    files.filter_map(read).collect()
}

#[test]
fn every_combination_is_a_row_and_failed_runs_name_their_cause() {
    let folder = Folder::new(SWEEP);
    let (status, said, errors) = folder.sweep("out", &["--jobs", "2"]);
    assert_eq!(status, Some(0), "{errors}");
    assert!(
        said.contains("done            4") && said.contains("refused         2"),
        "{said}"
    );
    let rows = folder.rows("out");
    assert_eq!(rows.len(), 6);
    let kinetic =
        |row: &BTreeMap<String, String>| row["kinetic_last"].parse::<f64>().expect("a number");
    for row in &rows {
        match row["contact.normal.damping"].as_str() {
            "nonsense" => {
                assert_eq!(row["status"], "refused");
                assert!(
                    row["cause"].contains("contact.normal.damping=-10.0"),
                    "{row:?}"
                );
                assert_eq!(row["kinetic_last"], "");
            }
            label => {
                assert_eq!(row["status"], "done");
                // The grains approach with 0.5 m/s each; only damping takes energy.
                let mass = 2700.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9;
                let share = kinetic(row) / (0.25 * mass);
                assert_eq!((share - 1.0).abs() < 1e-3, label == "elastic", "{row:?}");
                assert!(row["most"].parse::<f64>().expect("a number") > 0.0);
            }
        }
    }
}

#[test]
fn the_page_of_a_sweep_shows_how_its_runs_ended_and_what_was_observed() {
    let folder = Folder::new(SWEEP);
    let (status, _, errors) = folder.sweep("out", &[]);
    assert_eq!(status, Some(0), "{errors}");
    let page = fs::read_to_string(folder.path("out/sweep.html")).expect("a page");
    for cells in ["<td>done</td><td>4</td>", "<td>refused</td><td>2</td>"] {
        assert!(page.contains(cells), "{cells}");
    }
    // Two observations over the one axis of numbers, with a curve for each damping that has results.
    for (text, number) in [
        ("<figure>", 2),
        ("</svg> contact.normal.damping elastic", 2),
        ("</svg> contact.normal.damping nonsense", 0),
        ("time.step (10⁻⁹ s)", 2),
        ("kinetic_last (10⁻⁶ J)", 1),
    ] {
        assert_eq!(page.matches(text).count(), number, "{text}");
    }
    // Without an axis of numbers there is a table, whose means are those of all runs.
    let words = Folder::new(&SWEEP.replace(
        "values = [1e-8, 2e-8]",
        "values = [1e-8, 2e-8]\nlabels = [\"fine\", \"coarse\"]",
    ));
    assert_eq!(words.sweep("out", &[]).0, Some(0));
    let page = fs::read_to_string(words.path("out/sweep.html")).expect("a page");
    let row = words
        .rows("out")
        .into_iter()
        .find(|row| row["time.step"] == "coarse" && row["contact.normal.damping"] == "damped");
    let most: f64 = row.expect("a row")["most"].parse().expect("a number");
    assert!(page.contains(&format!(
        "<td>coarse</td><td>damped</td><td>1</td><td>{most:.4e}</td>"
    )));
}

#[test]
fn the_bits_of_a_run_depend_neither_on_jobs_nor_on_kills() {
    let folder = Folder::new(SWEEP);
    for (out, jobs) in [("one", "1"), ("two", "2")] {
        assert_eq!(folder.sweep(out, &["--jobs", jobs, "--quiet"]).0, Some(0));
    }
    let killed = folder.path("killed");
    for patience in [5, 20, 60, 150] {
        let mut child = gouge()
            .args(folder.arguments("killed", &["--quiet"]))
            .spawn()
            .expect("starts");
        std::thread::sleep(Duration::from_millis(patience));
        child.kill().expect("ours");
        child.wait().expect("ours");
    }
    // A run of a killed sweep may still be going on; it is left to its end.
    let began = Instant::now();
    while folder.sweep("killed", &["--quiet"]).0 != Some(0) || results(&killed).len() < 8 {
        assert!(began.elapsed() < Duration::from_secs(60));
    }
    let expected = results(&folder.path("one"));
    assert_eq!(expected.len(), 8);
    assert!(results(&folder.path("two")) == expected);
    assert!(results(&killed) == expected);
}

#[test]
fn a_changed_sweep_runs_only_what_is_new() {
    let folder = Folder::new(SWEEP);
    assert_eq!(folder.sweep("out", &["--quiet"]).0, Some(0));
    let times = |out: &Path| -> BTreeMap<PathBuf, std::time::SystemTime> {
        let paths = results(out).into_keys().map(|path| out.join(path));
        paths
            .map(|path| {
                (
                    path.clone(),
                    fs::metadata(path)
                        .and_then(|data| data.modified())
                        .expect("a time"),
                )
            })
            .collect()
    };
    let before = times(&folder.path("out"));
    let longer = SWEEP
        .replace("[1e-8, 2e-8]", "[2e-8, 1e-8, 4e-8]")
        .replace("times = 10.0", "times = 10");
    fs::write(folder.path("sweep.toml"), longer).expect("a file");
    let (_, said, _) = folder.sweep("out", &["--plan"]);
    assert!(
        said.contains("runs            9, of which 3 are not done yet"),
        "{said}"
    );
    assert_eq!(folder.sweep("out", &["--quiet"]).0, Some(0));
    let after = times(&folder.path("out"));
    assert_eq!(after.len(), 12);
    assert!(before.iter().all(|(path, time)| after[path] == *time));
    assert_eq!(folder.rows("out").len(), 9);
}

#[test]
fn status_retry_and_collect_read_and_change_only_files() {
    let folder = Folder::new(SWEEP);
    let (status, said, _) = folder.sweep("out", &["status"]);
    assert_eq!((status, said.as_str()), (Some(0), "waiting         6\n"));
    assert_eq!(folder.sweep("out", &["--quiet"]).0, Some(0));
    fs::remove_file(folder.path("out/runs.csv")).expect("ours");
    assert_eq!(folder.sweep("out", &["collect"]).0, Some(0));
    assert_eq!(folder.rows("out").len(), 6);
    let (_, said, _) = folder.sweep("out", &["retry"]);
    assert_eq!(said, "2 runs will be run again\n");
    let (_, said, _) = folder.sweep("out", &["status"]);
    assert_eq!(said, "waiting         2\ndone            4\n");
}

#[test]
fn keys_that_change_together_form_one_axis() {
    let folder = Folder::new(
        r#"
scene = "head-on"
set = ["time.end=1e-6"]
[[axis]]
name = "pair"
keys = ["time.step", "contact.normal.damping"]
values = [[1e-8, 0.0], [2e-8, 1.0]]
labels = ["fine", "coarse"]
[[observe]]
column = "time"
statistic = "last"
"#,
    );
    let (status, _, said) = folder.sweep("out", &[]);
    assert_eq!(status, Some(0), "{said}");
    let rows = folder.rows("out");
    let cells =
        |column: &str| -> Vec<&str> { rows.iter().map(|row| row[column].as_str()).collect() };
    assert_eq!(cells("pair"), ["fine", "coarse"]);
    assert_eq!(cells("steps"), ["100", "50"]);
    assert_eq!(cells("time_last"), ["1e-6", "1e-6"]);
}

#[test]
fn a_sweep_of_a_hundred_thousand_runs_is_handled_in_seconds() {
    let folder = Folder::new(
        r#"
scene = "head-on"
[[axis]]
key = "time.step"
values = [1e-8]
[seeds]
"particles.0.velocity.0" = "1..100001"
[[observe]]
quantity = "bonds-broken"
"#,
    );
    let (_, said, _) = folder.sweep("out", &["status"]);
    assert_eq!(said, "waiting         100000\n");
    // All runs but one are made up: links to the one that is run.
    let out = folder.path("out");
    let plan = fs::read_to_string(out.join("plan")).expect("the names of all runs");
    let names: Vec<&str> = plan.lines().skip(1).collect();
    assert_eq!(names.len(), 100_000);
    let first = out.join("runs").join(names[0]);
    let first_text = first.to_str().expect("UTF-8");
    let done = run(&[
        "run",
        "head-on",
        "--out",
        first_text,
        "-q",
        "--set",
        "time.step=1e-8",
    ]);
    assert!(done.status.success());
    for name in &names[1..] {
        std::os::unix::fs::symlink(&first, out.join("runs").join(name)).expect("a link");
    }
    for (command, most) in [("status", 10), ("collect", 30)] {
        let began = Instant::now();
        let (status, _, said) = folder.sweep("out", &[command]);
        assert_eq!(status, Some(0), "{said}");
        let took = began.elapsed();
        assert!(took < Duration::from_secs(most), "{command} took {took:?}");
    }
    assert_eq!(
        folder.sweep("out", &["status"]).1,
        "done            100000\n"
    );
    let rows = folder.rows("out");
    assert_eq!(rows.len(), 100_000);
    assert!(rows.iter().all(|row| row["bonds-broken"] == "0.0"));
}

/// Mistakes: what is replaced by what, and what the error says.
const MISTAKES: [[&str; 3]; 16] = [
    ["head-on", "no-such-scene", "no-such-scene"],
    [
        "times = 10.0",
        "time = 10.0",
        "sweep.toml:11: axis.time = 10.0: unknown key",
    ],
    [
        "\"nonsense\"]",
        "]",
        "sweep.toml:13: axis.labels = [\"elastic\", \"damped\", ]: must hold one name for each of the 3 values",
    ],
    [
        "\"nonsense\"]",
        "\"damped\"]",
        "sweep.toml:13: axis.labels = [\"elastic\", \"damped\", \"damped\"]: must be unique",
    ],
    [
        "[1e-8, 2e-8]",
        "[]",
        "sweep.toml:6: axis.values = []: must hold at least one value",
    ],
    ["[1e-8, 2e-8]", "[1e-8, 1e-8]", "are the same run"],
    ["key = \"time.step\"", "key = \"time.stop\"", "time.stop"],
    [
        "statistic = \"last\"",
        "",
        "sweep.toml:15: observe.statistic: a column needs one of mean",
    ],
    [
        "[[axis]]\nkey = \"contact.normal.damping\"",
        "[[axis]]\nname = \"time.step\"\nkey = \"contact.normal.damping\"",
        "sweep.toml:10: axis.name = \"time.step\": must be unique",
    ],
    [
        "name = \"most\"",
        "name = \"kinetic_last\"",
        "sweep.toml:21: observe.name = \"kinetic_last\": must be unique",
    ],
    [
        "name = \"most\"",
        "name = \"steps\"",
        "sweep.toml:21: observe.name = \"steps\": must be unique",
    ],
    [
        "column = \"kinetic\"",
        "column = \"friction_load\"",
        "sweep.toml:16: observe.column = \"friction_load\": must be a column of the series: time, kinetic",
    ],
    [
        "column = \"kinetic\"\nstatistic = \"last\"",
        "quantity = \"friction\"",
        "sweep.toml:16: observe.quantity = \"friction\": needs a scene with [driving]",
    ],
    [
        "after = 1e-6",
        "after = 1.0",
        "sweep.toml:24: observe.after = 1.0: must not be above time.end",
    ],
    [
        "column = \"kinetic\"",
        "column = 7",
        "sweep.toml:16: observe.column = 7: must be a string",
    ],
    [
        "after = 1e-6",
        "after = nan",
        "sweep.toml:24: observe.after = nan: must be a finite",
    ],
];

#[test]
fn mistakes_in_a_sweep_are_named() {
    let replaced = MISTAKES.map(|[from, to, words]| {
        assert!(SWEEP.contains(from), "{from}");
        (SWEEP.replacen(from, to, 1), words)
    });
    let added = [
        (
            "[[axis]]\nkey = \"contact.normal\"\nvalues = [{}]\n",
            "must not change contact.normal.damping",
        ),
        ("[seeds]\nsetup = \"8..3\"\n", "seeds.setup"),
        ("[budget]\ncore_hours = 1e-12\n", "budget.core_hours"),
    ];
    let added = added.map(|(text, words)| (SWEEP.to_owned() + text, words));
    for (text, words) in replaced.into_iter().chain(added) {
        let folder = Folder::new(&text);
        let (status, _, said) = folder.sweep("out", &[]);
        assert_eq!(status, Some(2), "{words}: {said}");
        assert!(said.contains(words), "{words}: {said}");
        assert!(!folder.path("out/runs").exists());
    }
}

#[test]
fn durations_have_fitting_units_and_single_things_no_plural() {
    for (seconds, text) in [
        (0.012, "0.012 s"),
        (3.21, "3.2 s"),
        (90.0, "90 s"),
        (600.0, "10 min"),
        (9000.0, "2.5 h"),
    ] {
        assert_eq!(duration(seconds), text);
    }
    let folder = Folder::new(&SWEEP.replace("[1e-8, 2e-8]", "[1e-8]"));
    assert_eq!(folder.sweep("out", &["--quiet"]).0, Some(0));
    assert_eq!(
        folder.sweep("out", &["retry"]).1,
        "1 run will be run again\n"
    );
    let said = folder.sweep("out", &["--plan"]).1;
    assert!(said.contains(" s on one core)"), "{said}");
}
