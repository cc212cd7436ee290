//! The pass over strong links.

use super::block::{Block, Columns, Ends, IDLE, IRREGULAR, LINKS, Outputs, Reads, blocks};
use super::prefetch::is_large;
use super::scatter::Scatter;
use super::turning::{turned, turned_far};
use super::{PartWorkspace, Sums};
use crate::bonds::Edition;
use crate::bonds::{BondColumns, Bonds, Rest};
use crate::geometry::{PairFrame, PairMotion};
use crate::laws::{AdjustedKelvinVoigt, BeamLaw, YieldLaw};
use crate::particles::Particles;
use core::ops::Range;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::pair::{Pair, pairs_before};
use gouge_common::parts::{Ready, Work};

/// Laws and choices of the pass.
#[derive(Clone, Copy)]
pub(crate) struct BondPass<M, B, Y> {
    pub metric: M,
    pub normal: AdjustedKelvinVoigt,
    pub beam: B,
    pub yielding: Y,
    /// Whether angles are wrapped to [-pi, pi), as the thesis author did.
    pub wraps: bool,
}

/// A strong link in its present state.
pub(crate) struct BondState<S> {
    pub frame: PairFrame<S>,
    pub motion: PairMotion<S>,
    pub xi_adjusted: S,
    pub zeta: [S; 2],
    pub d_zeta: [S; 2],
    pub normal_force: S,
    pub tangential_force: S,
    pub torques: [S; 2],
}

impl<S: Lanes> BondState<S> {
    /// Force on i in N.
    #[inline(always)]
    pub fn force(&self) -> Vec2<S> {
        self.frame.vector(self.normal_force, self.tangential_force)
    }
}

impl<M: Metric, B: BeamLaw, Y: YieldLaw> BondPass<M, B, Y> {
    /// Forces of a link whose ends are at the given angles, in rad, to their unbent directions; thesis
    /// eqs. (33)-(34) and (43)-(45).
    #[inline(always)]
    fn state<S: Lanes>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        rest_distance: S,
        angles: [S; 2],
    ) -> BondState<S> {
        let motion = PairMotion::new(&frame, ends.velocity);
        let xi_adjusted = rest_distance - frame.distance;
        let normal_force = self.normal.force(xi_adjusted, motion.normal_velocity);
        let (mut zeta, mut d_zeta) = ([S::zero(); 2], [S::zero(); 2]);
        let (mut torques, mut tangential_force) = ([S::zero(); 2], S::zero());
        if !B::ABSENT {
            for end in 0..2 {
                zeta[end] = ends.radii[end] * angles[end];
                d_zeta[end] = ends.radii[end] * (ends.spins[end] - motion.frame_rate);
                torques[end] = ends.radii[end] * self.beam.force(zeta[end], d_zeta[end]);
            }
            tangential_force = (torques[0] + torques[1]) * frame.inverse_distance;
        }
        BondState {
            frame,
            motion,
            xi_adjusted,
            zeta,
            d_zeta,
            normal_force,
            tangential_force,
            torques,
        }
    }

    /// The state of most links, thesis eqs. (28)-(34), and whether it is that of this one.
    #[inline(always)]
    fn regular<S: Lanes>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        rest: &Rest<S>,
    ) -> (BondState<S>, bool) {
        if B::ABSENT {
            return (self.state(ends, frame, rest.distance, [S::zero(); 2]), true);
        }
        let unbent = (rest.reference, rest.angles);
        let (angles, is_regular) = turned(ends.angles, unbent, frame.normal, self.wraps);
        (self.state(ends, frame, rest.distance, angles), is_regular)
    }

    /// The state of any link.
    fn any<S: Lanes>(&self, ends: &Ends<S>, rest: &mut Rest<S>) -> BondState<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if B::ABSENT {
            return self.state(ends, frame, rest.distance, [S::zero(); 2]);
        }
        let unbent = (&mut rest.reference, &mut rest.angles);
        let angles = turned_far(ends.angles, unbent, frame.normal, self.wraps);
        self.state(ends, frame, rest.distance, angles)
    }

    /// The present state of a link.
    pub fn state_of<S: Lanes>(
        &self,
        particles: &Particles<S>,
        pair: Pair,
        mut rest: Rest<S>,
    ) -> BondState<S> {
        let ends = Columns::of(particles).ends(pair);
        self.any(&ends, &mut rest)
    }

    #[inline(always)]
    fn stored<S: Lanes>(&self, state: &BondState<S>) -> S {
        self.normal.stored_energy(state.xi_adjusted)
            + (self.beam.stored_energy(state.zeta[0]) + self.beam.stored_energy(state.zeta[1]))
    }

    #[inline(always)]
    fn heat_rate<S: Lanes>(&self, state: &BondState<S>) -> S {
        self.normal.heat_rate(state.motion.normal_velocity)
            + (self.beam.heat_rate(state.d_zeta[0]) + self.beam.heat_rate(state.d_zeta[1]))
    }
}

