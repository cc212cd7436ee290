//! The spheres of this topic.

use std::f64::consts::PI;

/// Radius of most spheres in m.
pub const RADIUS: f64 = crate::scenes::events::RADIUS;

/// Mass of a sphere of 2700 kg/m^3 in kg.
pub fn mass(radius: f64) -> f64 {
    2700.0 * 4.0 * PI * radius * radius * radius / 3.0
}

/// Moment of inertia of such a sphere in kg m^2.
pub fn inertia(radius: f64) -> f64 {
    2700.0 * 8.0 * PI * radius.powi(5) / 15.0
}
