//! Runs that are killed, fail or meet a full disk: results are kept and the run can be continued.

mod disk;
mod endings;
mod failing;
mod folders;

use crate::program::{gouge, run, stderr, write_draft};
use gouge_validation::scenes::Draft;
use gouge_validation::scenes::fault::weak as weak_fault;
use rand::RngExt;
use rand_pcg::Pcg64;
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

/// Names and contents of all files below a folder.
type Files = BTreeMap<PathBuf, Vec<u8>>;

fn files(folder: &Path) -> Files {
    let mut files = Files::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            files.extend(self::files(&path));
        } else {
            files.insert(path.clone(), fs::read(&path).expect("a readable file"));
        }
    }
    files
}

/// The outputs that two runs of the same scene have in common: everything except times and the checkpoint, which
/// contains times.
fn comparable_files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut comparable_files = Files::new();
    for (path, mut bytes) in files(folder) {
        let name = path
            .strip_prefix(folder)
            .expect("below the folder")
            .to_owned();
        match name.to_str() {
            Some("checkpoint") => bytes.clear(),
            Some("summary.json") => {
                let mut summary: Value = serde_json::from_slice(&bytes).expect("JSON");
                let summary = summary.as_object_mut().expect("an object");
                for key in [
                    "wall_seconds",
                    "particle_steps_per_second",
                    "link_steps_per_second",
                    "neighbor_rebuilds",
                ] {
                    assert!(summary.remove(key).is_some(), "{key}");
                }
                bytes = serde_json::to_vec(summary).expect("JSON");
            }
            _ => {}
        }
        comparable_files.insert(name, bytes);
    }
    comparable_files
}

fn assert_same(folder: &Path, reference: &Path) {
    let (found, expected) = (comparable_files(folder), comparable_files(reference));
    let names = |files: &Files| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&found), names(&expected));
    for (name, bytes) in &found {
        let texts = || [bytes, &expected[name]].map(|bytes| String::from_utf8_lossy(bytes));
        let shown = || match name.ends_with("summary.json") {
            true => format!("{:?}", texts()),
            false => String::new(),
        };
        assert!(
            *bytes == expected[name],
            "{} differs {}",
            name.display(),
            shown()
        );
    }
}