/// The loop over all strong links: adds their forces; those that break exert none and are listed.
///
/// Reads positions, velocities and angles; writes forces and, where a frame has turned far, the
/// references of links. Allocates nothing. Without `LEDGER` no heat is found.
pub(crate) struct BondLoop<'a, S: Lanes, M, B, Y, const LEDGER: bool> {
    pub pass: BondPass<M, B, Y>,
    pub particles: &'a Particles<S>,
    pub links: BondColumns<'a, S>,
    pub sums: Sums<'a, S>,
    pub edition: Edition,
}

impl<S: Lanes, M: Metric, B: BeamLaw, Y: YieldLaw, const LEDGER: bool> Work<PartWorkspace<S>>
    for BondLoop<'_, S, M, B, Y, LEDGER>
{
    fn split_at(self, particle: usize) -> (Self, Self) {
        let at = pairs_before(self.links.pairs, self.sums.first + particle);
        let (links, other_links) = self.links.split_at(at);
        let (sums, other_sums) = self.sums.split_at(particle);
        let left = Self {
            links,
            sums,
            ..self
        };
        let right = Self {
            links: other_links,
            sums: other_sums,
            ..left
        };
        (left, right)
    }

    #[inline(always)]
    fn act(mut self, desk: &mut PartWorkspace<S>, instructions: Instructions) {
        let columns = Columns::of(self.particles);
        desk.strong
            .begin(self.edition, self.links.pairs, self.sums.first);
        let is_large = is_large(self.particles.len());
        for links in blocks(self.links.first, self.links.pairs.len()) {
            desk.block.gather(
                columns,
                (self.links.pairs, links.clone()),
                Self::READS,
                is_large.then_some(&self.sums),
                |link| self.links.prefetch(link),
            );
            let mut flags = self.compute(&mut desk.block, links.clone());
            if flags & IRREGULAR != 0 {
                flags |= self.compute_irregular(&mut desk.block, links.clone());
            }
            let all = flags & IDLE == 0;
            if !all {
                self.note_broken(desk, links.clone());
            }
            let scatter = Scatter::<_, LEDGER> {
                pairs: &self.links.pairs[links.clone()],
                outputs: &desk.block.outputs,
                turns: !B::ABSENT,
                all,
                sums: self.sums.again(),
                tally: &mut desk.tally,
            };
            S::run(instructions, scatter);
            let outputs = &desk.block.outputs;
            desk.strong
                .note(self.links.pairs, links, outputs, !B::ABSENT);
        }
        if LEDGER {
            self.book_breaking(desk);
        }
    }

    fn start(ready: Ready<Self, PartWorkspace<S>>) {
        S::run(ready.instructions, ready);
    }
}

