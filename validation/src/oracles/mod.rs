//! Independent models that the kernel is compared with; none of them calls the kernel.

pub mod amplification;
pub mod arcs;
pub mod bounce;
pub mod flow;
pub mod grains;
pub mod impact;
pub mod lens;
pub mod original;
pub mod oscillator;
pub mod rolling;
pub mod settling;
pub mod spectrum;
