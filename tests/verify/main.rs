//! Tests of `gouge-verify`, the program that `gouge verify` starts.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::path::Path;
use std::process::{Command, Output, Stdio};

fn verify(arguments: &[&str], folder: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_gouge-verify"))
        .args(arguments)
        .arg("--out")
        .arg(folder)
        .output()
        .expect("the program starts")
}

#[test]
fn a_pattern_that_matches_no_check_is_refused() {
    let folder = std::env::temp_dir().join(format!("gouge-verify-{}", std::process::id()));
    let output = verify(&["--only", "no-such-check"], &folder);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("no check matches"), "{message}");
    assert!(!folder.exists(), "nothing is written");
}

#[test]
fn a_closed_pipe_stops_the_lines_but_not_the_reports() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut child = Command::new(env!("CARGO_BIN_EXE_gouge-verify"))
        .args(["--only", "identities", "--out"])
        .arg(folder.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{message}");
    assert_eq!(message, "");
    assert!(folder.path().join("report.html").exists());
    assert!(folder.path().join("report.json").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_an_error_but_the_reports_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full");
    let output = Command::new(env!("CARGO_BIN_EXE_gouge-verify"))
        .args(["--only", "identities", "--out"])
        .arg(folder.path())
        .stdout(full.expect("the device"))
        .output()
        .expect("the program starts");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("standard output"), "{message}");
    assert!(folder.path().join("report.html").exists());
}

/// The report page in a folder, without timings and the date, and with figure files inserted.
fn page(folder: &Path) -> String {
    let page = std::fs::read_to_string(folder.join("report.html")).expect("the page");
    let (before, rest) = page.split_once("<time>").expect("the date");
    let page = before.to_owned() + rest.split_once("</time>").expect("its end").1;
    let mut parts = page.split("<td class=\"n time\">");
    let mut timeless = parts.next().expect("the head").to_owned();
    for part in parts {
        timeless += part.split_once("</td>").expect("the end of a cell").1;
    }
    let mut parts = timeless.split("<img src=\"");
    let mut whole = parts.next().expect("the head").to_owned();
    for part in parts {
        let (name, rest) = part
            .split_once("\" alt=\"\">")
            .expect("the end of an image");
        whole += &std::fs::read_to_string(folder.join(name)).expect("the figure");
        whole += rest;
    }
    whole
}

#[test]
fn a_page_with_separate_figures_shows_the_same_as_a_self_contained_page() {
    // The second one has a slash in its name.
    for id in ["chung-ooi.4", "references.lammps/bond-axial"] {
        let folder = tempfile::tempdir().expect("a folder");
        let (alone, apart) = (folder.path().join("alone"), folder.path().join("apart"));
        let only = ["--only", id];
        assert!(verify(&only, &alone).status.success());
        let output = verify(&[&only[..], &["--figures-apart"]].concat(), &apart);
        assert!(output.status.success(), "{output:?}");
        let figures = std::fs::read_dir(apart.join("figures")).expect("figures");
        assert!(figures.count() > 0, "{id}");
        assert!(!alone.join("figures").exists());
        assert!(page(&alone) == page(&apart));
    }
}
