//! Claims about friction.

use crate::statistics::{Mean, holm, rising, slope};
use crate::study::claim::{Finding, Rule, Verdict, within_or_beyond};
use crate::study::sample::Sample;
use std::collections::BTreeMap;

/// The laws with friction.
const RUBBING: [&str; 2] = ["HW", "CS"];
/// Probability below which an effect counts as shown.
const LEVEL: f64 = 0.01;
/// Difference of two laws below which they count as alike.
const ALIKE: f64 = 0.10;

pub(super) static RULES: [Rule; 6] = [
    Rule {
        statement: "Friction decays exponentially after its peak, thesis (100).",
        rule: "In 90 % of the runs, neighbouring residuals of the fit are not correlated by more than chance (2 standard errors).",
        test: decay,
    },
    Rule {
        statement: "Internal friction raises the coefficient of friction.",
        rule: "At five sixths of the pressures from 0.05 to 0.6 (15 of 18), for both laws: paired by seed, one-sided Student test with Holm's adjustment, p < 0.01.",
        test: raises,
    },
    Rule {
        statement: "It makes no difference which of the two laws of friction is used.",
        rule: "The 90 % interval of HW less CS, averaged over the pressures of each seed, lies within 0.10 of zero.",
        test: alike,
    },
    Rule {
        statement: "The coefficient of friction falls with the pressure.",
        rule: "Jonckheere's test over the pressures from 0.05 to 0.6, for both laws: p < 0.01.",
        test: falls,
    },
    Rule {
        statement: "At very low and very high pressures it does not.",
        rule: "At both ends (up to 0.05, from 0.6 on), the slope of friction over ln p differs from that in between (95 % interval of the difference over seeds) and does not differ from zero.",
        test: extremes,
    },
    Rule {
        statement: "Internal friction makes fragments roll past each other instead of sliding.",
        rule: "The ratio of rolling to slip in the debris is larger for both laws than without friction: paired by seed, averaged over the pressures with debris, in logarithms, p < 0.01.",
        test: rolls,
    },
];

fn decay(sample: &Sample) -> Option<Finding> {
    let of_run = |run: &crate::study::results::Run| run.number("decay-correlation");
    let correlations: Vec<f64> = sample.runs().filter_map(of_run).collect();
    let mean = Mean::of(&correlations).filter(|_| sample.is_arm())?;
    // About 200 samples follow the peak.
    let chance = 2.0 / 200_f64.sqrt();
    let within = correlations.iter().filter(|one| one.abs() < chance).count();
    let share = within as f64 / correlations.len() as f64;
    let numbers = format!(
        "{:.0} % of {} runs within chance; mean correlation of neighbouring residuals {:.2}.",
        100.0 * share,
        correlations.len(),
        mean.mean
    );
    Some(Finding::new(
        Verdict::of(share >= 0.9, share < 0.5),
        numbers,
    ))
}

fn raises(sample: &Sample) -> Option<Finding> {
    let pressures = sample.middle();
    let (mut shown, mut opposed, mut said) = (usize::MAX, 0, Vec::new());
    for law in RUBBING {
        let means: Vec<Mean> = pressures
            .iter()
            .filter_map(|&p| over_seeds(&sample.differences([law, "none"], p, "friction")))
            .filter(|mean| mean.number > 1)
            .collect();
        let significant = |sign: f64| {
            let signed = means.iter().map(|one| Mean {
                mean: sign * one.mean,
                ..*one
            });
            let probabilities: Vec<f64> = signed.map(|one| one.p_greater()).collect();
            holm(&probabilities)
                .into_iter()
                .filter(|p| *p < LEVEL)
                .count()
        };
        let shown_here = significant(1.0);
        shown = shown.min(shown_here);
        opposed = opposed.max(significant(-1.0));
        let gains: Vec<f64> = means.iter().map(|mean| mean.mean).collect();
        let [least, most] = ends(&gains)?;
        said.push(format!(
            "{law}: shown at {shown_here} of {} pressures, mean gains from {least:.2} to {most:.2}",
            pressures.len()
        ));
    }
    let numbers = format!("{}; over {} seeds.", said.join("; "), sample.seeds().len());
    let is_met = 6 * shown >= 5 * pressures.len();
    Some(Finding::new(Verdict::of(is_met, opposed > 0), numbers))
}

/// The mean over pressures of a number for each seed that has it at most of them.
fn seeds_means<'a>(
    pressures: &[f64],
    of: impl Fn(f64) -> BTreeMap<&'a str, f64>,
) -> BTreeMap<&'a str, f64> {
    let mut values: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    for (seed, value) in pressures.iter().flat_map(|&p| of(p)) {
        values.entry(seed).or_default().push(value);
    }
    let has_most = |values: &Vec<f64>| 2 * values.len() > pressures.len();
    let mean = |(seed, values): (_, Vec<f64>)| {
        let mean = Mean::of(&values).filter(|_| has_most(&values))?;
        Some((seed, mean.mean))
    };
    values.into_iter().filter_map(mean).collect()
}

/// The mean over the seeds.
fn over_seeds(by_seed: &BTreeMap<&str, f64>) -> Option<Mean> {
    Mean::of(&by_seed.values().copied().collect::<Vec<f64>>())
}

/// What the first table has more than the second one, for each seed in both.
fn less<'a>(
    ones: &BTreeMap<&'a str, f64>,
    others: &BTreeMap<&'a str, f64>,
) -> BTreeMap<&'a str, f64> {
    let pair = |(seed, one): (&&'a str, &f64)| Some((*seed, one - others.get(seed)?));
    ones.iter().filter_map(pair).collect()
}

