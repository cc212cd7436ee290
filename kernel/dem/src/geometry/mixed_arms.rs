//! Lever arms as other programs mix them, for comparisons with those programs.

use super::{Arm, FocalArm, PairFrame, PairMotion};
use gouge_common::pair::map_ends;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// A distance of a particle's centre from the contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lever {
    /// The radius.
    Radius,
    /// The distance to the focal point.
    Focal,
    /// The radius less half of the normal displacement.
    HalfOverlap,
}

impl Lever {
    /// The distances of both ends in m.
    #[inline(always)]
    fn distances<S: Real>(self, radii: [S; 2], distance: S) -> [S; 2] {
        match self {
            Self::Radius => radii,
            Self::Focal => FocalArm.distances(radii, distance),
            Self::HalfOverlap => {
                let half_overlap = (radii[0] + radii[1] - distance) * 0.5;
                map_ends(radii, |radius| radius - half_overlap)
            }
        }
    }
}

/// Factor by which the relative velocity of the centres enters the tangential velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Translation {
    /// One.
    Whole,
    /// The sum of the kinematic arms over the distance of the centres, as in thesis eq. (34).
    Levers,
}

/// Three conventions that other programs choose apart from each other; for comparisons only.
///
/// $$ \partial_t \zeta = d_i \omega_i + d_j \omega_j - f\, (\vec v_j - \vec v_i) \cdot \vec e^{\,t}, \qquad \zeta = \sum \partial_t \zeta\, \Delta t, \qquad \tau_i = h_i F $$
///
/// d are the kinematic arms and h the arms of the torque, in m; f is the factor of the translation.
/// The displacement is the sum over steps that these programs keep, not a function of the state: nothing
/// is added when forces are found before the first step. The tangential force between the centres
/// is F itself, so that angular momentum is conserved only where h_i + h_j is the distance. One number for
/// all three (the thesis's d of both, with f their sum over the distance) is [`ContactDistance`]'s other
/// variants.
///
/// | program | d | f | h |
/// |---|---|---|---|
/// | LAMMPS, `pair granular` | radius | 1 | half-overlap |
/// | LAMMPS, `pair gran/hooke` | radius | 1 | radius |
/// | YADE, `avoidGranularRatcheting` off | half-overlap | 1 | half-overlap |
/// | YADE, `avoidGranularRatcheting` on | radius | levers | half-overlap |
///
/// [`ContactDistance`]: super::ContactDistance
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MixedArms {
    /// Arms d with which rotation enters the tangential velocity.
    pub kinematic: Lever,
    /// Factor f of the translation.
    pub translation: Translation,
    /// Arms h of the torque.
    pub torque: Lever,
}

impl Arm for MixedArms {
    const ACCUMULATES: bool = true;

    #[inline(always)]
    fn distances<S: Real>(self, radii: [S; 2], distance: S) -> [S; 2] {
        self.torque.distances(radii, distance)
    }

    #[inline(always)]
    fn velocities<S: Real>(
        self,
        radii: [S; 2],
        frame: &PairFrame<S>,
        motion: &PairMotion<S>,
        spins: [S; 2],
    ) -> [S; 2] {
        let levers = self.kinematic.distances(radii, frame.distance);
        let turning = match self.translation {
            Translation::Whole => motion.shear_velocity / (levers[0] + levers[1]),
            Translation::Levers => motion.frame_rate,
        };
        map_ends([0, 1], |end| levers[end] * (spins[end] - turning))
    }
}
