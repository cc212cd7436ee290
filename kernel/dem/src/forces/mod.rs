//! The only place that writes forces: one pass a kind of interaction, thesis eqs. (26)-(27).
//!
//! Each pass is generic over the laws it calls and is chosen once a step, so that no choice is made
//! inside a loop.

mod prefetch;
mod ambient;
mod block;
mod cross_part;
mod driving;
mod external;
pub(crate) mod inspection;
mod scatter;
mod bonds;
mod turning;
mod contacts;

pub use inspection::{Interaction, InteractionKind};

pub(crate) use ambient::ambient;
use block::Block;
pub(crate) use bonds::{BondLoop, BondPass, stored_in_bonds};
pub(crate) use contacts::{ContactLoop, ContactPass, stored_in_contacts};
use cross_part::Departures;
pub(crate) use driving::{driving, measure};
pub(crate) use external::external;

use gouge_common::geometry::Vec2;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use gouge_common::scalar::Real;
use prefetch_index::prefetch_index;

/// Forces and torques on all particles.
#[derive(Clone, Debug, Default)]
pub struct Forces<S> {
    /// Forces in N.
    pub force: Vec<Vec2<S>>,
    /// Torques in N m.
    pub torque: Vec<S>,
}

impl<S: Real> Forces<S> {
    /// No force on any of so many particles.
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
    /// All of them, to be added to.
    pub(crate) fn sums(&mut self) -> Sums<'_, S> {
        Sums {
            first: 0,
            force: &mut self.force,
            torque: &mut self.torque,
        }
    }
}

/// Forces and torques on consecutive particles while links add to them.
pub(crate) struct Sums<'a, S> {
    first: usize,
    force: &'a mut [Vec2<S>],
    torque: &'a mut [S],
}

impl<'a, S: Real> Sums<'a, S> {
    fn split_at(self, particle: usize) -> (Self, Self) {
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
    /// The same for a shorter while.
    #[inline(always)]
    fn again(&mut self) -> Sums<'_, S> {
        Sums {
            first: self.first,
            force: self.force,
            torque: self.torque,
        }
    }
    /// The same, known to be equally long: one check serves both columns.
    #[inline(always)]
    fn equally_long(self) -> Self {
        let number = self.force.len();
        Self {
            first: self.first,
            force: &mut self.force[..number],
            torque: &mut self.torque[..number],
        }
    }
    /// Prefetch the sums of a particle, torques if links turn their ends.
    #[inline(always)]
    fn prefetch(&self, particle: usize, turns: bool) {
        let particle = particle.wrapping_sub(self.first);
        prefetch_index(&*self.force, particle);
        if turns {
            prefetch_index(&*self.torque, particle);
        }
    }
    /// Add a link's force on i, its reaction on j and, if it turns its ends, the torques: on j, which is
    /// among the particles, and on i, where that is.
    #[inline(always)]
    fn add<const TURNS: bool>(&mut self, pair: Pair, force: Vec2<S>, torques: [S; 2]) {
        let (i, j) = pair.indices();
        let (i, j) = (i.wrapping_sub(self.first), j.wrapping_sub(self.first));
        let number = self.force.len();
        assert!(j < number, "{MISSING}");
        if i < number {
            self.force[i] += force;
            if TURNS {
                self.torque[i] += torques[0];
            }
        }
        self.force[j] -= force;
        if TURNS {
            self.torque[j] += torques[1];
        }
    }
}

/// What a part needs to compute links.
#[derive(Clone, Debug, Default)]
pub(crate) struct PartWorkspace<S: Lanes> {
    /// Links side by side.
    pub block: Block<S>,
    /// What the part books; without a ledger nothing.
    pub tally: Tally<S>,
    /// Positions of the links that broke.
    pub broken: Vec<u32>,
    /// What strong links do to earlier parts.
    pub strong: Departures<S>,
    /// What weak links do to earlier parts.
    pub weak: Departures<S>,
}

/// Links are made between particles that exist, and no particle is ever removed.
const MISSING: &str = "a link joins particles that exist";

/// What a pass books besides forces, in one evaluation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Tally<S> {
    /// Power turned into heat by links, in W.
    pub friction_rate: S,
    /// Heat of links that appeared at once, in J.
    pub friction: S,
    /// Power turned into heat by the medium, in W.
    pub ambient_rate: S,
    /// Power of the driving force, in W.
    pub driving_rate: S,
    /// Stored energy lost with removed links, in J.
    pub breaking: S,
    /// Stored energy gained with links made under load, in J.
    pub bonding: S,
}

impl Tally<f64> {
    /// All entries, for a record of the state.
    pub(crate) fn numbers(&self) -> [f64; 6] {
        [
            self.friction_rate,
            self.friction,
            self.ambient_rate,
            self.driving_rate,
            self.breaking,
            self.bonding,
        ]
    }
    /// The tally with the given entries.
    pub(crate) fn from_numbers(numbers: [f64; 6]) -> Self {
        let [
            friction_rate,
            friction,
            ambient_rate,
            driving_rate,
            breaking,
            bonding,
        ] = numbers;
        Self {
            friction_rate,
            friction,
            ambient_rate,
            driving_rate,
            breaking,
            bonding,
        }
    }
}
