//! `gouge compare`: a run against data of others.

use crate::program::{run, stderr, stdout, write_draft};
use gouge_dem::integrators::Integrator;
use gouge_validation::scenes::{Draft, Grain};
use std::path::Path;

/// Two grains that fly apart in gravity, one of them spinning.
fn flight() -> Draft {
    Draft::open_box(Integrator::VelocityVerlet, 1e-4)
        .ending_at(1e-2)
        .gravity(10.0)
        .grain(Grain::at([0.0, 0.5], 1e-3).moving([1.0, 2.0]))
        .grain(
            Grain::at([1.0, 0.0], 2e-3)
                .moving([-3.0, 0.0])
                .spinning(7.0),
        )
}

/// x, y, vx, vy and angular velocity of a grain at a time: a parabola.
fn exact(grain: usize, t: f64) -> [f64; 5] {
    let ([x, y], [vx, vy], spin) = match grain {
        0 => ([0.0, 0.5], [1.0, 2.0], 0.0),
        _ => ([1.0, 0.0], [-3.0, 0.0], 7.0),
    };
    [
        x + vx * t,
        y + vy * t - 5.0 * t * t,
        vx,
        vy - 10.0 * t,
        spin,
    ]
}

/// A LAMMPS dump of every tenth step, the second grain first.
fn dump() -> String {
    let mut text = String::new();
    for step in (0..=100).step_by(10) {
        text += &format!(
            "ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 1\n0 1\n0 1\n\
             ITEM: ATOMS id type x y z vx vy omegaz\n"
        );
        for grain in [1, 0] {
            let [x, y, vx, vy, spin] = exact(grain, f64::from(step) * 1e-4);
            text += &format!("{} 1 {x:?} {y:?} 0 {vx:?} {vy:?} {spin:?}\n", grain + 1);
        }
    }
    text
}

fn csv() -> String {
    let mut text = "time,id,name,x,vy\n".to_owned();
    for step in [100, 0, 50] {
        let t = f64::from(step) * 1e-4;
        for grain in [0, 1] {
            let [x, _, _, vy, _] = exact(grain, t);
            text += &format!("{t:?},{grain},grain,{x:?},{vy:?}\n");
        }
    }
    text
}

/// Status, standard output and standard error of a comparison with a file of the given text.
fn compared(data: &str, options: &[&str]) -> (Option<i32>, String, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &flight());
    let file = folder.path().join("data");
    std::fs::write(&file, data).expect("a file");
    let text = |path: &Path| path.to_str().expect("UTF-8").to_owned();
    let (scene, file) = (text(&scene), text(&file));
    let arguments = [&["compare", &scene, &file], options].concat();
    let output = run(&arguments);
    (output.status.code(), stdout(&output), stderr(&output))
}

#[test]
fn the_exact_flight_is_within_rounding() {
    for data in [dump(), csv()] {
        let (status, table, said) = compared(&data, &["--tolerance", "1e-12"]);
        assert_eq!(status, Some(0), "{table}{said}");
        assert!(!table.contains("OUTSIDE"), "{table}");
    }
    let (_, table, _) = compared(&dump(), &[]);
    for words in [
        "angular_velocity",
        "times compared: 11",
        "not compared: type, z",
    ] {
        assert!(table.contains(words), "{table}");
    }
}

#[test]
fn a_difference_is_found_where_it_is() {
    // At 5 ms the first grain has x = 5 mm; a thousandth of the range, which is 1 m, is added.
    let wrong = dump().replace("1 1 0.005 ", "1 1 0.006 ");
    assert_ne!(wrong, dump());
    let (status, table, said) = compared(&wrong, &[]);
    assert_eq!(status, Some(1), "{table}");
    assert!(said.contains("differ by more than the tolerance"), "{said}");
    let line = table
        .lines()
        .find(|line| line.contains("OUTSIDE"))
        .expect("a line");
    let cells: Vec<&str> = line.split_whitespace().collect();
    assert_eq!(cells[0], "x");
    let number = |cell: &str| cell.parse::<f64>().expect("a number");
    assert!((number(cells[1]) - 1e-3).abs() < 1e-6, "{line}");
    assert!((number(cells[5]) - 5e-3).abs() < 1e-9, "{line}");
    assert_eq!(cells[6], "0", "the particle: {line}");
    assert_eq!(table.matches("OUTSIDE").count(), 1, "{table}");
    for options in [
        &["--tolerance", "x=0.01"][..],
        &["--tolerance", "0.01"],
        &["--columns", "y,vx"],
    ] {
        assert_eq!(compared(&wrong, options).0, Some(0), "{options:?}");
    }
    let (status, ..) = compared(
        &dump().replace("1 1 0.005 ", "1 1 nan "),
        &["--tolerance", "1e9"],
    );
    assert_eq!(status, Some(1), "a value that is not a number never agrees");
}

