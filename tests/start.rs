//! Beginning a run from the final state of another one.

use crate::nothing_lost::fault;
use crate::program::{run, stderr, write_draft};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli, KelvinVoigt};
use gouge_validation::scenes::{Draft, Grain};
use std::path::{Path, PathBuf};

/// Three grains without damping, so that forces do not depend on velocities: two bonded across the seam of a periodic box, the third rubbing along them.
pub fn grains(step: f64) -> Draft {
    let at = |x: f64, y: f64| Grain::at([x, y], 1e-3);
    Draft::open_box(Integrator::VelocityVerlet, step)
        .with("box.width", 10e-3)
        .with("box.boundary", "periodic-x")
        .law(KelvinVoigt {
            stiffness: 1e6,
            damping: 0.0,
        })
        .friction("cundall-strack-truncated", 0.5, 1e6)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e6,
            damping: 0.0,
        })
        .law(EulerBernoulli {
            stiffness: 1e6,
            damping: 0.0,
        })
        .grain(at(9.2e-3, 0.0).spinning(100.0))
        .grain(at(1.19e-3, 0.0))
        .grain(at(9.9e-3, 1.75e-3).moving([0.3, -0.3]))
        .bonded(0, 1)
}

/// A folder for runs.
pub struct Folder(tempfile::TempDir);

impl Folder {
    pub fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder"))
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Run a draft; its status and what it said.
    pub fn run(&self, draft: &Draft, out: &str) -> (Option<i32>, String) {
        let scene = write_draft(self.0.path(), draft);
        let out = self.path(out);
        let [scene, out] = [&scene, &out].map(|path: &PathBuf| path.to_str().expect("UTF-8"));
        let output = run(&["run", scene, "--out", out, "--accept-untrusted"]);
        (output.status.code(), stderr(&output))
    }

    pub fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.path(name)).expect(name)
    }
}

#[test]
fn a_run_that_begins_at_the_end_of_another_ends_like_one_long_run() {
    let folder = Folder::new();
    let until = |end: f64| grains(1e-8).ending_at(end);
    assert_eq!(folder.run(&until(3e-6), "half"), (Some(0), String::new()));
    assert_eq!(folder.run(&until(6e-6), "whole"), (Some(0), String::new()));
    // Of the particles that the scene lists none is used, nor are the bonds.
    let rest = until(3e-6)
        .with("start", "half")
        .replacing("particles.0.radius", 2e-3);
    assert_eq!(folder.run(&rest, "rest"), (Some(0), String::new()));
    assert_eq!(
        folder.read("rest/particles.csv"),
        folder.read("whole/particles.csv")
    );
    assert_ne!(
        folder.read("half/particles.csv"),
        folder.read("whole/particles.csv")
    );
    // Time and energies begin anew.
    let series = folder.read("rest/series.csv");
    assert!(
        series
            .lines()
            .nth(1)
            .is_some_and(|row| row.starts_with("0.0,"))
    );
    // Without the memory of the contact and the bond, the end would be another.
    let loose = until(3e-6)
        .with("start", "half")
        .without("contact.tangential")
        .friction("haff-werner", 0.5, 1.0);
    assert_eq!(folder.run(&loose, "loose"), (Some(0), String::new()));
    assert_ne!(
        folder.read("loose/particles.csv"),
        folder.read("whole/particles.csv")
    );
}

#[test]
fn one_set_up_serves_several_runs() {
    let folder = Folder::new();
    let base = fault("velocity-verlet", "cundall-strack-truncated", "none");
    let (status, said) = folder.run(&base, "whole");
    assert_eq!(status, Some(0), "{said}");
    let (status, said) = folder.run(&base.clone().replacing("time.end", 0.0), "made");
    assert_eq!(status, Some(0), "{said}");
    let (status, said) = folder.run(&base.with("start", "made"), "run");
    assert_eq!(status, Some(0), "{said}");
    assert_eq!(
        folder.read("run/particles.csv"),
        folder.read("whole/particles.csv")
    );
    assert_eq!(
        folder.read("run/series.csv"),
        folder.read("whole/series.csv")
    );
}

