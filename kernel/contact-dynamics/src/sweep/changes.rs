//! What a sweep changed, and whether that is little enough.

use super::StopCriterion;
use crate::local::Components;

/// Changes during one sweep.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Changes {
    largest: f64,
    largest_relative: f64,
    sum: f64,
    positive: usize,
}

impl Changes {
    /// Book a visit. `floor` is the smallest denominator of relative changes; they are booked only if `IS_RELATIVE`.
    #[inline(always)]
    pub fn add<const IS_RELATIVE: bool>(
        &mut self,
        change: Components,
        impulse: Components,
        floor: f64,
    ) {
        let size = larger(change.n.abs(), change.t.abs());
        self.largest = larger(self.largest, size);
        if IS_RELATIVE && size > 0.0 {
            let reference = larger(larger(impulse.n.abs(), impulse.t.abs()), floor);
            self.largest_relative = larger(self.largest_relative, size / reference);
        }
        // Normal impulses are not negative.
        self.sum += impulse.n;
        self.positive += usize::from(impulse.n > 0.0);
    }

    /// Book the changes of other points of the same sweep.
    pub fn join(&mut self, other: &Self) {
        self.largest = larger(self.largest, other.largest);
        self.largest_relative = larger(self.largest_relative, other.largest_relative);
        self.sum += other.sum;
        self.positive += other.positive;
    }

    /// Mean positive normal impulse in kg m/s.
    pub fn mean(&self) -> f64 {
        self.sum / self.positive.max(1) as f64
    }

    /// Whether the changes satisfy a criterion that is about changes.
    pub fn are_small(&self, stop: StopCriterion) -> bool {
        match stop {
            StopCriterion::Increment { tolerance, floor } => {
                self.largest <= tolerance * self.mean().max(floor)
            }
            StopCriterion::Relative { tolerance, .. } => self.largest_relative <= tolerance,
            StopCriterion::NaturalMap { .. } => false,
        }
    }
}

/// The larger of two numbers; the first one unless the second is larger. One instruction.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}
