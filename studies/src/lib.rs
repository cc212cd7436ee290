//! Many runs: sweeps over the keys of a scene, the study of the thesis, and calibration.

mod columns;
mod csv_table;
mod text;

pub mod decay;
pub mod final_state;
pub mod statistics;
pub mod sweep;
pub mod words;

pub mod calibrate;
pub mod study;
