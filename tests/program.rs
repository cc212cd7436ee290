//! Helpers that run the program like a user.

use gouge_validation::scenes::Draft;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The program under test.
pub fn gouge() -> Command {
    Command::new(env!("CARGO_BIN_EXE_gouge"))
}

/// Run the program to its end.
pub fn run(arguments: &[&str]) -> Output {
    gouge()
        .args(arguments)
        .output()
        .expect("the program starts")
}

/// Standard error of a finished program.
pub fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Standard output of a finished program.
pub fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Write the scene of a draft into a folder.
pub fn write_draft(folder: &Path, draft: &Draft) -> PathBuf {
    write_scene(folder, &draft.text().expect("a scene"))
}

/// Write a scene into a folder.
pub fn write_scene(folder: &Path, text: &str) -> PathBuf {
    let path = folder.join("scene.toml");
    std::fs::write(&path, text).expect("the folder is writable");
    path
}
