//! Integration methods and bounds of the time step, thesis eqs. (55)-(62).

mod beeman;
mod euler;
mod method;
mod previous;
mod stage;
mod taylor;
mod time_step;
mod velocity_verlet;

pub use method::Integrator;
pub use previous::Previous;
pub use time_step::{
    Oscillator, characteristic_polynomial, crack_bound, critical_step, is_stable, is_stable_below,
    wave_bound,
};

pub(crate) use beeman::{BeemanBegin, BeemanCorrect, BeemanPredict};
pub(crate) use euler::{Euler, SymplecticEuler};
pub(crate) use stage::{Advance, Motion, Stage};
pub(crate) use taylor::Taylor;
pub(crate) use velocity_verlet::{HalfKick, HalfKickAndDrift, VerletCorrect, VerletPredict};
