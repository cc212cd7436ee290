//! The pass over weak links.

use super::block::{Block, Columns, Ends, IDLE, IRREGULAR, LINKS, Outputs, Reads, blocks};
use super::prefetch::is_large;
use super::scatter::Scatter;
use super::turning::{turned, turned_far};
use super::{PartWorkspace, Sums};
use crate::bonds::Bonds;
use crate::bonds::Edition;
use crate::contacts::{ContactMemory, Contacts, MemoryColumns};
use crate::geometry::{Arm, PairFrame, PairMotion};
use crate::laws::{Friction, NormalLaw, Slide, TangentialLaw};
use crate::model::Reading;
use crate::particles::Particles;
use core::ops::Range;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::instructions::Instructions;
use gouge_common::lanes::Lanes;
use gouge_common::pair::{Pair, pairs_before};
use gouge_common::parts::{Ready, Work};
use pulp::NullaryFnOnce;

/// Laws and choices of the pass.
#[derive(Clone, Copy)]
pub(crate) struct ContactPass<M, A, N, T> {
    pub metric: M,
    pub arm: A,
    pub normal: N,
    pub tangential: T,
    pub reading: Reading,
    /// Time since the previous evaluation in s, for arms that accumulate.
    pub elapsed: f64,
}

/// A contact in its present state.
pub(crate) struct ContactState<S> {
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

impl<S: Lanes> ContactState<S> {
    /// Force on i in N.
    #[inline(always)]
    pub fn force(&self) -> Vec2<S> {
        self.frame.vector(self.normal_force, self.tangential_force)
    }
}

impl<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw> ContactPass<M, A, N, T> {
    /// Whether tangential displacements are functions of the present angles.
    const FOLLOWS_ANGLES: bool = T::REMEMBERS && !A::ACCUMULATES;

    /// Kinematics and forces of a contact whose ends have turned by the given angles since it began, in
    /// rad; thesis eqs. (28)-(42).
    #[inline(always)]
    fn state<S: Lanes>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        angles: [S; 2],
        memory: &mut ContactMemory<S>,
    ) -> ContactState<S> {
        let motion = PairMotion::new(&frame, ends.velocity);
        let xi = frame.normal_displacement(ends.radii);
        let normal_force = self.normal.force(ends.radii, xi, motion.normal_velocity);
        let mut state = ContactState {
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
    fn rub<S: Lanes>(
        &self,
        ends: &Ends<S>,
        angles: [S; 2],
        memory: &mut ContactMemory<S>,
        state: &mut ContactState<S>,
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

    /// Whether the spheres overlap.
    #[inline(always)]
    pub fn touch<S: Lanes>(&self, ends: &Ends<S>) -> bool {
        let reach = ends.radii[0] + ends.radii[1];
        self.metric.nearest(ends.difference).norm_squared() < reach * reach
    }

    /// The memory of a contact that begins.
    pub fn begin<S: Lanes>(&self, ends: &Ends<S>) -> ContactMemory<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        let rest = if A::ACCUMULATES {
            [S::zero(); 2]
        } else {
            ends.angles
        };
        ContactMemory::begin(&frame, rest)
    }

    /// What the contact at a position remembers; it begins now if nothing is remembered.
    pub fn memory_at<S: Lanes>(
        &self,
        weak: &Contacts<S>,
        position: usize,
        ends: &Ends<S>,
    ) -> ContactMemory<S> {
        weak.memory_at(position).unwrap_or_else(|| self.begin(ends))
    }

    /// The state of most contacts, thesis eqs. (29)-(32), and whether it is that of this one.
    #[inline(always)]
    fn regular<S: Lanes>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        memory: &mut ContactMemory<S>,
    ) -> (ContactState<S>, bool) {
        if !Self::FOLLOWS_ANGLES {
            return (self.state(ends, frame, [S::zero(); 2], memory), true);
        }
        let unturned = (memory.reference, memory.ends);
        let (angles, is_regular) = turned(ends.angles, unturned, frame.normal, self.wraps());
        (self.state(ends, frame, angles, memory), is_regular)
    }

    /// Whether angles are wrapped to [-pi, pi), as the thesis author did.
    #[inline(always)]
    fn wraps(&self) -> bool {
        self.reading == Reading::Thesis
    }

    /// The state of any contact.
    pub fn any<S: Lanes>(&self, ends: &Ends<S>, memory: &mut ContactMemory<S>) -> ContactState<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if !Self::FOLLOWS_ANGLES {
            return self.state(ends, frame, [S::zero(); 2], memory);
        }
        let unturned = (&mut memory.reference, &mut memory.ends);
        let angles = turned_far(ends.angles, unturned, frame.normal, self.wraps());
        self.state(ends, frame, angles, memory)
    }

