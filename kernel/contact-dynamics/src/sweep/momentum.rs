//! Extrapolation of impulses from sweep to sweep.

use super::Row;
use super::unit::MovingUnit;
use crate::local::Components;
use crate::units::Velocity;

/// What Nesterov's method remembers from one pair of sweeps to the next.
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
    /// Nesterov's sequence: 1, and then half of 1 + (1 + 4 x²)^(1/2) after x.
    sequence: f64,
}

impl Momentum {
    /// Start from impulses and velocities without a history.
    pub fn begin(&mut self, rows: &[Row], units: &[MovingUnit]) {
        let impulses = rows.iter().map(|row| row.impulse);
        self.start.clear();
        self.start.extend(impulses.clone());
        self.last.clear();
        self.last.extend(impulses);
        self.last_velocity.clear();
        self.last_velocity
            .extend(units.iter().map(|unit| unit.velocity));
        self.sequence = 1.0;
    }

    /// Extrapolate impulses and velocities after a pair of sweeps.
    pub fn extrapolate(&mut self, largest: f64, rows: &mut [Row], units: &mut [MovingUnit]) {
        let part = self.part(largest, rows);
        let remembered = self.start.iter_mut().zip(&mut self.last);
        for (row, (start, last)) in rows.iter_mut().zip(remembered) {
            let end = row.impulse;
            row.impulse.n += part * (end.n - last.n);
            row.impulse.t += part * (end.t - last.t);
            (*start, *last) = (row.impulse, end);
        }
        for (unit, last) in units.iter_mut().zip(&mut self.last_velocity) {
            let end = unit.velocity;
            unit.velocity.linear += (end.linear - last.linear) * part;
            unit.velocity.angular += (end.angular - last.angular) * part;
            *last = end;
        }
    }

    /// The part of the last change by which to extrapolate: none if the latest pair of sweeps went against it.
    fn part(&mut self, largest: f64, rows: &[Row]) -> f64 {
        let mut product = 0.0;
        for (row, (start, last)) in rows.iter().zip(self.start.iter().zip(&self.last)) {
            let end = row.impulse;
            product += row.w.nn * (start.n - end.n) * (end.n - last.n)
                + row.w.tt * (start.t - end.t) * (end.t - last.t);
        }
        if product > 0.0 {
            self.sequence = 1.0;
            return 0.0;
        }
        let next = 0.5 * (1.0 + (1.0 + 4.0 * self.sequence * self.sequence).sqrt());
        let part = (self.sequence - 1.0) / next;
        self.sequence = next;
        part.min(largest)
    }
}
