//! Claims about what does not matter.

use crate::statistics::Mean;
use crate::study::change::Change;
use crate::study::claim::{Finding, Rule};
use crate::study::results::Run;
use crate::study::sample::Sample;
use std::collections::BTreeSet;

/// Change of friction below which a parameter counts as immaterial.
const IMMATERIAL: f64 = 0.05;
/// The part with which variants are compared, and its law.
const BASE: (&str, &str) = ("corrected-small", "CS");

pub(super) static RULES: [Rule; 1] = [Rule {
    statement: "The height of the jags and the stiffness of the well make no difference. (Friction 0.8 between grains is tried with them, because the author may have used it.)",
    rule: "The 90 % interval of the change of friction, averaged over the pressures of each seed, lies within 0.05 of zero for the flat fault, jags of twice the height and a well of twice the stiffness.",
    test: immaterial,
}];

fn immaterial(sample: &Sample) -> Option<Finding> {
    if sample.is_arm() {
        return None;
    }
    let variants: BTreeSet<&str> = sample.runs().map(|run| run.text("variant")).collect();
    let changes = variants.iter().map(|variant| change(sample, variant));
    let changes: Vec<Change> = changes.collect::<Option<_>>()?;
    let is_tried = |change: &Change| change.value.starts_with("friction");
    let (tried, judged): (Vec<_>, Vec<_>) = changes.into_iter().partition(is_tried);
    let mut finding = Change::judged(&judged, IMMATERIAL, |_| String::new());
    for change in &tried {
        finding.numbers += &format!(" Tried: {}.", change.said());
    }
    (!judged.is_empty()).then_some(finding)
}

/// The change of friction from the base to a variant, averaged over the pressures of each seed.
fn change<'a>(sample: &Sample, variant: &'a str) -> Option<Change<'a>> {
    let base = Sample {
        part: BASE.0,
        ..*sample
    };
    let of_run = |run: &Run| -> Option<f64> {
        let others = base.by_seed(BASE.1, run.pressure(), "friction");
        Some(run.number("friction")? - others.get(run.seed())?)
    };
    let of_seed = |seed: &&str| -> Option<f64> {
        let runs = sample.runs();
        let runs = runs.filter(|run| run.text("variant") == variant && run.seed() == *seed);
        let changes: Vec<f64> = runs.filter_map(of_run).collect();
        Mean::of(&changes).map(|mean| mean.mean)
    };
    let changes: Vec<f64> = sample.seeds().iter().filter_map(of_seed).collect();
    Change::of_seeds(variant, &changes)
}
