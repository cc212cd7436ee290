//! The pass over weak links.

use super::block::{Block, Columns, Ends, LINKS, Outputs};
use super::{Forces, Tally};
use crate::geometry::{Arm, Metric, PairFrame, PairMotion, is_wrapped, small_turn, turn, wrapped};
use crate::instructions::Instructions;
use crate::laws::{Friction, NormalLaw, Slide, TangentialLaw};
use crate::links::{ContactMemory, StrongLinks, WeakLinks};
use crate::model::Reading;
use crate::particles::Particles;
use crate::scalar::Real;

/// Laws and choices of the pass.
#[derive(Clone, Copy)]
pub(crate) struct WeakPass<M, A, N, T> {
    pub metric: M,
    pub arm: A,
    pub normal: N,
    pub tangential: T,
    pub reading: Reading,
    /// Time since the previous evaluation in s, for arms that accumulate.
    pub elapsed: f64,
}

/// A contact in its present state.
pub(crate) struct WeakState<S> {
    pub frame: PairFrame<S>,
    pub motion: PairMotion<S>,
    pub xi: S,
    pub zeta: [S; 2],
    pub d_zeta: [S; 2],
    pub normal_force: S,
    pub friction: Friction<S>,
    pub tangential_force: S,
    pub torques: [S; 2],
}

/// A frame that has turned far from its reference, or an angle to be wrapped.
const IRREGULAR: u64 = 1;

impl<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw> WeakPass<M, A, N, T> {
    /// Whether tangential displacements are functions of the present angles.
    const FOLLOWS_ANGLES: bool = T::REMEMBERS && !A::ACCUMULATES;

