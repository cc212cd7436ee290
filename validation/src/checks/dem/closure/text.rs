//! Parts of the scenes of this topic.

use crate::checks::dem::scenes::{head, particle};
use std::f64::consts::PI;

/// Radius of most spheres in m.
pub const RADIUS: f64 = 1e-3;

/// Mass of a sphere of 2700 kg/m^3 in kg.
pub fn mass(radius: f64) -> f64 {
    2700.0 * 4.0 * PI * radius * radius * radius / 3.0
}

/// Moment of inertia of such a sphere in kg m^2.
pub fn inertia(radius: f64) -> f64 {
    2700.0 * 8.0 * PI * radius.powi(5) / 15.0
}

/// Kelvin-Voigt contacts.
pub fn kelvin_voigt(stiffness: f64, damping: f64) -> String {
    format!(
        "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = {stiffness:e}\ndamping = {damping:e}\n"
    )
}

/// A friction law with its friction coefficient and its second parameter.
pub fn friction(law: &str, friction: f64, parameter: f64) -> String {
    let name = if law == "haff-werner" {
        "damping"
    } else {
        "stiffness"
    };
    format!(
        "[contact.tangential]\nlaw = \"{law}\"\nfriction = {friction:e}\n{name} = {parameter:e}\n"
    )
}

/// A fixed sphere.
pub fn fixed(position: [f64; 2], radius: f64) -> String {
    particle(position, [0.0; 2], 0.0, radius) + "role = \"fixed\"\n"
}

/// Two equal spheres of [`RADIUS`] that touch and approach head on, each with the given speed.
pub fn head_on(integrator: &str, step: f64, contact: &str, speed: f64) -> String {
    let just = RADIUS.next_down();
    head(integrator, step)
        + contact
        + &particle([-just, 0.0], [speed, 0.0], 0.0, RADIUS)
        + &particle([just, 0.0], [-speed, 0.0], 0.0, RADIUS)
}
