//! Kinematics and laws of a single contact.

use super::ends::{Bodies, Columns, Ends};
use super::rotations::{general_rotations, regular_rotations};
use crate::contacts::{ContactMemory, Contacts};
use crate::geometry::{Arm, PairFrame, PairMotion};
use crate::laws::{Friction, NormalLaw, TangentialLaw, TangentialMotion};
use crate::model::Reading;
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::lanes::Lanes;
use gouge_common::pair::map_ends;

/// Laws and options of the pass over contacts.
#[derive(Clone, Copy)]
pub(crate) struct ContactPass<M, A, N, T> {
    pub metric: M,
    pub arm: A,
    pub normal: N,
    pub tangential: T,
    pub reading: Reading,
    /// Time since the previous evaluation in s, for lever arms that accumulate.
    pub elapsed: f64,
}

/// Present kinematics and forces of a contact.
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
    /// Whether tangential displacements are functions of the particle angles.
    pub const FOLLOWS_ANGLES: bool = T::REMEMBERS && !A::ACCUMULATES;

    /// Kinematics and forces of a contact, thesis eqs. (28)-(42); `angles` are the rotations of both ends in rad
    /// since the contact began.
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
        let normal_force = self
            .normal
            .force(ends.radii, xi, self.damped(ends, &motion));
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
            self.add_tangential(ends, angles, memory, &mut state);
        }
        state
    }

    /// The normal velocity in m/s, scaled with the damping of the pair if the law scales it.
    #[inline(always)]
    fn damped<S: Lanes>(&self, ends: &Ends<S>, motion: &PairMotion<S>) -> S {
        if N::SCALES_DAMPING {
            motion.normal_velocity * self.normal.damping_factor(ends.radii, ends.reduced_mass)
        } else {
            motion.normal_velocity
        }
    }

    /// Compute the tangential displacements and velocities, the tangential force, and the torques on both particles.
    #[inline(always)]
    fn add_tangential<S: Lanes>(
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
            memory.ends = map_ends([0, 1], |end| {
                memory.ends[end] + state.d_zeta[end] * self.elapsed
            });
            state.zeta = memory.ends;
        }
        let motion = TangentialMotion {
            displacement: state.zeta[0] + state.zeta[1],
            velocity: state.d_zeta[0] + state.d_zeta[1],
        };
        state.friction = self
            .tangential
            .friction(motion, state.normal_force, &mut memory.state);
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
    pub fn overlaps<S: Lanes>(&self, ends: &Ends<S>) -> bool {
        let reach = ends.radii[0] + ends.radii[1];
        self.metric.nearest(ends.difference).norm_squared() < reach * reach
    }

    /// Memory of a contact that begins now.
    pub fn begin<S: Lanes>(&self, ends: &Ends<S>) -> ContactMemory<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        let rest = if A::ACCUMULATES {
            [S::zero(); 2]
        } else {
            ends.angles
        };
        ContactMemory::begin(&frame, rest)
    }

    /// Memory of the contact at an index; if it has none, that of a contact that begins now.
    pub fn memory_at<S: Lanes>(
        &self,
        contacts: &Contacts<S>,
        position: usize,
        ends: &Ends<S>,
    ) -> ContactMemory<S> {
        contacts
            .memory_at(position)
            .unwrap_or_else(|| self.begin(ends))
    }

    /// State of a contact by the regular path, thesis eqs. (29)-(32), and whether that path applies.
    ///
    /// It applies if the frame has rotated little and no angle needs wrapping; otherwise use
    /// [`general_state`](Self::general_state).
    #[inline(always)]
    pub fn regular_state<S: Lanes>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        memory: &mut ContactMemory<S>,
    ) -> (ContactState<S>, bool) {
        if !Self::FOLLOWS_ANGLES {
            return (self.state(ends, frame, [S::zero(); 2], memory), true);
        }
        let initial = (memory.reference, memory.ends);
        let (angles, is_regular) =
            regular_rotations(ends.angles, initial, frame.normal, self.wraps_angles());
        (self.state(ends, frame, angles, memory), is_regular)
    }

    /// Whether angles are wrapped to [-pi, pi), as in the program of the thesis's author.
    #[inline(always)]
    fn wraps_angles(&self) -> bool {
        self.reading == Reading::Thesis
    }

    /// State of a contact by the general path. Renews the reference direction if the frame has rotated far.
    pub fn general_state<S: Lanes>(
        &self,
        ends: &Ends<S>,
        memory: &mut ContactMemory<S>,
    ) -> ContactState<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if !Self::FOLLOWS_ANGLES {
            return self.state(ends, frame, [S::zero(); 2], memory);
        }
        let initial = (&mut memory.reference, &mut memory.ends);
        let angles = general_rotations(ends.angles, initial, frame.normal, self.wraps_angles());
        self.state(ends, frame, angles, memory)
    }

    /// Elastic energy stored in a contact in J.
    #[inline(always)]
    pub fn stored_energy<S: Lanes>(&self, radii: [S; 2], state: &ContactState<S>, memory: S) -> S {
        let displacement = state.zeta[0] + state.zeta[1];
        self.normal.stored_energy(radii, state.xi)
            + self
                .tangential
                .stored_energy(displacement, state.normal_force, memory)
    }

    /// Heat production of a contact in W: power of the forces that is not stored as elastic energy.
    #[inline(always)]
    pub fn heat_rate<S: Lanes>(&self, radii: [S; 2], state: &ContactState<S>) -> S {
        let viscous = self.normal.elastic_force(radii, state.xi) - state.normal_force;
        viscous * state.motion.normal_velocity + state.friction.heat_rate
    }

    /// Elastic energy stored in all contacts in J, thesis eqs. (75)-(76).
    pub fn total_stored_energy<S: Lanes>(&self, bodies: Bodies<S>, contacts: &Contacts<S>) -> S {
        let columns = Columns::of(bodies);
        let mut sum = S::zero();
        for (position, pair) in contacts.pairs.iter().enumerate() {
            let ends = columns.ends(*pair);
            if !self.overlaps(&ends) {
                continue;
            }
            let mut memory = self.memory_at(contacts, position, &ends);
            let state = self.general_state(&ends, &mut memory);
            sum += self.stored_energy(ends.radii, &state, memory.state);
        }
        sum
    }
}