    /// Kinematics and forces of a contact whose ends have turned by the given angles since it began, in
    /// rad; thesis eqs. (28)-(42).
    #[inline(always)]
    fn state<S: Real>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        angles: [S; 2],
        memory: &mut ContactMemory<S>,
    ) -> WeakState<S> {
        let motion = PairMotion::new(&frame, ends.velocity);
        let xi = frame.normal_displacement(ends.radii);
        let normal_force = self.normal.force(ends.radii, xi, motion.normal_velocity);
        let mut state = WeakState {
            frame,
            motion,
            xi,
            zeta: [S::zero(); 2],
            d_zeta: [S::zero(); 2],
            normal_force,
            friction: Friction {
                force: S::zero(),
                heat_rate: S::zero(),
                heat: S::zero(),
            },
            tangential_force: S::zero(),
            torques: [S::zero(); 2],
        };
        if !T::ABSENT {
            self.rub(ends, angles, memory, &mut state);
        }
        state
    }

    /// The tangential part: displacements, velocities, force and torques of both ends.
    #[inline(always)]
    fn rub<S: Real>(
        &self,
        ends: &Ends<S>,
        angles: [S; 2],
        memory: &mut ContactMemory<S>,
        state: &mut WeakState<S>,
    ) {
        let arms = self.arm.distances(ends.radii, state.frame.distance);
        state.d_zeta = self
            .arm
            .velocities(ends.radii, &state.frame, &state.motion, ends.spins);
        if Self::FOLLOWS_ANGLES {
            state.zeta = [arms[0] * angles[0], arms[1] * angles[1]];
        } else if T::REMEMBERS {
            memory.ends = [0, 1].map(|end| memory.ends[end] + state.d_zeta[end] * self.elapsed);
            state.zeta = memory.ends;
        }
        let slide = Slide {
            displacement: state.zeta[0] + state.zeta[1],
            velocity: state.d_zeta[0] + state.d_zeta[1],
        };
        state.friction = self
            .tangential
            .friction(slide, state.normal_force, &mut memory.state);
        state.torques = [
            arms[0] * state.friction.force,
            arms[1] * state.friction.force,
        ];
        state.tangential_force = if A::ACCUMULATES || self.reading == Reading::Thesis {
            state.friction.force
        } else {
            (state.torques[0] + state.torques[1]) * state.frame.inverse_distance
        };
    }

    /// The memory of a contact that begins.
    pub fn begin<S: Real>(&self, frame: &PairFrame<S>, angles: [S; 2]) -> ContactMemory<S> {
        let ends = if A::ACCUMULATES {
            [S::zero(); 2]
        } else {
            angles
        };
        ContactMemory::begin(frame, ends)
    }

    /// The state of most contacts, thesis eqs. (29)-(32), and whether it is that of this one.
    #[inline(always)]
    fn regular<S: Real>(
        &self,
        ends: &Ends<S>,
        memory: &mut ContactMemory<S>,
    ) -> (WeakState<S>, bool) {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if !Self::FOLLOWS_ANGLES {
            return (self.state(ends, frame, [S::zero(); 2], memory), true);
        }
        let (turned, is_small) = small_turn(memory.reference, frame.normal);
        let angles = [0, 1].map(|end| ends.angles[end] - memory.ends[end] - turned);
        let keeps =
            (self.reading != Reading::Thesis) | angles.map(is_wrapped).iter().all(|&keeps| keeps);
        (self.state(ends, frame, angles, memory), is_small & keeps)
    }

    /// The state of any contact; a frame that has turned far becomes the reference of its turn.
    pub fn any<S: Real>(&self, ends: &Ends<S>, memory: &mut ContactMemory<S>) -> WeakState<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if !Self::FOLLOWS_ANGLES {
            return self.state(ends, frame, [S::zero(); 2], memory);
        }
        let (turned, is_small) = turn(memory.reference, frame.normal);
        let angles = [0, 1].map(|end| {
            let angle = ends.angles[end] - memory.ends[end] - turned;
            if self.reading == Reading::Thesis {
                wrapped(angle)
            } else {
                angle
            }
        });
        if !is_small {
            memory.reference = frame.normal;
            memory.ends = memory.ends.map(|angle| angle + turned);
        }
        self.state(ends, frame, angles, memory)
    }

    /// Energy stored in a contact in J.
    #[inline(always)]
    fn stored<S: Real>(&self, radii: [S; 2], state: &WeakState<S>, memory: S) -> S {
        let displacement = state.zeta[0] + state.zeta[1];
        self.normal.stored_energy(radii, state.xi)
            + self
                .tangential
                .stored_energy(displacement, state.normal_force, memory)
    }

    /// Power turned into heat in a contact in W: what the elastic forces do not give back.
    #[inline(always)]
    fn heat_rate<S: Real>(&self, radii: [S; 2], state: &WeakState<S>) -> S {
        let viscous = self.normal.elastic_force(radii, state.xi) - state.normal_force;
        viscous * state.motion.normal_velocity + state.friction.heat_rate
    }
}

/// The loop over all pairs: adds the forces of those that overlap, and begins or ends their memory.
///
/// `strong` tells the pairs whose bonds broke in this evaluation: if they overlap, their stored energy
/// is booked as work of bonding. Allocates nothing.
pub(crate) struct WeakLoop<'a, S: Real, M, A, N, T, const LEDGER: bool> {
    pub pass: WeakPass<M, A, N, T>,
    pub particles: &'a Particles<S>,
    pub weak: &'a mut WeakLinks<S>,
    pub strong: Option<&'a StrongLinks<S>>,
    pub forces: &'a mut Forces<S>,
    pub tally: &'a mut Tally<S>,
    pub block: &'a mut Block<S>,
}

impl<S: Real, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw, const LEDGER: bool>
    pulp::NullaryFnOnce for WeakLoop<'_, S, M, A, N, T, LEDGER>
{
    type Output = ();

    #[inline(always)]
    fn call(mut self) {
        let columns = Columns::of(self.particles);
        let mut next = 0;
        while next < self.weak.pairs.len() {
            let lanes;
            (lanes, next) = self.find_touching(columns, next);
            self.gather(columns, lanes);
            if self.compute(lanes) & IRREGULAR != 0 {
                self.compute_irregular(lanes);
            }
            if T::REMEMBERS {
                self.remember(lanes);
            }
            self.scatter(lanes);
            if LEDGER {
                self.book_bonding(lanes);
            }
        }
    }
}

