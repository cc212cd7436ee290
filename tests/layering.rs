//! Which modules and crates may use each other.

use crate::sources::{KERNELS, kernel_files, read, root, rust_files};
use std::path::Path;

/// Allowed uses of a module listed further down: a model names its integrator, as plain data.
const EXCEPTIONS: [(&str, &str); 1] = [("model", "integrators")];

/// Crates with their folders, from the lowest to the highest: each may depend only on earlier ones.
const CRATES: [(&str, &str); 11] = [
    ("gouge-page", "page"),
    ("gouge-common", "kernel/common"),
    ("gouge-dem", "kernel/dem"),
    ("gouge-contact-dynamics", "kernel/contact-dynamics"),
    ("gouge-peridem", "kernel/peridem"),
    ("gouge-replay", "replay"),
    ("gouge-scalars", "validation/scalars"),
    ("gouge-runner", "runner"),
    ("gouge-validation", "validation"),
    ("gouge-studies", "studies"),
    ("gouge", "cli"),
];

/// Lines of code, without comments and unit tests.
fn code(text: &str) -> impl Iterator<Item = &str> {
    text.lines()
        .take_while(|line| !line.starts_with("#[cfg(test)]"))
        .filter(|line| !line.trim_start().starts_with("//"))
}

/// The top-level module of a file of a crate; none for the root of the crate.
fn module(source: &Path, file: &Path) -> Option<String> {
    let inside = file.strip_prefix(source).expect("a file of the crate");
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
    // What a macro names is found from other crates, so it is exported by the root.
    let is_own = |&(at, _): &(usize, &str)| !line[..at].ends_with('$');
    let places = line.match_indices("crate::").filter(is_own);
    places.map(after).collect()
}

/// Modules of a crate, in the order in which the root of the crate lists them: from the lowest to the highest.
fn order(source: &Path) -> Vec<String> {
    let text = read(&source.join("lib.rs"));
    let name = |line: &str| {
        let line = line.strip_prefix("pub ").unwrap_or(line);
        Some(line.strip_prefix("mod ")?.strip_suffix(';')?.to_owned())
    };
    text.lines().filter_map(name).collect()
}

#[test]
fn the_kernel_is_listed_from_particles_to_estimators() {
    // The root of the crate lists modules in the order of chapter 3 of the thesis, with other modules between them.
    let chapter = [
        "geometry",
        "particles",
        "laws",
        "model",
        "bonds",
        "contacts",
        "forces",
        "integrators",
        "world",
        "estimators",
        "setup",
    ];
    let order = order(&root().join("kernel/dem/src"));
    let listed: Vec<&String> = order
        .iter()
        .filter(|name| chapter.contains(&name.as_str()))
        .collect();
    assert_eq!(listed, chapter);
}

#[test]
fn modules_use_only_what_is_listed_above_them() {
    for source in KERNELS.map(|folder| root().join(folder)) {
        let order = order(&source);
        let place = |name: &str| match order.iter().position(|other| other == name) {
            Some(place) => place,
            None => panic!("{name} is not in lib.rs"),
        };
        for file in rust_files(&source) {
            let Some(module) = module(&source, &file) else {
                continue;
            };
            let text = read(&file);
            for (line, other) in
                code(&text).flat_map(|line| used(line).into_iter().map(move |o| (line, o)))
            {
                let allowed = other == module
                    || place(other) < place(&module)
                    || EXCEPTIONS.contains(&(module.as_str(), other));
                assert!(allowed, "{}: {line}", file.display());
            }
        }
    }
}

#[test]
fn no_two_files_of_the_kernel_depend_on_each_other() {
    let files = kernel_files();
    let uses = |file: &Path| {
        let text = read(file);
        let siblings = code(&text).filter_map(|line| {
            let rest = line.trim_start().strip_prefix("use super::")?;
            let name = rest
                .split(|c: char| !c.is_alphanumeric() && c != '_')
                .next()?;
            let sibling = file.with_file_name(format!("{name}.rs"));
            sibling.exists().then_some(sibling)
        });
        siblings.collect::<Vec<_>>()
    };
    for file in &files {
        for other in uses(file) {
            assert!(
                !uses(&other).contains(file),
                "{} and {} use each other",
                file.display(),
                other.display()
            );
        }
    }
}

#[test]
fn crates_depend_only_on_lower_ones() {
    for (place, (name, folder)) in CRATES.iter().enumerate() {
        let manifest = read(&root().join(folder).join("Cargo.toml"));
        let used_at_run_time = manifest.split("[dev-dependencies]").next();
        let lines = used_at_run_time.unwrap_or_default().lines();
        for other in lines.filter_map(|line| line.strip_suffix(".workspace = true")) {
            let position = CRATES.iter().position(|(lower, _)| *lower == other);
            assert!(
                position.is_none_or(|position| position < place),
                "{name} depends on {other}"
            );
        }
    }
}

