//! Full disks, foreign files and unfinished runs: nothing is overwritten unless requested.

use super::{assert_same, colliding_pair, complete, fault, files, kill, start, text};
use crate::program::{run, stderr, write_draft};
use gouge_dem::integrators::Integrator;
use gouge_validation::scenes::Draft;
use rand_pcg::Pcg64;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

/// Run with file sizes limited to a number of blocks of 512 bytes, as if the disk became full.
fn on_a_small_disk(blocks: usize, scene: &Path, out: &Path, resume: bool) -> Output {
    let program = start(scene, out, resume);
    let mut shell = Command::new("sh");
    shell.arg("-c").arg(format!(
        "ulimit -f {blocks}; trap '' XFSZ; exec \"$0\" \"$@\""
    ));
    shell.arg(program.get_program()).args(program.get_args());
    shell.output().expect("a shell")
}

#[test]
fn a_full_disk_is_reported_and_the_run_continues_when_there_is_space() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &colliding_pair(1e-8));
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    complete(&scene, &reference, false);
    let mut sizes = vec![];
    // First not even a checkpoint fits; then longer and longer series fit.
    for blocks in [0, 1, 8, 16, 24, 32] {
        let resume = out.join("checkpoint").exists();
        let output = on_a_small_disk(blocks, &scene, &out, resume);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(1), "{blocks}: {said}");
        assert!(
            said.starts_with(&format!("gouge: cannot write {}/", out.display())),
            "{said}"
        );
        let series = fs::read_to_string(out.join("series.csv")).unwrap_or_default();
        assert!(
            series.is_empty() || series.ends_with('\n'),
            "the last row is incomplete: {series}"
        );
        assert!(!out.join("summary.json").exists());
        assert!(
            !files(&out)
                .keys()
                .any(|path| text(path).ends_with("partial"))
        );
        sizes.push(series.len());
    }
    assert!(
        sizes[2..].windows(2).all(|two| two[0] < two[1]),
        "{sizes:?}"
    );
    complete(&scene, &out, true);
    assert_same(&out, &reference);
}

#[test]
fn a_checkpoint_that_does_not_fit_leaves_the_earlier_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &fault("euler", "cundall-strack", "none"));
    let (reference, out) = (folder.path().join("reference"), folder.path().join("out"));
    complete(&scene, &reference, false);
    let mut random = Pcg64::new(31, 32);
    while !out.join("checkpoint").exists() || out.join("summary.json").exists() {
        let _ = fs::remove_dir_all(&out);
        kill(&scene, &out, false, &mut random, 2000);
    }
    let path = out.join("checkpoint");
    let before = fs::read(&path).expect("a checkpoint");
    let output = on_a_small_disk(before.len() / 1024, &scene, &out, true);
    assert_eq!(output.status.code(), Some(1));
    assert!(stderr(&output).contains(text(&path)), "{}", stderr(&output));
    assert_eq!(fs::read(&path).expect("a checkpoint"), before);
    complete(&scene, &out, true);
    assert_same(&out, &reference);
}

#[test]
fn an_unfinished_run_is_not_overwritten() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = write_draft(folder.path(), &colliding_pair(1e-8));
    let out = folder.path().join("out");
    complete(&scene, &out, false);
    let done = files(&out);
    fs::remove_file(out.join("summary.json")).expect("ours");
    let before = files(&out);
    for (name, advice) in [(text(&scene), "--resume"), ("oblique", "--overwrite")] {
        let output = run(&["run", name, "--out", text(&out)]);
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(advice) && said.contains(text(&out)), "{said}");
        assert_eq!(files(&out), before);
    }
    complete(&scene, &out, true);
    assert_eq!(files(&out).len(), done.len());
}

#[test]
fn foreign_files_survive() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    fs::create_dir_all(out.join("trajectory")).expect("a new folder");
    let foreign = [
        "notes.txt",
        "checkpoint.old",
        "summary.partial",
        "trajectory/analysis.py",
        "trajectory/frame_start.xyz",
        "trajectory/frame_01.xyz",
        "trajectory/frame_000001.dat",
        "trajectory/run.vtk",
    ];
    for name in foreign {
        fs::write(out.join(name), "precious").expect("ours");
    }
    let scene = write_draft(folder.path(), &fault("euler", "cundall-strack", "extxyz"));
    complete(&scene, &out, false);
    assert!(out.join("trajectory/frame_000010.xyz").exists());
    let output = start(Path::new("head-on"), &out, false)
        .arg("--overwrite")
        .output()
        .expect("the program starts");
    assert!(output.status.success(), "{}", stderr(&output));
    assert!(!out.join("trajectory/frame_000010.xyz").exists());
    for name in foreign {
        assert_eq!(fs::read(out.join(name)).expect(name), b"precious");
    }
}

#[test]
fn a_run_does_not_replace_what_its_scene_reads() {
    let folder = tempfile::tempdir().expect("a folder");
    let list = folder.path().join("particles.csv");
    fs::write(&list, "x,y,radius,vx\n0,0,1e-3,1\n1,0,1e-3,0\n").expect("ours");
    let scene = Draft::open_box(Integrator::Euler, 1e-3)
        .ending_at(1.0)
        .with("particles_file", "particles.csv");
    let scene = write_draft(folder.path(), &scene);
    let before = files(folder.path());
    let output = run(&["run", text(&scene), "--out", text(folder.path())]);
    let said = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains(text(&list)), "{said}");
    assert_eq!(files(folder.path()), before);
    complete(&scene, &folder.path().join("out"), false);
}
