//! Rigid units: what moves as one. A free body is a unit; a wall and the bodies glued to it are one unit.

use crate::error::{SetupError, require};
use gouge_common::geometry::Vec2;

/// Velocity of a unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity {
    /// Velocity of the centre in m/s.
    pub linear: Vec2,
    /// Angular velocity in rad/s, anticlockwise.
    pub angular: f64,
}

/// Force and torque on a unit that do not come from contacts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Force in N.
    pub force: Vec2,
    /// Torque about the centre in N m, anticlockwise.
    pub torque: f64,
}

/// Inverse mass in each direction and inverse moment of inertia; zero where the motion is imposed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct InverseMass {
    /// Inverse of the mass that moves horizontally, in 1/kg.
    pub x: f64,
    /// Inverse of the mass that moves vertically, in 1/kg.
    pub y: f64,
    /// Inverse moment of inertia in 1/(kg m²).
    pub rotation: f64,
}

impl InverseMass {
    /// A unit whose motion is imposed altogether.
    pub const IMPOSED: Self = Self {
        x: 0.0,
        y: 0.0,
        rotation: 0.0,
    };

    /// A free body.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] unless both are positive.
    pub fn free(mass: f64, moment_of_inertia: f64) -> Result<Self, SetupError> {
        // The inverse of a tiny number is not finite.
        let accepted = "positive, with a finite inverse";
        let is_valid = |number: f64| number > 0.0 && (1.0 / number).is_finite();
        require("mass", mass, accepted, is_valid(mass))?;
        let is_mobile = is_valid(moment_of_inertia);
        require("moment of inertia", moment_of_inertia, accepted, is_mobile)?;
        Ok(Self {
            x: 1.0 / mass,
            y: 1.0 / mass,
            rotation: 1.0 / moment_of_inertia,
        })
    }

    /// Kinetic energy in J of the directions whose motion is not imposed.
    pub fn kinetic_energy(self, velocity: Velocity) -> f64 {
        let part = |inverse: f64, v: f64| {
            if inverse > 0.0 {
                0.5 * v * v / inverse
            } else {
                0.0
            }
        };
        part(self.x, velocity.linear.x)
            + part(self.y, velocity.linear.y)
            + part(self.rotation, velocity.angular)
    }

    /// The velocity after a load has acted for a time in s.
    #[inline]
    pub fn accelerated(self, velocity: Velocity, load: Load, time: f64) -> Velocity {
        Velocity {
            linear: Vec2::new(
                velocity.linear.x + time * self.x * load.force.x,
                velocity.linear.y + time * self.y * load.force.y,
            ),
            angular: velocity.angular + time * self.rotation * load.torque,
        }
    }
}
