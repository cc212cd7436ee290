//! Bond-based peridynamics in the plane, from its definitions.

pub mod constants;
pub mod elastic;

/// A weight as a function of the reference length over the horizon.
pub type WeightFunction = fn(f64) -> f64;

/// The weights: constant, conic, parabolic.
pub const WEIGHTS: [(&str, WeightFunction); 3] = [
    ("constant", |_| 1.0),
    ("conic", |ratio| 1.0 - ratio),
    ("parabolic", |ratio| 1.0 - ratio * ratio),
];
