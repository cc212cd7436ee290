//! The first page: what was shown, how, with which evidence from outside, and what was not.

use super::equations::{Coverage, title};
use super::fold::{link, ratio};
use super::judged::{Digits, used, weakest_first};
use super::outside::programs;
use super::{Entry, Record};
use crate::checks::{Origin, Source};
use maud::{Markup, html};

/// Facts about the program and the machine.
pub struct Facts {
    /// The date of the run.
    pub date: String,
    /// The commit from which the program was built.
    pub commit: &'static str,
    /// The machine.
    pub machine: String,
    /// The instruction set that the kernel used.
    pub instructions: &'static str,
    /// Whether all checks of the register were run.
    pub is_complete: bool,
}

/// The first page.
pub fn first_page(entries: &[Entry], facts: &Facts) -> Markup {
    let coverage = Source::ALL.map(|source| (source, Coverage::of(source, entries)));
    html! {
        header {
            h1 { "gouge: verification report" }
            p.about {
                time { (facts.date) } " · version " (env!("CARGO_PKG_VERSION")) " · " (commit(facts.commit))
            }
            (verdict(entries, facts))
            p {
                "gouge is a two-dimensional discrete element program: spheres in a plane, breakable viscoelastic bonds, and contacts with friction. "
                "Its model is that of S. Kiiskinen, "
                cite { "Modeling Friction between Shearing Brittle Surfaces with a Discrete Element Method" }
                " (Jyväskylä, 2018), the thesis. "
                "A second kernel moves rigid discs and polygons by contact dynamics (Azéma, Estrada and Radjai, 2012)."
            }
            p {
                b { "This is verification, not validation. " }
                "The report shows that the program solves the equations of the model correctly. "
                "It does not show that the model describes rock: no check compares friction or strength with laboratory measurements."
            }
            p {
                b { "Method. " }
                "Each check runs a scene and compares it with an oracle that does not use the program's kernel: a closed form, an independent integration, an invariant, or another program. "
                "Each states the origin of its tolerance: rounding, the order of the method, or a statistical margin. "
                "Other programs ran from their own inputs; their results are stored in " code { "references/" } " with versions and hashes."
            }
            p {
                b { "Scope and limits. " }
                (scope(coverage, facts.is_complete))
                " Results hold for the scenes and parameters that each check states. "
                "Crumbling is chaotic, so scenes of many grains agree with other programs only on average. "
                "Some figures show measured impacts of single spheres; no check rests on them. "
                "Chapters on speed and on the author's program show stored measurements."
            }
            (table(entries, coverage, facts))
        }
    }
}

fn commit(commit: &str) -> Markup {
    html! {
        @match commit.strip_suffix("-dirty") {
            Some(hash) => { "commit " code { (hash) } " with uncommitted changes" }
            None => { "commit " code { (commit) } }
        }
    }
}

fn verdict(entries: &[Entry], facts: &Facts) -> Markup {
    let records = || entries.iter().map(|entry| &entry.record);
    let failed: Vec<&Record> = records().filter(|record| !record.passed()).collect();
    html! {
        p.verdict {
            b { (entries.len() - failed.len()) " of " (entries.len()) " checks pass." }
            @if !facts.is_complete { " Only some checks were run." }
        }
        @if !failed.is_empty() { p.fail { "Failed: " @for record in &failed { (link(record)) " " } } }
    }
}

/// Which equations are covered, in words.
fn scope(coverage: [(Source, Coverage); 3], is_complete: bool) -> String {
    coverage
        .map(|(source, coverage)| scope_of(source, coverage, is_complete))
        .join(" ")
}

fn scope_of(source: Source, coverage: Coverage, is_complete: bool) -> String {
    let Coverage {
        all,
        checked,
        tested,
        missing,
    } = coverage;
    let model = match source {
        Source::Thesis => None,
        Source::Azema => Some("contact dynamics"),
        Source::Peridem => Some("peridynamic grains"),
    };
    if let Some(model) = model {
        return format!("Of {all} of {model}, {checked} have checks.");
    }
    let covered =
        format!("Checks stand for {checked} of the {all} numbered equations of the thesis");
    if !is_complete {
        return format!("{covered}.");
    }
    let verb = if missing == 1 { "is" } else { "are" };
    format!("{covered}; {tested} have only unit tests, and {missing} {verb} not implemented.")
}

