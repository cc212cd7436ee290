//! Velocities and inverse masses side by side, so that a visit of a point reads one cache line per unit.

use crate::units::{InverseMass, Velocity};

/// A unit as the sweep sees it. One cache line.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(align(64))]
pub(super) struct MovingUnit {
    pub velocity: Velocity,
    pub inverse: InverseMass,
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
