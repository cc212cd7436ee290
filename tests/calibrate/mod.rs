//! Calibration: the numerics on models with known answers, the command, and its page of documentation.

mod command;
mod documentation;
mod mistakes;
mod numerics;
