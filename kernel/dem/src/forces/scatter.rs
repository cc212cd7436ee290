//! Adding the forces of pairs to the sums of their particles.

use super::block::{IDLE, Outputs, PAIRS};
use super::bookings::Bookings;
use super::sums::Sums;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use pulp::NullaryFnOnce;

/// Adds the forces of a block of pairs one after the other, in the order of the pairs; with `LEDGER` also their heat.
///
/// A loop of its own, so that all its variables stay in registers.
pub(super) struct Scatter<'a, S: Lanes, const LEDGER: bool> {
    pub pairs: &'a [Pair],
    pub outputs: &'a Outputs<S>,
    /// Whether pairs exert torques.
    pub has_torques: bool,
    /// Whether any pair is idle.
    pub has_idle: bool,
    pub sums: Sums<'a, S>,
    pub bookings: &'a mut Bookings<S>,
}

impl<S: Lanes, const LEDGER: bool> NullaryFnOnce for Scatter<'_, S, LEDGER> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        match (self.has_torques, self.has_idle) {
            (true, true) => self.add::<true, false>(),
            (true, false) => self.add::<true, true>(),
            (false, true) => self.add::<false, false>(),
            (false, false) => self.add::<false, true>(),
        }
    }
}

impl<S: Lanes, const LEDGER: bool> Scatter<'_, S, LEDGER> {
    #[inline(always)]
    fn add<const TORQUES: bool, const ALL: bool>(self) {
        let (outputs, mut sums) = (self.outputs, self.sums.with_equal_lengths());
        let (mut heat_rate, mut heat) = (self.bookings.friction_rate, self.bookings.friction);
        for (lane, &pair) in (0..PAIRS).zip(self.pairs) {
            if LEDGER {
                heat_rate += outputs.heat_rate[lane];
                heat += outputs.heat[lane];
            }
            if ALL || outputs.flags[lane] & IDLE == 0 {
                sums.add::<TORQUES>(pair, outputs.force(lane), outputs.torques(lane));
            }
        }
        (self.bookings.friction_rate, self.bookings.friction) = (heat_rate, heat);
    }
}
