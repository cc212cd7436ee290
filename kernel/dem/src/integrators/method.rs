//! The choice of a method.

/// Integration method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Integrator {
    /// Explicit Euler, thesis eq. (55).
    Euler,
    /// Symplectic (semi-implicit) Euler.
    SymplecticEuler,
    /// Taylor expansion to second order, thesis eq. (56).
    Taylor,
    /// Velocity Verlet with predicted velocities.
    VelocityVerlet,
    /// Velocity Verlet with the velocities of half a step, as LAMMPS has it; for comparisons only.
    VelocityVerletHalfStep,
    /// Modified Beeman predictor-corrector, thesis eqs. (57)-(58).
    Beeman,
}

impl Integrator {
    /// Every method that a scene may sensibly choose.
    pub const ALL: [Self; 5] = [
        Self::Euler,
        Self::SymplecticEuler,
        Self::Taylor,
        Self::VelocityVerlet,
        Self::Beeman,
    ];

    /// Whether a step evaluates forces before it moves, and not after.
    pub fn evaluates_first(self) -> bool {
        matches!(self, Self::Euler | Self::SymplecticEuler | Self::Taylor)
    }
    /// Fraction of the velocity error that exact driving corrects per step.
    ///
    /// One where a step applies the present acceleration over its full length. The other methods spread an
    /// acceleration over two or more steps; a quarter keeps the response damped: the error falls by a factor
    /// of 0.70 per step.
    pub fn velocity_gain(self) -> f64 {
        if self.evaluates_first() { 1.0 } else { 0.25 }
    }
    /// Whether something of the previous evaluation is kept from step to step.
    pub fn needs_previous(self) -> bool {
        self == Self::Beeman
    }
}
