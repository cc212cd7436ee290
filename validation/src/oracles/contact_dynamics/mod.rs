//! Independent solutions for rigid bodies in contact.

pub mod bodies;
pub mod outline;
pub mod point;