impl<S: Real, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw, const LEDGER: bool>
    WeakLoop<'_, S, M, A, N, T, LEDGER>
{
    /// Run the loop.
    pub fn run(self, instructions: Instructions) {
        A::run::<S, Self>(instructions, self);
    }

    /// Put pairs that overlap into the lanes of the block, from a position on, until it is full or no pair
    /// is left; returns the number of lanes and the position after the last pair looked at.
    #[inline(always)]
    fn find_touching(&mut self, columns: Columns<S>, first: usize) -> (usize, usize) {
        let number = self.weak.pairs.len();
        let (mut lanes, mut position) = (0, first);
        while position < number && lanes < LINKS {
            let (difference, radii) = columns.gap(self.weak.pairs[position]);
            let reach = radii[0] + radii[1];
            let overlaps = self.pass.metric.nearest(difference).norm_squared() < reach * reach;
            if T::REMEMBERS && overlaps != self.weak.memories.touches[position] {
                if LEDGER && lanes > 0 {
                    // What ends here is booked after what came before.
                    break;
                }
                self.begin_or_end(position, overlaps);
            }
            // Every pair is put down, and those that do not overlap are written over: no branch.
            self.block.inputs.position[lanes] = position as u32;
            self.block.inputs.difference[lanes] = difference;
            self.block.inputs.radii[lanes] = radii;
            lanes += usize::from(overlaps);
            position += 1;
        }
        (lanes, position)
    }

    /// A contact that ends: without a normal force no law stores anything, all that was left is heat.
    #[cold]
    #[inline(never)]
    fn begin_or_end(&mut self, position: usize, begins: bool) {
        let ends = Columns::of(self.particles).ends(self.weak.pairs[position]);
        if begins {
            let frame = PairFrame::new(self.pass.metric.nearest(ends.difference));
            let memory = self.pass.begin(&frame, ends.angles);
            self.weak.memories.set(position, memory);
            return;
        }
        if LEDGER {
            let state = self.pass.any(&ends, &mut self.weak.memories.get(position));
            self.tally.friction += state.friction.heat;
        }
        self.weak.memories.touches[position] = false;
    }

    #[inline(always)]
    fn gather(&mut self, columns: Columns<S>, lanes: usize) {
        let memories = &self.weak.memories;
        for lane in 0..lanes.min(LINKS) {
            let position = self.block.inputs.position[lane] as usize;
            let pair = self.weak.pairs[position];
            self.block.inputs.velocity[lane] = columns.relative_velocity(pair);
            if !T::ABSENT {
                self.block.inputs.spins[lane] = columns.spins(pair);
            }
            if WeakPass::<M, A, N, T>::FOLLOWS_ANGLES {
                self.block.inputs.angles[lane] = columns.angles(pair);
                self.block.inputs.reference[lane] = memories.references[position];
            }
            if T::REMEMBERS {
                self.block.inputs.rest[lane] = memories.ends[position];
                self.block.inputs.state[lane] = memories.states[position];
            }
        }
    }

    #[inline(always)]
    fn compute(&mut self, lanes: usize) -> u64 {
        let (inputs, outputs) = (&*self.block.inputs, &mut *self.block.outputs);
        let mut flags = 0;
        for lane in 0..lanes.min(LINKS) {
            let mut memory = inputs.memory(lane);
            let ends = inputs.ends(lane);
            let (state, is_regular) = self.pass.regular(&ends, &mut memory);
            if T::REMEMBERS {
                outputs.state[lane] = memory.state;
            }
            if A::ACCUMULATES {
                for end in 0..2 {
                    outputs.rest[end][lane] = memory.ends[end];
                }
            }
            self.pass
                .put::<S, LEDGER>(outputs, lane, &state, ends.radii);
            outputs.flags[lane] = IRREGULAR * u64::from(!is_regular);
            flags |= outputs.flags[lane];
        }
        flags
    }

    #[cold]
    #[inline(never)]
    fn compute_irregular(&mut self, lanes: usize) {
        for lane in 0..lanes.min(LINKS) {
            if self.block.outputs.flags[lane] & IRREGULAR != 0 {
                let ends = self.block.inputs.ends(lane);
                let mut memory = self.block.inputs.memory(lane);
                let state = self.pass.any(&ends, &mut memory);
                self.block.outputs.state[lane] = memory.state;
                self.pass
                    .put::<S, LEDGER>(&mut self.block.outputs, lane, &state, ends.radii);
                let position = self.block.inputs.position[lane] as usize;
                self.weak.memories.set(position, memory);
            }
        }
    }

    #[inline(always)]
    fn remember(&mut self, lanes: usize) {
        for lane in 0..lanes.min(LINKS) {
            let position = self.block.inputs.position[lane] as usize;
            self.weak.memories.states[position] = self.block.outputs.state[lane];
            if A::ACCUMULATES {
                self.weak.memories.ends[position] = self.block.outputs.rest.map(|end| end[lane]);
            }
        }
    }

    #[inline(always)]
    fn scatter(&mut self, lanes: usize) {
        let mut sums = self.forces.sums();
        let (mut heat_rate, mut heat) = (self.tally.friction_rate, self.tally.friction);
        for lane in 0..lanes.min(LINKS) {
            let pair = self.weak.pairs[self.block.inputs.position[lane] as usize];
            if LEDGER {
                heat_rate += self.block.outputs.heat_rate[lane];
                heat += self.block.outputs.heat[lane];
            }
            sums.add_forces(pair, self.block.outputs.force(lane));
            if !T::ABSENT {
                sums.add_torques(pair, self.block.outputs.torques(lane));
            }
        }
        (self.tally.friction_rate, self.tally.friction) = (heat_rate, heat);
    }

    /// Book the energy of contacts that take the place of broken bonds.
    #[inline(always)]
    fn book_bonding(&mut self, lanes: usize) {
        let Some(strong) = self.strong.filter(|strong| !strong.broken.is_empty()) else {
            return;
        };
        for lane in 0..lanes.min(LINKS) {
            if strong.breaks_now(self.weak.pairs[self.block.inputs.position[lane] as usize]) {
                let ends = self.block.inputs.ends(lane);
                let mut memory = self.block.inputs.memory(lane);
                memory.state = self.block.outputs.state[lane];
                if A::ACCUMULATES {
                    memory.ends = self.block.outputs.rest.map(|end| end[lane]);
                }
                let pass = WeakPass {
                    elapsed: 0.0,
                    ..self.pass
                };
                let state = pass.any(&ends, &mut memory);
                self.tally.bonding += pass.stored(ends.radii, &state, memory.state);
            }
        }
    }
}

