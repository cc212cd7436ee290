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
    lattice_theory_gives_the_targets(&folder.path().join("out/elastic/material.toml"));
}

/// The most likely stiffnesses give the measured constants by the theory of the lattice as a spring network: along one of
/// its directions C11 = sqrt(3) / 4 (3 k_n + k_s), C12 = sqrt(3) / 4 (k_n - k_s), with the shear stiffness k_s = k_t / 2
/// of a beam between touching grains.
fn lattice_theory_gives_the_targets(material: &std::path::Path) {
    let material: toml::Table = read(material).parse().expect("TOML");
    let stiffness = |name: &str| {
        material["bond"][name]["stiffness"]
            .as_float()
            .expect("a number")
    };
    let (normal, shear) = (stiffness("normal"), 0.5 * stiffness("tangential"));
    let factor = 3.0_f64.sqrt() / 4.0;
    let (along, across) = (factor * (3.0 * normal + shear), factor * (normal - shear));
    let ratio = across / along;
    let modulus = (along - ratio * across) / 2e-3;
    assert!((ratio - 0.26).abs() < 1e-3, "{ratio}");
    // Forces enter the twenty free rows halfway to the next ones, but the area of the specimen ends at their discs.
    let row = 0.75_f64.sqrt();
    let area = (19.0 * row + 1.0) / (20.0 * row);
    assert!((modulus / (69e9 * area) - 1.0).abs() < 1e-3, "{modulus}");
}
