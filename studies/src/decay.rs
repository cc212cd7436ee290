//! Decay of friction after its peak.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use std::f64::consts::GOLDEN_RATIO;

/// Number of decay rates that are tried, evenly in the logarithm, before the best one is refined.
const TRIALS: usize = 60;
/// Number of golden sections: the last interval is a millionth of the first.
const SECTIONS: usize = 30;
/// Number of blocks of residuals, and of resampled series, for the interval of the limit.
const BLOCKS: usize = 20;
const RESAMPLED: usize = 200;
/// Quantile 0.975 of the normal distribution.
const NORMAL: f64 = 1.959_963_984_540_054;

/// The part of thesis eq. (100) after the peak, fitted by least squares:
///
/// mu(t) = D1 + (mu_crit - D1) exp(-D2 (t - t_crit)).
///
/// t_crit and mu_crit are time and value of the largest sample, as the author of the thesis took them.
#[derive(Clone, Debug)]
pub struct Decay {
    /// Time t_crit of the peak in s.
    pub peak_time: f64,
    /// Friction mu_crit at the peak.
    pub peak: f64,
    /// Limit D1 of friction.
    pub limit: f64,
    /// Rate D2 in 1/s, at least one over the time after the peak and at most one over the time between samples.
    pub rate: f64,
    /// Times since the peak in s.
    times: Vec<f64>,
    /// Fitted values less samples.
    residuals: Vec<f64>,
}

impl Decay {
    /// Fit samples of friction; samples that are not finite, from before there was a load, do not count. None if fewer
    /// than `BLOCKS` samples follow the peak.
    pub fn fit(times: &[f64], friction: &[f64]) -> Option<Self> {
        let samples = times.iter().zip(friction);
        let finite: Vec<[f64; 2]> = samples
            .filter(|(_, mu)| mu.is_finite())
            .map(|(&t, &mu)| [t, mu])
            .collect();
        let highest = (0..finite.len()).max_by(|&a, &b| finite[a][1].total_cmp(&finite[b][1]))?;
        let after = &finite[highest..];
        if after.len() <= BLOCKS {
            return None;
        }
        let [peak_time, peak] = after[0];
        let times: Vec<f64> = after.iter().map(|[t, _]| t - peak_time).collect();
        let values: Vec<f64> = after.iter().map(|[_, mu]| *mu).collect();
        let rate = best_rate(&times, &values);
        let limit = limit(&times, &values, rate);
        let residual = |(t, mu): (&f64, &f64)| at([peak, limit, rate], *t) - mu;
        let residuals = times.iter().zip(&values).map(residual).collect();
        Some(Self {
            peak_time,
            peak,
            limit,
            rate,
            times,
            residuals,
        })
    }

    /// Standard deviation of the residuals.
    pub fn deviation(&self) -> f64 {
        let squares: f64 = self.residuals.iter().map(|one| one * one).sum();
        (squares / (self.residuals.len() - 2) as f64).sqrt()
    }

    /// Correlation of neighbouring residuals: about zero if they are independent, as least squares assumes.
    pub fn correlation(&self) -> f64 {
        let squares: f64 = self.residuals.iter().map(|one| one * one).sum();
        let pairs = self.residuals.windows(2).map(|two| two[0] * two[1]);
        pairs.sum::<f64>() / squares
    }

    /// Half the width of the 95 % confidence interval of the limit: the fit is repeated with the residuals drawn in
    /// blocks, so that their correlation counts.
    pub fn limit_margin(&self) -> f64 {
        let number = self.residuals.len();
        let size = number.div_ceil(BLOCKS);
        let mut random = Pcg64::seed_from_u64(0);
        let limits: Vec<f64> = (0..RESAMPLED)
            .map(|_| {
                let blocks = (0..BLOCKS).map(|_| random.random_range(0..=number - size));
                let starts: Vec<usize> = blocks.collect();
                let drawn = |place: usize| self.residuals[starts[place / size] + place % size];
                let value = |(place, &t): (usize, &f64)| match place {
                    0 => self.peak,
                    _ => at([self.peak, self.limit, self.rate], t) - drawn(place),
                };
                let values: Vec<f64> = self.times.iter().enumerate().map(value).collect();
                limit(&self.times, &values, best_rate(&self.times, &values))
            })
            .collect();
        let mean = limits.iter().sum::<f64>() / RESAMPLED as f64;
        let squares: f64 = limits.iter().map(|one| (one - mean).powi(2)).sum();
        NORMAL * (squares / (RESAMPLED - 1) as f64).sqrt()
    }
}

/// Friction at a time after the peak, for peak, limit and rate.
fn at([peak, limit, rate]: [f64; 3], time: f64) -> f64 {
    limit + (peak - limit) * (-rate * time).exp()
}

/// The limit that fits best at a given rate: the model is linear in it. The first value is the peak.
fn limit(times: &[f64], values: &[f64], rate: f64) -> f64 {
    let terms = times.iter().zip(values).map(|(t, mu)| {
        let decayed = (-rate * t).exp();
        let weight = 1.0 - decayed;
        [weight * (mu - values[0] * decayed), weight * weight]
    });
    let [product, square] = terms.fold([0.0; 2], |sum, one| [sum[0] + one[0], sum[1] + one[1]]);
    product / square
}

/// Sum of the squared residuals at a given rate and the limit that fits it best.
fn misfit(times: &[f64], values: &[f64], rate: f64) -> f64 {
    let limit = limit(times, values, rate);
    let residuals = times.iter().zip(values);
    let residuals = residuals.map(|(&t, mu)| at([values[0], limit, rate], t) - mu);
    residuals.map(|one| one * one).sum()
}

/// The rate that fits best, between one over all the time and one over the time between samples.
fn best_rate(times: &[f64], values: &[f64]) -> f64 {
    let span = times[times.len() - 1];
    let low = -span.ln();
    let width = ((times.len() - 1) as f64).ln() / TRIALS as f64;
    let of = |logarithm: f64| misfit(times, values, logarithm.exp());
    let trial = |place: usize| low + width * place as f64;
    let best = (0..=TRIALS).min_by(|&a, &b| of(trial(a)).total_cmp(&of(trial(b))));
    let best = best.unwrap_or_default();
    let mut ends = [trial(best.saturating_sub(1)), trial((best + 1).min(TRIALS))];
    for _ in 0..SECTIONS {
        let part = (ends[1] - ends[0]) / GOLDEN_RATIO;
        let inner = [ends[1] - part, ends[0] + part];
        match of(inner[0]) < of(inner[1]) {
            true => ends[1] = inner[1],
            false => ends[0] = inner[0],
        }
    }
    (0.5 * (ends[0] + ends[1])).exp()
}
