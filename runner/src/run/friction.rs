//! The coefficient of friction of a whole run, with its uncertainty.

use serde::{Deserialize, Serialize};

/// Number of blocks into which the samples are divided.
pub const BLOCKS: usize = 10;
/// Quantile 0.975 of Student's distribution with `BLOCKS - 1` degrees of freedom.
const STUDENT: f64 = 2.262_157_162_740_992;
/// Least slip in units of the mean radius.
const SLIDING: f64 = 0.01;
/// Correlation of neighbouring blocks above which they are not independent; of independent ones, 95 % are below.
const CORRELATED: f64 = 0.5;

/// Coefficient of friction of a driven block that slides, averaged over the second half of a run.
///
/// $$ \mu = \frac{\int F^x \bar v^x \, dt}{\int L \bar v^x \, dt} $$
///
/// $F^x$ is the horizontal driving force in N, $L$ the load in N (minus the vertical driving force, positive if it
/// presses), and $\bar v^x$ the mean horizontal velocity of the driven grains in m/s. The integrals count every step,
/// whereas a sample of the forces is a snapshot.
///
/// The interval is that of the mean of ten blocks, by Student's distribution. It is valid if blocks are long compared
/// with the time over which friction remembers its past, which `correlation` tells.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Friction {
    /// Coefficient of friction.
    pub coefficient: f64,
    /// Confidence interval of the coefficient, 95 %.
    pub interval: [f64; 2],
    /// Time in s from which on samples count.
    pub since: f64,
    /// Slip in m since then.
    pub slip: f64,
    /// Correlation of neighbouring blocks.
    pub correlation: f64,
    /// Mean of the instantaneous coefficients of the same samples, thesis (85).
    pub samples_mean: f64,
    /// Standard deviation of the instantaneous coefficients.
    pub samples_deviation: f64,
}

/// What a sample says about the drive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriveSample {
    /// Time in s.
    pub time: f64,
    /// Work of the horizontal driving force so far in J.
    pub shearing: f64,
    /// Integral of the load over the slip so far in J.
    pub sliding: f64,
    /// Mean horizontal velocity of the driven grains in m/s.
    pub velocity: f64,
    /// Instantaneous coefficient of friction, thesis (85).
    pub coefficient: f64,
}

impl DriveSample {
    /// The sample as numbers, for a checkpoint.
    pub fn numbers(&self) -> [f64; 5] {
        [
            self.time,
            self.shearing,
            self.sliding,
            self.velocity,
            self.coefficient,
        ]
    }

    /// The sample that [`DriveSample::numbers`] stored.
    pub fn of_numbers([time, shearing, sliding, velocity, coefficient]: [f64; 5]) -> Self {
        Self {
            time,
            shearing,
            sliding,
            velocity,
            coefficient,
        }
    }
}

/// Sums over the time between samples.
#[derive(Clone, Copy, Default)]
struct Stretch {
    work: f64,
    load_slip: f64,
    slip: f64,
}

impl Friction {
    /// The friction that the samples of a run show, for grains of a mean radius in m; none if the block is not pressed
    /// all the time, if it slides by less than a hundredth of the radius, or if there are fewer than two samples per
    /// block.
    pub fn of(samples: &[DriveSample], radius: f64) -> Option<Self> {
        let half = 0.5 * (samples.first()?.time + samples.last()?.time);
        let late = samples.iter().copied().filter(|one| one.time >= half);
        let rows: Vec<DriveSample> = late.collect();
        let size = rows.len().saturating_sub(1) / BLOCKS;
        if size < 2 {
            return None;
        }
        let rows = &rows[rows.len() - 1 - size * BLOCKS..];
        let stretches: Vec<Stretch> = rows
            .windows(2)
            .map(|pair| stretch(&pair[0], &pair[1]))
            .collect();
        let blocks: Vec<Stretch> = stretches.chunks(size).map(total).collect();
        let whole = total(&blocks);
        // Of a block that is pressed, load times slip has the sign of the slip.
        let is_pressed = |block: &Stretch| block.load_slip * block.slip > 0.0;
        if whole.slip.abs() < SLIDING * radius || !blocks.iter().all(is_pressed) {
            return None;
        }
        let coefficient = whole.work / whole.load_slip;
        let means: Vec<f64> = blocks.iter().map(|one| one.work / one.load_slip).collect();
        let (mean, deviation) = mean_and_deviation(&means);
        let margin = STUDENT * deviation / (BLOCKS as f64).sqrt();
        let samples: Vec<f64> = rows.iter().map(|row| row.coefficient).collect();
        let (samples_mean, samples_deviation) = mean_and_deviation(&samples);
        Some(Self {
            coefficient,
            interval: [coefficient - margin, coefficient + margin],
            since: rows[0].time,
            slip: whole.slip,
            correlation: correlation(&means, mean),
            samples_mean,
            samples_deviation,
        })
    }

    /// Whether the blocks depend on each other, so that the interval is too narrow.
    pub fn is_correlated(&self) -> bool {
        self.correlation > CORRELATED
    }
}

/// Work, load times slip, and slip between two samples.
fn stretch(before: &DriveSample, after: &DriveSample) -> Stretch {
    Stretch {
        work: after.shearing - before.shearing,
        load_slip: after.sliding - before.sliding,
        slip: 0.5 * (before.velocity + after.velocity) * (after.time - before.time),
    }
}

fn total(stretches: &[Stretch]) -> Stretch {
    stretches
        .iter()
        .fold(Stretch::default(), |sum, one| Stretch {
            work: sum.work + one.work,
            load_slip: sum.load_slip + one.load_slip,
            slip: sum.slip + one.slip,
        })
}

fn mean_and_deviation(values: &[f64]) -> (f64, f64) {
    let number = values.len() as f64;
    let mean = values.iter().sum::<f64>() / number;
    let squares: f64 = values.iter().map(|one| (one - mean).powi(2)).sum();
    (mean, (squares / (number - 1.0)).sqrt())
}

/// Correlation of each value with the next one; zero for equal values.
fn correlation(values: &[f64], mean: f64) -> f64 {
    let squares: f64 = values.iter().map(|one| (one - mean).powi(2)).sum();
    let pairs = values
        .windows(2)
        .map(|two| (two[0] - mean) * (two[1] - mean));
    match squares > 0.0 {
        true => pairs.sum::<f64>() / squares,
        false => 0.0,
    }
}
