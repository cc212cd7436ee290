//! The pass over strong links.

use super::block::{Block, Columns, Ends, LINKS, Outputs};
use super::turning::{turned, turned_far};
use super::{Arrival, Desk, Sums};
use crate::geometry::{Metric, PairFrame, PairMotion, Vec2};
use crate::instructions::Instructions;
use crate::laws::{AdjustedKelvinVoigt, BeamLaw, ZhangEckert};
use crate::links::{Pair, Rest, StrongColumns, StrongLinks, pairs_before};
use crate::particles::Particles;
use crate::parts::{Ready, Work};
use crate::scalar::Real;
use core::ops::Range;

/// Laws and choices of the pass.
#[derive(Clone, Copy)]
pub(crate) struct StrongPass<M, B> {
    pub metric: M,
    pub normal: AdjustedKelvinVoigt,
    pub beam: B,
    pub yielding: Option<ZhangEckert>,
    /// Whether angles are wrapped to [-pi, pi), as the thesis author did.
    pub wraps: bool,
}

/// A strong link in its present state.
pub(crate) struct StrongState<S> {
    pub frame: PairFrame<S>,
    pub motion: PairMotion<S>,
    pub xi_adjusted: S,
    pub zeta: [S; 2],
    pub d_zeta: [S; 2],
    pub normal_force: S,
    pub tangential_force: S,
    pub torques: [S; 2],
}

impl<S: Real> StrongState<S> {
    /// Force on i in N.
    #[inline(always)]
    pub fn force(&self) -> Vec2<S> {
        self.frame.vector(self.normal_force, self.tangential_force)
    }
}

/// A frame that has turned far from its reference, or an angle to be wrapped.
const IRREGULAR: u64 = 1;
/// A link that breaks.
const BREAKS: u64 = 2;

impl<M: Metric, B: BeamLaw> StrongPass<M, B> {
    /// Forces of a link whose ends are at the given angles, in rad, to their unbent directions; thesis
    /// eqs. (33)-(34) and (43)-(45).
    #[inline(always)]
    fn state<S: Real>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        rest_distance: S,
        angles: [S; 2],
    ) -> StrongState<S> {
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
        StrongState {
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
    fn regular<S: Real>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        rest: &Rest<S>,
    ) -> (StrongState<S>, bool) {
        if B::ABSENT {
            return (self.state(ends, frame, rest.distance, [S::zero(); 2]), true);
        }
        let unbent = (rest.reference, rest.angles);
        let (angles, is_regular) = turned(ends.angles, unbent, frame.normal, self.wraps);
        (self.state(ends, frame, rest.distance, angles), is_regular)
    }

    /// The state of any link.
    fn any<S: Real>(&self, ends: &Ends<S>, rest: &mut Rest<S>) -> StrongState<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if B::ABSENT {
            return self.state(ends, frame, rest.distance, [S::zero(); 2]);
        }
        let unbent = (&mut rest.reference, &mut rest.angles);
        let angles = turned_far(ends.angles, unbent, frame.normal, self.wraps);
        self.state(ends, frame, rest.distance, angles)
    }

    /// The present state of a link.
    pub fn state_of<S: Real>(
        &self,
        particles: &Particles<S>,
        pair: Pair,
        mut rest: Rest<S>,
    ) -> StrongState<S> {
        let ends = Columns::of(particles).ends(pair);
        self.any(&ends, &mut rest)
    }

    /// Force on i in N and torque on j in N m of the link at a position; nothing if it breaks.
    pub fn effect<S: Real>(
        &self,
        particles: &Particles<S>,
        strong: &StrongLinks<S>,
        position: usize,
    ) -> Option<(Vec2<S>, S)> {
        let link = strong.get(position);
        let ends = Columns::of(particles).ends(link.pair);
        let state = self.any(&ends, &mut { link.rest });
        let breaks = self.breaks(&state, ends.radii, link.strength_factor);
        (!breaks).then(|| (state.force(), state.torques[1]))
    }

    #[inline(always)]
    fn stored<S: Real>(&self, state: &StrongState<S>) -> S {
        self.normal.stored_energy(state.xi_adjusted)
            + (self.beam.stored_energy(state.zeta[0]) + self.beam.stored_energy(state.zeta[1]))
    }

    #[inline(always)]
    fn heat_rate<S: Real>(&self, state: &StrongState<S>) -> S {
        self.normal.heat_rate(state.motion.normal_velocity)
            + (self.beam.heat_rate(state.d_zeta[0]) + self.beam.heat_rate(state.d_zeta[1]))
    }
}

/// The loop over all strong links: adds their forces; those that break exert none and are listed.
///
/// Reads positions, velocities and angles; writes forces and, where a frame has turned far, the
/// references of links. Allocates nothing. `YIELDS` and `LEDGER` leave out what they name.
pub(crate) struct StrongLoop<'a, S: Real, M, B, const YIELDS: bool, const LEDGER: bool> {
    pub pass: StrongPass<M, B>,
    pub particles: &'a Particles<S>,
    pub links: StrongColumns<'a, S>,
    pub sums: Sums<'a, S>,
    pub arrivals: &'a [Vec<Arrival<S>>],
}

