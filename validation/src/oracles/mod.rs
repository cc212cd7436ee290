//! Independent models that the kernel is compared with; none of them calls the kernel.

pub mod arcs;
pub mod components;
pub mod flow;
pub mod original;
pub mod oscillator;
pub mod solid;
