//! Elastic spheres from their stress fields, not from the formulas of the thesis.

use super::quadrature::{integral, root};
use std::f64::consts::{PI, TAU};

/// Equal elastic spheres in contact.
#[derive(Clone, Copy, Debug)]
pub struct Spheres {
    /// Young's modulus in Pa.
    pub modulus: f64,
    /// Poisson's ratio.
    pub ratio: f64,
    /// Radius of each in m.
    pub radius: f64,
}

impl Spheres {
    /// Force in N at an overlap in m: Hertz's pressure, p0 sqrt(1 - (s/a)^2), over the contact of
    /// radius a = sqrt(R* xi), with p0 = 2 E* a / (pi R*), R* half the radius and E* half of Y / (1 -
    /// nu^2).
    pub fn force(&self, overlap: f64) -> f64 {
        let (reduced, effective) = (
            0.5 * self.radius,
            0.5 * self.modulus / (1.0 - self.ratio.powi(2)),
        );
        let contact = (reduced * overlap).sqrt();
        let highest = 2.0 * effective * contact / (PI * reduced);
        let ring = |s: f64| TAU * s * ((1.0 - s) * (1.0 + s)).sqrt();
        highest * contact * contact * integral(0.0, 1.0, ring)
    }
    /// Overlap in m at which the contact force has a value in N.
    pub fn overlap(&self, force: f64) -> f64 {
        root(0.0, self.radius, |xi| self.force(xi) - force)
    }
    /// Force over overlap to the power 3/2, in N/m^(3/2).
    pub fn prefactor(&self) -> f64 {
        self.force(self.radius) / self.radius.powf(1.5)
    }
    /// Mass of each in kg, as a stack of discs.
    pub fn mass(&self, density: f64) -> f64 {
        let disc = |z: f64| PI * (1.0 - z) * (1.0 + z);
        density * self.radius.powi(3) * integral(-1.0, 1.0, disc)
    }
}

/// Force in N of a stress in Pa over a disc of a radius in m.
pub fn force_on_disc(stress: f64, radius: f64) -> f64 {
    stress * radius * radius * integral(0.0, 1.0, |s| TAU * s)
}
