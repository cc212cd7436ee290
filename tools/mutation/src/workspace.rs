//! A copy of the workspace in which every site asks whether it is the one to be scaled.

use crate::Outcome;
use crate::declared::Declared;
use crate::site::{Findings, Side, Site};
use crate::sites::find;
use std::fs;
use std::path::{Path, PathBuf};

/// Where the lowest crate of the kernel lives, which holds what asks for the site to be scaled.
const COMMON: &str = "kernel/common/src";
/// Where the model's crate lives.
const DEM: &str = "kernel/dem/src";

/// Whose uses of the kernel's constants count as well.
const USERS: [&str; 2] = ["runner/src", "validation/src"];

/// What is not copied.
const LEFT_BEHIND: [&str; 3] = ["target", ".git", "mutation"];

/// A source file with what was found in it.
pub struct Source {
    path: PathBuf,
    text: String,
    found: Findings,
}

/// All sites of the kernel, numbered, with the sources around them.
///
/// # Errors
/// Files that cannot be read or parsed; macros that hide numbers.
pub fn survey(root: &Path) -> Outcome<Vec<Source>> {
    let mut parsed = parse(root, COMMON, Side::Kernel)?;
    parsed.extend(parse(root, DEM, Side::Kernel)?);
    let declared = Declared::in_files(parsed.iter().map(|(.., file)| file));
    for user in USERS {
        parsed.extend(parse(root, user, Side::User)?);
    }
    let mut sources = Vec::new();
    let mut next = 0;
    for (path, side, text, file) in parsed {
        let name = path.to_string_lossy().into_owned();
        let mut found = find(&name, &text, &file, &declared, side);
        if let Some(tokens) = found.opaque.first() {
            return Err(format!("{name}: cannot read the macro around {tokens}").into());
        }
        for site in &mut found.sites {
            site.id = next;
            next += 1;
        }
        sources.push(Source { path, text, found });
    }
    Ok(sources)
}

/// Read the sources below a folder, in order of their paths.
fn parse(
    root: &Path,
    folder: &str,
    side: Side,
) -> Outcome<Vec<(PathBuf, Side, String, syn::File)>> {
    let mut paths = Vec::new();
    list(&root.join(folder), &mut paths)?;
    paths.retain(|path| path.extension().is_some_and(|end| end == "rs"));
    paths.sort();
    let mut parsed = Vec::new();
    for path in paths {
        let text = fs::read_to_string(&path)?;
        let file = syn::parse_file(&text)?;
        parsed.push((path.strip_prefix(root)?.to_owned(), side, text, file));
    }
    Ok(parsed)
}

/// The sites of all sources.
pub fn sites(sources: &[Source]) -> Vec<Site> {
    let all = sources.iter().flat_map(|source| &source.found.sites);
    all.cloned().collect()
}

/// Copy the workspace and build the sites into the copy. Files that are the same stay untouched, so that
/// nothing is compiled twice.
///
/// # Errors
/// Files that cannot be read or written.
pub fn plant(root: &Path, copy: &Path, sources: &[Source]) -> Outcome<()> {
    let mut paths = Vec::new();
    list(root, &mut paths)?;
    let module_path = copy.join(COMMON).join("perturbation.rs");
    remove_others(root, copy, &module_path)?;
    for path in paths {
        let inside = path.strip_prefix(root)?;
        let source = sources.iter().find(|source| source.path == inside);
        let bytes = match (source, inside == Path::new("Cargo.toml")) {
            (Some(source), _) => rewritten(source).into_bytes(),
            (None, true) => fs::read_to_string(&path)?
                .replace("    \"tools/mutation\",\n", "")
                .into_bytes(),
            (None, false) => fs::read(&path)?,
        };
        write(&copy.join(inside), &bytes)?;
    }
    let number = sites(sources).len();
    let module =
        include_str!("perturbation.rs.txt").replace("NUMBER_OF_SITES", &number.to_string());
    write(&module_path, module.as_bytes())
}

/// Remove files of the copy that the workspace has no longer.
fn remove_others(root: &Path, copy: &Path, kept: &Path) -> Outcome<()> {
    let mut paths = Vec::new();
    if copy.exists() {
        list(copy, &mut paths)?;
    }
    for path in paths {
        if path != kept && !root.join(path.strip_prefix(copy)?).exists() {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}

fn write(path: &Path, bytes: &[u8]) -> Outcome<()> {
    if fs::read(path).is_ok_and(|old| old == bytes) {
        return Ok(());
    }
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    Ok(fs::write(path, bytes)?)
}

/// All files below a folder.
fn list(folder: &Path, found: &mut Vec<PathBuf>) -> Outcome<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let is_left = LEFT_BEHIND.iter().any(|name| entry.file_name() == *name);
        if entry.file_type()?.is_dir() {
            if !is_left {
                list(&entry.path(), found)?;
            }
        } else if !is_left {
            found.push(entry.path());
        }
    }
    Ok(())
}

/// The text of a source with its sites built in.
fn rewritten(source: &Source) -> String {
    // Insertions by place; what closes comes before what opens, inner ends before outer ones.
    let mut insertions: Vec<(usize, bool, String)> = Vec::new();
    let library = match source.path.starts_with(COMMON) {
        true => "crate",
        false => "gouge_common",
    };
    for site in &source.found.sites {
        let name = if site.shorthand {
            format!("{}: ", site.expression)
        } else {
            String::new()
        };
        let head = format!("{name}{library}::perturbation::at({}, ", site.id);
        insertions.push((site.range.start, true, head));
        insertions.push((site.range.end, false, ")".to_owned()));
    }
    let mut text = source.text.clone();
    for [word, ty, value] in &source.found.structures {
        insertions.push((word.start, true, "static ".to_owned()));
        insertions.push((ty.start, true, "std::sync::LazyLock<".to_owned()));
        insertions.push((ty.end, false, ">".to_owned()));
        insertions.push((value.start, true, "std::sync::LazyLock::new(|| ".to_owned()));
        insertions.push((value.end, false, ")".to_owned()));
        // Blanks keep every other place where it was.
        text.replace_range(word.clone(), "     ");
    }
    insertions.sort_by_key(|(place, opens, _)| (*place, *opens));
    let mut result = String::new();
    let mut from = 0;
    for (place, _, words) in insertions {
        result += &text[from..place];
        result += &words;
        from = place;
    }
    result += &text[from..];
    if source.path.ends_with("kernel/common/src/lib.rs") {
        result += "\n#[allow(missing_docs)]\npub mod perturbation;\n";
    }
    result
}
