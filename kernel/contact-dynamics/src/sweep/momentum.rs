//! Extrapolation of impulses from sweep to sweep.

use super::Row;
use crate::local::Components;
use crate::units::Velocity;

/// What Nesterov's method remembers of some points and units from one pair of sweeps to the next.
///
/// Velocities are extrapolated with the impulses. Both stay consistent, because velocities are a linear function of
/// impulses and the weights of an extrapolation add up to one.
#[derive(Clone, Debug, Default)]
pub(super) struct Momentum {
    /// Impulses from which the latest pair of sweeps started.
    start: Vec<Components>,
    /// Impulses after the pair of sweeps before it.
    last: Vec<Components>,
    last_velocity: Vec<Velocity>,
}

impl Momentum {
    /// Start from impulses and velocities without a history.
    pub fn begin(&mut self, rows: &[Row], velocities: impl Iterator<Item = Velocity>) {
        let impulses = rows.iter().map(|row| row.impulse);
        self.start.clear();
        self.start.extend(impulses.clone());
        self.last.clear();
        self.last.extend(impulses);
        self.last_velocity.clear();
        self.last_velocity.extend(velocities);
    }

    /// Forget everything, and make room for a number of points, and as many units.
    pub fn clear(&mut self, room: usize) {
        self.start.clear();
        self.start.reserve(room);
        self.last.clear();
        self.last.reserve(room);
        self.last_velocity.clear();
        self.last_velocity.reserve(room);
    }

    /// How far the latest pair of sweeps went against the change before it; negative if it went along.
    pub fn product(&self, rows: &[Row]) -> f64 {
        let mut product = 0.0;
        for (row, (start, last)) in rows.iter().zip(self.start.iter().zip(&self.last)) {
            let end = row.impulse;
            product += row.w.nn * (start.n - end.n) * (end.n - last.n)
                + row.w.tt * (start.t - end.t) * (end.t - last.t);
        }
        product
    }

    /// Extrapolate impulses by a part of their last change.
    pub fn move_rows(&mut self, part: f64, rows: &mut [Row]) {
        let remembered = self.start.iter_mut().zip(&mut self.last);
        for (row, (start, last)) in rows.iter_mut().zip(remembered) {
            let end = row.impulse;
            row.impulse.n += part * (end.n - last.n);
            row.impulse.t += part * (end.t - last.t);
            (*start, *last) = (row.impulse, end);
        }
    }

    /// The velocity of a unit, extrapolated by a part of its last change.
    #[inline(always)]
    pub fn moved(&mut self, part: f64, unit: usize, end: Velocity) -> Velocity {
        let last = core::mem::replace(&mut self.last_velocity[unit], end);
        Velocity {
            linear: end.linear + (end.linear - last.linear) * part,
            angular: end.angular + (end.angular - last.angular) * part,
        }
    }
}

/// Nesterov's sequence: 1, and then half of 1 + (1 + 4 x²)^(1/2) after x.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sequence(f64);

impl Default for Sequence {
    fn default() -> Self {
        Self(1.0)
    }
}

impl Sequence {
    /// The part of the last change by which to extrapolate, at most `largest`: none if the latest pair of sweeps went
    /// against it, which a positive product says.
    pub fn next(&mut self, largest: f64, product: f64) -> f64 {
        if product > 0.0 {
            self.0 = 1.0;
            return 0.0;
        }
        let next = 0.5 * (1.0 + (1.0 + 4.0 * self.0 * self.0).sqrt());
        let part = (self.0 - 1.0) / next;
        self.0 = next;
        part.min(largest)
    }
}
