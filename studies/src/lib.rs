//! Many runs: sweeps over the keys of a scene, and the study of the thesis.

mod columns;
pub mod decay;
pub mod statistics;
pub mod study;
pub mod sweep;
