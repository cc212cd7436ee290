//! The loop over pairs, shared by contacts and bonds.

use super::block::{Block, IDLE, IRREGULAR, blocks};
use super::cross_part::CrossPartForces;
use super::ends::{Bodies, Columns, Reads};
use super::prefetch::is_large;
use super::scatter::Scatter;
use super::sums::Sums;
use super::workspace::PartWorkspace;
use crate::pairs::ListVersion;
use core::ops::Range;
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::pair::{Pair, pairs_before};
use gouge_common::parts::{PartTask, Work};
use pulp::NullaryFnOnce;

/// A range of consecutive contacts or bonds, as the loop uses them.
pub(crate) trait PairForces<S: Lanes>: Sized + Send {
    /// Whether heat and work are recorded.
    const LEDGER: bool;
    /// Whether pairs exert torques.
    const HAS_TORQUES: bool;
    /// Whether the loop is compiled for vector instructions.
    const IS_WIDE: bool;
    /// Which particle data the laws read.
    const READS: Reads;

    /// Index of the first of these pairs among all pairs.
    fn first(&self) -> usize;
    /// The pairs, sorted.
    fn pairs(&self) -> &[Pair];
    /// Split the pairs at an index.
    fn split_at(self, at: usize) -> (Self, Self);
    /// Prefetch the data that the pairs store, at an index.
    fn prefetch(&self, position: usize);
    /// The buffer for their forces on earlier parts, and the block.
    fn cross_part_and_block(
        workspace: &mut PartWorkspace<S>,
    ) -> (&mut CrossPartForces<S>, &Block<S>);
    /// Compute a block by the regular path. Returns the union of the flags.
    fn compute(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64;
    /// Recompute flagged pairs of a block by the general path. Returns the union of the flags that this adds.
    fn compute_irregular(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64;
    /// Store the results of a block other than forces; `has_idle` if some of its pairs are idle.
    fn store(&mut self, workspace: &mut PartWorkspace<S>, positions: Range<usize>, has_idle: bool);
    /// Record energies that change instantaneously; called only with a ledger.
    fn book(&self, workspace: &mut PartWorkspace<S>, positions: Range<usize>);
}

/// Adds the forces of contacts or bonds to their particles, block by block.
///
/// Reads particles and pairs; writes force sums, memories and bookings. Allocates nothing.
pub(crate) struct PairLoop<'a, S, F> {
    pub forces: F,
    pub bodies: Bodies<'a, S>,
    pub sums: Sums<'a, S>,
    pub list_version: ListVersion,
}

impl<S: Lanes, F: PairForces<S>> Work<PartWorkspace<S>> for PairLoop<'_, S, F> {
    fn split_at(self, particle: usize) -> (Self, Self) {
        let at = pairs_before(self.forces.pairs(), self.sums.first + particle);
        let (forces, other_forces) = self.forces.split_at(at);
        let (sums, other_sums) = self.sums.split_at(particle);
        let left = Self {
            forces,
            sums,
            ..self
        };
        let right = Self {
            forces: other_forces,
            sums: other_sums,
            ..left
        };
        (left, right)
    }

    #[inline(always)]
    fn run_part(mut self, workspace: &mut PartWorkspace<S>, instructions: Instructions) {
        let (cross_part, _) = F::cross_part_and_block(workspace);
        cross_part.begin(self.list_version, self.forces.pairs(), self.sums.first);
        let columns = Columns::of(self.bodies);
        let is_large = is_large(self.bodies.particles.len());
        for positions in blocks(self.forces.first(), self.forces.pairs().len()) {
            let block = &mut workspace.block;
            let flags = self.compute_block(block, columns, positions.clone(), is_large);
            let has_idle = flags & IDLE != 0;
            self.forces.store(workspace, positions.clone(), has_idle);
            if F::LEDGER {
                self.scatter::<true>(workspace, positions.clone(), has_idle, instructions);
            } else {
                self.scatter::<false>(workspace, positions.clone(), has_idle, instructions);
            }
            let (cross_part, block) = F::cross_part_and_block(workspace);
            cross_part.collect(
                self.forces.pairs(),
                positions.clone(),
                &block.outputs,
                F::HAS_TORQUES,
            );
            if F::LEDGER {
                self.forces.book(workspace, positions);
            }
        }
    }

    fn dispatch(task: PartTask<Self, PartWorkspace<S>>) {
        if F::IS_WIDE {
            S::run(task.instructions, task);
        } else {
            task.call();
        }
    }
}

impl<S: Lanes, F: PairForces<S>> PairLoop<'_, S, F> {
    /// Compute the forces of a block. Returns the union of the flags.
    #[inline(always)]
    fn compute_block(
        &mut self,
        block: &mut Block<S>,
        columns: Columns<S>,
        positions: Range<usize>,
        is_large: bool,
    ) -> u64 {
        block.gather(
            columns,
            (self.forces.pairs(), positions.clone()),
            F::READS,
            is_large.then_some(&self.sums),
            |position| self.forces.prefetch(position),
        );
        let mut flags = self.forces.compute(block, positions.clone());
        if flags & IRREGULAR != 0 {
            flags |= self.forces.compute_irregular(block, positions);
        }
        flags
    }

    /// Add the forces of a block to the force sums.
    #[inline(always)]
    fn scatter<const LEDGER: bool>(
        &mut self,
        workspace: &mut PartWorkspace<S>,
        positions: Range<usize>,
        has_idle: bool,
        instructions: Instructions,
    ) {
        let scatter = Scatter::<_, LEDGER> {
            pairs: &self.forces.pairs()[positions],
            outputs: &workspace.block.outputs,
            has_torques: F::HAS_TORQUES,
            has_idle,
            sums: self.sums.reborrow(),
            bookings: &mut workspace.bookings,
        };
        S::run(instructions, scatter);
    }
}
