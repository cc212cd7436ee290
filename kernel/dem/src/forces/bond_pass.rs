//! Kinematics and laws of a single bond.

use super::ends::{Bodies, Columns, Ends};
use super::rotations::{general_rotations, regular_rotations};
use crate::bonds::{Bonds, Rest};
use crate::geometry::{PairFrame, PairMotion};
use crate::laws::{AdjustedKelvinVoigt, BeamLaw, YieldLaw};
use gouge_common::geometry::{Metric, Vec2};
use gouge_common::lanes::Lanes;
use gouge_common::pair::Pair;

/// Laws and options of the pass over bonds.
#[derive(Clone, Copy)]
pub(crate) struct BondPass<M, B, Y> {
    pub metric: M,
    pub normal: AdjustedKelvinVoigt,
    pub beam: B,
    pub yielding: Y,
    /// Whether angles are wrapped to [-pi, pi), as in the program of the thesis's author.
    pub wraps_angles: bool,
}

/// Present kinematics and forces of a bond.
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
    /// Kinematics and forces of a bond whose ends are bent by the given angles in rad, thesis eqs. (33)-(34) and
    /// (43)-(45).
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

    /// State of a bond by the regular path, thesis eqs. (28)-(34), and whether that path applies.
    ///
    /// It applies if the frame has rotated little and no angle needs wrapping; otherwise use
    /// [`general_state`](Self::general_state).
    #[inline(always)]
    pub fn regular_state<S: Lanes>(
        &self,
        ends: &Ends<S>,
        frame: PairFrame<S>,
        rest: &Rest<S>,
    ) -> (BondState<S>, bool) {
        if B::ABSENT {
            return (self.state(ends, frame, rest.distance, [S::zero(); 2]), true);
        }
        let unbent = (rest.reference, rest.angles);
        let (angles, is_regular) =
            regular_rotations(ends.angles, unbent, frame.normal, self.wraps_angles);
        (self.state(ends, frame, rest.distance, angles), is_regular)
    }

    /// State of a bond by the general path. Renews the reference direction if the frame has rotated far.
    pub fn general_state<S: Lanes>(&self, ends: &Ends<S>, rest: &mut Rest<S>) -> BondState<S> {
        let frame = PairFrame::new(self.metric.nearest(ends.difference));
        if B::ABSENT {
            return self.state(ends, frame, rest.distance, [S::zero(); 2]);
        }
        let unbent = (&mut rest.reference, &mut rest.angles);
        let angles = general_rotations(ends.angles, unbent, frame.normal, self.wraps_angles);
        self.state(ends, frame, rest.distance, angles)
    }

    /// Present state of a bond.
    pub fn state_of<S: Lanes>(
        &self,
        bodies: Bodies<S>,
        pair: Pair,
        mut rest: Rest<S>,
    ) -> BondState<S> {
        let ends = Columns::of(bodies).ends(pair);
        self.general_state(&ends, &mut rest)
    }

    /// Elastic energy stored in a bond in J.
    #[inline(always)]
    pub fn stored_energy<S: Lanes>(&self, state: &BondState<S>) -> S {
        self.normal.stored_energy(state.xi_adjusted)
            + (self.beam.stored_energy(state.zeta[0]) + self.beam.stored_energy(state.zeta[1]))
    }

    /// Heat production of a bond in W.
    #[inline(always)]
    pub fn heat_rate<S: Lanes>(&self, state: &BondState<S>) -> S {
        self.normal.heat_rate(state.motion.normal_velocity)
            + (self.beam.heat_rate(state.d_zeta[0]) + self.beam.heat_rate(state.d_zeta[1]))
    }

    /// Elastic energy stored in all bonds in J, thesis eq. (77).
    pub fn total_stored_energy<S: Lanes>(&self, bodies: Bodies<S>, bonds: &Bonds<S>) -> S {
        let mut sum = S::zero();
        for bond in bonds.iter() {
            sum += self.stored_energy(&self.state_of(bodies, bond.pair, bond.rest));
        }
        sum
    }
}
