//! What changes if an axis has one value instead of another.

use super::claim::{Finding, Verdict, within_or_beyond};
use super::results::Run;
use super::sample::Sample;
use crate::statistics::Mean;

/// The change from one value of an axis to another, averaged over all other axes of each seed.
pub struct Change<'a> {
    /// The other value.
    pub value: &'a str,
    /// The mean over the seeds.
    pub mean: Mean,
    /// Its interval, 90 %.
    pub interval: [f64; 2],
}

impl<'a> Change<'a> {
    /// The change of a number; none with fewer than two seeds.
    pub fn of(
        sample: Sample,
        axis: &str,
        [base, value]: [&'a str; 2],
        number: impl Fn(&Run) -> Option<f64>,
    ) -> Option<Self> {
        Self::of_seeds(value, &sample.changes(axis, [value, base], number))
    }

    /// The change to a value, from that of each seed; none with fewer than two seeds.
    pub fn of_seeds(value: &'a str, changes: &[f64]) -> Option<Self> {
        let mean = Mean::of(changes).filter(|mean| mean.number > 1)?;
        Some(Self {
            value,
            mean,
            interval: mean.interval(0.9),
        })
    }

    /// Whether all changes are equivalent to none: holds if all intervals lie within a distance of zero, refuted if one
    /// lies beyond it. A remark on each may follow.
    pub fn judged(changes: &[Self], distance: f64, remark: impl Fn(&Self) -> String) -> Finding {
        let places = || {
            let intervals = changes.iter().map(|change| change.interval);
            intervals.map(|interval| within_or_beyond(interval, distance))
        };
        let is_met = places().all(|[is_within, _]| is_within);
        let is_opposed = places().any(|[_, is_beyond]| is_beyond);
        let said: Vec<String> = changes
            .iter()
            .map(|change| change.said() + &remark(change))
            .collect();
        let seeds = changes.first().map_or(0, |change| change.mean.number);
        let numbers = format!("{}; 90 % intervals over {seeds} seeds.", said.join("; "));
        Finding::new(Verdict::of(is_met, is_opposed), numbers)
    }
    /// The value, and the mean with its interval.
    pub fn said(&self) -> String {
        let [low, high] = self.interval;
        let mean = self.mean.mean;
        format!("{}: {mean:+.3} [{low:.3}, {high:.3}]", self.value)
    }
}
