//! Seeded random inputs for checks.

use rand::RngExt;
use rand_pcg::Pcg64;

/// A stream of random numbers, the same in every run.
pub struct Random(Pcg64);

impl Random {
    /// The stream of the given seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64::new(u128::from(seed), 0xa02b_dbf7_bb3c_0a7a))
    }
    /// Uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.0.random::<f64>()
    }
    /// Uniform in its logarithm, in [low, high); both positive.
    pub fn magnitude(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
    /// A magnitude of either sign.
    pub fn signed(&mut self, low: f64, high: f64) -> f64 {
        let size = self.magnitude(low, high);
        if self.0.random::<bool>() { size } else { -size }
    }
    /// A whole number below a bound.
    pub fn below(&mut self, bound: usize) -> usize {
        self.0.random_range(0..bound)
    }
    /// One of several values.
    pub fn choice<T: Copy>(&mut self, of: &[T]) -> T {
        of[self.below(of.len())]
    }
}