fn table(entries: &[Entry], coverage: [(Source, Coverage); 3], facts: &Facts) -> Markup {
    let records = || entries.iter().map(|entry| &entry.record);
    let passed = records().filter(|record| record.passed()).count();
    let weakest = weakest_first(entries);
    html! {
        table.facts {
            tr { th { "checks" } td { (passed) " of " (entries.len()) " pass: " (origins(entries)) } }
            @if let Some(weakest) = weakest.first() {
                tr { th { "largest error / tolerance" } td { (ratio(used(weakest))) ", " (link(weakest)) } }
            }
            @if let Some(digits) = Digits::of(records()) {
                tr { th { "correct digits" } td {
                    "fewest " (format!("{:.1}", digits.fewest)) ", median " (format!("{:.1}", digits.median))
                    "; checks that demand at least three: " (digits.checks)
                } }
            }
            @for (source, coverage) in coverage {
                tr { th { "equations of " (title(source)) } td { (coverage.checked) " of " (coverage.all) " with a check" } }
            }
            @for (name, program) in programs(entries) {
                tr { th { (name) " " (program.versions.join(", ")) } td { (program.words()) } }
            }
            tr { th { "machine" } td { (facts.machine) "; instructions: " (facts.instructions) } }
            tr { th { "time of all checks / s" } td.n.time { (format!("{:.0}", records().map(|record| record.seconds).sum::<f64>())) } }
        }
    }
}

/// Number of checks by the origin of their tolerance.
fn origins(entries: &[Entry]) -> String {
    let count = |origin: Origin| {
        let of = |entry: &&Entry| entry.record.tolerance_origin == origin;
        format!("{} {}", entries.iter().filter(of).count(), origin.name())
    };
    Origin::ALL.map(count).join(", ")
}

#[cfg(test)]
mod tests {
    use super::super::examples::{covering, entry, record};
    use super::{Facts, first_page};
    use crate::checks::{Measurement, Origin};

    fn facts() -> Facts {
        Facts {
            date: "2026-11-29".to_owned(),
            commit: "0123456789ab-dirty",
            machine: "a processor, 2 threads".to_owned(),
            instructions: "portable",
            is_complete: true,
        }
    }

    /// The words of a page, without tags.
    fn words(page: &str) -> Vec<String> {
        let texts = page.split('<').filter_map(|part| part.split_once('>'));
        let text: Vec<&str> = texts.map(|(_, text)| text).collect();
        text.join(" ")
            .split_whitespace()
            .map(str::to_owned)
            .collect()
    }

    #[test]
    fn the_first_page_is_short_and_says_what_failed() {
        let failed = record(
            "pairs.bad",
            Measurement::absolute(0.0, 2.0, 1.0),
            Origin::Exact,
        );
        let stored = Measurement::absolute(0.0, 1e-13, 1e-9);
        let entries = [
            entry(covering("laws.some", "(34)-(36)")),
            entry(failed),
            entry(record("references.yade/hertz", stored, Origin::Exact)),
        ];
        let page = first_page(&entries, &facts()).into_string();
        assert_eq!(page.matches("<table").count(), 1);
        let text = words(&page).join(" ");
        for expected in [
            "2 of 3 checks pass",
            "Failed: pairs.bad",
            "2026-11-29",
            "0123456789ab with uncommitted changes",
            "stand for 3 of the 137 numbered equations of the thesis; 133 have only unit tests, and 1 is not implemented",
            "step by step 1 of 1 cases; digits: fewest 13.0, median 13.0",
            "verification, not validation",
            "instructions: portable",
        ] {
            assert!(text.contains(expected), "{expected}: {text}");
        }
        assert!(
            (200..370).contains(&words(&page).len()),
            "{}",
            words(&page).len()
        );
    }
}