fn alike(sample: &Sample) -> Option<Finding> {
    let pressures = sample.pressures();
    let differences = |p: f64| sample.differences(RUBBING, p, "friction");
    let mean = over_seeds(&seeds_means(&pressures, differences)).filter(|mean| mean.number > 1)?;
    let [low, high] = mean.interval(0.9);
    let each = pressures
        .iter()
        .filter_map(|&p| over_seeds(&differences(p)));
    let each: Vec<f64> = each.map(|mean| mean.mean).collect();
    let [least, most] = ends(&each)?;
    let numbers = format!(
        "HW less CS: {:.3}, 90 % [{low:.3}, {high:.3}]; at single pressures from {least:.2} to {most:.2}.",
        mean.mean
    );
    let [is_met, is_opposed] = within_or_beyond([low, high], ALIKE);
    Some(Finding::new(Verdict::of(is_met, is_opposed), numbers))
}

fn falls(sample: &Sample) -> Option<Finding> {
    let pressures = sample.middle();
    let groups = |law: &str, sign: f64| -> Vec<Vec<f64>> {
        let values = |&p: &f64| sample.values(law, p, "friction").into_iter();
        pressures
            .iter()
            .map(|p| values(p).map(|mu| sign * mu).collect())
            .collect()
    };
    let is_filled = |law: &&str| {
        groups(law, 1.0)
            .iter()
            .filter(|group| !group.is_empty())
            .count()
            > 2
    };
    if !sample.is_arm() || !RUBBING.iter().all(is_filled) {
        return None;
    }
    let falling = RUBBING.map(|law| rising(&groups(law, -1.0)));
    let growing = RUBBING.map(|law| rising(&groups(law, 1.0)));
    let slopes = RUBBING.map(|law| slope_over_logarithm(sample, law, &pressures));
    let numbers = format!(
        "p = {:.1e} (HW), {:.1e} (CS); slope over ln p {:.3}, {:.3}.",
        falling[0], falling[1], slopes[0], slopes[1]
    );
    let is_met = falling.iter().all(|p| *p < LEVEL);
    Some(Finding::new(
        Verdict::of(is_met, growing.iter().any(|p| *p < LEVEL)),
        numbers,
    ))
}

/// Slopes of friction over ln p, one for each seed that has all pressures.
fn slopes<'a>(sample: &Sample<'a>, law: &str, pressures: &[f64]) -> BTreeMap<&'a str, f64> {
    let of_seed = |seed: &'a str| {
        let point = |&p: &f64| Some([p.ln(), *sample.by_seed(law, p, "friction").get(seed)?]);
        let points: Option<Vec<[f64; 2]>> = pressures.iter().map(point).collect();
        Some((seed, slope(&points?)))
    };
    sample.seeds().into_iter().filter_map(of_seed).collect()
}

fn slope_over_logarithm(sample: &Sample, law: &str, pressures: &[f64]) -> f64 {
    over_seeds(&slopes(sample, law, pressures)).map_or(f64::NAN, |mean| mean.mean)
}

fn extremes(sample: &Sample) -> Option<Finding> {
    let middle = sample.middle();
    let (mut is_met, mut is_opposed, mut said) = (true, false, Vec::new());
    for law in RUBBING {
        let between = slopes(sample, law, &middle);
        for (name, pressures) in ["low", "high"].iter().zip(sample.extremes()) {
            let here = slopes(sample, law, &pressures);
            let change = less(&here, &between);
            if pressures.len() < 3 || change.len() < 2 {
                return None;
            }
            let [here, change] = [
                over_seeds(&here)?.interval(0.95),
                over_seeds(&change)?.interval(0.95),
            ];
            let holds_zero = |[low, high]: [f64; 2]| low <= 0.0 && high >= 0.0;
            is_met &= holds_zero(here) && !holds_zero(change);
            is_opposed |= here[1] < 0.0;
            said.push(format!(
                "{law} {name}: slope [{:.3}, {:.3}]",
                here[0], here[1]
            ));
        }
    }
    let numbers = format!("{} (95 %, over ln p).", said.join("; "));
    Some(Finding::new(Verdict::of(is_met, is_opposed), numbers))
}

fn rolls(sample: &Sample) -> Option<Finding> {
    let pressures = sample.middle();
    let ratios = |law: &str, p: f64| {
        let slip = sample.by_seed(law, p, "slip_speed_mean");
        let rolling = sample.by_seed(law, p, "rolling_speed_mean").into_iter();
        let ratio = |(seed, rolling): (_, f64)| {
            let ratio = rolling / slip.get(seed)?;
            (ratio > 0.0 && ratio.is_finite()).then(|| (seed, ratio.ln()))
        };
        rolling.filter_map(ratio).collect::<BTreeMap<&str, f64>>()
    };
    let gain = |law: &str| {
        let gains = seeds_means(&pressures, |p| less(&ratios(law, p), &ratios("none", p)));
        over_seeds(&gains).filter(|mean| mean.number > 1)
    };
    let (hw, cs) = (gain("HW")?, gain("CS")?);
    let numbers = format!(
        "Rolling over slip grows by a factor of {:.2} (HW, p = {:.1e}) and {:.2} (CS, p = {:.1e}).",
        hw.mean.exp(),
        hw.p_greater(),
        cs.mean.exp(),
        cs.p_greater()
    );
    let is_met = hw.p_greater() < LEVEL && cs.p_greater() < LEVEL;
    let is_opposed = [hw, cs].iter().any(|one| one.interval(0.95)[1] < 0.0);
    Some(Finding::new(Verdict::of(is_met, is_opposed), numbers))
}

/// Least and largest value; none without values.
fn ends(values: &[f64]) -> Option<[f64; 2]> {
    let least = values.iter().copied().min_by(f64::total_cmp)?;
    let most = values.iter().copied().max_by(f64::total_cmp)?;
    Some([least, most])
}
