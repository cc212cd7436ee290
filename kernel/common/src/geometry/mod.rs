//! The plane and the box: vectors and distances.

mod domain;
mod metric;
mod vector;

pub use domain::{Domain, WithMetric};
pub use metric::{Metric, Open, PeriodicX};
pub use vector::Vec2;
