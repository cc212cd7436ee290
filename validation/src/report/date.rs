//! The date of a report.

use std::time::{SystemTime, UNIX_EPOCH};

/// Today's date in UTC, as year-month-day.
pub fn today() -> String {
    let passed = SystemTime::now().duration_since(UNIX_EPOCH);
    let days = passed.map_or(0, |passed| passed.as_secs() / 86_400);
    let [year, month, day] = of_day(days);
    format!("{year}-{month:02}-{day:02}")
}

/// Year, month and day of the Gregorian calendar, from the number of days since 1 January 1970.
fn of_day(mut days: u64) -> [u64; 3] {
    let is_leap =
        |year: u64| year.is_multiple_of(4) && !year.is_multiple_of(100) || year.is_multiple_of(400);
    let mut year = 1970;
    while days >= 365 + u64::from(is_leap(year)) {
        days -= 365 + u64::from(is_leap(year));
        year += 1;
    }
    let february = 28 + u64::from(is_leap(year));
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30] {
        if days < length {
            break;
        }
        days -= length;
        month += 1;
    }
    [year, month, days + 1]
}

#[cfg(test)]
mod tests {
    use super::of_day;

    #[test]
    fn days_have_their_dates() {
        for (day, date) in [
            (0, [1970, 1, 1]),
            (58, [1970, 2, 28]),
            (59, [1970, 3, 1]),
            (364, [1970, 12, 31]),
            (365, [1971, 1, 1]),
            (11_016, [2000, 2, 29]),
            (11_017, [2000, 3, 1]),
            (20_786, [2026, 11, 29]),
            (47_540, [2100, 2, 28]),
            (47_541, [2100, 3, 1]),
        ] {
            assert_eq!(of_day(day), date, "{day}");
        }
    }
}
