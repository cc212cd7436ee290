//! The measurements of `benches/runs/`, which the program carries with it.

use include_dir::{Dir, include_dir};
use serde::de::DeserializeOwned;

/// The files, named by date and kind.
pub static RUNS: Dir = include_dir!("$CARGO_MANIFEST_DIR/../benches/runs");

/// The latest run of a kind and its date.
pub fn latest<Run: DeserializeOwned>(kind: &str) -> Option<(String, Run)> {
    let ending = format!("-{kind}.json");
    let files = RUNS.files().filter_map(|file| {
        let name = file.path().file_name()?.to_str()?;
        Some((name.strip_suffix(&ending)?.to_owned(), file))
    });
    let (date, file) = files.max_by(|a, b| a.0.cmp(&b.0))?;
    Some((date, serde_json::from_slice(file.contents()).ok()?))
}

/// The quantile of a probability; undefined for nothing.
pub fn quantile(sample: &[f64], probability: f64) -> f64 {
    let mut sorted = sample.to_vec();
    sorted.sort_by(f64::total_cmp);
    let place = probability * sorted.len().saturating_sub(1) as f64;
    sorted
        .get(place.round() as usize)
        .copied()
        .unwrap_or(f64::NAN)
}

/// Median and quartiles in words.
pub fn spread(sample: &[f64], digits: usize) -> String {
    let [low, middle, high] = [0.25, 0.5, 0.75].map(|probability| quantile(sample, probability));
    format!("{middle:.digits$} ({low:.digits$} to {high:.digits$})")
}

/// Ratios of neighbouring turns.
pub fn ratios(sample: &[f64], other: &[f64]) -> Vec<f64> {
    sample.iter().zip(other).map(|(a, b)| a / b).collect()
}
