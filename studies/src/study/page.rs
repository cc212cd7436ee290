//! The page of the study.

use super::claims::{Claim, PARTS};
use super::results::{Results, Run};
use gouge_page::{Figure, table};
use maud::{Markup, html};
use std::collections::BTreeMap;

/// The page: verdicts first, then what was run, then figures.
pub fn page(results: &Results, claims: &[Claim], figures: &[Figure]) -> Markup {
    gouge_page::page(
        "Friction between shearing brittle surfaces: the study of the thesis with many seeds",
        html! {
            h1 { "The study of the thesis, repeated" }
            p {
                "Kiiskinen's thesis ran 75 simulations, 3 laws of friction times 25 pressures, of one packing. "
                "Here every run is repeated with several packings, and each claim has a rule that was fixed before the runs. "
                "The corrected arm uses the equations as corrected in the errata, velocity Verlet, and a stable step for each law. "
                "The other arm computes as the author's program did: explicit Euler at 10 ns, friction as printed, moment of inertia 3/5 m r². "
                "Runs of the corrected arm whose energy balance is off do not count; those of the other arm all do."
            }
            h2 { "Claims and verdicts" }
            (verdicts(claims))
            h2 { "Runs" }
            (runs(results))
            (lost(results))
            h2 { "Figures" }
            @for figure in figures { (figure.html()) }
            h2 { "Data" }
            p { "One row a run: " a href="runs.csv" { "runs.csv" } ". Friction and heat over time: " a href="curves.csv" { "curves.csv" } "." }
        },
    )
}

fn verdicts(claims: &[Claim]) -> Markup {
    html! {
        @for claim in claims {
            h3 { (claim.statement) }
            p { "Holds if: " (claim.rule) }
            @if claim.findings.is_empty() { p { "Not run." } }
            ul {
                @for (part, finding) in &claim.findings {
                    li { b { (finding.verdict.name()) } " (" (part) "). " (finding.numbers) }
                }
            }
        }
    }
}

/// How many runs of each part ended how, and what they cost.
fn runs(results: &Results) -> Markup {
    let row = |part: &&str| {
        let all = || results.runs().iter().filter(|run| run.part == **part);
        let mut states: BTreeMap<&str, usize> = BTreeMap::new();
        all().for_each(|run| *states.entry(run.text("status")).or_default() += 1);
        let states = states.iter();
        let states: Vec<String> = states
            .map(|(name, number)| format!("{number} {name}"))
            .collect();
        let seconds: f64 = all().filter_map(|run| run.number("wall_seconds")).sum();
        let cells = [
            (*part).to_owned(),
            all().count().to_string(),
            states.join(", "),
            format!("{:.2}", seconds / 3600.0),
        ];
        (all().next().is_some()).then_some(cells.into())
    };
    let rows: Vec<Vec<String>> = PARTS.iter().filter_map(row).collect();
    let columns = ["part", "runs", "of which", "core-hours"].map(str::to_owned);
    table("Runs of each part", &columns, &rows)
}

/// The runs that do not count, with their causes.
fn lost(results: &Results) -> Markup {
    let mut causes: BTreeMap<[&str; 3], usize> = BTreeMap::new();
    let is_lost = |run: &&Run| !run.counts() && !matches!(run.text("status"), "waiting" | "begun");
    for run in results.runs().iter().filter(is_lost) {
        let cause = run
            .text("cause")
            .split([':', ';'])
            .next()
            .unwrap_or_default();
        *causes
            .entry([&run.part, run.text("status"), cause])
            .or_default() += 1;
    }
    let row = |([part, status, cause], number): ([&str; 3], usize)| {
        vec![
            part.to_owned(),
            status.to_owned(),
            number.to_string(),
            cause.to_owned(),
        ]
    };
    let rows: Vec<Vec<String>> = causes.into_iter().map(row).collect();
    let columns = ["part", "status", "runs", "cause"].map(str::to_owned);
    match rows.is_empty() {
        true => html! { p { "All runs that ended count." } },
        false => table("Runs that do not count", &columns, &rows),
    }
}
