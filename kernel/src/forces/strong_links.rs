//! The pass over strong links.

use super::block::{Block, Columns, Ends, LINKS, Outputs};
use super::{Forces, Tally};
use crate::geometry::{Metric, PairFrame, PairMotion, is_wrapped, small_turn, turn, wrapped};
use crate::laws::{AdjustedKelvinVoigt, BeamLaw, ZhangEckert};
use crate::links::{Rest, StrongLink, StrongLinks};
use crate::particles::Particles;
use crate::scalar::Real;

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
    fn regular<S: Real>(&self, ends: &Ends<S>, rest: &Rest<S>) -> (StrongState<S>, bool) {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if B::ABSENT {
            return (self.state(ends, frame, rest.distance, [S::zero(); 2]), true);
        }
        let (turned, is_small) = small_turn(rest.reference, frame.normal);
        let angles = [0, 1].map(|end| ends.angles[end] - rest.angles[end] - turned);
        let keeps = !self.wraps | (is_wrapped(angles[0]) & is_wrapped(angles[1]));
        (
            self.state(ends, frame, rest.distance, angles),
            is_small & keeps,
        )
    }

    /// The state of any link.
    ///
    /// A link whose frame has turned far from its reference takes the present direction as the new
    /// one; the rest angles turn with it, so that angles stay functions of the state and never jump.
    fn any<S: Real>(&self, ends: &Ends<S>, rest: &mut Rest<S>) -> StrongState<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if B::ABSENT {
            return self.state(ends, frame, rest.distance, [S::zero(); 2]);
        }
        let (turned, is_small) = turn(rest.reference, frame.normal);
        let angles = [0, 1].map(|end| {
            let angle = ends.angles[end] - rest.angles[end] - turned;
            if self.wraps { wrapped(angle) } else { angle }
        });
        if !is_small {
            rest.reference = frame.normal;
            rest.angles = rest.angles.map(|angle| angle + turned);
        }
        self.state(ends, frame, rest.distance, angles)
    }

    /// The present state of a link.
    pub fn state_of<S: Real>(
        &self,
        particles: &Particles<S>,
        mut link: StrongLink<S>,
    ) -> StrongState<S> {
        let ends = Columns::of(particles).ends(link.pair);
        self.any(&ends, &mut link.rest)
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
    pub strong: &'a mut StrongLinks<S>,
    pub forces: &'a mut Forces<S>,
    pub tally: &'a mut Tally<S>,
    pub block: &'a mut Block<S>,
}

impl<S: Real, M: Metric, B: BeamLaw, const YIELDS: bool, const LEDGER: bool> pulp::NullaryFnOnce
    for StrongLoop<'_, S, M, B, YIELDS, LEDGER>
{
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        let number = self.strong.len();
        let columns = Columns::of(self.particles);
        for first in (0..number).step_by(LINKS) {
            let last = number.min(first + LINKS);
            let pairs = &self.strong.pairs[first..last];
            self.block.inputs.gather(columns, pairs);
            let flags = self.compute(first, last);
            if flags & IRREGULAR != 0 {
                self.compute_irregular(first, last);
            }
            self.scatter(first, last);
        }
        if LEDGER {
            for &position in &self.strong.broken {
                let link = self.strong.get(position as usize);
                self.tally.breaking += self.pass.stored(&self.pass.state_of(self.particles, link));
            }
        }
    }
}

impl<S: Real, M: Metric, B: BeamLaw, const YIELDS: bool, const LEDGER: bool>
    StrongLoop<'_, S, M, B, YIELDS, LEDGER>
{
    #[inline(always)]
    fn compute(&mut self, first: usize, last: usize) -> u64 {
        let number = (last - first).min(LINKS);
        let references = &self.strong.references[first..][..number];
        let angles = &self.strong.angles[first..][..number];
        let distances = &self.strong.distances[first..][..number];
        let factors = &self.strong.strength_factors[first..][..number];
        let (inputs, outputs) = (&*self.block.inputs, &mut *self.block.outputs);
        let mut flags = 0;
        for lane in 0..number {
            let rest = Rest {
                reference: references[lane],
                angles: angles[lane],
                distance: distances[lane],
            };
            let ends = inputs.ends(lane);
            let (state, is_regular) = self.pass.regular(&ends, &rest);
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
    fn compute_irregular(&mut self, first: usize, last: usize) {
        for lane in 0..last - first {
            if self.block.outputs.flags[lane] & IRREGULAR == 0 {
                continue;
            }
            let position = first + lane;
            let StrongLink {
                mut rest,
                strength_factor,
                ..
            } = self.strong.get(position);
            let ends = self.block.inputs.ends(lane);
            let state = self.pass.any(&ends, &mut rest);
            self.strong.references[position] = rest.reference;
            self.strong.angles[position] = rest.angles;
            self.block.outputs.flags[lane] = self.pass.settle::<S, YIELDS, LEDGER>(
                &mut self.block.outputs,
                lane,
                &state,
                ends.radii,
                strength_factor,
            );
        }
    }

    #[inline(always)]
    fn scatter(&mut self, first: usize, last: usize) {
        let mut sums = self.forces.sums();
        let mut heat_rate = self.tally.friction_rate;
        let pairs = &self.strong.pairs[first..last];
        for (lane, &pair) in pairs.iter().enumerate().take(LINKS) {
            if YIELDS && self.block.outputs.flags[lane] & BREAKS != 0 {
                self.strong.broken.push((first + lane) as u32);
                continue;
            }
            if LEDGER {
                heat_rate += self.block.outputs.heat_rate[lane];
            }
            sums.add_forces(pair, self.block.outputs.force(lane));
            if !B::ABSENT {
                sums.add_torques(pair, self.block.outputs.torques(lane));
            }
        }
        self.tally.friction_rate = heat_rate;
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
        let force = state.frame.normal * state.normal_force
            + state.frame.tangent() * state.tangential_force;
        outputs.set(lane, force, state.torques);
        if LEDGER {
            outputs.heat_rate[lane] = self.heat_rate(state);
        }
        let breaks = match self.yielding {
            Some(law) if YIELDS => law.breaks(
                state.normal_force,
                state.tangential_force,
                radii,
                strength_factor,
            ),
            _ => false,
        };
        BREAKS * u64::from(breaks)
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
        sum += pass.stored(&pass.state_of(particles, link));
    }
    sum
}
