//! Choice of an integration method.

/// Integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Explicit Euler, thesis eq. (55).
    Euler,
    /// Symplectic (semi-implicit) Euler.
    SymplecticEuler,
    /// Taylor expansion to second order, thesis eq. (56).
    Taylor,
    /// Velocity Verlet, with forces at the predicted velocity.
    VelocityVerlet,
    /// Velocity Verlet as in LAMMPS, with forces at the half-step velocity; for comparisons only.
    VelocityVerletHalfStep,
    /// Modified Beeman predictor-corrector, thesis eqs. (57)-(58).
    Beeman,
}

impl Integrator {
    /// All methods that are recommended for scenes.
    pub const ALL: [Self; 5] = [
        Self::Euler,
        Self::SymplecticEuler,
        Self::Taylor,
        Self::VelocityVerlet,
        Self::Beeman,
    ];

    /// Whether a step evaluates forces before it moves particles, and not afterwards.
    pub fn evaluates_first(self) -> bool {
        matches!(self, Self::Euler | Self::SymplecticEuler | Self::Taylor)
    }
    /// Fraction of the velocity error that exact driving corrects per step, dimensionless.
    ///
    /// One for methods whose step applies the present acceleration over its full length. The other methods spread
    /// an acceleration over two or more steps; with a gain of 1/4 the response stays damped, and the error
    /// decreases by a factor of 0.70 per step.
    pub fn velocity_gain(self) -> f64 {
        if self.evaluates_first() { 1.0 } else { 0.25 }
    }
    /// Whether the method keeps accelerations of previous evaluations from step to step.
    pub fn needs_previous(self) -> bool {
        self == Self::Beeman
    }
}