    /// Energy stored in a contact in J.
    #[inline(always)]
    fn stored<S: Lanes>(&self, radii: [S; 2], state: &ContactState<S>, memory: S) -> S {
        let displacement = state.zeta[0] + state.zeta[1];
        self.normal.stored_energy(radii, state.xi)
            + self
                .tangential
                .stored_energy(displacement, state.normal_force, memory)
    }

    /// Power turned into heat in a contact in W: what the elastic forces do not give back.
    #[inline(always)]
    fn heat_rate<S: Lanes>(&self, radii: [S; 2], state: &ContactState<S>) -> S {
        let viscous = self.normal.elastic_force(radii, state.xi) - state.normal_force;
        viscous * state.motion.normal_velocity + state.friction.heat_rate
    }
}

/// The loop over all pairs: adds the forces of those that overlap, and begins or ends their memory.
///
/// All pairs of a block are looked at as if they touched, without a branch; what is rare is found by its
/// flag and computed again.
///
/// `strong` tells the pairs whose bonds broke in this evaluation: if they overlap, their stored energy
/// is booked as work of bonding. Allocates nothing.
pub(crate) struct ContactLoop<'a, S: Lanes, M, A, N, T, const LEDGER: bool> {
    pub pass: ContactPass<M, A, N, T>,
    pub particles: &'a Particles<S>,
    /// Position of the first pair among all.
    pub first: usize,
    pub pairs: &'a [Pair],
    pub memories: MemoryColumns<'a, S>,
    pub strong: Option<&'a Bonds<S>>,
    pub sums: Sums<'a, S>,
    pub edition: Edition,
}

impl<S: Lanes, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw, const LEDGER: bool>
    Work<PartWorkspace<S>> for ContactLoop<'_, S, M, A, N, T, LEDGER>
{
    fn split_at(self, particle: usize) -> (Self, Self) {
        let at = pairs_before(self.pairs, self.sums.first + particle);
        let (pairs, other_pairs) = self.pairs.split_at(at);
        let (memories, other_memories) = self.memories.split_at(at);
        let (sums, other_sums) = self.sums.split_at(particle);
        let left = Self {
            pairs,
            memories,
            sums,
            ..self
        };
        let right = Self {
            first: self.first + at,
            pairs: other_pairs,
            memories: other_memories,
            sums: other_sums,
            ..left
        };
        (left, right)
    }

    #[inline(always)]
    fn act(mut self, desk: &mut PartWorkspace<S>, instructions: Instructions) {
        let columns = Columns::of(self.particles);
        desk.weak.begin(self.edition, self.pairs, self.sums.first);
        let is_large = is_large(self.particles.len());
        for links in blocks(self.first, self.pairs.len()) {
            desk.block.gather(
                columns,
                (self.pairs, links.clone()),
                Self::READS,
                is_large.then_some(&self.sums),
                |link| {
                    if T::REMEMBERS {
                        self.memories.prefetch(link);
                    }
                },
            );
            let flags = self.compute(&mut desk.block, links.clone());
            if flags & IRREGULAR != 0 {
                self.compute_irregular(&mut desk.block, links.clone());
            }
            self.remember(&desk.block, links.clone());
            let scatter = Scatter::<_, LEDGER> {
                pairs: &self.pairs[links.clone()],
                outputs: &desk.block.outputs,
                turns: !T::ABSENT,
                all: flags & IDLE == 0,
                sums: self.sums.again(),
                tally: &mut desk.tally,
            };
            S::run(instructions, scatter);
            let outputs = &desk.block.outputs;
            desk.weak
                .note(self.pairs, links.clone(), outputs, !T::ABSENT);
            if LEDGER {
                self.book_bonding(desk, links);
            }
        }
    }

    fn start(ready: Ready<Self, PartWorkspace<S>>) {
        // Other arms take roots and arctangents and serve comparisons: wide instructions are not worth the code.
        if A::CONSTANT {
            S::run(ready.instructions, ready);
        } else {
            ready.call();
        }
    }
}

