//! Forces of contacts in blocks, and the memories that begin and end.

use super::block::{Block, IDLE, IRREGULAR, Outputs, PAIRS};
use super::contact_pass::{ContactPass, ContactState};
use super::cross_part::CrossPartForces;
use super::ends::Reads;
use super::pair_loop::PairForces;
use super::workspace::PartWorkspace;
use crate::bonds::Bonds;
use crate::contacts::{ContactMemory, MemoryColumns};
use crate::geometry::Arm;
use crate::laws::{NormalLaw, TangentialLaw};
use core::ops::Range;
use gouge_common::geometry::Metric;
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;

/// A range of consecutive pairs that may touch, with their memories.
///
/// All pairs of a block are computed as if they touched, without a branch. Pairs that begin or cease to touch are
/// flagged and recomputed.
pub(crate) struct ContactForces<'a, S: Lanes, M, A, N, T, const LEDGER: bool> {
    pub pass: ContactPass<M, A, N, T>,
    /// Index of the first of these pairs among all pairs.
    pub first: usize,
    pub pairs: &'a [Pair],
    pub memories: MemoryColumns<'a, S>,
    /// All bonds. If the pair of a bond that breaks in this evaluation overlaps, it becomes a contact whose stored
    /// energy is recorded.
    pub bonds: Option<&'a Bonds<S>>,
}