impl<S: Lanes, M: Metric, B: BeamLaw, Y: YieldLaw, const LEDGER: bool>
    BondLoop<'_, S, M, B, Y, LEDGER>
{
    const READS: Reads = Reads {
        angles: !B::ABSENT,
        spins: !B::ABSENT,
        radii: false,
    };

    #[inline(always)]
    fn compute(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64 {
        let number = positions.len().min(LINKS);
        let links = self.links.part(positions.start..positions.start + number);
        let (inputs, frames, outputs) = block.open(self.pass.metric, number);
        let mut flags = 0;
        for lane in 0..number {
            let rest = links.rest(lane);
            let ends = with_radii(inputs.ends(lane), &links, lane);
            let (state, is_regular) = self.pass.regular(&ends, frames.at(lane), &rest);
            let flag = self
                .pass
                .settle::<S, LEDGER>(outputs, lane, &state, links.sections[lane])
                | (IRREGULAR * u64::from(!is_regular));
            outputs.flags[lane] = flag;
            flags |= flag;
        }
        flags
    }

    /// Compute again what is irregular; tells the flags of these links.
    #[cold]
    #[inline(never)]
    fn compute_irregular(&mut self, block: &mut Block<S>, positions: Range<usize>) -> u64 {
        let mut flags = 0;
        for (lane, position) in positions.enumerate() {
            if block.outputs.flags[lane] & IRREGULAR == 0 {
                continue;
            }
            let mut rest = self.links.rest(position);
            let ends = with_radii(block.inputs.ends(lane), &self.links, position);
            let state = self.pass.any(&ends, &mut rest);
            self.links.refer(position, &rest);
            let section = self.links.sections[position];
            let outputs = &mut block.outputs;
            let flag = self
                .pass
                .settle::<S, LEDGER>(outputs, lane, &state, section);
            outputs.flags[lane] = flag;
            flags |= flag;
        }
        flags
    }

    /// List the links of a block that break.
    #[cold]
    #[inline(never)]
    fn note_broken(&self, desk: &mut PartWorkspace<S>, positions: Range<usize>) {
        let flags = &desk.block.outputs.flags;
        for (position, flag) in positions.zip(flags) {
            if flag & IDLE != 0 {
                desk.broken.push((self.links.first + position) as u32);
            }
        }
    }

    fn book_breaking(&self, desk: &mut PartWorkspace<S>) {
        for &position in &desk.broken {
            let position = position as usize - self.links.first;
            let (pair, rest) = (self.links.pairs[position], self.links.rest(position));
            let state = self.pass.state_of(self.particles, pair, rest);
            desk.tally.breaking += self.pass.stored(&state);
        }
    }
}

/// The ends of the link at a position, with the radii that it keeps.
#[inline(always)]
fn with_radii<S: Lanes>(ends: Ends<S>, links: &BondColumns<S>, position: usize) -> Ends<S> {
    Ends {
        radii: links.radii.map(|radii| radii[position]),
        ..ends
    }
}

impl<M: Metric, B: BeamLaw, Y: YieldLaw> BondPass<M, B, Y> {
    /// Write what a link does into its lane; tells whether it breaks.
    #[inline(always)]
    fn settle<S: Lanes, const LEDGER: bool>(
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
        let breaks = self.breaks(state, section);
        if LEDGER {
            let heat_rate = self.heat_rate(state);
            outputs.heat_rate[lane] = if breaks { S::zero() } else { heat_rate };
            outputs.heat[lane] = S::zero();
        }
        IDLE * u64::from(breaks)
    }

    #[inline(always)]
    fn breaks<S: Lanes>(&self, state: &BondState<S>, section: S) -> bool {
        self.yielding
            .is_exceeded(state.normal_force, state.tangential_force, section)
    }
}

/// Energy stored in all strong links in J, thesis eq. (77).
pub(crate) fn stored_in_bonds<S: Lanes, M: Metric, B: BeamLaw, Y: YieldLaw>(
    pass: BondPass<M, B, Y>,
    particles: &Particles<S>,
    strong: &Bonds<S>,
) -> S {
    let mut sum = S::zero();
    for link in strong.iter() {
        sum += pass.stored(&pass.state_of(particles, link.pair, link.rest));
    }
    sum
}
