//! Data of previous evaluations that methods keep.

use super::method::Integrator;
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;

/// Data of previous evaluations.
///
/// Velocity Verlet keeps forces during a step; between steps they are zero. Beeman keeps accelerations.
#[derive(Clone, Debug)]
pub struct Previous<S> {
    /// Forces in N or accelerations in m/s^2.
    pub linear: Vec<Vec2<S>>,
    /// Torques in N m or angular accelerations in rad/s^2.
    pub angular: Vec<S>,
    /// Accelerations one evaluation earlier, for the Beeman method only.
    pub older_linear: Vec<Vec2<S>>,
    /// Angular accelerations one evaluation earlier, for the Beeman method only.
    pub older_angular: Vec<S>,
    /// Whether the accelerations have been set.
    pub is_set: bool,
}

impl<S: Real> Previous<S> {
    /// Zeros, for a number of particles.
    pub fn new(integrator: Integrator, number: usize) -> Self {
        let kept = match integrator {
            Integrator::VelocityVerlet | Integrator::Beeman => number,
            _ => 0,
        };
        let older = if integrator == Integrator::Beeman {
            number
        } else {
            0
        };
        Self {
            linear: vec![Vec2::zero(); kept],
            angular: vec![S::zero(); kept],
            older_linear: vec![Vec2::zero(); older],
            older_angular: vec![S::zero(); older],
            is_set: false,
        }
    }
}
