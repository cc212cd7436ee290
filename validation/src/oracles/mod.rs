//! Independent solutions that the kernel is compared with; none of them calls the kernel.

pub mod amplification;
pub mod arcs;
pub mod beams;
pub mod bonded_pair;
pub mod bounce;
pub mod components;
pub mod dissipation;
pub mod emergent;
pub mod events;
pub mod flow;
pub mod grains;
pub mod head_on;
pub mod impact;
pub mod lens;
pub mod matter;
pub mod minimum;
pub mod normal;
pub mod original;
pub mod oscillator;
pub mod printed;
pub mod quadrature;
pub mod rolling;
pub mod settling;
pub mod sliding;
pub mod solid;
pub mod spectrum;
