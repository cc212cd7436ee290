//! Linear networks of bodies and simple beams: statics, modes and waves.
//!
//! A beam consists of a stretching spring of stiffness k_n and, at each end, a spring of stiffness k_t
//! that resists rotation of the body relative to the line of centres, with its radius as the lever arm:
//! U = 1/2 k_n (D - D_0)^2 + 1/2 k_t (r_i^2 (phi_i - lambda)^2 + r_j^2 (phi_j - lambda)^2).

pub mod cantilever;
pub mod network;
pub mod pair;
pub mod stretched;
pub mod waves;

/// Stiffnesses of a beam in N/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Springs {
    /// Stretching, k_n.
    pub normal: f64,
    /// Rotation of an end, k_t.
    pub tangential: f64,
}

/// A body: a homogeneous sphere in the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Radius in m.
    pub radius: f64,
    /// Density in kg/m^3.
    pub density: f64,
}

impl Sphere {
    /// Mass in kg.
    pub fn mass(self) -> f64 {
        4.0 / 3.0 * std::f64::consts::PI * self.radius.powi(3) * self.density
    }
    /// Moment of inertia in kg m^2.
    pub fn inertia(self) -> f64 {
        2.0 / 5.0 * self.mass() * self.radius.powi(2)
    }
}