impl<S: Lanes, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw, const LEDGER: bool> PairForces<S>
    for ContactForces<'_, S, M, A, N, T, LEDGER>
{
    const LEDGER: bool = LEDGER;
    const HAS_TORQUES: bool = !T::ABSENT;
    /// Other lever arms need square roots or arctangents and serve comparisons: vector instructions are not worth the
    /// code size.
    const IS_WIDE: bool = A::CONSTANT;
    const READS: Reads = Reads {
        angles: ContactPass::<M, A, N, T>::FOLLOWS_ANGLES,
        spins: !T::ABSENT,
        radii: true,
        masses: N::SCALES_DAMPING,
    };

    #[inline(always)]
    fn first(&self) -> usize {
        self.first
    }
    #[inline(always)]
    fn pairs(&self) -> &[Pair] {
        self.pairs
    }
    fn split_at(self, at: usize) -> (Self, Self) {
        let (pairs, other_pairs) = self.pairs.split_at(at);
        let (memories, other_memories) = self.memories.split_at(at);
        let left = Self {
            pairs,
            memories,
            ..self
        };
        let right = Self {
            first: self.first + at,
            pairs: other_pairs,
            memories: other_memories,
            ..left
        };
        (left, right)
    }
    #[inline(always)]
    fn prefetch(&self, position: usize) {
        if T::REMEMBERS {
            self.memories.prefetch(position);
        }
    }
    #[inline(always)]
    fn cross_part_and_block(
        workspace: &mut PartWorkspace<S>,
    ) -> (&mut CrossPartForces<S>, &Block<S>) {
        (&mut workspace.contacts, &workspace.block)
    }

    #[inline(always)]
    fn compute(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64 {
        let number = positions.len().min(PAIRS);
        let memories = self.memories.part(if T::REMEMBERS {
            positions.start..positions.start + number
        } else {
            0..0
        });
        let (inputs, frames, outputs) = block.with_frames(self.pass.metric, number);
        let mut flags = 0;
        for lane in 0..number {
            let ends = inputs.ends(lane);
            let touches = self.pass.overlaps(&ends);
            let old = if T::REMEMBERS {
                memories.get(lane)
            } else {
                ContactMemory::default()
            };
            let mut memory = old;
            let (state, is_regular) = self.pass.regular_state(&ends, frames.at(lane), &mut memory);
            if T::REMEMBERS {
                outputs.memory_state[lane] = if touches { memory.state } else { old.state };
            }
            if A::ACCUMULATES {
                let now = if touches { memory.ends } else { old.ends };
                outputs.memory_ends[0][lane] = now[0];
                outputs.memory_ends[1][lane] = now[1];
            }
            self.pass
                .write::<S, LEDGER>(outputs, lane, &state, ends.radii, touches);
            let is_irregular = ((touches != old.touches) & T::REMEMBERS) | (touches & !is_regular);
            let flag = (IDLE * u64::from(!touches)) | (IRREGULAR * u64::from(is_irregular));
            outputs.flags[lane] = flag;
            flags |= flag;
        }
        flags
    }

    /// Begin and end contacts, and recompute flagged ones by the general path. Adds no idle pair.
    ///
    /// When a contact ends, its remaining tangential energy becomes heat: no law stores energy without a normal
    /// force.
    #[cold]
    #[inline(never)]
    fn compute_irregular(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64 {
        for (lane, position) in positions.enumerate() {
            let flags = block.outputs.flags[lane];
            if flags & IRREGULAR == 0 {
                continue;
            }
            let ends = block.inputs.ends(lane);
            let outputs = &mut *block.outputs;
            let mut memory = self.memories.get(position);
            let touches = flags & IDLE == 0;
            if touches && !memory.touches {
                memory = self.pass.begin(&ends);
            }
            let state = self.pass.general_state(&ends, &mut memory);
            self.pass
                .write::<S, LEDGER>(outputs, lane, &state, ends.radii, touches);
            if !touches {
                memory.touches = false;
                outputs.heat[lane] = state.friction.heat;
            }
            self.memories.set(position, memory);
            outputs.memory_state[lane] = memory.state;
            for end in 0..2 {
                outputs.memory_ends[end][lane] = memory.ends[end];
            }
        }
        0
    }

    /// Store the history variables of the contacts.
    #[inline(always)]
    fn store(&mut self, workspace: &mut PartWorkspace<S>, positions: Range<usize>, _: bool) {
        if !T::REMEMBERS {
            return;
        }
        let number = positions.len().min(PAIRS);
        let outputs = &*workspace.block.outputs;
        self.memories.states[positions.clone()].copy_from_slice(&outputs.memory_state[..number]);
        if A::ACCUMULATES {
            for (ends, now) in self.memories.ends.iter_mut().zip(&outputs.memory_ends) {
                ends[positions.clone()].copy_from_slice(&now[..number]);
            }
        }
    }

    /// Record the stored energy of contacts that replace broken bonds.
    #[inline(always)]
    fn book(&self, workspace: &mut PartWorkspace<S>, positions: Range<usize>) {
        let Some(bonds) = self.bonds.filter(|bonds| !bonds.broken.is_empty()) else {
            return;
        };
        for (lane, position) in positions.enumerate() {
            let touches = workspace.block.outputs.flags[lane] & IDLE == 0;
            if touches && bonds.just_broke(self.pairs[position]) {
                let ends = workspace.block.inputs.ends(lane);
                let mut memory = if T::REMEMBERS {
                    self.memories.get(position)
                } else {
                    self.pass.begin(&ends)
                };
                let pass = ContactPass {
                    elapsed: 0.0,
                    ..self.pass
                };
                let state = pass.general_state(&ends, &mut memory);
                workspace.bookings.bonding += pass.stored_energy(ends.radii, &state, memory.state);
            }
        }
    }
}

impl<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw> ContactPass<M, A, N, T> {
    /// Write the forces of a contact into its lane, and its heat if `LEDGER`.
    #[inline(always)]
    fn write<S: Lanes, const LEDGER: bool>(
        &self,
        outputs: &mut Outputs<S>,
        lane: usize,
        state: &ContactState<S>,
        radii: [S; 2],
        touches: bool,
    ) {
        outputs.set_force(lane, state.force());
        if !T::ABSENT {
            outputs.set_torques(lane, state.torques);
        }
        if LEDGER {
            let (heat_rate, heat) = (self.heat_rate(radii, state), state.friction.heat);
            outputs.heat_rate[lane] = if touches { heat_rate } else { S::zero() };
            outputs.heat[lane] = if touches { heat } else { S::zero() };
        }
    }
}
