//! Forces of bonds, and which of them break.

use super::Settings;
use super::blocks::{Block, Blocks, Buffer};
use super::lanes::BATCH;
use crate::bond_law::{BreakOrder, BreakingRule, Elongation};
use crate::bonds::BondRows;
use crate::grain::Grains;
use crate::material::{BondConstants, Weight};
use crate::state::{Place, State, moved};
use core::ops::Range;
use gouge_common::geometry::Vec2;
use gouge_common::instructions::Instructions;
use gouge_common::pair::Pair;
use pulp::NullaryFnOnce;

/// The weight of a pass, known when it is compiled.
trait Weigh {
    const WEIGHT: Weight;
}
struct Constant;
impl Weigh for Constant {
    const WEIGHT: Weight = Weight::Constant;
}
struct Conic;
impl Weigh for Conic {
    const WEIGHT: Weight = Weight::Conic;
}
struct Parabolic;
impl Weigh for Parabolic {
    const WEIGHT: Weight = Weight::Parabolic;
}

/// What a pass reads.
#[derive(Clone, Copy)]
struct Nodes<'a> {
    grains: &'a Grains,
    places: &'a [Place],
    velocity: &'a [Vec2],
    acceleration: &'a [Vec2],
    time_step: f64,
    order: BreakOrder,
    instructions: Instructions,
}

impl Nodes<'_> {
    /// Displacement in m of a node in this step.
    fn moved(&self, node: usize) -> Vec2 {
        moved(self.velocity[node], self.acceleration[node], self.time_step)
    }
}

/// Add the forces of all bonds to force densities in N/m^3, remove bonds that break, and list them by later node and then
/// by earlier one.
pub(super) fn add_bond_forces(
    grains: &Grains,
    settings: &Settings,
    state: &mut State,
    blocks: &mut Blocks,
    force: &mut [Vec2],
    broken: &mut Vec<Pair>,
) {
    let nodes = Nodes {
        grains,
        places: &state.places,
        velocity: &state.velocity,
        acceleration: &state.acceleration,
        time_step: settings.time_step,
        order: settings.break_order,
        instructions: blocks.instructions,
    };
    let Blocks {
        blocks, buffers, ..
    } = blocks;
    run(nodes, blocks, state.bonds.rows_mut(), buffers);
    broken.clear();
    for (block, buffer) in blocks.iter().zip(buffers) {
        let stiffness = grains.rows[block.grain].constants.stiffness;
        for (force, &sum) in force[block.reach()].iter_mut().zip(&buffer.sums) {
            *force += sum * stiffness;
        }
        broken.extend_from_slice(&buffer.broken);
        state.work.broken += buffer.lost_energy;
    }
    state.bonds.forget(broken);
}

fn run(nodes: Nodes, blocks: &[Block], rows: BondRows, buffers: &mut [Buffer]) {
    match (blocks, buffers) {
        ([block], [buffer]) => nodes.instructions.run(BlockPass {
            nodes,
            block,
            rows,
            buffer,
        }),
        (blocks, buffers) if !blocks.is_empty() => {
            let half = blocks.len() / 2;
            let (left, right) = rows.split_at(blocks[half].nodes.start - blocks[0].nodes.start);
            let (buffers_left, buffers_right) = buffers.split_at_mut(half);
            rayon::join(
                || run(nodes, &blocks[..half], left, buffers_left),
                || run(nodes, &blocks[half..], right, buffers_right),
            );
        }
        _ => {}
    }
}

/// A block, with its rows and its buffer.
struct BlockPass<'a> {
    nodes: Nodes<'a>,
    block: &'a Block,
    rows: BondRows<'a>,
    buffer: &'a mut Buffer,
}

impl NullaryFnOnce for BlockPass<'_> {
    type Output = ();

    /// The only place that selects a weight and a rule of breaking.
    #[inline(always)]
    fn call(self) {
        match self.nodes.grains.rows[self.block.grain].constants.weight {
            Weight::Constant => self.with_breaking::<Constant>(),
            Weight::Conic => self.with_breaking::<Conic>(),
            Weight::Parabolic => self.with_breaking::<Parabolic>(),
        }
    }
}