impl<S: Real, M: Metric, B: BeamLaw, const YIELDS: bool, const LEDGER: bool> Work<Desk<S>>
    for StrongLoop<'_, S, M, B, YIELDS, LEDGER>
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
    fn act(mut self, desk: &mut Desk<S>) {
        let number = self.links.pairs.len();
        let columns = Columns::of(self.particles);
        if B::ABSENT {
            self.sums.add_arrivals::<false>(self.arrivals);
        } else {
            self.sums.add_arrivals::<true>(self.arrivals);
        }
        for first in (0..number).step_by(LINKS) {
            let last = number.min(first + LINKS);
            let pairs = &self.links.pairs[first..last];
            (desk.block.inputs).gather(columns, pairs, !B::ABSENT, !B::ABSENT);
            if self.compute(&mut desk.block, first..last) & IRREGULAR != 0 {
                self.compute_irregular(&mut desk.block, first..last);
            }
            self.scatter(desk, first..last);
        }
        if LEDGER {
            self.book_breaking(desk);
        }
    }

    fn start(ready: Ready<Self, Desk<S>>, instructions: Instructions) {
        S::run(instructions, ready);
    }
}

impl<S: Real, M: Metric, B: BeamLaw, const YIELDS: bool, const LEDGER: bool>
    StrongLoop<'_, S, M, B, YIELDS, LEDGER>
{
    #[inline(always)]
    fn compute(&mut self, block: &mut Block<S>, links: Range<usize>) -> u64 {
        let number = links.len().min(LINKS);
        let references = &self.links.references[links.start..][..number];
        let angles = &self.links.angles[links.start..][..number];
        let distances = &self.links.distances[links.start..][..number];
        let factors = &self.links.strength_factors[links.start..][..number];
        let (inputs, outputs) = (&*block.inputs, &mut *block.outputs);
        block.frames.find(self.pass.metric, inputs, number);
        let mut flags = 0;
        for lane in 0..number {
            let rest = Rest {
                reference: references[lane],
                angles: angles[lane],
                distance: distances[lane],
            };
            let ends = inputs.ends(lane);
            let (state, is_regular) = self.pass.regular(&ends, block.frames.at(lane), &rest);
            let flag = self.pass.settle::<S, YIELDS, LEDGER>(
                outputs,
                lane,
                &state,
                ends.radii,
                factors[lane],
            ) | (IRREGULAR * u64::from(!is_regular));
            outputs.flags[lane] = flag;
            flags |= flag;
        }
        flags
    }

    #[cold]
    #[inline(never)]
    fn compute_irregular(&mut self, block: &mut Block<S>, links: Range<usize>) {
        for (lane, position) in links.enumerate() {
            if block.outputs.flags[lane] & IRREGULAR == 0 {
                continue;
            }
            let mut rest = self.links.rest(position);
            let ends = block.inputs.ends(lane);
            let state = self.pass.any(&ends, &mut rest);
            self.links.references[position] = rest.reference;
            self.links.angles[position] = rest.angles;
            block.outputs.flags[lane] = self.pass.settle::<S, YIELDS, LEDGER>(
                &mut block.outputs,
                lane,
                &state,
                ends.radii,
                self.links.strength_factors[position],
            );
        }
    }

    #[inline(always)]
    fn scatter(&mut self, desk: &mut Desk<S>, links: Range<usize>) {
        let outputs = &*desk.block.outputs;
        let before = self.links.first + links.start;
        let mut sums = self.sums.equally_long();
        let mut heat_rate = desk.tally.friction_rate;
        for (lane, &pair) in (0..LINKS).zip(&self.links.pairs[links]) {
            if YIELDS && outputs.flags[lane] & BREAKS != 0 {
                desk.broken.push((before + lane) as u32);
                continue;
            }
            if LEDGER {
                heat_rate += outputs.heat_rate[lane];
            }
            let (force, torques) = (outputs.force(lane), outputs.torques(lane));
            if B::ABSENT {
                sums.add::<false>(pair, force, torques);
            } else {
                sums.add::<true>(pair, force, torques);
            }
        }
        desk.tally.friction_rate = heat_rate;
    }

    fn book_breaking(&self, desk: &mut Desk<S>) {
        for &position in &desk.broken {
            let position = position as usize - self.links.first;
            let (pair, rest) = (self.links.pairs[position], self.links.rest(position));
            let state = self.pass.state_of(self.particles, pair, rest);
            desk.tally.breaking += self.pass.stored(&state);
        }
    }
}

impl<M: Metric, B: BeamLaw> StrongPass<M, B> {
    /// Write what a link does into its lane.
    #[inline(always)]
    fn settle<S: Real, const YIELDS: bool, const LEDGER: bool>(
        &self,
        outputs: &mut Outputs<S>,
        lane: usize,
        state: &StrongState<S>,
        radii: [S; 2],
        strength_factor: S,
    ) -> u64 {
        outputs.set_force(lane, state.force());
        if !B::ABSENT {
            outputs.set_torques(lane, state.torques);
        }
        if LEDGER {
            outputs.heat_rate[lane] = self.heat_rate(state);
        }
        BREAKS * u64::from(YIELDS && self.breaks(state, radii, strength_factor))
    }

    #[inline(always)]
    pub fn breaks<S: Real>(
        &self,
        state: &StrongState<S>,
        radii: [S; 2],
        strength_factor: S,
    ) -> bool {
        let (normal, tangential) = (state.normal_force, state.tangential_force);
        self.yielding
            .is_some_and(|law| law.breaks(normal, tangential, radii, strength_factor))
    }
}

/// Energy stored in all strong links in J, thesis eq. (77).
pub(crate) fn stored_in_strong_links<S: Real, M: Metric, B: BeamLaw>(
    pass: StrongPass<M, B>,
    particles: &Particles<S>,
    strong: &StrongLinks<S>,
) -> S {
    let mut sum = S::zero();
    for link in strong.iter() {
        sum += pass.stored(&pass.state_of(particles, link.pair, link.rest));
    }
    sum
}