#[test]
fn a_state_that_does_not_fit_is_refused() {
    let folder = Folder::new();
    let base = grains(1e-8).ending_at(1e-6);
    assert_eq!(folder.run(&base, "half"), (Some(0), String::new()));
    std::fs::create_dir(folder.path("empty")).expect("a folder");
    std::fs::create_dir(folder.path("foreign")).expect("a folder");
    std::fs::write(folder.path("foreign/checkpoint"), "precious").expect("a file");
    std::fs::create_dir(folder.path("unfinished")).expect("a folder");
    std::fs::copy(
        folder.path("half/checkpoint"),
        folder.path("unfinished/checkpoint"),
    )
    .expect("a copy");
    let of = |name: &str| base.clone().with("start", name);
    let cases = [
        (of("absent"), "output folder of a finished run"),
        (of("empty"), "output folder of a finished run"),
        (of("foreign"), "it is not a checkpoint"),
        (of("unfinished"), "not finished"),
        (
            of("half").replacing("box.width", 11e-3),
            "another box.width",
        ),
        (of("half").without("bond").without("bonds"), "1 bonds"),
        (of("half").with("start", 7), "must be a string"),
    ];
    for (draft, words) in cases {
        let (status, said) = folder.run(&draft, "out");
        assert_eq!(status, Some(2), "{words}: {said}");
        let place = "scene.toml:";
        assert!(
            said.contains(words) && said.contains("start") && said.contains(place),
            "{words}: {said}"
        );
        assert!(!folder.path("out/summary.json").exists());
    }
    // A run may not replace the state from which it begins.
    let (status, said) = folder.run(&of("half"), "half");
    assert_eq!(status, Some(2), "{said}");
    assert!(Path::exists(&folder.path("half/checkpoint")));
}

/// The links of each frame, as rows of text without the header.
#[test]
fn frames_of_links_show_all_contacts_and_bonds_with_their_forces() {
    let folder = Folder::new();
    let draft = grains(1e-8).ending_at(1e-6).with("output.links", true);
    let scene = write_draft(
        folder.0.path(),
        &draft.clone().with("output.trajectory", "vtk"),
    );
    let links = run(&["links", scene.to_str().expect("UTF-8")]);
    let links = String::from_utf8(links.stdout).expect("UTF-8");
    let rows: Vec<Vec<&str>> = links
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(rows.len(), 3, "a bond and a contact: {links}");
    for format in ["vtk", "extxyz"] {
        let (status, said) = folder.run(&draft.clone().with("output.trajectory", format), format);
        assert_eq!(status, Some(0), "{said}");
    }
    let dump = folder.read("extxyz/trajectory/links_000000.dump");
    let lines: Vec<&str> = dump.lines().collect();
    assert_eq!(
        &lines[..4],
        ["ITEM: TIMESTEP", "0", "ITEM: NUMBER OF ENTRIES", "2"]
    );
    for (line, row) in lines[9..].iter().zip(&rows[1..]) {
        let kind = if row[2] == "weak" { "1" } else { "2" };
        let expected: Vec<&str> = row
            .iter()
            .map(|&cell| if cell == row[2] { kind } else { cell })
            .collect();
        assert_eq!(line.split(' ').collect::<Vec<_>>(), expected);
    }
    let vtk = folder.read("vtk/trajectory/links_000000.vtk");
    assert!(
        vtk.contains("LINES 2 6") && vtk.contains("CELL_DATA 2"),
        "{vtk}"
    );
    // The bond crosses the seam: its segment ends beyond it.
    let points = vtk.split("POINTS 4 double\n").nth(1).expect("points");
    let x: Vec<f64> = points
        .split_whitespace()
        .take(12)
        .step_by(3)
        .map(|x| x.parse().expect("a number"))
        .collect();
    let bond = rows[1..]
        .iter()
        .position(|row| row[2] == "strong")
        .expect("a bond");
    assert!(
        (x[2 * bond + 1] - x[2 * bond] - 1.99e-3).abs() < 1e-9,
        "{x:?}"
    );
    let list = folder.read("vtk/trajectory/links.vtk.series");
    assert!(
        list.contains("\"links_000000.vtk\", \"time\": 0.0"),
        "{list}"
    );
}
