//! A distribution given by some of its quantiles.

/// A distribution whose cumulative distribution is linear between given points.
///
/// Equal values at different probabilities are values that occur with the difference as probability; equal
/// probabilities at different values leave a gap between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Tabulated {
    /// Values, not decreasing.
    pub values: Vec<f64>,
    /// Probabilities of a value not greater than each of them: not decreasing, from 0 to 1.
    pub probabilities: Vec<f64>,
}

impl Tabulated {
    /// Value below which the variable lies with a probability in [0, 1).
    pub fn quantile(&self, probability: f64) -> f64 {
        let (x, p) = (&self.values, &self.probabilities);
        // The first point above the probability; the one before is not above it.
        let above = p
            .partition_point(|&one| one <= probability)
            .min(p.len() - 1);
        let below = above.saturating_sub(1);
        let width = p[above] - p[below];
        let share = match width > 0.0 {
            true => (probability - p[below]) / width,
            false => 1.0,
        };
        x[below] + share * (x[above] - x[below])
    }
}
