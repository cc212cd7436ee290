//! Independent models that the kernel is compared with; none of them calls the kernel.

pub mod original;
pub mod oscillator;
