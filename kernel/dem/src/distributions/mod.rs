//! Probability distributions of sizes and strengths in closed form, thesis appendices B, E and F.

mod number;
mod strength;
mod tabulated;
mod uniform;
mod weibull;

pub use number::{
    DENSEST_DISCS, DENSEST_SPHERES, discs_in_square, spheres_in_cube, spheres_per_disc,
};
pub use strength::{Power, WeakestProduct};
pub use tabulated::Tabulated;
pub use uniform::{Uniform, UniformProduct, UniformSum, crystallises, relative_deviation_of_ratio};
pub use weibull::Weibull;

/// A continuous random variable.
pub trait Distribution {
    /// Probability density.
    fn density(&self, x: f64) -> f64;
    /// Cumulative distribution: probability of a value not greater than x.
    fn cumulative(&self, x: f64) -> f64;
}
