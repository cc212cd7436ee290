//! Division of the bonds of all grains into blocks that run in parallel.
//!
//! The division depends on the grains alone, and sums of blocks are added in their order, so the result does not depend on
//! the number of threads.

use super::lanes::Lanes;
use crate::bonds::Bonds;
use crate::grain::Grains;
use core::ops::Range;
use gouge_common::geometry::Vec2;
use gouge_common::instructions::Instructions;
use gouge_common::pair::Pair;

/// Most nodes of a block.
const BLOCK: usize = 1024;

/// Consecutive nodes of a grain, with their bonds to earlier nodes.
#[derive(Clone, Debug)]
pub(super) struct Block {
    pub(super) grain: usize,
    pub(super) nodes: Range<usize>,
    /// The first node to which these bonds lead.
    pub(super) first: usize,
}

impl Block {
    /// All nodes on which its bonds act.
    pub(super) fn reach(&self) -> Range<usize> {
        self.first..self.nodes.end
    }
}

/// What a block computes.
#[derive(Clone, Debug, Default)]
pub(super) struct Buffer {
    /// Sums over bonds for each node that the block reaches.
    pub(super) sums: Vec<Vec2>,
    /// Bonds that are computed together.
    pub(super) lanes: Lanes,
    /// What is computed for each of them.
    pub(super) pulls: Vec<Vec2>,
    /// Bonds that broke.
    pub(super) broken: Vec<Pair>,
    /// Energy in J/m of the bonds that broke.
    pub(super) lost_energy: f64,
}

impl Buffer {
    pub(super) fn reset(&mut self, block: &Block) {
        self.sums.clear();
        self.sums.resize(block.reach().len(), Vec2::zero());
        self.broken.clear();
        self.lost_energy = 0.0;
    }
}

/// All blocks with their buffers, and the instructions that compute them.
#[derive(Clone, Debug, Default)]
pub(super) struct Blocks {
    pub(super) blocks: Vec<Block>,
    pub(super) buffers: Vec<Buffer>,
    pub(super) instructions: Instructions,
}

impl Blocks {
    pub(super) fn new(grains: &Grains, bonds: &Bonds) -> Self {
        let mut blocks = Vec::new();
        for (grain, row) in grains.rows.iter().enumerate() {
            let number = row.nodes.len().div_ceil(BLOCK);
            let begin = |part: usize| row.nodes.start + part * row.nodes.len() / number;
            blocks.extend((0..number).map(|part| {
                let nodes = begin(part)..begin(part + 1);
                let reached = nodes
                    .clone()
                    .filter_map(|node| bonds.with_earlier(node).next());
                let first = reached
                    .map(|(earlier, _)| earlier)
                    .fold(nodes.start, usize::min);
                Block {
                    grain,
                    nodes,
                    first,
                }
            }));
        }
        let buffers = vec![Buffer::default(); blocks.len()];
        Self {
            blocks,
            buffers,
            instructions: Instructions::default(),
        }
    }
}
