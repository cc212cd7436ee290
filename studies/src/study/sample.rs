//! The runs of one part of the study, paired by seed.

use super::results::{Results, Run};
use crate::statistics::Mean;
use gouge_page::Curve;
use std::collections::{BTreeMap, BTreeSet};

/// Lowest and highest pressure between which friction is said to fall, in units of the normal strength.
const MIDDLE: [f64; 2] = [0.05, 0.6];

/// A part of the study.
#[derive(Clone, Copy)]
pub struct Sample<'a> {
    /// All runs.
    pub results: &'a Results,
    /// Name of the part.
    pub part: &'a str,
}

impl<'a> Sample<'a> {
    /// Runs that count.
    pub fn runs(self) -> impl Iterator<Item = &'a Run> + Clone {
        self.results.of(self.part)
    }

    /// Whether the part holds blocks of full size.
    pub fn is_full(self) -> bool {
        self.part.ends_with("-full")
    }

    /// Whether the part is one of the study proper, and not of its variants.
    pub fn is_arm(self) -> bool {
        !self.part.starts_with("variants")
    }

    /// The pressures, rising.
    pub fn pressures(self) -> Vec<f64> {
        let mut all: Vec<f64> = self.runs().map(Run::pressure).collect();
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// The pressures between which friction is said to fall.
    pub fn middle(self) -> Vec<f64> {
        let is_inside = |p: &f64| (MIDDLE[0]..=MIDDLE[1]).contains(p);
        self.pressures().into_iter().filter(is_inside).collect()
    }

    /// The pressures below and above these.
    pub fn extremes(self) -> [Vec<f64>; 2] {
        let all = self.pressures();
        let below = all.iter().copied().filter(|&p| p <= MIDDLE[0]);
        let above = all.iter().copied().filter(|&p| p >= MIDDLE[1]);
        [below.collect(), above.collect()]
    }

    /// A number of all runs with a law and a pressure, by seed.
    pub fn by_seed(self, law: &str, pressure: f64, column: &str) -> BTreeMap<&'a str, f64> {
        let is_meant = |run: &&Run| run.law() == law && run.pressure() == pressure;
        let number = |run: &'a Run| Some((run.seed(), run.number(column)?));
        self.runs().filter(is_meant).filter_map(number).collect()
    }

    /// A number of all runs with a law and a pressure.
    pub fn values(self, law: &str, pressure: f64, column: &str) -> Vec<f64> {
        self.by_seed(law, pressure, column).into_values().collect()
    }

    /// Means over pressure of a number of the runs that are meant, with 95 % intervals over seeds; a single run has no
    /// interval.
    pub fn over_pressure(
        self,
        label: &str,
        column: &str,
        is_meant: impl Fn(&Run) -> bool,
    ) -> Curve {
        let mean = |pressure: f64| {
            let runs = self.runs().filter(|run| run.pressure() == pressure);
            let numbers = runs
                .filter(|run| is_meant(run))
                .filter_map(|run| run.number(column));
            Mean::of(&numbers.collect::<Vec<f64>>())
        };
        let pressures = self.pressures().into_iter();
        let means: Vec<(f64, Mean)> = pressures.filter_map(|p| Some((p, mean(p)?))).collect();
        let intervals = means.iter().map(|(_, mean)| match mean.number {
            1 => [mean.mean; 2],
            _ => mean.interval(0.95),
        });
        let points = means.iter().map(|(p, mean)| [*p, mean.mean]);
        Curve::marked_line(label, points).with_intervals(intervals)
    }

    /// The seeds.
    pub fn seeds(self) -> BTreeSet<&'a str> {
        self.runs().map(Run::seed).collect()
    }

    /// A law less another one, for each seed that has both.
    pub fn differences(
        self,
        [law, other]: [&str; 2],
        pressure: f64,
        column: &str,
    ) -> BTreeMap<&'a str, f64> {
        let others = self.by_seed(other, pressure, column);
        let ones = self.by_seed(law, pressure, column).into_iter();
        ones.filter_map(|(seed, one)| Some((seed, one - others.get(seed)?)))
            .collect()
    }

    /// What changes if an axis has one value instead of another, for each seed and averaged over everything else.
    /// A seed that lacks a run does not count.
    pub fn changes(
        self,
        axis: &str,
        [value, base]: [&str; 2],
        of: impl Fn(&Run) -> Option<f64>,
    ) -> Vec<f64> {
        let key = |run: &'a Run| (run.law(), run.text("pressure"));
        let of_seed = |seed: &&str| -> Option<f64> {
            let own = |value| {
                let runs = self.runs();
                runs.filter(move |run| run.seed() == *seed && run.text(axis) == value)
            };
            let change = |run: &'a Run| {
                let mut others = own(base);
                Some(of(run)? - of(others.find(|other| key(other) == key(run))?)?)
            };
            let changes: Option<Vec<f64>> = own(value).map(change).collect();
            Mean::of(&changes?).map(|mean| mean.mean)
        };
        self.seeds().iter().filter_map(of_seed).collect()
    }
}
