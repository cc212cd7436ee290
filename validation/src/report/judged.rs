//! How well a check passed: digits where they mean something, and the part of its tolerance that the
//! error used.

use super::{Entry, Record};
use crate::checks::Origin;
use std::cmp::Ordering;

/// Largest tolerance, relative to the expected value, of a check that demands digits: three of them.
const DEMANDING: f64 = 1e-3;

/// Correct digits of a check that demands at least three of them.
///
/// Statistical checks and checks that count wrong cases have none. Neither have those with a wider
/// tolerance, such as observed orders, nor those whose error with respect to zero is in units of
/// rounding.
pub fn digits(record: &Record) -> Option<f64> {
    let distance = (record.measured - record.expected).abs();
    let size = match record.expected.abs() {
        0.0 if distance == record.error => 1.0,
        0.0 => return None,
        size => size,
    };
    let is_exact = record.tolerance_origin == Origin::Exact;
    let demanded = match (record.error > 0.0, distance > 0.0) {
        // The error may be in other units than the values.
        (true, true) => record.tolerance * distance / record.error / size,
        (false, false) if is_exact => 0.0,
        (false, false) => record.tolerance,
        _ => return None,
    };
    let is_counted = record.tolerance_origin != Origin::Statistical
        && record.tolerance > 0.0
        && record.error.is_finite();
    (is_counted && demanded <= DEMANDING).then_some(record.digits)
}

/// Error over tolerance: above one if the check fails, and zero if no error is tolerated and there is
/// none.
pub fn used(record: &Record) -> f64 {
    match record.error / record.tolerance {
        _ if record.error == 0.0 => 0.0,
        ratio if ratio.is_nan() => f64::INFINITY,
        ratio => ratio,
    }
}

/// All checks, failed ones first, then by the part of the tolerance that was used, largest first.
pub fn weakest_first(entries: &[Entry]) -> Vec<&Record> {
    let mut records: Vec<&Record> = entries.iter().map(|entry| &entry.record).collect();
    records.sort_by(|a, b| weaker(a, b));
    records
}

fn weaker(a: &Record, b: &Record) -> Ordering {
    let failed_first = a.passed().cmp(&b.passed());
    failed_first.then_with(|| used(b).total_cmp(&used(a)))
}

/// The checks that demand digits, by their digits, fewest first.
pub fn fewest_digits_first<'a>(
    records: impl IntoIterator<Item = &'a Record>,
) -> Vec<(f64, &'a Record)> {
    let counted = records
        .into_iter()
        .filter_map(|record| Some((digits(record)?, record)));
    let mut counted: Vec<(f64, &Record)> = counted.collect();
    counted.sort_by(|a, b| a.0.total_cmp(&b.0));
    counted
}

/// Fewest and median digits of some checks, with the number of checks that demand digits.
pub struct Digits {
    /// Number of checks with digits.
    pub checks: usize,
    /// Fewest digits.
    pub fewest: f64,
    /// Median; of an even number, the smaller of the two in the middle.
    pub median: f64,
}

impl Digits {
    /// Those of some checks; none if no check demands digits.
    pub fn of<'a>(records: impl IntoIterator<Item = &'a Record>) -> Option<Self> {
        let sorted = fewest_digits_first(records);
        let at = |place: usize| sorted.get(place).map(|(digits, _)| *digits);
        Some(Self {
            checks: sorted.len(),
            fewest: at(0)?,
            median: at((sorted.len() - 1) / 2)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::examples::{entry, record};
    use super::{Digits, digits, used, weakest_first};
    use crate::checks::{Measurement, Origin};

    #[test]
    fn only_checks_that_demand_digits_have_them() {
        let of = |measurement, origin| digits(&record("a.b", measurement, origin));
        let relative = Measurement::relative(2.0, 2.0 + 2e-9, 1e-8);
        assert!(of(relative, Origin::Convergent).is_some_and(|found| (found - 9.0).abs() < 0.01));
        let normalised = Measurement::absolute(0.0, 1e-12, 1e-10);
        assert!(of(normalised, Origin::Exact).is_some_and(|found| (found - 12.0).abs() < 0.01));
        let same = Measurement::ulp(3.0, 3.0, 4.0);
        assert_eq!(of(same, Origin::Exact), Some(16.0));
        let none = [
            (
                Measurement::relative(1.0, 1.0001, 1e-3),
                Origin::Statistical,
            ),
            (Measurement::count(0), Origin::Exact),
            (Measurement::count(2), Origin::Exact),
            // An observed order.
            (Measurement::absolute(2.0, 2.0105, 0.03), Origin::Convergent),
            // An error with respect to zero, in units of rounding.
            (Measurement::scaled(0.0, -1e-16, 2e-16, 4.0), Origin::Exact),
            // A value that is nothing but rounding itself.
            (
                Measurement::scaled(-4e-16, -2e-14, 2e-14, 8.0),
                Origin::Exact,
            ),
            (
                Measurement::absolute(f64::NAN, f64::NAN, 1e-9),
                Origin::Exact,
            ),
        ];
        for (measurement, origin) in none {
            assert_eq!(of(measurement, origin), None, "{measurement:?}");
        }
    }

    #[test]
    fn a_chapter_of_statistics_and_counts_has_no_fewest_digits() {
        let records = [
            record("a.a", Measurement::count(0), Origin::Exact),
            record(
                "a.b",
                Measurement::absolute(0.0, 0.5, 1.0),
                Origin::Statistical,
            ),
        ];
        assert!(Digits::of(&records).is_none());
        let more = [1e-6, 1e-9, 1e-12].map(|error| {
            record(
                "a.c",
                Measurement::absolute(0.0, error, 1e-5),
                Origin::Exact,
            )
        });
        let found = Digits::of(records.iter().chain(&more));
        assert!(found.is_some_and(|found| {
            found.checks == 3
                && (found.fewest - 6.0).abs() < 1e-9
                && (found.median - 9.0).abs() < 1e-9
        }));
    }

    #[test]
    fn failed_checks_come_first_and_then_those_closest_to_failing() {
        let of = |id, error, tolerance| {
            entry(record(
                id,
                Measurement::absolute(0.0, error, tolerance),
                Origin::Exact,
            ))
        };
        let entries = [
            of("fine", 0.1, 1.0),
            of("close", 0.9, 1.0),
            of("counted", 0.0, 0.0),
            of("failed", 1.5, 1.0),
            of("undefined", f64::NAN, 1.0),
            of("wrong", 1.0, 0.0),
            of("closer", 9.9e-9, 1e-8),
        ];
        let order: Vec<&str> = weakest_first(&entries).iter().map(|one| one.id).collect();
        assert_eq!(order[3..], ["closer", "close", "fine", "counted"]);
        assert_eq!(order[2], "failed");
        let wrong = weakest_first(&entries);
        assert!(
            wrong[..3]
                .iter()
                .all(|one| !one.passed() && used(one) > 1.0)
        );
    }
}
