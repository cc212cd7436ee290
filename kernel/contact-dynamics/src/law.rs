//! The law of all contact points: friction, restitution, and what gaps do.

use crate::error::{SetupError, require};
use crate::local::Components;
use gouge_equations::rendered;

/// What the gap of a contact point does to the law of Signorini.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum GapRule {
    /// A contact point exists if its gap is not positive when it is detected, and the gap does not enter the law.
    /// This is what the source describes.
    Closed,
    /// The law is written for $u_n + \max(g, 0)/\Delta t$, so that an open point closes exactly at the next detection.
    #[default]
    Predicted,
    /// As [`GapRule::Predicted`], and a fraction of the overlap beyond an allowed one is removed per step, with the
    /// additional term $b \min(g + g_0, 0)/\Delta t$. It does work, which is booked separately.
    Stabilized {
        /// Fraction b of the excess overlap that is removed per step, in [0, 1].
        fraction: f64,
        /// Allowed overlap $g_0$ in m, not negative.
        allowed_overlap: f64,
    },
}

/// Terms of the law of Signorini that come from the gap, in m/s.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GapVelocity {
    /// Approach velocity that is permitted because the point is open; not negative.
    pub closing: f64,
    /// Velocity that corrects an overlap; not positive.
    pub correcting: f64,
}

impl GapRule {
    /// Velocities that a gap in m adds to the law of Signorini for a time step in s.
    #[inline]
    pub fn velocity(self, gap: f64, time_step: f64) -> GapVelocity {
        let closing = gap.max(0.0) / time_step;
        match self {
            Self::Closed => GapVelocity::default(),
            Self::Predicted => GapVelocity {
                closing,
                correcting: 0.0,
            },
            Self::Stabilized {
                fraction,
                allowed_overlap,
            } => GapVelocity {
                closing,
                correcting: fraction * (gap + allowed_overlap).min(0.0) / time_step,
            },
        }
    }

    /// Whether a point with a gap in m is a closed contact, at which bodies rebound.
    #[inline]
    pub fn is_closed(self, gap: f64) -> bool {
        self == Self::Closed || gap <= 0.0
    }
}

/// Coefficients of the contact law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactLaw {
    /// Coefficient of friction, not negative.
    pub friction: f64,
    /// Normal and tangential coefficients of restitution, azema (A4)-(A5).
    pub restitution: Components,
    /// What the gap does.
    pub gap: GapRule,
}

impl ContactLaw {
    /// A law without restitution, with the default treatment of gaps.
    pub fn inelastic(friction: f64) -> Self {
        Self {
            friction,
            restitution: Components::default(),
            gap: GapRule::default(),
        }
    }

    /// Whether only closed points count: if the gap rule says so, or if bodies rebound.
    ///
    /// At an open point of [`GapRule::Predicted`] a body is slowed down so that it arrives at zero gap, and would
    /// rebound with what is left of its velocity.
    #[inline]
    pub fn takes_closed_points_only(&self) -> bool {
        self.gap == GapRule::Closed || self.restitution.n > 0.0
    }

    /// Check the coefficients.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for negative friction, a normal restitution outside [0, 1], a tangential one outside
    /// [-1, 1], or a stabilisation outside its range.
    pub fn validate(&self) -> Result<(), SetupError> {
        let e = self.restitution;
        require(
            "friction",
            self.friction,
            "not negative",
            self.friction >= 0.0,
        )?;
        let is_valid = (0.0..=1.0).contains(&e.n);
        require("normal restitution", e.n, "in [0, 1]", is_valid)?;
        let is_valid = (-1.0..=1.0).contains(&e.t);
        require("tangential restitution", e.t, "in [-1, 1]", is_valid)?;
        if let GapRule::Stabilized {
            fraction,
            allowed_overlap,
        } = self.gap
        {
            let is_valid = (0.0..=1.0).contains(&fraction);
            require("stabilisation", fraction, "in [0, 1]", is_valid)?;
            let is_valid = allowed_overlap >= 0.0;
            require("allowed overlap", allowed_overlap, "not negative", is_valid)?;
        }
        Ok(())
    }
}
