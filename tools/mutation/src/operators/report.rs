//! Prints the number of detected mutants.

use super::mutant::{Kind, Mutant};
use crate::results::{Fate, Results};
use crate::{Outcome, campaign};
use statrs::distribution::{Beta, ContinuousCDF};
use std::process::ExitCode;

/// Print the survivors, the numbers per kind and the proportion of detected mutants.
///
/// # Errors
/// Only if the distribution of the confidence interval rejects the numbers, which does not happen.
pub fn print(
    all: usize,
    sample: &[Mutant],
    viable: &[Mutant],
    results: &Results,
) -> Outcome<ExitCode> {
    let survivors = campaign::print_survivors(viable, results);
    let detected = viable.len() - survivors;
    println!(
        "\n{:12} {:>8} {:>8} {:>8} {:>8}",
        "", "drawn", "viable", "detected", "survived"
    );
    for (kind, name) in Kind::ALL {
        let of = |list: &[Mutant]| list.iter().filter(|one| one.kind == kind).count();
        let is_detected = |one: &&Mutant| results.fate(*one).is_some_and(Fate::is_detected);
        let own = viable.iter().filter(|one| one.kind == kind);
        let detected = own.filter(is_detected).count();
        let (drawn, viable) = (of(sample), of(viable));
        let survived = viable - detected;
        println!("{name:12} {drawn:8} {viable:8} {detected:8} {survived:8}");
    }
    let late = |one: &&Mutant| results.fate(*one) == Some(&Fate::Endless);
    println!(
        "\n{all} mutants in total, {} drawn, {} of these do not compile",
        sample.len(),
        sample.len() - viable.len()
    );
    println!(
        "{detected} of {} detected, {} of these by the time limit, {survivors} survived",
        viable.len(),
        viable.iter().filter(late).count()
    );
    if !viable.is_empty() {
        let [low, high] = interval(detected, viable.len())?.map(|share| 100.0 * share);
        let share = 100.0 * detected as f64 / viable.len() as f64;
        println!("{share:.1} %, 95 % interval {low:.1} to {high:.1} %");
    }
    Ok(if survivors == 0 {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// Clopper-Pearson confidence interval of a proportion, at 95 %.
fn interval(part: usize, whole: usize) -> Outcome<[f64; 2]> {
    let quantile = |a: usize, b: usize, level: f64| -> Outcome<f64> {
        Ok(Beta::new(a as f64, b as f64)?.inverse_cdf(level))
    };
    let low = match part {
        0 => 0.0,
        _ => quantile(part, whole - part + 1, 0.025)?,
    };
    let high = match whole - part {
        0 => 1.0,
        rest => quantile(part + 1, rest, 0.975)?,
    };
    Ok([low, high])
}

#[cfg(test)]
mod tests {
    use super::interval;

    #[test]
    fn the_interval_has_its_closed_form_where_there_is_one() {
        // All of n: the lower end is the n-th root of 0.025. None of n: the mirror image.
        let root = 0.025f64.powf(1.0 / 20.0);
        for (part, expected) in [(20, [root, 1.0]), (0, [0.0, 1.0 - root])] {
            let found = interval(part, 20).unwrap_or_default();
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9, "{found} {expected}");
            }
        }
    }

    #[test]
    fn the_interval_is_that_of_another_program() {
        // binom.test(4, 10) of R: 0.1215523 to 0.7376219.
        let [low, high] = interval(4, 10).unwrap_or_default();
        assert!((low - 0.1215523).abs() < 1e-7 && (high - 0.7376219).abs() < 1e-7);
    }
}
