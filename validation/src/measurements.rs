//! The measurements of `benches/runs/`, which are compiled into the program.

use include_dir::{Dir, include_dir};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use statrs::distribution::{Binomial, ContinuousCDF, DiscreteCDF, StudentsT};
use statrs::statistics::Statistics;
use statrs::stats_tests::ttest_onesample::ttest_onesample;
use statrs::stats_tests::{Alternative, NaNPolicy};

/// The files, named by date and kind.
pub static RUNS: Dir = include_dir!("$CARGO_MANIFEST_DIR/../benches/runs");

/// The latest run of a kind and its date.
pub fn latest<Run: DeserializeOwned>(kind: &str) -> Option<(String, Run)> {
    let (date, bytes) = newest(&format!("-{kind}.json"))?;
    Some((date, serde_json::from_slice(bytes).ok()?))
}

/// The latest file whose name has the given ending, and the rest of its name, which is the date.
fn newest(ending: &str) -> Option<(String, &'static [u8])> {
    let files = RUNS.files().filter_map(|file| {
        let name = file.path().file_name()?.to_str()?;
        Some((name.strip_suffix(ending)?.to_owned(), file.contents()))
    });
    files.max_by(|a, b| a.0.cmp(&b.0))
}

/// The quantile for a probability; undefined for an empty sample.
pub fn quantile(sample: &[f64], probability: f64) -> f64 {
    let mut sorted = sample.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = probability * sorted.len().saturating_sub(1) as f64;
    sorted
        .get(place.round() as usize)
        .copied()
        .unwrap_or(f64::NAN)
}

/// Median and quartiles as text.
pub fn spread(sample: &[f64], digits: usize) -> String {
    let [low, middle, high] = [0.25, 0.5, 0.75].map(|probability| quantile(sample, probability));
    format!("{middle:.digits$} ({low:.digits$} to {high:.digits$})")
}

/// Ratios of neighbouring alternating runs.
pub fn ratios(sample: &[f64], other: &[f64]) -> Vec<f64> {
    sample.iter().zip(other).map(|(a, b)| a / b).collect()
}

/// A run of the small fault, as written by `gouge-bench inertia`.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct FrictionRun {
    /// Seed of the packing and of the strengths.
    pub seed: u64,
    /// Moment of inertia in m r^2.
    pub inertia_factor: f64,
    /// Mean coefficient of friction from the load during sliding.
    pub friction_load: f64,
    /// Mean coefficient of friction from the reaction during sliding.
    pub friction_feedback: f64,
    /// Number of broken bonds.
    pub bonds_broken: f64,
}

/// The latest runs of the small fault and their date.
pub fn friction_runs() -> Option<(String, Vec<FrictionRun>)> {
    let (date, bytes) = newest("-inertia.csv")?;
    let rows: Result<Vec<FrictionRun>, _> = csv::Reader::from_reader(bytes).deserialize().collect();
    Some((date, rows.ok()?))
}

/// Differences of a quantity between two runs of each seed.
#[derive(Clone, Debug)]
pub struct Paired {
    differences: Vec<f64>,
}

impl Paired {
    /// From the differences.
    pub fn new(differences: Vec<f64>) -> Self {
        Self { differences }
    }

    /// Number of pairs.
    pub fn number(&self) -> usize {
        self.differences.len()
    }

    /// Mean difference.
    pub fn mean(&self) -> f64 {
        self.differences.iter().mean()
    }

    /// Confidence interval of the mean at the given level, by Student's distribution; undefined for
    /// fewer than two pairs.
    pub fn interval(&self, level: f64) -> [f64; 2] {
        let number = self.differences.len() as f64;
        let error = self.differences.iter().std_dev() / number.sqrt();
        let half = StudentsT::new(0.0, 1.0, number - 1.0).map_or(f64::NAN, |student| {
            student.inverse_cdf(0.5 + 0.5 * level) * error
        });
        [self.mean() - half, self.mean() + half]
    }

    /// Probability of a mean at least as far from zero if there were no difference, by the t test.
    pub fn p_by_t(&self) -> f64 {
        let test = ttest_onesample(
            self.differences.clone(),
            0.0,
            Alternative::TwoSided,
            NaNPolicy::Propogate,
        );
        test.map_or(f64::NAN, |(_, p)| p)
    }

    /// Probability of signs at least as unequal if there were no difference, by the sign test; pairs
    /// without a difference do not count.
    pub fn p_by_signs(&self) -> f64 {
        let count = |is: fn(&&f64) -> bool| self.differences.iter().filter(is).count() as u64;
        let (above, below) = (count(|d| **d > 0.0), count(|d| **d < 0.0));
        Binomial::new(0.5, above + below).map_or(f64::NAN, |coins| {
            (2.0 * coins.cdf(above.min(below))).min(1.0)
        })
    }
}
