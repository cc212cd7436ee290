//! Thesis table 1: flags of the final states, by rules that are frozen here.
//!
//! The caption of the table says "more than a few"; here a few are three, always: fragments, grains above each other, or
//! mean diameters. "Reached the edges" means that less than 1.5 mean diameters are left.

use super::printed::{LAWS, TABLE};
use crate::study::claim::{Finding, Rule, Verdict};
use crate::study::results::Run;
use crate::study::sample::Sample;
use maud::{Markup, html};
use statrs::distribution::{Binomial, DiscreteCDF};

/// "A few" fragments, grains or mean diameters.
const FEW: f64 = 3.0;
/// Distance in mean diameters at which something has reached the edges.
const REACHED: f64 = 1.5;

/// A flag and its rule.
type Flag = (char, fn(&Run) -> Option<bool>);

/// The flags in the order of the table.
const FLAGS: [Flag; 5] = [
    ('F', |run| Some(run.number("debris-fragments")? > FEW)),
    ('C', |run| Some(run.number("longest-crack")? > FEW)),
    ('L', |run| Some(run.number("debris-depth")? > FEW)),
    // A run without such a crack has no gap.
    ('E', |run| {
        run.number("debris-fragments")?;
        Some(run.number("crack-gap").is_some_and(|gap| gap < REACHED))
    }),
    ('B', |run| Some(run.number("edge-debris")? > FEW)),
];

pub(super) static RULES: [Rule; 3] = [
    Rule {
        statement: "Table 1: fragments (F), cracks (C), a layer (L), cracks that reach the edges (E), a layer that reaches them (B).",
        rule: "A printed flag, set or not, is contradicted if all seeds say the opposite. Holds if at most one flag in twenty is contradicted; refuted if more than one in ten.",
        test: flags,
    },
    Rule {
        statement: "The lowest pressure at which each flag appears is that of table 1.",
        rule: "For each law and flag, the printed pressure lies within the range of the lowest ones over seeds, give or take one pressure of the study. Holds if all do, refuted if fewer than half do.",
        test: first,
    },
    Rule {
        statement: "From 0.7 of the strength on (HW) or 0.9 (no friction, CS), the layer reaches the edges, so that 2, 4 and 2 runs are rejected.",
        rule: "At each pressure of the study, most seeds have the printed flag B. Holds if all agree, refuted if fewer than half of those with a printed B do.",
        test: rejected,
    },
];

/// Pressures of the study that the table has, too, with the printed flags of a law.
fn printed(sample: &Sample, law: usize) -> Vec<(f64, &'static str)> {
    let pressures = sample.pressures();
    let rows = TABLE.iter().filter(|(p, _)| pressures.contains(p));
    rows.map(|(p, flags)| (*p, flags[law])).collect()
}

/// Whether each seed has a flag.
fn found(sample: &Sample, law: &str, pressure: f64, flag: &Flag) -> Vec<bool> {
    let is_meant = |run: &&Run| run.law() == law && run.pressure() == pressure;
    sample.runs().filter(is_meant).filter_map(flag.1).collect()
}

fn is_testable(sample: &Sample) -> bool {
    let is_judged = |run: &Run| run.number("debris-fragments").is_some();
    sample.is_full() && sample.runs().any(is_judged)
}

fn flags(sample: &Sample) -> Option<Finding> {
    if !is_testable(sample) {
        return None;
    }
    let (mut cells, mut contradicted, mut agreeing, mut all) = (0, 0, 0, 0);
    for (law, name) in LAWS.into_iter().enumerate() {
        for (p, printed) in printed(sample, law) {
            for flag in &FLAGS {
                let seeds = found(sample, name, p, flag);
                let same = seeds
                    .iter()
                    .filter(|seed| **seed == printed.contains(flag.0))
                    .count();
                cells += usize::from(!seeds.is_empty());
                contradicted += usize::from(!seeds.is_empty() && same == 0);
                agreeing += same;
                all += seeds.len();
            }
        }
    }
    let number = sample.seeds().len();
    // If each seed had its flags by chance as often as they agree here.
    let chance = (1.0 - agreeing as f64 / all as f64).powi(number as i32);
    let expected =
        Binomial::new(chance, cells as u64).map_or(0, |binomial| binomial.inverse_cdf(0.5));
    let said = format!(
        "{contradicted} of {cells} flags are contradicted by all of {number} seeds (by chance {expected}, if seeds agree with the table as often as they do, {:.0} %).",
        100.0 * agreeing as f64 / all as f64
    );
    Some(Finding::new(
        Verdict::of(20 * contradicted <= cells, 10 * contradicted > cells),
        said,
    ))
}

