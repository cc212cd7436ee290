//! Vectors and the box.

mod domain;
mod metric;
mod vector;

pub use domain::{Domain, WithMetric};
pub use metric::{Metric, Open, PeriodicX};
pub use vector::Vec2;