fn summary(folder: &Path) -> Value {
    let text = fs::read_to_string(folder.join("summary.json")).expect("a summary");
    serde_json::from_str(&text).expect("JSON")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

/// A run that writes checkpoints as often as possible.
fn start(scene: &Path, out: &Path, resume: bool) -> Command {
    let mut command = gouge();
    command.arg("run").arg(scene).arg("--out").arg(out);
    command.args(["--checkpoint-interval", "0", "--accept-untrusted"]);
    if resume {
        command.arg("--resume");
    }
    command
}

/// A complete run, which must succeed.
fn complete(scene: &Path, out: &Path, resume: bool) {
    let output = start(scene, out, resume)
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", stderr(&output));
}

/// The protocol of the small granite fault, so short and so weak that it breaks in a fraction of a
/// second.
pub fn fault(integrator: &str, friction: &str, trajectory: &str) -> Draft {
    weak_fault()
        .replacing("time.integrator", integrator)
        .replacing("contact.tangential.law", friction)
        .replacing("time.end", 40e-6)
        .replacing("output.interval", 0.7e-6)
        .with("output.trajectory", trajectory)
}

/// Start or continue a run and kill it at a random moment. Return whether it was still running and whether the scene
/// proper had begun.
fn kill(scene: &Path, out: &Path, resume: bool, random: &mut Pcg64, size: u64) -> (bool, bool) {
    let mut command = start(scene, out, resume);
    let mut child = command
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    // Half of the moments are anywhere, including start and set-up; the others are in the scene proper.
    let moment = random.random::<f64>();
    let enough = if random.random::<bool>() {
        (moment * size as f64) as u64
    } else {
        u64::MAX
    };
    let patience = Duration::from_secs_f64(if enough == u64::MAX {
        0.15 * moment
    } else {
        10.0
    });
    let began = std::time::Instant::now();
    let series = out.join("series.csv");
    let length = || fs::metadata(&series).map_or(0, |data| data.len());
    let mut is_running = true;
    while is_running && length() < enough && began.elapsed() < patience {
        std::thread::sleep(Duration::from_micros(100));
        is_running = child.try_wait().expect("ours").is_none();
    }
    child.kill().expect("ours");
    let status = child.wait().expect("ours");
    (status.code().is_none(), length() > 1000)
}

/// Kill a run many times, complete it, and compare it with one that was left alone.
fn check_kill_and_resume(draft: &Draft, kills: usize, seed: u128) {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), draft);
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    // Some methods and laws are coarse at this step, which the run says.
    let [scene_text, reference_text] = [&scene, &reference].map(|path| self::text(path));
    let output = run(&[
        "run",
        scene_text,
        "--out",
        reference_text,
        "--accept-untrusted",
    ]);
    assert!(output.status.success(), "{}", stderr(&output));
    let report = summary(&reference);
    assert!(
        report["bonds_broken"].as_u64() > Some(0),
        "no bond breaks: {report}"
    );
    let size = fs::metadata(reference.join("series.csv"))
        .expect("a series")
        .len();
    let mut random = Pcg64::new(seed, 21);
    let (mut killed, mut in_scene) = (0, 0);
    for _ in 0..20 * kills {
        let resumes = out.join("checkpoint").exists();
        let (was_running, had_begun) = kill(&scene, &out, resumes, &mut random, size);
        killed += usize::from(was_running);
        in_scene += usize::from(was_running && had_begun);
        if !was_running {
            assert_same(&out, &reference);
            fs::remove_dir_all(&out).expect("ours");
        }
        if killed >= kills && in_scene >= kills / 2 {
            break;
        }
    }
    assert!(
        killed >= kills && in_scene >= kills / 2,
        "{killed} {in_scene}"
    );
    complete(&scene, &out, true);
    assert_same(&out, &reference);
    // Continuing a complete run changes nothing.
    complete(&scene, &out, true);
    assert_same(&out, &reference);
}

#[test]
fn a_killed_run_with_velocity_verlet_loses_no_bit() {
    check_kill_and_resume(
        &fault("velocity-verlet", "cundall-strack-truncated", "extxyz"),
        7,
        1,
    );
}

#[test]
fn a_killed_run_with_beeman_loses_no_bit() {
    let measures = ["stress", "strain", "unbalanced-force"];
    let measure: Vec<toml::Value> = measures.map(Into::into).to_vec();
    let draft = fault("beeman", "cundall-strack", "vtk").with("output.measure", measure);
    check_kill_and_resume(&draft, 10, 2);
}

#[test]
fn a_killed_run_with_euler_loses_no_bit() {
    check_kill_and_resume(&fault("euler", "cundall-strack", "none"), 10, 3);
}

/// A scene in which two particles meet; its checkpoint is small, its series long.
fn colliding_pair(step: f64) -> Draft {
    Draft::builtin("head-on").replacing("time.step", step)
}

/// Damaged checkpoints: with a wrong bit, truncated, too long, or empty.
fn damaged(whole: &[u8]) -> Vec<Vec<u8>> {
    let mut random = Pcg64::new(5, 6);
    let mut damaged: Vec<Vec<u8>> = (0..20)
        .map(|_| {
            let mut bytes = whole.to_vec();
            let place = random.random_range(0..bytes.len());
            bytes[place] ^= 1 << random.random_range(0..8);
            bytes
        })
        .collect();
    let lengths = [
        0,
        1,
        15,
        16,
        47,
        48,
        143,
        144,
        whole.len() / 2,
        whole.len() - 1,
    ];
    damaged.extend(lengths.map(|length| whole[..length].to_vec()));
    damaged.push([whole, b"x"].concat());
    damaged.push(vec![0; whole.len()]);
    damaged
}

