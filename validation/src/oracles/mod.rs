//! Independent models that the kernel is compared with; none of them calls the kernel.

pub mod emergent;
pub mod flow;
pub mod impact;
pub mod minimum;
pub mod normal;
pub mod original;
pub mod oscillator;
pub mod quadrature;
pub mod solid;
