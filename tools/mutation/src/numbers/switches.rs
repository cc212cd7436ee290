//! The sites of all sources, and the sources with a switch around each site.

use super::declared::Declared;
use super::site::{Findings, Side, Site};
use super::sites::find;
use crate::Outcome;
use crate::kernel::Kernel;
use crate::workspace::{Source, library, parse_all};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// A source file with its sites.
pub struct Searched {
    source: Source,
    found: Findings,
}

/// All sources with their numbered sites.
///
/// # Errors
/// A file that cannot be read or parsed, or a macro whose numbers cannot be found.
pub fn survey(root: &Path, kernel: Kernel) -> Outcome<Vec<Searched>> {
    let mut parsed = parse_all(root, kernel.folders())?;
    let mut declared = Declared::in_files(parsed.iter().map(|source| &source.file));
    let foundations = parse_all(root, kernel.foundations())?;
    declared.add_foundations(foundations.iter().map(|source| &source.file));
    declared.counts_optional = kernel.counts_optional();
    let own = parsed.len();
    parsed.extend(parse_all(root, kernel.users())?);
    let mut searched = Vec::new();
    let mut next = 0;
    for (place, source) in parsed.into_iter().enumerate() {
        let side = if place < own {
            Side::Kernel
        } else {
            Side::User
        };
        let name = source.name();
        let mut found = find(&name, &source.text, &source.file, &declared, side);
        if let Some(tokens) = found.opaque.first() {
            return Err(format!("{name}: cannot read the macro around {tokens}").into());
        }
        for site in &mut found.sites {
            site.id = next;
            next += 1;
        }
        searched.push(Searched { source, found });
    }
    Ok(searched)
}

/// The sites of all sources.
pub fn sites(searched: &[Searched]) -> Vec<Site> {
    let all = searched.iter().flat_map(|one| &one.found.sites);
    all.cloned().collect()
}

/// The texts of all sources with their switches.
pub fn texts(searched: &[Searched]) -> HashMap<PathBuf, String> {
    let of = |one: &Searched| (one.source.path.clone(), rewritten(one));
    searched.iter().map(of).collect()
}

/// The text of a source with its sites built in.
fn rewritten(Searched { source, found }: &Searched) -> String {
    // Insertions by position. At one position, closing ones precede opening ones, and inner ends precede outer ends.
    let mut insertions: Vec<(usize, bool, String)> = Vec::new();
    let library = library(&source.path);
    for site in &found.sites {
        let name = if site.shorthand {
            format!("{}: ", site.expression)
        } else {
            String::new()
        };
        let call = format!("{library}::perturbation::at({}, ", site.id);
        let [head, tail] = match site.optional {
            true => [name, format!(".map(|value| {call}value))")],
            false => [name + &call, ")".to_owned()],
        };
        insertions.push((site.range.start, true, head));
        insertions.push((site.range.end, false, tail));
    }
    let mut text = source.text.clone();
    for [word, ty, value] in &found.structures {
        insertions.push((word.start, true, "static ".to_owned()));
        insertions.push((ty.start, true, "std::sync::LazyLock<".to_owned()));
        insertions.push((ty.end, false, ">".to_owned()));
        insertions.push((value.start, true, "std::sync::LazyLock::new(|| ".to_owned()));
        insertions.push((value.end, false, ")".to_owned()));
        // Blanks keep all other positions unchanged.
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
    result
}