fn first(sample: &Sample) -> Option<Finding> {
    if !is_testable(sample) {
        return None;
    }
    let pairs = LAWS.into_iter().enumerate();
    let pairs = pairs.flat_map(|law| FLAGS.iter().map(move |flag| (law, flag)));
    let each: Vec<(bool, String)> = pairs
        .filter_map(|((law, name), flag)| first_of(sample, (law, name), flag))
        .collect();
    let within = each.iter().filter(|(is_within, _)| *is_within).count();
    let off: Vec<&str> = each
        .iter()
        .filter(|(is_within, _)| !is_within)
        .map(|(_, said)| said.as_str())
        .collect();
    let numbers = format!("{within} of {} agree. Off: {}.", each.len(), off.join("; "));
    let verdict = Verdict::of(within == each.len(), 2 * within < each.len());
    (!each.is_empty()).then(|| Finding::new(verdict, numbers))
}

/// Whether the printed first pressure of a flag agrees with those of the seeds, and what is printed and found; none if
/// it is not printed or not found.
fn first_of(sample: &Sample, (law, name): (usize, &str), flag: &Flag) -> Option<(bool, String)> {
    let pressures = sample.pressures();
    let has = |seed: &str, p: f64| {
        let mut runs = sample.runs();
        let mut runs = runs
            .by_ref()
            .filter(|run| run.law() == name && run.pressure() == p);
        runs.any(|run| run.seed() == seed && flag.1(run) == Some(true))
    };
    let of_seed = |seed: &&str| pressures.iter().position(|p| has(seed, *p));
    let seeds: Vec<usize> = sample.seeds().iter().filter_map(of_seed).collect();
    let (low, high) = (*seeds.iter().min()?, *seeds.iter().max()?);
    let mut printed = printed(sample, law).into_iter();
    let (p, _) = printed.find(|(_, flags)| flags.contains(flag.0))?;
    let here = pressures.iter().position(|other| *other == p)?;
    let is_within = here + 1 >= low && here <= high + 1;
    let [low, high] = [low, high].map(|place| pressures[place]);
    let said = format!("{name} {} printed {p}, found {low} to {high}", flag.0);
    Some((is_within, said))
}

fn rejected(sample: &Sample) -> Option<Finding> {
    if !is_testable(sample) {
        return None;
    }
    let flag = &FLAGS[4];
    let (mut agree, mut all, mut reached, mut expected) = (0, 0, 0, 0);
    for (law, name) in LAWS.into_iter().enumerate() {
        for (p, printed) in printed(sample, law) {
            let seeds = found(sample, name, p, flag);
            let is_there = 2 * seeds.iter().filter(|seed| **seed).count() > seeds.len();
            let is_printed = printed.contains('B');
            all += 1;
            agree += usize::from(is_there == is_printed);
            expected += usize::from(is_printed);
            reached += usize::from(is_printed && is_there);
        }
    }
    let numbers = format!(
        "Of {expected} combinations with a printed B, most seeds have it in {reached}; {agree} of all {all} agree."
    );
    Some(Finding::new(
        Verdict::of(agree == all, 2 * reached < expected),
        numbers,
    ))
}

/// The table, with the number of seeds that have each flag beside the printed ones.
pub fn table(sample: Sample) -> Option<Markup> {
    if !is_testable(&sample) {
        return None;
    }
    let cell = |law: usize, p: f64| -> String {
        let count = |flag: &Flag| {
            let seeds = found(&sample, LAWS[law], p, flag);
            let number = seeds.iter().filter(|seed| **seed).count();
            (number > 0).then(|| format!("{}{number}", flag.0))
        };
        let counts: Vec<String> = FLAGS.iter().filter_map(count).collect();
        counts.join(" ")
    };
    let row = |(p, printed): &(f64, [&str; 3])| {
        let cells = (0..3).map(|law| format!("{} | {}", printed[law], cell(law, *p)));
        [format!("{p}")].into_iter().chain(cells).collect()
    };
    let pressures = sample.pressures();
    let rows = TABLE.iter().filter(|(p, _)| pressures.contains(p));
    let rows: Vec<Vec<String>> = rows.map(row).collect();
    let columns = ["pressure", "no friction", "HW", "CS"].map(str::to_owned);
    let caption = format!(
        "Thesis table 1 ({}): printed flags | number of the {} seeds that have each",
        sample.part,
        sample.seeds().len()
    );
    Some(html! { (gouge_page::table(&caption, &columns, &rows)) })
}
