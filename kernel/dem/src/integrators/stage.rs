//! A stage of an integration method, and the loop that applies it to all particles.

use core::ops::{Add, AddAssign, Mul, Sub};
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::neighbors::Staleness;
use gouge_common::parts::{PartTask, Work, split_or_empty};
use gouge_common::scalar::Real;

/// Type of a coordinate: a vector for translations, a number for rotations.
pub(crate) trait Coordinate<S>:
    Copy
    + Default
    + Send
    + Sync
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<S, Output = Self>
    + AddAssign
{
}
impl<S: Real> Coordinate<S> for Vec2<S> {}
impl<S: Real> Coordinate<S> for S {}

/// Translations or rotations of all particles, as columns of equal length.
pub(crate) struct Motion<'a, V, S> {
    /// Positions in m or angles in rad.
    pub coordinate: &'a mut [V],
    /// Velocities in m/s or rad/s.
    pub velocity: &'a mut [V],
    /// Forces in N or torques in N m.
    pub force: &'a [V],
    /// Inverse masses in 1/kg or moments of inertia in 1/(kg m^2), zero for fixed particles.
    pub inverse_inertia: &'a [S],
    /// Forces or accelerations of the previous evaluation.
    pub previous: &'a mut [V],
    /// Accelerations one evaluation earlier, for methods that keep them.
    pub older: &'a mut [V],
}

/// A stage of a method: changes coordinates and velocities under given forces.
///
/// Accelerations are forces times inverse inertias, thesis eq. (51).
pub(crate) trait Stage {
    /// Whether the stage changes coordinates.
    const MOVES: bool = true;
    /// Whether the forces are kept as those of the previous evaluation when the stage is finished. The buffers are
    /// swapped: the next evaluation adds to the old buffer of previous forces, which must be zero.
    const KEEPS_FORCES: bool = false;
    /// Apply the stage with a time step in s.
    fn advance<V: Coordinate<S>, S: Real>(motion: Motion<V, S>, step: f64);
}

impl<V, S> Motion<'_, V, S> {
    /// Reborrows for a shorter lifetime.
    #[inline(always)]
    fn reborrow(&mut self) -> Motion<'_, V, S> {
        Motion {
            coordinate: self.coordinate,
            velocity: self.velocity,
            force: self.force,
            inverse_inertia: self.inverse_inertia,
            previous: self.previous,
            older: self.older,
        }
    }
    #[inline(always)]
    fn split_at(self, at: usize) -> (Self, Self) {
        let (coordinate, other_coordinate) = split_or_empty(self.coordinate, at);
        let (velocity, other_velocity) = split_or_empty(self.velocity, at);
        let (force, other_force) = self.force.split_at(at);
        let (inverse_inertia, other_inertia) = self.inverse_inertia.split_at(at);
        let (previous, other_previous) = split_or_empty(self.previous, at);
        let (older, other_older) = split_or_empty(self.older, at);
        (
            Self {
                coordinate,
                velocity,
                force,
                inverse_inertia,
                previous,
                older,
            },
            Self {
                coordinate: other_coordinate,
                velocity: other_velocity,
                force: other_force,
                inverse_inertia: other_inertia,
                previous: other_previous,
                older: other_older,
            },
        )
    }
}

/// Applies a stage to translations, and to rotations if anything rotates. If the stage changes coordinates, positions
/// are then moved back into the box and the neighbour list is tested.
pub(crate) struct Advance<'a, T, S, M> {
    pub stage: core::marker::PhantomData<fn() -> T>,
    pub step: f64,
    pub linear: Motion<'a, Vec2<S>, S>,
    pub angular: Option<Motion<'a, S, S>>,
    pub staleness: Staleness<'a, S, M>,
}

/// Number of particles that are advanced together: few enough for their columns to stay in the cache.
const CHUNK: usize = 256;

/// Each part returns whether the neighbour list has become stale.
impl<T: Stage, S: Lanes, M: Metric> Work<bool> for Advance<'_, T, S, M> {
    #[inline(always)]
    fn split_at(self, at: usize) -> (Self, Self) {
        let Self {
            stage,
            step,
            linear,
            angular,
            staleness,
        } = self;
        let (linear, other_linear) = linear.split_at(at);
        let (angular, other_angular) = angular.map(|motion| motion.split_at(at)).unzip();
        let (staleness, other_staleness) = staleness.split_at(at);
        let left = Self {
            stage,
            step,
            linear,
            angular,
            staleness,
        };
        let right = Self {
            stage,
            step,
            linear: other_linear,
            angular: other_angular,
            staleness: other_staleness,
        };
        (left, right)
    }

    #[inline(always)]
    fn run_part(self, is_stale: &mut bool, _: Instructions) {
        *is_stale = false;
        let mut rest = self;
        while !rest.linear.coordinate.is_empty() {
            let size = CHUNK.min(rest.linear.coordinate.len());
            let (now, remaining) = rest.split_at(size);
            rest = remaining;
            let Self {
                step,
                mut linear,
                angular,
                staleness,
                ..
            } = now;
            T::advance(linear.reborrow(), step);
            if let Some(angular) = angular {
                T::advance(angular, step);
            }
            if T::MOVES {
                staleness.metric.wrap_all(linear.coordinate);
                *is_stale |= staleness.is_stale(linear.coordinate);
            }
        }
    }

    fn dispatch(task: PartTask<Self, bool>) {
        S::run(task.instructions, task);
    }
}