impl BlockPass<'_> {
    #[inline(always)]
    fn with_breaking<W: Weigh>(self) {
        let breaking = self.nodes.grains.rows[self.block.grain].breaking;
        match (breaking, self.nodes.order) {
            (None, _) => self.add::<W, false, false, false>(),
            (Some(BreakingRule::TensionOnly), BreakOrder::BreakFirst) => {
                self.add::<W, true, false, true>();
            }
            (Some(BreakingRule::TensionOnly), BreakOrder::ForceFirst) => {
                self.add::<W, true, false, false>();
            }
            (Some(BreakingRule::TwoSided), BreakOrder::BreakFirst) => {
                self.add::<W, true, true, true>();
            }
            (Some(BreakingRule::TwoSided), BreakOrder::ForceFirst) => {
                self.add::<W, true, true, false>();
            }
        }
    }

    /// Sums over the bonds of the block of the pair force density per stiffness, times the area of the other node.
    #[inline(always)]
    fn add<W: Weigh, const BREAKS: bool, const TWO_SIDED: bool, const BREAK_FIRST: bool>(self) {
        let Self {
            nodes,
            block,
            mut rows,
            buffer,
        } = self;
        let constants = nodes.grains.rows[block.grain].constants;
        let (first, reach) = (block.first, block.reach());
        let (places, area) = (&nodes.places[reach.clone()], &nodes.grains.area[reach]);
        let (critical_stretch, horizon) = (constants.critical_stretch, constants.horizon);
        let is_over = move |elongation: &Elongation| {
            BREAKS && elongation.exceeds::<TWO_SIDED>(critical_stretch)
        };
        let pull_or_zero = move |elongation: &Elongation| {
            let breaks = is_over(elongation);
            let pull = elongation.pull(W::WEIGHT, horizon);
            let acts = !(BREAK_FIRST && breaks);
            (if acts { pull } else { Vec2::zero() }, breaks)
        };
        buffer.reset(block);
        let mut next = 0;
        while next < block.nodes.len() {
            let begin = next;
            buffer.lanes.number = 0;
            while next < block.nodes.len() && buffer.lanes.number < BATCH {
                let here = rows.places(next);
                let earlier = rows.earlier[here.clone()].iter();
                let earlier = earlier.map(|&earlier| places[earlier as usize - first]);
                let own = places[block.nodes.start + next - first];
                buffer.lanes.gather(own, earlier, &rows.length[here]);
                next += 1;
            }
            let has_broken = buffer.lanes.compute(&mut buffer.pulls, pull_or_zero);
            add_pulls(&rows, begin..next, block, area, buffer);
            if !(BREAKS && has_broken) {
                continue;
            }
            for row in begin..next {
                let later = block.nodes.start + row;
                let (own, own_area) = (places[later - first], area[later - first]);
                let energy_if_over = |earlier: usize, length| {
                    let elongation = places[earlier - first].elongation_to(own, length);
                    let moved = nodes.moved(later) - nodes.moved(earlier);
                    is_over(&elongation).then(|| {
                        let lost = lost_energy::<BREAK_FIRST>(&elongation, &constants, moved);
                        lost * own_area * area[earlier - first]
                    })
                };
                remove(&mut rows, row, later, buffer, energy_if_over);
            }
        }
    }
}

/// Add what was computed for the bonds of some rows to the sums of both nodes, times the area of the other one.
#[inline(always)]
fn add_pulls(
    rows: &BondRows,
    range: Range<usize>,
    block: &Block,
    area: &[f64],
    buffer: &mut Buffer,
) {
    let mut pulls = &buffer.pulls[..];
    let sums = &mut buffer.sums[..area.len()];
    for row in range {
        let later = block.nodes.start + row - block.first;
        let own_area = area[later];
        let earlier = &rows.earlier[rows.places(row)];
        let (own, others) = pulls.split_at(earlier.len());
        let mut sum = Vec2::zero();
        for (&earlier, &pull) in earlier.iter().zip(own) {
            let earlier = earlier as usize - block.first;
            sums[earlier] += pull * own_area;
            sum += -pull * area[earlier];
        }
        sums[later] += sum;
        pulls = others;
    }
}

/// Energy in J/m per product of the two areas that a breaking bond takes with it, for the relative displacement in m of its
/// ends in this step.
///
/// A step gives nodes half of the work of the force at its beginning and half of that at its end. A bond that breaks first
/// does not act at the end, and one that breaks last acts once more at the beginning of the next step: its energy at the end
/// less, or more, half of the work of its force. With it the balance of energy closes with the second order of the step.
fn lost_energy<const BREAK_FIRST: bool>(
    elongation: &Elongation,
    constants: &BondConstants,
    moved: Vec2,
) -> f64 {
    let pull = elongation.pull(constants.weight, constants.horizon);
    let work = pull.dot(moved) * constants.stiffness;
    let sign = if BREAK_FIRST { -0.5 } else { 0.5 };
    elongation.energy(constants) + sign * work
}

/// Remove bonds that break from a row, and keep the order of the others.
#[cold]
fn remove(
    rows: &mut BondRows,
    row: usize,
    later: usize,
    buffer: &mut Buffer,
    energy_if_over: impl Fn(usize, f64) -> Option<f64>,
) {
    let places = rows.places(row);
    let mut kept = places.start;
    for place in places.clone() {
        let (earlier, length) = (rows.earlier[place], rows.length[place]);
        if let Some(energy) = energy_if_over(earlier as usize, length) {
            buffer.broken.push(Pair::new(earlier as usize, later));
            buffer.lost_energy += energy;
        } else {
            (rows.earlier[kept], rows.length[kept]) = (earlier, length);
            kept += 1;
        }
    }
    rows.held[row] = (kept - places.start) as u16;
}
