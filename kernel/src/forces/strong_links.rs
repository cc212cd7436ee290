//! The pass over strong links.

use super::{Forces, Tally};
use crate::geometry::{Metric, PairFrame, PairMotion, turn, wrapped};
use crate::laws::{AdjustedKelvinVoigt, BeamLaw, ZhangEckert};
use crate::links::{StrongLink, StrongLinks};
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

impl<M: Metric, B: BeamLaw> StrongPass<M, B> {
    /// Kinematics and forces of a link, thesis eqs. (28)-(34) and (43)-(45).
    ///
    /// A link whose frame has turned far from its reference takes the present direction as the new
    /// one; the rest angles turn with it, so that angles stay functions of the state and never jump.
    #[inline(always)]
    pub fn state<S: Real>(
        &self,
        particles: &Particles<S>,
        link: &mut StrongLink<S>,
    ) -> StrongState<S> {
        let (i, j) = link.pair.indices();
        let p = particles;
        let frame = PairFrame::new(self.metric.displacement(p.position[i], p.position[j]));
        let motion = PairMotion::new(&frame, p.velocity[j] - p.velocity[i]);
        let xi_adjusted = link.rest_distance - frame.distance;
        let normal_force = self.normal.force(xi_adjusted, motion.normal_velocity);
        let (mut zeta, mut d_zeta) = ([S::zero(); 2], [S::zero(); 2]);
        let (mut torques, mut tangential_force) = ([S::zero(); 2], S::zero());
        if !B::ABSENT {
            let (turned, is_small) = turn(link.reference, frame.normal);
            let ends = [(i, 0), (j, 1)];
            for (particle, end) in ends {
                let mut angle = p.angle[particle] - link.rest_angles[end] - turned;
                if self.wraps {
                    angle = wrapped(angle);
                }
                zeta[end] = p.radius[particle] * angle;
                d_zeta[end] =
                    p.radius[particle] * (p.angular_velocity[particle] - motion.frame_rate);
                torques[end] = p.radius[particle] * self.beam.force(zeta[end], d_zeta[end]);
            }
            tangential_force = (torques[0] + torques[1]) * frame.inverse_distance;
            if !is_small {
                link.reference = frame.normal;
                link.rest_angles = link.rest_angles.map(|angle| angle + turned);
            }
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

    #[inline(always)]
    fn stored<S: Real>(&self, state: &StrongState<S>) -> S {
        self.normal.stored_energy(state.xi_adjusted)
            + (self.beam.stored_energy(state.zeta[0]) + self.beam.stored_energy(state.zeta[1]))
    }
}

/// Add the forces of all strong links; those that break exert none and are listed.
///
/// Reads positions, velocities and angles; writes forces and, where a frame has turned far, the
/// references of links. Allocates nothing. `YIELDS` and `LEDGER` leave out what they name.
#[inline(never)]
pub(crate) fn strong_links<
    S: Real,
    M: Metric,
    B: BeamLaw,
    const YIELDS: bool,
    const LEDGER: bool,
>(
    pass: StrongPass<M, B>,
    particles: &Particles<S>,
    strong: &mut StrongLinks<S>,
    forces: &mut Forces<S>,
    tally: &mut Tally<S>,
) {
    let StrongLinks { links, broken } = strong;
    for (position, link) in links.iter_mut().enumerate() {
        let (i, j) = link.pair.indices();
        let state = pass.state(particles, link);
        if YIELDS
            && let Some(law) = pass.yielding
            && law.breaks(
                state.normal_force,
                state.tangential_force,
                [particles.radius[i], particles.radius[j]],
                link.strength_factor,
            )
        {
            broken.push(position as u32);
            if LEDGER {
                tally.breaking += pass.stored(&state);
            }
            continue;
        }
        if LEDGER {
            tally.friction_rate += pass.normal.heat_rate(state.motion.normal_velocity)
                + (pass.beam.heat_rate(state.d_zeta[0]) + pass.beam.heat_rate(state.d_zeta[1]));
        }
        let force = state.frame.normal * state.normal_force
            + state.frame.tangent() * state.tangential_force;
        forces.add_pair((i, j), force, state.torques);
    }
}

/// Energy stored in all strong links in J, thesis eq. (77).
pub(crate) fn stored_in_strong_links<S: Real, M: Metric, B: BeamLaw>(
    pass: StrongPass<M, B>,
    particles: &Particles<S>,
    links: &[StrongLink<S>],
) -> S {
    let mut sum = S::zero();
    for link in links {
        sum += pass.stored(&pass.state(particles, &mut link.clone()));
    }
    sum
}
