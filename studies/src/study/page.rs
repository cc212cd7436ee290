//! The page of the study.

use super::Study;
use super::claim::{Claim, Finding};
use super::illustration::STYLE;
use super::results::{Results, Run};
use gouge_page::table;
use maud::{Markup, html};
use std::collections::BTreeMap;

/// The page: verdicts first, then what was run, then figures.
pub fn page(
    study: &Study,
    results: &Results,
    claims: &[Claim],
    illustrations: &[Markup],
) -> Markup {
    gouge_page::styled_page(
        study.title,
        STYLE,
        html! {
            h1 { (study.title) }
            ((study.introduction)())
            (summary(claims))
            h2 { "Claims and verdicts" }
            p { "Each claim has a rule, fixed before the runs unless the introduction says otherwise. Parts of the study stand in brackets." }
            (verdicts(claims))
            h2 { "Runs" }
            (runs(study, results))
            (lost(results))
            @for table in (study.tables)(results) { (table) }
            h2 { "Figures" }
            @for illustration in illustrations { (illustration) }
            h2 { "Data" }
            p {
                "One row a run: " a href="runs.csv" { "runs.csv" }
                ". Verdicts: " a href="claims.csv" { "claims.csv" }
                ". " (study.curves.names.join(" and ").replace('_', " ")) " over time: " a href="curves.csv" { "curves.csv" } "."
            }
        },
    )
}

/// Each claim with its verdict in every part of the study that has one.
fn summary(claims: &[Claim]) -> Markup {
    let said = |(part, finding): &(&str, Finding)| format!("{part}: {}", finding.verdict.name());
    let row = |claim: &Claim| {
        let mut all = claim.findings.iter().map(said);
        let first = all.next().unwrap_or_else(|| "not run".to_owned());
        let others: Vec<String> = all.collect();
        vec![claim.statement.to_owned(), first, others.join("; ")]
    };
    let rows: Vec<Vec<String>> = claims.iter().map(row).collect();
    let columns = ["claim", "verdict", "in other parts"].map(str::to_owned);
    table(
        "Verdicts, by the most telling part of the study",
        &columns,
        &rows,
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
fn runs(study: &Study, results: &Results) -> Markup {
    let row = |part: &&str| {
        let all = || results.runs().iter().filter(|run| run.part == **part);
        let mut states: BTreeMap<&str, usize> = BTreeMap::new();
        all().for_each(|run| *states.entry(run.text("status")).or_default() += 1);
        let states = states.iter();
        let states: Vec<String> = states
            .map(|(name, number)| format!("{number} {name}"))
            .collect();
        let seconds = all().filter_map(|run| run.number("wall_seconds"));
        let seconds = seconds.fold(0.0, |sum, one| sum + one);
        let cells = [
            (*part).to_owned(),
            all().count().to_string(),
            states.join(", "),
            format!("{:.2}", seconds / 3600.0),
        ];
        (all().next().is_some()).then_some(cells.into())
    };
    let rows: Vec<Vec<String>> = study.order.iter().filter_map(row).collect();
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
