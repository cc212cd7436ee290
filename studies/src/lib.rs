//! Many runs: sweeps over the keys of a scene.

pub mod decay;
mod series;
pub mod sweep;
