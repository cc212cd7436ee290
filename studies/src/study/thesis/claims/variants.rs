//! Claims about what does not matter.

use crate::statistics::Mean;
use crate::study::claim::{Finding, Rule, Verdict, within_or_beyond};
use crate::study::results::Run;
use crate::study::sample::Sample;

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
    let base = Sample {
        part: BASE.0,
        ..*sample
    };
    let mut variants: Vec<&str> = sample.runs().map(|run| run.text("variant")).collect();
    variants.sort_unstable();
    variants.dedup();
    let (mut is_met, mut is_opposed, mut said) = (!variants.is_empty(), false, Vec::new());
    for variant in variants {
        let change = |run: &Run| -> Option<f64> {
            let other = base.by_seed(BASE.1, run.pressure(), "friction");
            Some(run.number("friction")? - other.get(run.seed())?)
        };
        let of_seed = |seed: &&str| -> Option<f64> {
            let runs = sample.runs();
            let runs = runs.filter(|run| run.text("variant") == variant && run.seed() == *seed);
            let changes: Vec<f64> = runs.filter_map(change).collect();
            Mean::of(&changes).map(|mean| mean.mean)
        };
        let changes: Vec<f64> = sample.seeds().iter().filter_map(of_seed).collect();
        let mean = Mean::of(&changes).filter(|mean| mean.number > 1)?;
        let [low, high] = mean.interval(0.9);
        if !variant.starts_with("friction") {
            let [is_within, is_beyond] = within_or_beyond([low, high], IMMATERIAL);
            is_met &= is_within;
            is_opposed |= is_beyond;
        }
        said.push(format!(
            "{variant}: {:+.3} [{low:.3}, {high:.3}]",
            mean.mean
        ));
    }
    let numbers = format!("{} (90 %).", said.join("; "));
    (!said.is_empty()).then(|| Finding::new(Verdict::of(is_met, is_opposed), numbers))
}
