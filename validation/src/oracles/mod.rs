//! Independent models that the kernel is compared with; none of them calls the kernel.

pub mod dissipation;
pub mod flow;
pub mod original;
pub mod oscillator;
pub mod printed;
pub mod sliding;
