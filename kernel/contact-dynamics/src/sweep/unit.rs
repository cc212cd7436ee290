//! Velocities and inverse masses side by side, so that a visit of a point reads one cache line per unit.

use crate::units::{InverseMass, Velocity};
use core::sync::atomic::{AtomicU64, Ordering};
use gouge_common::geometry::Vec2;

/// A unit as the sweep sees it. One cache line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub(super) struct MovingUnit {
    pub velocity: Velocity,
    pub inverse: InverseMass,
}

/// A unit that several threads may reach, one after the other. One cache line.
#[derive(Debug, Default)]
#[repr(align(64))]
pub(super) struct SharedUnit {
    velocity: [AtomicU64; 3],
    inverse: InverseMass,
}

/// Units that a sweep changes.
pub(super) trait Units {
    /// A unit.
    fn get(&self, index: usize) -> MovingUnit;
    /// Change the velocity of a unit.
    fn set(&mut self, index: usize, velocity: Velocity);
}

impl Units for &mut [MovingUnit] {
    #[inline(always)]
    fn get(&self, index: usize) -> MovingUnit {
        self[index]
    }

    #[inline(always)]
    fn set(&mut self, index: usize, velocity: Velocity) {
        self[index].velocity = velocity;
    }
}

impl Units for &[SharedUnit] {
    #[inline(always)]
    fn get(&self, index: usize) -> MovingUnit {
        let unit = &self[index];
        MovingUnit {
            velocity: unit.velocity(),
            inverse: unit.inverse,
        }
    }

    #[inline(always)]
    fn set(&mut self, index: usize, velocity: Velocity) {
        self[index].set_velocity(velocity);
    }
}

impl SharedUnit {
    /// A unit with a velocity.
    pub fn new(velocity: Velocity, inverse: InverseMass) -> Self {
        let Velocity { linear, angular } = velocity;
        Self {
            velocity: [linear.x, linear.y, angular].map(|v| AtomicU64::new(v.to_bits())),
            inverse,
        }
    }

    /// Its velocity.
    #[inline(always)]
    pub fn velocity(&self) -> Velocity {
        let number = |index: usize| f64::from_bits(self.velocity[index].load(Ordering::Relaxed));
        Velocity {
            linear: Vec2::new(number(0), number(1)),
            angular: number(2),
        }
    }

    /// Change its velocity.
    #[inline(always)]
    pub fn set_velocity(&self, velocity: Velocity) {
        let Velocity { linear, angular } = velocity;
        for (cell, number) in self.velocity.iter().zip([linear.x, linear.y, angular]) {
            cell.store(number.to_bits(), Ordering::Relaxed);
        }
    }
}

/// Join the columns.
pub(super) fn gather(
    units: &mut Vec<MovingUnit>,
    velocities: &[Velocity],
    inverse_masses: &[InverseMass],
) {
    units.clear();
    let join = |(&velocity, &inverse)| MovingUnit { velocity, inverse };
    units.extend(velocities.iter().zip(inverse_masses).map(join));
}

/// Write the velocities back.
pub(super) fn scatter(units: &[MovingUnit], velocities: &mut [Velocity]) {
    for (velocity, unit) in velocities.iter_mut().zip(units) {
        *velocity = unit.velocity;
    }
}
