//! Forces and torques on particles, and adding the forces of pairs.

use gouge_common::geometry::Vec2;
use gouge_common::pair::Pair;
use gouge_common::scalar::Real;
use prefetch_index::prefetch_index;

/// Message for an index out of range. It cannot occur: particles are never removed.
pub(super) const MISSING: &str = "a pair joins particles that exist";

/// Forces and torques on all particles.
#[derive(Clone, Debug, Default)]
pub struct Forces<S> {
    /// Forces in N.
    pub force: Vec<Vec2<S>>,
    /// Torques in N m.
    pub torque: Vec<S>,
}

impl<S: Real> Forces<S> {
    /// Zero force and torque on each particle.
    pub fn new(number: usize) -> Self {
        Self {
            force: vec![Vec2::zero(); number],
            torque: vec![S::zero(); number],
        }
    }
    pub(crate) fn clear(&mut self) {
        self.force.fill(Vec2::zero());
        self.torque.fill(S::zero());
    }
    /// The sums of all particles.
    pub(crate) fn sums(&mut self) -> Sums<'_, S> {
        Sums {
            first: 0,
            force: &mut self.force,
            torque: &mut self.torque,
        }
    }
}

/// Force and torque sums of a range of consecutive particles.
pub(crate) struct Sums<'a, S> {
    /// Index of the first of these particles.
    pub first: usize,
    pub force: &'a mut [Vec2<S>],
    pub torque: &'a mut [S],
}

impl<'a, S: Real> Sums<'a, S> {
    pub fn split_at(self, particle: usize) -> (Self, Self) {
        let (force, other_force) = self.force.split_at_mut(particle);
        let (torque, other_torque) = self.torque.split_at_mut(particle);
        let first = self.first;
        let left = Self {
            first,
            force,
            torque,
        };
        let right = Self {
            first: first + particle,
            force: other_force,
            torque: other_torque,
        };
        (left, right)
    }
    /// Reborrows for a shorter lifetime.
    #[inline(always)]
    pub fn reborrow(&mut self) -> Sums<'_, S> {
        Sums {
            first: self.first,
            force: self.force,
            torque: self.torque,
        }
    }
    /// The same sums, with both columns cut to the same length so that one bounds check serves both.
    #[inline(always)]
    pub fn with_equal_lengths(self) -> Self {
        let number = self.force.len();
        Self {
            first: self.first,
            force: &mut self.force[..number],
            torque: &mut self.torque[..number],
        }
    }
    /// Prefetch the sums of a particle; torques only if pairs exert torques.
    #[inline(always)]
    pub fn prefetch(&self, particle: usize, torques: bool) {
        let particle = particle.wrapping_sub(self.first);
        prefetch_index(&*self.force, particle);
        if torques {
            prefetch_index(&*self.torque, particle);
        }
    }
    /// Add the force of j on i, its reaction on j and, with `TORQUES`, the torques on both.
    ///
    /// j must be in the range. The force on i is added only if i is in the range, too.
    #[inline(always)]
    pub fn add<const TORQUES: bool>(&mut self, pair: Pair, force: Vec2<S>, torques: [S; 2]) {
        let (i, j) = pair.indices();
        let (i, j) = (i.wrapping_sub(self.first), j.wrapping_sub(self.first));
        let number = self.force.len();
        assert!(j < number, "{MISSING}");
        if i < number {
            self.force[i] += force;
            if TORQUES {
                self.torque[i] += torques[0];
            }
        }
        self.force[j] -= force;
        if TORQUES {
            self.torque[j] += torques[1];
        }
    }
}
