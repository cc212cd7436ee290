//! Lever arms as mixed by other programs, for comparison with them.

use super::{Arm, FocalArm, PairFrame, PairMotion};
use gouge_common::pair::map_ends;
use gouge_common::scalar::Real;
use gouge_equations::rendered;

/// A choice of lever arm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lever {
    /// The radius.
    Radius,
    /// The distance from the focal point.
    Focal,
    /// The radius less half the normal displacement.
    HalfOverlap,
}

impl Lever {
    /// Lever arms of both ends in m.
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

/// Factor of the relative velocity of the centres in the tangential velocity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Translation {
    /// One.
    Whole,
    /// The sum of the kinematic lever arms divided by the distance of the centres, as in thesis eq. (34).
    Levers,
}

/// Separate lever arms for rotation, translation and torque, as in other programs; for comparisons only.
///
/// $$ \partial_t \zeta = d_i \omega_i + d_j \omega_j - f\, (\vec v_j - \vec v_i) \cdot \vec e^{\,t}, \qquad \zeta = \sum \partial_t \zeta\, \Delta t, \qquad \tau_i = h_i F $$
///
/// $d$ are the kinematic lever arms and $h$ the lever arms of the torque, in m; $f$ is the factor of the translation.
///
/// As in these programs, the displacement is a sum over steps and not a function of state. The evaluation before the
/// first step adds nothing. The tangential force on the centres is $F$ itself, so angular momentum is conserved only
/// if $h_i + h_j$ is the distance of the centres. The other variants of [`ContactDistance`] use the same lever arm
/// for $d$ and $h$, with $f$ their sum divided by the distance.
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
    /// Lever arms $d$ of the rotation in the tangential velocity.
    pub kinematic: Lever,
    /// Factor $f$ of the translation in the tangential velocity.
    pub translation: Translation,
    /// Lever arms $h$ of the torque.
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
