//! The program that runs the checks, which `gouge verify` starts.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::process::Command;

#[test]
fn a_pattern_that_matches_no_check_is_refused() {
    let folder = std::env::temp_dir().join(format!("gouge-verify-{}", std::process::id()));
    let output = Command::new(env!("CARGO_BIN_EXE_gouge-verify"))
        .args(["--only", "no-such-check", "--out"])
        .arg(&folder)
        .output()
        .expect("the program starts");
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{message}");
    assert!(message.contains("no check matches"), "{message}");
    assert!(!folder.exists(), "nothing is written");
}
