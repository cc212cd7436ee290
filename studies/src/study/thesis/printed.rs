//! What the thesis prints: table 1.

/// Laws of friction, in the order of the table.
pub const LAWS: [&str; 3] = ["none", "HW", "CS"];

/// A row of table 1: pressure in units of the normal strength, and the flags of the three laws.
pub type Row = (f64, [&'static str; 3]);

/// Thesis table 1. F: more than a few fragments. C: cracks longer than a few particles. L: a layer of fragments thicker
/// than a few particles. E: cracks from the layer reached the edges. B: the layer reached the edges.
pub const TABLE: [Row; 25] = [
    (0.0125, ["", "", "F"]),
    (0.025, ["F", "F", "FC"]),
    (0.0375, ["F", "F", "FC"]),
    (0.05, ["F", "F", "FC"]),
    (0.0625, ["F", "F", "F"]),
    (0.075, ["F", "F", "FC"]),
    (0.0875, ["FC", "F", "FC"]),
    (0.1, ["FCL", "F", "FCL"]),
    (0.1125, ["FC", "F", "FCL"]),
    (0.125, ["FCL", "FCL", "FCLE"]),
    (0.15, ["FCL", "FCL", "FCLE"]),
    (0.175, ["FCL", "FCL", "FCLE"]),
    (0.2, ["FCL", "FCL", "FCLE"]),
    (0.225, ["FCL", "FL", "FCL"]),
    (0.25, ["FCL", "FL", "FCL"]),
    (0.3, ["FL", "FL", "FCL"]),
    (0.35, ["FL", "FCL", "FCL"]),
    (0.4, ["FCL", "FCL", "FCLE"]),
    (0.45, ["FCL", "FCL", "FCLE"]),
    (0.5, ["FCL", "FCL", "FCLE"]),
    (0.6, ["FCLE", "FCLE", "FCLE"]),
    (0.7, ["FCLE", "FCLEB", "FCLE"]),
    (0.8, ["FCLE", "FCLEB", "FCLE"]),
    (0.9, ["FCLEB", "FCLEB", "FCLEB"]),
    (1.0, ["FCLEB", "FCLEB", "FCLEB"]),
];
