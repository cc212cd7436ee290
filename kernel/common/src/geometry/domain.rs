//! The box in which particles move.

use super::{Metric, Open, PeriodicX, Vec2};

/// The box: its side lengths, if given, and whether x is periodic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// Horizontal side in m.
    pub width: Option<f64>,
    /// Vertical side in m.
    pub height: Option<f64>,
    /// Whether x is periodic; the period is the width.
    pub periodic: bool,
}

/// An operation on positions, compiled for each metric.
pub trait WithMetric {
    /// Result of the operation.
    type Output;
    /// Run the operation with a metric.
    fn call<M: Metric>(self, metric: M) -> Self::Output;
}

impl Domain {
    /// Period in x in m, if x is periodic.
    pub fn period(&self) -> Option<f64> {
        self.width.filter(|_| self.periodic)
    }

    /// Run an operation with the metric of the box. The only place that selects a metric.
    #[inline]
    pub fn with_metric<A: WithMetric>(&self, action: A) -> A::Output {
        match self.period() {
            Some(length) => action.call(PeriodicX { length }),
            None => action.call(Open),
        }
    }

    /// Displacement between two points. For occasional use: passes over pairs select the metric once.
    pub fn displacement(&self, from: Vec2, to: Vec2) -> Vec2 {
        self.with_metric(Displacement { from, to })
    }
}

struct Displacement {
    from: Vec2,
    to: Vec2,
}

impl WithMetric for Displacement {
    type Output = Vec2;
    #[inline]
    fn call<M: Metric>(self, metric: M) -> Vec2 {
        metric.displacement(self.from, self.to)
    }
}
