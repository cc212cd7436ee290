//! What the thesis prints.

/// Laws of friction, in the order of thesis table 1.
pub const LAWS: [&str; 3] = ["none", "HW", "CS"];
