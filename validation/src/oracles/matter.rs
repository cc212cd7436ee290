//! Elastic moduli from Hooke's law as a matrix, and spheres as stacks of discs.

use nalgebra::Matrix3;
use std::f64::consts::PI;

/// Normal stiffnesses of an isotropic solid: the inverse of its compliance matrix, with one on the
/// diagonal and minus Poisson's ratio elsewhere, over Young's modulus. None if the matrix is singular.
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
    /// Stress for a unit strain along one axis with zero strain along the others.
    pub uniaxial: f64,
    /// Mean stress for a unit volume change.
    pub bulk: f64,
    /// Half the stress difference when one axis is stretched and another compressed: shear in a frame
    /// rotated by 45 degrees.
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

/// Mass in kg and moment of inertia in kg m^2 of a homogeneous sphere, as a stack of thin discs, each
/// with a moment of inertia of half its mass times its squared radius. Boole's rule integrates these
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
