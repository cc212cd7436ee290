//! Sweeps over points in the order in which they were given.

use super::Row;
use super::changes::Changes;
use super::iteration::Sweeping;
use super::momentum::{Momentum, Sequence};
use super::residual::{larger, natural_map};
use super::unit::{MovingUnit, scatter};
use super::visit::Visit;
use crate::units::Velocity;

/// Points in the order in which they were given.
pub(super) struct Plain<'a> {
    pub rows: &'a mut [Row],
    pub units: &'a mut [MovingUnit],
    pub momentum: &'a mut Momentum,
    pub velocities: &'a mut [Velocity],
    pub sequence: Sequence,
}

impl Sweeping for Plain<'_> {
    fn begin_momentum(&mut self) {
        self.sequence = Sequence::default();
        let velocities = self.units.iter().map(|unit| unit.velocity);
        self.momentum.begin(self.rows, velocities);
    }

    fn extrapolate(&mut self, largest: f64) {
        let product = self.momentum.product(self.rows);
        let by = self.sequence.next(largest, product);
        self.momentum.move_rows(by, self.rows);
        for (index, unit) in self.units.iter_mut().enumerate() {
            unit.velocity = self.momentum.moved(by, index, unit.velocity);
        }
    }

    fn sweep(&mut self, visit: Visit) -> Changes {
        visit.run(self.rows, &mut *self.units)
    }

    fn residual(&mut self, friction: f64) -> f64 {
        scatter(self.units, self.velocities);
        largest_residual(self.rows, friction, self.velocities)
    }
}

/// Largest residual of the laws over all points in m/s.
pub(super) fn largest_residual(rows: &[Row], friction: f64, velocities: &[Velocity]) -> f64 {
    rows.iter().fold(0.0, |largest, row| {
        let units = row.kinematics.units.map(|unit| velocities[unit as usize]);
        larger(largest, natural_map(row, friction, units))
    })
}