impl<S: Lanes, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw, const LEDGER: bool>
    ContactLoop<'_, S, M, A, N, T, LEDGER>
{
    const READS: Reads = Reads {
        angles: ContactPass::<M, A, N, T>::FOLLOWS_ANGLES,
        spins: !T::ABSENT,
        radii: true,
    };

    /// Look at all pairs of the block as if they touched; tells which do, and whether some contact is
    /// not what it seems: it begins or ends, its frame has turned far from its reference, or an angle is to
    /// be wrapped.
    #[inline(always)]
    fn compute(&mut self, block: &mut Block<S>, links: Range<usize>) -> u64 {
        let number = links.len().min(LINKS);
        let memories = self.memories.part(if T::REMEMBERS {
            links.start..links.start + number
        } else {
            0..0
        });
        let (inputs, frames, outputs) = block.open(self.pass.metric, number);
        let mut flags = 0;
        for lane in 0..number {
            let ends = inputs.ends(lane);
            let touches = self.pass.touch(&ends);
            let old = if T::REMEMBERS {
                memories.get(lane)
            } else {
                ContactMemory::default()
            };
            let mut memory = old;
            let (state, is_regular) = self.pass.regular(&ends, frames.at(lane), &mut memory);
            if T::REMEMBERS {
                outputs.state[lane] = if touches { memory.state } else { old.state };
            }
            if A::ACCUMULATES {
                let now = if touches { memory.ends } else { old.ends };
                outputs.rest[0][lane] = now[0];
                outputs.rest[1][lane] = now[1];
            }
            self.pass
                .put::<S, LEDGER>(outputs, lane, &state, ends.radii, touches);
            let is_irregular = ((touches != old.touches) & T::REMEMBERS) | (touches & !is_regular);
            let flag = (IDLE * u64::from(!touches)) | (IRREGULAR * u64::from(is_irregular));
            outputs.flags[lane] = flag;
            flags |= flag;
        }
        flags
    }

    /// Begin and end contacts, and compute again what was not what it seemed.
    ///
    /// A contact that ends: without a normal force no law stores anything, all that was left is heat.
    #[cold]
    #[inline(never)]
    fn compute_irregular(&mut self, block: &mut Block<S>, links: Range<usize>) {
        for (lane, position) in links.enumerate() {
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
            let state = self.pass.any(&ends, &mut memory);
            self.pass
                .put::<S, LEDGER>(outputs, lane, &state, ends.radii, touches);
            if !touches {
                memory.touches = false;
                outputs.heat[lane] = state.friction.heat;
            }
            self.memories.set(position, memory);
            outputs.state[lane] = memory.state;
            for end in 0..2 {
                outputs.rest[end][lane] = memory.ends[end];
            }
        }
    }

    #[inline(always)]
    fn remember(&mut self, block: &Block<S>, links: Range<usize>) {
        let number = links.len().min(LINKS);
        let outputs = &*block.outputs;
        if !T::REMEMBERS {
            return;
        }
        self.memories.states[links.clone()].copy_from_slice(&outputs.state[..number]);
        if A::ACCUMULATES {
            for (ends, now) in self.memories.ends.iter_mut().zip(&outputs.rest) {
                ends[links.clone()].copy_from_slice(&now[..number]);
            }
        }
    }

    /// Book the energy of contacts that take the place of broken bonds.
    #[inline(always)]
    fn book_bonding(&self, desk: &mut PartWorkspace<S>, links: Range<usize>) {
        let Some(strong) = self.strong.filter(|strong| !strong.broken.is_empty()) else {
            return;
        };
        for (lane, position) in links.enumerate() {
            let touches = desk.block.outputs.flags[lane] & IDLE == 0;
            if touches && strong.breaks_now(self.pairs[position]) {
                let ends = desk.block.inputs.ends(lane);
                let mut memory = if T::REMEMBERS {
                    self.memories.get(position)
                } else {
                    self.pass.begin(&ends)
                };
                let pass = ContactPass {
                    elapsed: 0.0,
                    ..self.pass
                };
                let state = pass.any(&ends, &mut memory);
                desk.tally.bonding += pass.stored(ends.radii, &state, memory.state);
            }
        }
    }
}

impl<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw> ContactPass<M, A, N, T> {
    /// Write what a contact does into its lane.
    #[inline(always)]
    fn put<S: Lanes, const LEDGER: bool>(
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

/// Energy stored in all contacts in J, thesis eqs. (75)-(76).
pub(crate) fn stored_in_contacts<S: Lanes, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
    pass: ContactPass<M, A, N, T>,
    particles: &Particles<S>,
    weak: &Contacts<S>,
) -> S {
    let columns = Columns::of(particles);
    let mut sum = S::zero();
    for (position, pair) in weak.pairs.iter().enumerate() {
        let ends = columns.ends(*pair);
        if !pass.touch(&ends) {
            continue;
        }
        let mut memory = pass.memory_at(weak, position, &ends);
        let state = pass.any(&ends, &mut memory);
        sum += pass.stored(ends.radii, &state, memory.state);
    }
    sum
}
