//! Calibration: the numerics on models with known answers, and the command.

mod command;
mod numerics;