/// Damage to a checkpoint is detected before any file is changed.
#[test]
fn damaged_checkpoints_are_refused_and_nothing_is_changed() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &colliding_pair(1e-8));
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    complete(&scene, &reference, false);
    fs::create_dir(&out).expect("a new folder");
    for name in ["checkpoint", "series.csv"] {
        fs::copy(reference.join(name), out.join(name)).expect("a copy");
    }
    let path = out.join("checkpoint");
    let whole = fs::read(&path).expect("a checkpoint");
    let refused = |scene: &Path, reason: &str| {
        let before = files(&out);
        let output = start(scene, &out, true)
            .output()
            .expect("the program starts");
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(
            said.contains(&format!("cannot resume from {}: it ", path.display())),
            "{said}"
        );
        assert!(
            said.contains(reason) && !said.contains("panicked"),
            "{said}"
        );
        assert_eq!(files(&out), before);
    };
    for bytes in damaged(&whole) {
        fs::write(&path, bytes).expect("ours");
        refused(&scene, "damaged");
    }
    fs::write(&path, &whole).expect("ours");
    let other = write_draft(&reference, &colliding_pair(2e-8));
    refused(&other, "belongs to another scene");
    fs::remove_file(&other).expect("ours");
    complete(&scene, &out, true);
    assert_same(&out, &reference);
}

/// The bytes of a checkpoint with a correct checksum.
fn with_checksum(mut bytes: Vec<u8>) -> Vec<u8> {
    let digest = Sha256::digest(&bytes[..bytes.len() - 32]);
    let place = bytes.len() - 32;
    bytes[place..].copy_from_slice(&digest);
    bytes
}

#[test]
fn a_state_with_other_columns_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &colliding_pair(1e-8));
    let out = folder.path().join("out");
    complete(&scene, &out, false);
    fs::remove_file(out.join("summary.json")).expect("ours");
    let path = out.join("checkpoint");
    let whole = fs::read(&path).expect("a checkpoint");
    assert_eq!(with_checksum(whole.clone()), whole);
    let place_of = |name: &[u8]| {
        let place = whole.windows(name.len()).position(|bytes| bytes == name);
        place.expect("a column")
    };
    // The name of the model follows its length.
    let model = place_of(b"\x03\0\0\0\0\0\0\0dem") + 8;
    let changed = |place: usize| {
        let mut bytes = whole.clone();
        bytes[place] ^= 1;
        with_checksum(bytes)
    };
    // The name is followed by the kind of the column's shape, its width and its number of words.
    let drive = place_of(b"drive");
    let shape = drive + b"drive".len();
    let mut changes: Vec<Vec<u8>> = [model, drive, drive - 8, shape, shape + 8, shape + 16]
        .map(changed)
        .to_vec();
    changes.extend((model..whole.len() - 32).step_by(41).map(|length| {
        let mut bytes = whole[..length].to_vec();
        bytes.extend([0; 32]);
        with_checksum(bytes)
    }));
    let mut longer = whole.clone();
    longer.extend([0; 8]);
    changes.push(with_checksum(longer));
    for (number, bytes) in changes.into_iter().enumerate() {
        fs::write(&path, bytes).expect("ours");
        let output = start(&scene, &out, true)
            .output()
            .expect("the program starts");
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{number}: {said}");
        assert!(
            said.contains("its state does not fit the scene"),
            "{number}: {said}"
        );
    }
}

#[test]
fn a_series_that_lost_rows_is_not_continued() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &colliding_pair(1e-8));
    let out = folder.path().join("out");
    complete(&scene, &out, false);
    fs::remove_file(out.join("summary.json")).expect("ours");
    let series = out.join("series.csv");
    for is_missing in [false, true] {
        fs::write(&series, "time\n").expect("ours");
        if is_missing {
            fs::remove_file(&series).expect("ours");
        }
        let before = files(&out);
        let output = start(&scene, &out, true)
            .output()
            .expect("the program starts");
        assert_eq!(output.status.code(), Some(1));
        assert!(
            stderr(&output).contains(text(&series)),
            "{}",
            stderr(&output)
        );
        assert_eq!(files(&out), before);
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_reported() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    fs::write(&file, "precious").expect("ours");
    for out in [file.clone(), file.join("out")] {
        let output = run(&["run", "head-on", "--out", text(&out)]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(
            said.starts_with(&format!("gouge: cannot create {}: ", out.display())),
            "{said}"
        );
    }
    assert_eq!(fs::read(&file).expect("ours"), b"precious");
}
