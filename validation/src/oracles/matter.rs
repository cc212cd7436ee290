//! Elasticity from Hooke's law as a matrix, and spheres as stacks of discs.

use nalgebra::Matrix3;
use std::f64::consts::PI;

/// Normal stiffnesses of an isotropic solid: the inverse of its compliances, which are one along and
/// minus Poisson's ratio across each axis, over Young's modulus. Nothing for a solid without inverse.
fn stiffness(youngs_modulus: f64, poissons_ratio: f64) -> Option<Matrix3<f64>> {
    let compliance = Matrix3::from_fn(|row, column| {
        let share = if row == column { 1.0 } else { -poissons_ratio };
        share / youngs_modulus
    });
    compliance.try_inverse()
}

/// Moduli of an isotropic solid in Pa.
#[derive(Clone, Copy, Debug)]
pub struct Moduli {
    /// Stress for a unit strain along one axis while the others are held.
    pub uniaxial: f64,
    /// Mean stress for a unit change of volume.
    pub bulk: f64,
    /// Half the stress difference for stretching one axis and squeezing another: a shear seen at 45
    /// degrees.
    pub shear: f64,
}

/// The moduli of a solid with the given Young's modulus in Pa and Poisson's ratio.
pub fn moduli(youngs_modulus: f64, poissons_ratio: f64) -> Option<Moduli> {
    let stiffness = stiffness(youngs_modulus, poissons_ratio)?;
    let stress = |strain: [f64; 3]| stiffness * nalgebra::Vector3::from(strain);
    Some(Moduli {
        uniaxial: stress([1.0, 0.0, 0.0])[0],
        bulk: stress([1.0 / 3.0; 3]).mean(),
        shear: 0.5 * stress([1.0, -1.0, 0.0])[0],
    })
}

/// Mass in kg and moment of inertia in kg m^2 of a homogeneous sphere, as a stack of thin discs with
/// half their mass times the squared radius for the moment of inertia. Boole's rule integrates such
/// polynomials exactly.
pub fn sphere(density: f64, radius: f64) -> [f64; 2] {
    let weights = [7.0, 32.0, 12.0, 32.0, 7.0].map(|w| w / 90.0 * 2.0 * radius);
    let disc = |height: f64| {
        let squared = (radius - height) * (radius + height);
        let mass = density * PI * squared;
        [mass, 0.5 * mass * squared]
    };
    let heights = [-1.0, -0.5, 0.0, 0.5, 1.0].map(|share| share * radius);
    let mut sums = [0.0; 2];
    for (weight, height) in weights.iter().zip(heights) {
        for (sum, part) in sums.iter_mut().zip(disc(height)) {
            *sum += weight * part;
        }
    }
    sums
}
