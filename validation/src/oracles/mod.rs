//! Independent models that the kernel is compared with; none of them calls the kernel.

pub mod amplification;
pub mod bonded_pair;
pub mod events;
pub mod flow;
pub mod original;
pub mod oscillator;
pub mod spectrum;
