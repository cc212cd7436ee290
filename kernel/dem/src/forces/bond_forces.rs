//! Forces of bonds in blocks, and the list of bonds that break.

use super::block::{Block, IDLE, IRREGULAR, Outputs, PAIRS};
use super::bond_pass::{BondPass, BondState};
use super::cross_part::CrossPartForces;
use super::ends::{Bodies, Ends, Reads};
use super::pair_loop::PairForces;
use super::workspace::PartWorkspace;
use crate::bonds::BondColumns;
use crate::laws::{BeamLaw, YieldLaw};
use core::ops::Range;
use gouge_common::geometry::Metric;
use gouge_common::lanes::Lanes;
use gouge_common::pair::{Pair, map_ends};

/// A range of consecutive bonds. Bonds that break exert no force and are listed.
pub(crate) struct BondForces<'a, S: Lanes, M, B, Y, const LEDGER: bool> {
    pub pass: BondPass<M, B, Y>,
    pub bodies: Bodies<'a, S>,
    pub bonds: BondColumns<'a, S>,
}

impl<S: Lanes, M: Metric, B: BeamLaw, Y: YieldLaw, const LEDGER: bool> PairForces<S>
    for BondForces<'_, S, M, B, Y, LEDGER>
{
    const LEDGER: bool = LEDGER;
    const HAS_TORQUES: bool = !B::ABSENT;
    const IS_WIDE: bool = true;
    const READS: Reads = Reads {
        angles: !B::ABSENT,
        spins: !B::ABSENT,
        radii: false,
        masses: false,
    };

    #[inline(always)]
    fn first(&self) -> usize {
        self.bonds.first
    }
    #[inline(always)]
    fn pairs(&self) -> &[Pair] {
        self.bonds.pairs
    }
    fn split_at(self, at: usize) -> (Self, Self) {
        let (bonds, other_bonds) = self.bonds.split_at(at);
        let left = Self { bonds, ..self };
        let right = Self {
            bonds: other_bonds,
            ..left
        };
        (left, right)
    }
    #[inline(always)]
    fn prefetch(&self, position: usize) {
        self.bonds.prefetch(position);
    }
    #[inline(always)]
    fn cross_part_and_block(
        workspace: &mut PartWorkspace<S>,
    ) -> (&mut CrossPartForces<S>, &Block<S>) {
        (&mut workspace.bonds, &workspace.block)
    }

    #[inline(always)]
    fn compute(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64 {
        let number = positions.len().min(PAIRS);
        let bonds = self.bonds.part(positions.start..positions.start + number);
        let (inputs, frames, outputs) = block.with_frames(self.pass.metric, number);
        let mut flags = 0;
        for lane in 0..number {
            let rest = bonds.rest(lane);
            let ends = with_radii(inputs.ends(lane), &bonds, lane);
            let (state, is_regular) = self.pass.regular_state(&ends, frames.at(lane), &rest);
            let flag = self
                .pass
                .write::<S, LEDGER>(outputs, lane, &state, bonds.sections[lane])
                | (IRREGULAR * u64::from(!is_regular));
            outputs.flags[lane] = flag;
            flags |= flag;
        }
        flags
    }

    #[cold]
    #[inline(never)]
    fn compute_irregular(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64 {
        let mut flags = 0;
        for (lane, position) in positions.enumerate() {
            if block.outputs.flags[lane] & IRREGULAR == 0 {
                continue;
            }
            let mut rest = self.bonds.rest(position);
            let ends = with_radii(block.inputs.ends(lane), &self.bonds, position);
            let state = self.pass.general_state(&ends, &mut rest);
            self.bonds.set_reference(position, &rest);
            let section = self.bonds.sections[position];
            let outputs = &mut block.outputs;
            let flag = self.pass.write::<S, LEDGER>(outputs, lane, &state, section);
            outputs.flags[lane] = flag;
            flags |= flag;
        }
        flags
    }

    /// List the bonds that break.
    #[inline(always)]
    fn store(&mut self, workspace: &mut PartWorkspace<S>, positions: Range<usize>, has_idle: bool) {
        if has_idle {
            self.list_broken(workspace, positions);
        }
    }

    /// Nothing: the energy of a broken bond is recorded when the bond is listed.
    #[inline(always)]
    fn book(&self, _: &mut PartWorkspace<S>, _: Range<usize>) {}
}

impl<S: Lanes, M: Metric, B: BeamLaw, Y: YieldLaw, const LEDGER: bool>
    BondForces<'_, S, M, B, Y, LEDGER>
{
    #[cold]
    #[inline(never)]
    fn list_broken(&self, workspace: &mut PartWorkspace<S>, positions: Range<usize>) {
        for (lane, position) in positions.enumerate() {
            if workspace.block.outputs.flags[lane] & IDLE == 0 {
                continue;
            }
            workspace.broken.push((self.bonds.first + position) as u32);
            if LEDGER {
                let (pair, rest) = (self.bonds.pairs[position], self.bonds.rest(position));
                let state = self.pass.state_of(self.bodies, pair, rest);
                workspace.bookings.breaking += self.pass.stored_energy(&state);
            }
        }
    }
}

/// Particle data of the bond at an index, with the radii that the bond stores.
#[inline(always)]
fn with_radii<S: Lanes>(ends: Ends<S>, bonds: &BondColumns<S>, position: usize) -> Ends<S> {
    Ends {
        radii: map_ends(bonds.radii, |radii| radii[position]),
        ..ends
    }
}

impl<M: Metric, B: BeamLaw, Y: YieldLaw> BondPass<M, B, Y> {
    /// Write the forces of a bond into its lane, and its heat if `LEDGER`. Returns [`IDLE`] if the bond breaks.
    #[inline(always)]
    fn write<S: Lanes, const LEDGER: bool>(
        &self,
        outputs: &mut Outputs<S>,
        lane: usize,
        state: &BondState<S>,
        section: S,
    ) -> u64 {
        outputs.set_force(lane, state.force());
        if !B::ABSENT {
            outputs.set_torques(lane, state.torques);
        }
        let breaks = self
            .yielding
            .is_exceeded(state.normal_force, state.tangential_force, section);
        if LEDGER {
            let heat_rate = self.heat_rate(state);
            outputs.heat_rate[lane] = if breaks { S::zero() } else { heat_rate };
            outputs.heat[lane] = S::zero();
        }
        IDLE * u64::from(breaks)
    }
}
