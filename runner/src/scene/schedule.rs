//! When a run takes samples.

/// The steps of a run and of its samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Schedule {
    /// Time step in s.
    pub step: f64,
    /// End time in s.
    pub end: f64,
    /// Time between samples in s.
    pub interval: f64,
}

impl Schedule {
    /// Number of steps until the end time.
    pub fn steps(&self) -> u64 {
        steps_for(self.end, self.step)
    }

    /// Step of a sample, counted from zero; the last step is always sampled.
    pub fn sample_step(&self, sample: u64) -> u64 {
        self.regular_sample_step(sample).min(self.steps())
    }

    /// Step of a sample if the scene had no end.
    pub fn regular_sample_step(&self, sample: u64) -> u64 {
        let exact = sample as f64 * self.interval / self.step;
        (exact.round() as u64).max(sample)
    }

    /// Time of a sample in s.
    pub fn sample_time(&self, sample: u64) -> f64 {
        self.sample_step(sample) as f64 * self.step
    }
}

/// Number of steps that cover a duration: the quotient if it is an integer up to rounding, otherwise rounded up.
pub fn steps_for(duration: f64, step: f64) -> u64 {
    let exact = duration / step;
    let nearest = exact.round();
    let steps = if (exact - nearest).abs() < 1e-6 {
        nearest
    } else {
        exact.ceil()
    };
    steps as u64
}
