//! What links do, added to the sums of their particles.

use super::block::{IDLE, LINKS, Outputs};
use super::{Sums, Tally};
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;
use pulp::NullaryFnOnce;

/// A block of links whose forces are added one after the other, in their order; `LEDGER` books their heat.
///
/// A loop of its own, so that all that it needs stays in registers.
pub(super) struct Scatter<'a, S: Lanes, const LEDGER: bool> {
    pub pairs: &'a [Pair],
    pub outputs: &'a Outputs<S>,
    /// Whether links turn their ends.
    pub turns: bool,
    /// Whether no link is idle.
    pub all: bool,
    pub sums: Sums<'a, S>,
    pub tally: &'a mut Tally<S>,
}

impl<S: Lanes, const LEDGER: bool> NullaryFnOnce for Scatter<'_, S, LEDGER> {
    type Output = ();

    #[inline(always)]
    fn call(self) {
        match (self.turns, self.all) {
            (true, true) => self.add::<true, true>(),
            (true, false) => self.add::<true, false>(),
            (false, true) => self.add::<false, true>(),
            (false, false) => self.add::<false, false>(),
        }
    }
}

impl<S: Lanes, const LEDGER: bool> Scatter<'_, S, LEDGER> {
    #[inline(always)]
    fn add<const TURNS: bool, const ALL: bool>(self) {
        let (outputs, mut sums) = (self.outputs, self.sums.equally_long());
        let (mut heat_rate, mut heat) = (self.tally.friction_rate, self.tally.friction);
        for (lane, &pair) in (0..LINKS).zip(self.pairs) {
            if LEDGER {
                heat_rate += outputs.heat_rate[lane];
                heat += outputs.heat[lane];
            }
            if ALL || outputs.flags[lane] & IDLE == 0 {
                sums.add::<TURNS>(pair, outputs.force(lane), outputs.torques(lane));
            }
        }
        (self.tally.friction_rate, self.tally.friction) = (heat_rate, heat);
    }
}
