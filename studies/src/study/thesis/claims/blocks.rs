//! Claims about the runs themselves.

use crate::study::claim::{Finding, Rule, Verdict};
use crate::study::results::Run;
use crate::study::sample::Sample;

/// Time of a full run in s and how far it may be off.
const TIME: [f64; 2] = [50e-3, 1e-6];
/// Slip in its second half in m, half of the height of the block, and how far it may be off.
const SLIP: [f64; 2] = [50e-3, 0.5e-3];
/// How far the mean load may be off, as a part of it.
const LOAD: f64 = 0.01;

pub(super) static RULES: [Rule; 2] = [
    Rule {
        statement: "Each run lasts 50.000 ms ± 0.001 ms and reaches a strain of 1.00 ± 0.01.",
        rule: "Every run of full size; the strain of its second half is 0.500 ± 0.005.",
        test: strain,
    },
    Rule {
        statement: "The drive holds the load.",
        rule: "In every run the mean load over the second half is within 1 % of the pressure times the area.",
        test: load,
    },
];

fn strain(sample: &Sample) -> Option<Finding> {
    let numbers = |run: &Run| Some([run.number("time")?, run.number("slip")?]);
    let rows: Vec<[f64; 2]> = sample.runs().filter_map(numbers).collect();
    if rows.is_empty() || !sample.is_full() {
        return None;
    }
    let off = |place: usize, [target, _]: [f64; 2]| {
        let each = rows.iter().map(|row| (row[place] - target).abs());
        each.fold(0.0, f64::max)
    };
    let [time, slip] = [off(0, TIME), off(1, SLIP)];
    let said = format!(
        "Over {} runs, the time is off by at most {:.4} ms, the strain by {:.4}.",
        rows.len(),
        1e3 * time,
        10.0 * slip
    );
    let is_met = time <= TIME[1] && slip <= SLIP[1];
    Some(Finding::new(Verdict::of(is_met, !is_met), said))
}

fn load(sample: &Sample) -> Option<Finding> {
    let off: Vec<f64> = sample
        .runs()
        .filter_map(|run| run.number("load-held"))
        .map(|ratio| (ratio - 1.0).abs())
        .collect();
    if off.is_empty() || !sample.is_arm() {
        return None;
    }
    let within = off.iter().filter(|one| **one <= LOAD).count();
    let largest = off.iter().copied().fold(0.0, f64::max);
    let said = format!(
        "Within 1 % in {within} of {} runs; off by at most {:.1} %.",
        off.len(),
        100.0 * largest
    );
    let is_met = within == off.len();
    Some(Finding::new(Verdict::of(is_met, !is_met), said))
}