impl<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw> WeakPass<M, A, N, T> {
    /// Write what a contact does into its lane.
    #[inline(always)]
    fn put<S: Real, const LEDGER: bool>(
        &self,
        outputs: &mut Outputs<S>,
        lane: usize,
        state: &WeakState<S>,
        radii: [S; 2],
    ) {
        let force = state.frame.normal * state.normal_force
            + state.frame.tangent() * state.tangential_force;
        outputs.set(lane, force, state.torques);
        if LEDGER {
            outputs.heat_rate[lane] = self.heat_rate(radii, state);
            outputs.heat[lane] = state.friction.heat;
        }
    }
}

/// Energy stored in all contacts in J, thesis eqs. (75)-(76).
pub(crate) fn stored_in_weak_links<S: Real, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
    pass: WeakPass<M, A, N, T>,
    particles: &Particles<S>,
    weak: &WeakLinks<S>,
) -> S {
    let columns = Columns::of(particles);
    let mut sum = S::zero();
    for (position, pair) in weak.pairs.iter().enumerate() {
        let (i, j) = pair.indices();
        let displacement = pass
            .metric
            .displacement(particles.position[i], particles.position[j]);
        let radii = [particles.radius[i], particles.radius[j]];
        let frame = PairFrame::new(displacement);
        if frame.distance >= radii[0] + radii[1] {
            continue;
        }
        let mut memory = weak
            .memory_at(position)
            .unwrap_or_else(|| pass.begin(&frame, [particles.angle[i], particles.angle[j]]));
        let state = pass.any(&columns.ends(*pair), &mut memory);
        sum += pass.stored(radii, &state, memory.state);
    }
    sum
}