#[test]
fn a_column_that_is_zero_up_to_rounding_needs_an_absolute_tolerance() {
    let data = "time,id,fx\n0.01,0,1e-25\n0.01,1,1e-25\n";
    assert_eq!(compared(data, &[]).0, Some(1));
    assert_eq!(compared(data, &["--absolute", "fx=1e-20"]).0, Some(0));
    assert_eq!(compared(data, &["--absolute", "fx=1e-30"]).0, Some(1));
}

#[test]
fn a_step_of_another_length_is_taken_into_account() {
    let halved = |line: &str| {
        line.parse::<u32>()
            .map_or(line.to_owned(), |step| (step / 2).to_string())
    };
    let mut lines: Vec<String> = dump().lines().map(str::to_owned).collect();
    for place in 0..lines.len() - 1 {
        if lines[place] == "ITEM: TIMESTEP" {
            lines[place + 1] = halved(&lines[place + 1]);
        }
    }
    let coarse = lines.join("\n");
    assert_eq!(compared(&coarse, &[]).0, Some(1));
    assert_eq!(compared(&coarse, &["--data-step", "2e-4"]).0, Some(0));
}

#[test]
fn whole_runs_are_compared_by_the_columns_of_the_series() {
    let kinetic = |t: f64| {
        let mass = |r: f64| 2700.0 * 4.0 / 3.0 * std::f64::consts::PI * r.powi(3);
        let energy = |grain: usize, r: f64| {
            let [_, _, vx, vy, spin] = exact(grain, t);
            0.5 * mass(r) * (vx * vx + vy * vy + 0.4 * r * r * spin * spin)
        };
        energy(0, 1e-3) + energy(1, 2e-3)
    };
    let data = format!(
        "time,kinetic\n0.0,{:?}\n0.01,{:?}\n",
        kinetic(0.0),
        kinetic(0.01)
    );
    let (status, table, said) = compared(&data, &["--tolerance", "1e-9"]);
    assert_eq!(status, Some(0), "{table}{said}");
    assert_eq!(
        compared("time,kinetic\n0.0,1.0\n0.01,2.0\n", &[]).0,
        Some(1)
    );
}

/// A file, options, and words of the error.
type Refusal = (&'static str, &'static [&'static str], &'static str);

const REFUSALS: [Refusal; 19] = [
    (
        "time,id,x\n0.02,0,1.0\n",
        &[],
        "from 0 to the end of the run",
    ),
    ("time,id,x\n0.00015,0,1.0\n", &[], "multiple of time.step"),
    (
        "time,id,x\n-0.0001,0,1.0\n",
        &[],
        "from 0 to the end of the run",
    ),
    (
        "time,id,x\n0.0,7,1.0\n",
        &[],
        "id 7: must be from 0 to 1, as the scene has 2",
    ),
    (
        "time,id,x\n0.0,-1,1.0\n",
        &[],
        ":2: id = -1: must be an integer",
    ),
    ("time,id,x\n0.0,0\n", &[], "CSV file with a header"),
    (
        "time,id,colour\n0.0,0,1.0\n",
        &[],
        "no column can be compared",
    ),
    ("time,id,x\n0.0,0,0.0\n", &["--columns", "y"], "--columns y"),
    (
        "time,id,x\n0.0,0,0.0\n",
        &["--tolerance", "y=1"],
        "--tolerance y",
    ),
    (
        "time,id,x,y\n0.0,0,0.0,0.5\n0.0,1,1.0,\n",
        &[],
        ":3: y = \"\": must be a number",
    ),
    ("t,id,x\n0.0,0,0.0\n0.1,0,1.0\n", &[], "id 0: occurs twice"),
    ("time;id;x\n0.0;0;0.0\n", &[], "separated by commas"),
    (
        "time,id,x\n0.0,0,left\n",
        &[],
        "x: this column holds no numbers",
    ),
    (
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x\n3 2\n",
        &[],
        "id 3: must be from 1 to 2",
    ),
    ("", &[], "at least one row"),
    (
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS x y\n1 2\n",
        &[],
        "the column id",
    ),
    (
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x\n1 2\n",
        &[],
        "the file ends here",
    ),
    (
        "time,step,id,x\n0.0,0,0,0.0\n",
        &[],
        "only one of the columns time and step",
    ),
    (
        "time,id,x,x\n0.0,0,0.0,0.0\n",
        &[],
        "x: this column is given twice",
    ),
];

#[test]
fn data_that_cannot_be_compared_are_refused() {
    for (data, options, words) in REFUSALS {
        let (status, _, said) = compared(data, options);
        assert_eq!(status, Some(2), "{data}: {said}");
        assert!(
            said.contains(words) && said.contains("data"),
            "{data}: {said}"
        );
    }
}
