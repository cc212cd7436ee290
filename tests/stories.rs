//! The user stories about sweeps in the documentation, followed to the letter.

use crate::program::gouge;
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Programs of clusters: here they look at the job and do nothing.
const CLUSTERS: [(&str, &str); 2] = [
    ("sbatch", "#!/bin/bash\nexec bash -n \"$1\"\n"),
    ("hq", "#!/bin/bash\ntest \"$1\" = submit\n"),
];

/// A fenced block of a page: what stands behind the fence, and the text.
fn blocks(page: &str) -> Vec<(String, String)> {
    let mut blocks = Vec::new();
    let mut open: Option<(String, String)> = None;
    for line in page.lines() {
        match (line.strip_prefix("```"), open.take()) {
            (Some(kind), None) => open = Some((kind.to_owned(), String::new())),
            (Some(_), Some(block)) => blocks.push(block),
            (None, Some((kind, text))) => open = Some((kind, text + line + "\n")),
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a block is not closed");
    blocks
}

/// A folder with the program and stand-ins for clusters, to be searched first.
fn programs(folder: &Path) -> PathBuf {
    let programs = folder.join("programs");
    fs::create_dir(&programs).expect("a folder");
    symlink(gouge().get_program(), programs.join("gouge")).expect("a link");
    for (name, text) in CLUSTERS {
        let path = programs.join(name);
        fs::write(&path, text).expect("a file");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o755)).expect("permissions");
    }
    programs
}

/// Follow a page of `docs/` in an empty folder: write the blocks of TOML that begin with the name of a file, and run
/// the commands, except those that are marked as long. Returns the folder and what was printed.
fn follow(page: &str) -> (tempfile::TempDir, String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(page);
    let text = fs::read_to_string(path).expect("the page");
    let folder = tempfile::tempdir().expect("a folder");
    let programs = programs(folder.path());
    let search = format!(
        "{}:{}",
        programs.display(),
        std::env::var("PATH").unwrap_or_default()
    );
    let mut printed = String::new();
    for (kind, text) in blocks(&text) {
        let name = text.lines().next().and_then(|line| line.strip_prefix("# "));
        match (kind.as_str(), name.filter(|name| name.ends_with(".toml"))) {
            ("toml", Some(name)) => fs::write(folder.path().join(name), &text).expect("a file"),
            ("sh", _) => {
                let mut shell = Command::new("bash");
                let shell = shell.args(["-euc", &text]).current_dir(folder.path());
                let output = shell.env("PATH", &search).output().expect("bash starts");
                let said = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{page}:\n{text}{said}");
                printed += &String::from_utf8_lossy(&output.stdout);
            }
            _ => {}
        }
    }
    (folder, printed)
}

#[test]
fn the_stories_about_sweeps_can_be_followed() {
    let (folder, printed) = follow("studies.md");
    assert!(printed.contains("core-hours"), "{printed}");
    let table = csv::Reader::from_path(folder.path().join("out/laws/runs.csv"));
    let mut table = table.expect("a table");
    let header = table.headers().expect("a header").clone();
    assert!(header.iter().any(|name| name == "height"), "{header:?}");
    let rows: Vec<csv::StringRecord> = table.records().map(|row| row.expect("a row")).collect();
    assert_eq!(rows.len(), 9);
    let status = header
        .iter()
        .position(|name| name == "status")
        .expect("a status");
    assert!(rows.iter().all(|row| &row[status] == "done"), "{rows:?}");
}
