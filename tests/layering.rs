//! Who may use whom, and how long files may be.

use crate::equations::{read, root, rust_files};
use std::path::Path;

/// Uses of what is listed further down: a model names its integrator, as plain data.
const EXCEPTIONS: [(&str, &str); 1] = [("model", "integrators")];

/// Longest file in lines.
const LONGEST: usize = 500;

fn kernel() -> std::path::PathBuf {
    root().join("kernel/src")
}

/// Lines of code: no comments, nothing after the beginning of unit tests.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines()
        .take_while(|line| !line.starts_with("#[cfg(test)]"))
        .filter(|line| !line.trim_start().starts_with("//"))
}

/// The top module of a kernel file; none for the root of the crate.
fn module(file: &Path) -> Option<String> {
    let inside = file.strip_prefix(kernel()).expect("a kernel file");
    let first = inside.components().next().expect("a name").as_os_str();
    let name = Path::new(first)
        .file_stem()
        .expect("a name")
        .to_string_lossy();
    (name != "lib").then(|| name.into_owned())
}

/// Modules of the crate that a line names.
fn used(line: &str) -> Vec<&str> {
    let after = |(at, _): (usize, &str)| {
        let rest = &line[at + "crate::".len()..];
        let end = rest
            .find(|c: char| !c.is_alphanumeric() && c != '_')
            .unwrap_or(rest.len());
        &rest[..end]
    };
    line.match_indices("crate::").map(after).collect()
}

/// Modules of the kernel from the lowest to the highest, as the root of the crate lists them.
fn order() -> Vec<String> {
    let text = read(&kernel().join("lib.rs"));
    let name = |line: &str| {
        let line = line.strip_prefix("pub ").unwrap_or(line);
        Some(line.strip_prefix("mod ")?.strip_suffix(';')?.to_owned())
    };
    text.lines().filter_map(name).collect()
}

#[test]
fn the_kernel_is_listed_from_particles_to_estimators() {
    // Read down, the root of the crate is chapter 3 of the thesis; what is not named here lies between.
    let chapter = [
        "scalar",
        "geometry",
        "particles",
        "laws",
        "model",
        "links",
        "forces",
        "integrators",
        "world",
        "estimators",
        "setup",
    ];
    let order = order();
    let listed: Vec<&String> = order
        .iter()
        .filter(|name| chapter.contains(&name.as_str()))
        .collect();
    assert_eq!(listed, chapter);
}

#[test]
fn modules_use_only_what_is_listed_above_them() {
    let order = order();
    let place = |name: &str| match order.iter().position(|other| other == name) {
        Some(place) => place,
        None => panic!("{name} is not in lib.rs"),
    };
    for file in rust_files(&kernel()) {
        let Some(module) = module(&file) else {
            continue;
        };
        let text = read(&file);
        for line in code(&text) {
            for other in used(line) {
                let allowed = other == module
                    || place(other) < place(&module)
                    || EXCEPTIONS.contains(&(module.as_str(), other));
                assert!(allowed, "{}: {line}", file.display());
            }
        }
    }
}

#[test]
fn the_kernel_touches_nothing_outside_itself() {
    let outside = [
        "std::fs",
        "std::env",
        "std::time",
        "std::net",
        "std::io",
        "std::process",
        "std::thread",
        "println!",
        "mul_add",
        "static ",
        "unsafe",
    ];
    for file in rust_files(&kernel()) {
        let text = read(&file);
        for line in code(&text) {
            let words = outside.iter().find(|word| line.contains(*word));
            assert!(
                words.is_none() || line.contains("'static"),
                "{}: {line}",
                file.display()
            );
        }
    }
}

#[test]
fn only_passes_write_forces_and_estimators_write_nothing() {
    for file in rust_files(&kernel()) {
        let (module, text) = (module(&file), read(&file));
        for line in code(&text) {
            let is_force = ["force[", "torque[", "add_pair("]
                .iter()
                .any(|word| line.contains(word));
            let writes = ["+=", "-=", "] = ", "add_pair("]
                .iter()
                .any(|word| line.contains(word));
            if is_force && writes {
                assert_eq!(
                    module.as_deref(),
                    Some("forces"),
                    "{}: {line}",
                    file.display()
                );
            }
            if module.as_deref() == Some("estimators") {
                let columns = ["World", "Particles", "Forces", "Bonds", "Contacts"];
                let writes = columns
                    .iter()
                    .any(|name| line.contains(&format!("&mut {name}")));
                assert!(!writes, "{}: {line}", file.display());
            }
        }
    }
}

#[test]
fn oracles_never_call_the_kernel() {
    for file in rust_files(&root().join("validation/src/oracles")) {
        let text = read(&file);
        for line in code(&text) {
            assert!(!line.contains("gouge_dem"), "{}: {line}", file.display());
        }
    }
}

#[test]
fn files_are_short() {
    for folder in ["kernel/src", "validation/src"] {
        for file in rust_files(&root().join(folder)) {
            let lines = read(&file).lines().count();
            assert!(lines <= LONGEST, "{} has {lines} lines", file.display());
        }
    }
}

#[test]
fn the_paths_of_the_architecture_exist() {
    let path = root().join("ARCHITECTURE.md");
    if !path.exists() {
        return;
    }
    for name in read(&path).split('`').skip(1).step_by(2) {
        if name.contains('/') && !name.contains(' ') {
            // Invariants name folders of the kernel by themselves.
            let found = root().join(name).exists() || kernel().join(name).exists();
            assert!(found, "ARCHITECTURE.md names {name}");
        }
    }
}
