//! Many runs: sweeps over the keys of a scene.

pub mod sweep;
