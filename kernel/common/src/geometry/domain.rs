//! The box in which particles move.

use super::{Metric, Open, PeriodicX, Vec2};

/// The box: its boundary and, where known, its sides in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// Horizontal side in m.
    pub width: Option<f64>,
    /// Vertical side in m.
    pub height: Option<f64>,
    /// Whether x is periodic with the width.
    pub periodic: bool,
}

/// Something to do with the metric of a box, compiled for each metric.
pub trait WithMetric {
    /// What it returns.
    type Output;
    /// Do it.
    fn call<M: Metric>(self, metric: M) -> Self::Output;
}

impl Domain {
    /// The periodic width in m, if x is periodic.
    pub fn period(&self) -> Option<f64> {
        self.width.filter(|_| self.periodic)
    }

    /// Call an action with the metric of the box: the only place that chooses one.
    #[inline]
    pub fn with_metric<A: WithMetric>(&self, action: A) -> A::Output {
        match self.period() {
            Some(length) => action.call(PeriodicX { length }),
            None => action.call(Open),
        }
    }

    /// Displacement from one point to another, for occasional use; passes choose the metric once.
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
