//! The source files of the checks.

use include_dir::{Dir, File, include_dir};

/// The checks, as they were compiled.
static CHECKS: Dir = include_dir!("$CARGO_MANIFEST_DIR/src/checks");
/// The folder of these files in the source tree.
const FOLDER: &str = "validation/src/checks";

/// Where a check is defined.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The file, from the root of the source tree.
    pub file: String,
    /// The line, counted from one.
    pub line: usize,
}

/// Where a check is defined; none if its identifier is not written in any file.
pub fn place(id: &str) -> Option<Place> {
    let stored = id.strip_prefix("references.");
    let stored = stored.map(|path| path.strip_suffix(".control").unwrap_or(path));
    let texts = [
        Some(format!("id: \"{id}\"")),
        Some(format!("\"{id}\"")),
        // The checks of stored cases are listed by the folders of the cases.
        stored.map(|path| format!("\"{path}\"")),
    ];
    texts.iter().flatten().find_map(|text| first(&CHECKS, text))
}

/// The first place of a text in a folder.
fn first(folder: &Dir, text: &str) -> Option<Place> {
    let mut files = folder.files();
    let here = files.find_map(|file| first_in(file, text));
    here.or_else(|| folder.dirs().find_map(|inner| first(inner, text)))
}

fn first_in(file: &File, text: &str) -> Option<Place> {
    let content = file.contents_utf8()?;
    let at = content.find(text)?;
    Some(Place {
        file: format!("{FOLDER}/{}", file.path().display()),
        line: content[..at].lines().count().max(1),
    })
}

#[cfg(test)]
mod tests {
    use super::place;
    use crate::checks::register;
    use std::path::Path;

    #[test]
    fn every_check_has_its_place_in_a_file_of_its_own_topic() {
        for topic in register() {
            for check in &topic.checks {
                let found = place(check.id);
                assert!(found.is_some(), "{}", check.id);
                let Some(found) = found else { continue };
                let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
                let text = std::fs::read_to_string(root.join(&found.file)).unwrap_or_default();
                let line = text.lines().nth(found.line - 1).unwrap_or_default();
                let name = check.id.trim_start_matches("references.");
                assert!(
                    line.contains(name.trim_end_matches(".control")),
                    "{found:?}"
                );
                let folder = topic.id.replace('-', "_");
                assert!(found.file.contains(&folder), "{}: {found:?}", check.id);
            }
        }
    }
}
