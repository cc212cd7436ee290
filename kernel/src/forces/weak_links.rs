//! The pass over weak links.

use super::{Forces, Tally};
use crate::geometry::{Arm, Metric, PairFrame, PairMotion, turn, wrapped};
use crate::laws::{Friction, NormalLaw, Slide, TangentialLaw};
use crate::links::{ContactMemory, WeakLinks};
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

impl<M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw> WeakPass<M, A, N, T> {
    /// Kinematics and forces of a contact, thesis eqs. (28)-(42).
    #[inline(always)]
    pub fn state<S: Real>(
        &self,
        particles: &Particles<S>,
        (i, j): (usize, usize),
        frame: PairFrame<S>,
        memory: &mut ContactMemory<S>,
    ) -> WeakState<S> {
        let p = particles;
        let radii = [p.radius[i], p.radius[j]];
        let motion = PairMotion::new(&frame, p.velocity[j] - p.velocity[i]);
        let xi = frame.normal_displacement(radii);
        let normal_force = self.normal.force(radii, xi, motion.normal_velocity);
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
            self.rub(particles, (i, j), memory, &mut state);
        }
        state
    }

    /// The tangential part: displacements, velocities, force and torques of both ends.
    #[inline(always)]
    fn rub<S: Real>(
        &self,
        particles: &Particles<S>,
        (i, j): (usize, usize),
        memory: &mut ContactMemory<S>,
        state: &mut WeakState<S>,
    ) {
        let p = particles;
        let radii = [p.radius[i], p.radius[j]];
        let arms = self.arm.distances(radii, state.frame.distance);
        let spins = [p.angular_velocity[i], p.angular_velocity[j]];
        state.d_zeta = self
            .arm
            .velocities(radii, &state.frame, &state.motion, spins);
        if T::REMEMBERS {
            state.zeta = if A::ACCUMULATES {
                memory.ends = [0, 1].map(|end| memory.ends[end] + state.d_zeta[end] * self.elapsed);
                memory.ends
            } else {
                self.displacements(p, (i, j), arms, memory, &state.frame)
            };
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

    /// Tangential displacements of both ends since the contact began, thesis eqs. (29)-(32).
    #[inline(always)]
    fn displacements<S: Real>(
        &self,
        particles: &Particles<S>,
        (i, j): (usize, usize),
        arms: [S; 2],
        memory: &mut ContactMemory<S>,
        frame: &PairFrame<S>,
    ) -> [S; 2] {
        let (turned, is_small) = turn(memory.reference, frame.normal);
        let angles = [particles.angle[i], particles.angle[j]];
        let zeta = [0, 1].map(|end| {
            let angle = angles[end] - memory.ends[end] - turned;
            arms[end]
                * if self.reading == Reading::Thesis {
                    wrapped(angle)
                } else {
                    angle
                }
        });
        if !is_small {
            memory.reference = frame.normal;
            memory.ends = memory.ends.map(|angle| angle + turned);
        }
        zeta
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

/// Add the forces of all pairs that overlap, and begin or end their memory.
///
/// `is_broken` tells the pairs whose bonds broke in this evaluation: if they overlap, their stored
/// energy is booked as work of bonding. Allocates nothing.
#[inline(never)]
pub(crate) fn weak_links<
    S: Real,
    M: Metric,
    A: Arm,
    N: NormalLaw,
    T: TangentialLaw,
    const LEDGER: bool,
>(
    pass: WeakPass<M, A, N, T>,
    particles: &Particles<S>,
    weak: &mut WeakLinks<S>,
    is_broken: impl Fn(crate::links::Pair) -> bool,
    forces: &mut Forces<S>,
    tally: &mut Tally<S>,
) {
    let WeakLinks { pairs, memory, .. } = weak;
    let mut forgetful = ContactMemory::default();
    for (position, pair) in pairs.iter().enumerate() {
        let (i, j) = pair.indices();
        let displacement = pass
            .metric
            .displacement(particles.position[i], particles.position[j]);
        let radii = [particles.radius[i], particles.radius[j]];
        let reach = radii[0] + radii[1];
        let overlaps = displacement.norm_squared() < reach * reach;
        if !T::REMEMBERS && !overlaps {
            continue;
        }
        let memory = if T::REMEMBERS {
            &mut memory[position]
        } else {
            &mut forgetful
        };
        if !overlaps {
            if LEDGER && memory.touches {
                let frame = PairFrame::new(displacement);
                let state = pass.state(particles, (i, j), frame, memory);
                // Without a normal force no law stores anything: all that was left is heat.
                tally.friction += state.friction.heat;
            }
            memory.touches = false;
            continue;
        }
        let frame = PairFrame::new(displacement);
        if T::REMEMBERS && !memory.touches {
            *memory = pass.begin(&frame, [particles.angle[i], particles.angle[j]]);
        }
        let state = pass.state(particles, (i, j), frame, memory);
        if LEDGER {
            tally.friction_rate += pass.heat_rate(radii, &state);
            tally.friction += state.friction.heat;
            if is_broken(*pair) {
                tally.bonding += pass.stored(radii, &state, memory.state);
            }
        }
        let force = state.frame.normal * state.normal_force
            + state.frame.tangent() * state.tangential_force;
        forces.add_pair((i, j), force, state.torques);
    }
}

/// Energy stored in all contacts in J, thesis eqs. (75)-(76).
pub(crate) fn stored_in_weak_links<S: Real, M: Metric, A: Arm, N: NormalLaw, T: TangentialLaw>(
    pass: WeakPass<M, A, N, T>,
    particles: &Particles<S>,
    weak: &WeakLinks<S>,
) -> S {
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
        let mut memory = match weak.memory.get(position) {
            Some(memory) if memory.touches => *memory,
            _ => pass.begin(&frame, [particles.angle[i], particles.angle[j]]),
        };
        let state = pass.state(particles, (i, j), frame, &mut memory);
        sum += pass.stored(radii, &state, memory.state);
    }
    sum
}
