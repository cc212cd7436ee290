//! Independent models that the kernel is compared with; none of them calls the kernel.

pub mod flow;
pub mod impact;
pub mod original;
pub mod oscillator;