#[test]
fn the_command_line_only_reads_arguments_and_prints() {
    for path in rust_files(&root().join("cli/src")) {
        let is_front_page = path.ends_with("lib.rs");
        let kernels = ["gouge_dem", "gouge_common"];
        let text = read(&path);
        let uses = kernels.iter().any(|kernel| text.contains(kernel));
        assert!(is_front_page || !uses, "{} uses the kernel", path.display());
    }
}

#[test]
fn every_dependency_is_used() {
    let folders = [
        "benches",
        "examples",
        "python",
        "tools/equations",
        "tools/mutation",
    ];
    for folder in CRATES.iter().map(|(_, folder)| *folder).chain(folders) {
        let manifest = read(&root().join(folder).join("Cargo.toml"));
        let mut files = rust_files(&root().join(folder));
        let tested_above = [
            "cli",
            "validation",
            "kernel/contact-dynamics",
            "kernel/peridem",
        ];
        if tested_above.contains(&folder) {
            files.extend(rust_files(&root().join("tests")));
        }
        let sources: String = files.iter().map(|file| read(file)).collect();
        let mut is_dependency = false;
        for line in manifest.lines() {
            if line.starts_with('[') {
                is_dependency = line.contains("dependencies]");
            } else if let (true, Some(name)) = (is_dependency, line.split(['.', ' ']).next()) {
                let path = name.replace('-', "_");
                let is_used = name.is_empty()
                    || [format!("{path}::"), format!("use {path};")]
                        .iter()
                        .any(|use_of_it| sources.contains(use_of_it.as_str()));
                assert!(is_used, "{folder}/Cargo.toml: {name} is used nowhere");
            }
        }
    }
}

#[test]
fn the_kernel_has_no_io_clock_threads_or_globals() {
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
    for file in kernel_files() {
        let text = read(&file);
        for line in code(&text) {
            let words = outside.iter().find(|word| line.contains(*word));
            // A thread that waits may let others run; that starts none.
            let is_allowed = line.contains("'static") || line.contains("std::thread::yield_now()");
            assert!(words.is_none() || is_allowed, "{}: {line}", file.display());
        }
    }
}

#[test]
fn reading_a_scene_depends_only_on_its_files() {
    for file in rust_files(&root().join("runner/src/scene")) {
        let text = read(&file);
        for line in code(&text) {
            let outside = ["machine::", "std::time"]
                .iter()
                .any(|word| line.contains(word));
            assert!(!outside, "{}: {line}", file.display());
        }
    }
}

#[test]
fn the_runner_prints_nothing_and_only_one_file_reads_the_environment() {
    let output = [
        "print!",
        "println!",
        "dbg!",
        "stdout",
        "stderr",
        "indicatif",
        "process::exit",
        "process::abort",
        "Command",
    ];
    let environment = ["std::env", "env::"];
    let source = root().join("runner/src");
    for file in rust_files(&source) {
        let text = read(&file);
        let may_ask = file == source.join("machine.rs");
        for line in code(&text) {
            let prints = output.iter().any(|word| line.contains(word));
            let asks = environment.iter().any(|word| line.contains(word));
            assert!(!prints && (may_ask || !asks), "{}: {line}", file.display());
        }
    }
}

#[test]
fn only_passes_write_forces_and_estimators_write_nothing() {
    let source = root().join("kernel/dem/src");
    for file in rust_files(&source) {
        let (module, text) = (module(&source, &file), read(&file));
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
            let kernels = ["gouge_dem", "gouge_contact_dynamics"];
            let calls = kernels.iter().any(|kernel| line.contains(kernel));
            assert!(!calls, "{}: {line}", file.display());
        }
    }
}

#[test]
fn architecture_md_names_exactly_the_existing_modules() {
    let text = read(&root().join("ARCHITECTURE.md"));
    let named: Vec<&str> = text.split('`').skip(1).step_by(2).collect();
    for name in &named {
        if name.contains('/') && !name.contains(' ') {
            assert!(root().join(name).exists(), "ARCHITECTURE.md names {name}");
        }
    }
    for (_, folder) in CRATES {
        let source = root().join(folder).join("src");
        for entry in std::fs::read_dir(&source).expect("a readable folder") {
            let entry = entry.expect("readable");
            let name = entry.file_name().to_string_lossy().into_owned();
            let path = format!("{folder}/src/{name}");
            let is_named = name == "lib.rs"
                || named
                    .iter()
                    .any(|other| other.trim_end_matches('/') == path);
            assert!(is_named, "ARCHITECTURE.md lacks {path}");
        }
    }
}
