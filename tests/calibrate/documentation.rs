//! The commands of `docs/calibration.md`, followed literally.

use crate::program::{gouge, stderr, stdout};
use crate::sources::{read, root};

/// The fenced blocks of a page in order: their language and their lines.
fn blocks(page: &str) -> Vec<(String, Vec<String>)> {
    let mut blocks = Vec::new();
    let mut lines = page.lines();
    while let Some(line) = lines.next() {
        if let Some(language) = line.strip_prefix("```") {
            let inside = lines.by_ref().take_while(|line| !line.starts_with("```"));
            blocks.push((language.to_owned(), inside.map(str::to_owned).collect()));
        }
    }
    blocks
}

/// Words of a line: the widths of columns do not matter.
fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}

#[test]
fn its_commands_print_what_it_shows() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut said = String::new();
    for (language, lines) in blocks(&read(&root().join("docs/calibration.md"))) {
        match language.as_str() {
            "sh" => {
                for line in &lines {
                    let arguments = line.strip_prefix("gouge ").expect("a command").split(' ');
                    let output = gouge()
                        .args(arguments)
                        .current_dir(folder.path())
                        .output()
                        .expect("starts");
                    assert_eq!(output.status.code(), Some(0), "{line}: {}", stderr(&output));
                    said = stdout(&output);
                }
            }
            "text" => {
                for line in lines.iter().filter(|line| !line.is_empty()) {
                    let is_said = said.lines().any(|other| words(other) == words(line));
                    assert!(is_said, "{line} is not in {said}");
                }
            }
            "toml" => {
                let path = folder.path().join("own.toml");
                std::fs::write(&path, lines.join("\n")).expect("a file");
                let out = folder.path().join("own");
                let arguments = ["calibrate".as_ref(), path.as_os_str(), "--out".as_ref()];
                let output = gouge()
                    .args(arguments)
                    .args([out.as_os_str(), "--quiet".as_ref()])
                    .output()
                    .expect("starts");
                assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
            }
            other => panic!("a block of {other}"),
        }
    }
}
