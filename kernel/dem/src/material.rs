//! Elastic constants, and the granite of thesis section 4.1.

use gouge_equations::rendered;

/// An isotropic elastic solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elastic {
    /// Young's modulus Y in Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio, dimensionless, in (-1, 1/2).
    pub poissons_ratio: f64,
}

#[rendered]
impl Elastic {
    /// Shear modulus in Pa.
    ///
    /// $$ G = \frac{Y}{2 (1 + \nu)} $$
    ///
    /// Thesis eq. (39).
    pub fn shear_modulus(self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poissons_ratio))
    }
    /// P-wave modulus in Pa.
    ///
    /// $$ M = \frac{Y (1 - \nu)}{(1 - 2 \nu)(1 + \nu)} $$
    ///
    /// Thesis eq. (39).
    pub fn p_wave_modulus(self) -> f64 {
        let nu = self.poissons_ratio;
        self.youngs_modulus * (1.0 - nu) / ((1.0 - 2.0 * nu) * (1.0 + nu))
    }
    /// Bulk modulus in Pa.
    ///
    /// $$ K = \frac{Y}{3 (1 - 2 \nu)} $$
    ///
    /// Thesis eq. (60).
    pub fn bulk_modulus(self) -> f64 {
        self.youngs_modulus / (3.0 * (1.0 - 2.0 * self.poissons_ratio))
    }
    /// Speed of primary waves in m/s; density in kg/m^3.
    ///
    /// $$ c^P = \sqrt{\frac{K + \tfrac43 G}{\rho}} $$
    ///
    /// Thesis eq. (59).
    pub fn primary_wave_speed(self, density: f64) -> f64 {
        ((self.bulk_modulus() + 4.0 / 3.0 * self.shear_modulus()) / density).sqrt()
    }
    /// Speed of secondary waves in m/s; density in kg/m^3.
    ///
    /// $$ c^S = \sqrt{\frac{G}{\rho}} $$
    ///
    /// Thesis eq. (59).
    pub fn secondary_wave_speed(self, density: f64) -> f64 {
        (self.shear_modulus() / density).sqrt()
    }
}

/// A measured quantity with its standard uncertainty, in the same unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// Central value.
    pub value: f64,
    /// Standard uncertainty.
    pub uncertainty: f64,
}

const fn measured(value: f64, uncertainty: f64) -> Measured {
    Measured { value, uncertainty }
}

/// Properties of granite, a compromise between several granites (thesis section 4.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Granite {
    /// Density in kg/m^3.
    pub density: Measured,
    /// Young's modulus in Pa.
    pub youngs_modulus: Measured,
    /// Poisson's ratio.
    pub poissons_ratio: Measured,
    /// Ultimate normal strength of bonds in Pa.
    pub strength_normal: Measured,
    /// Coefficient of friction between particles, dimensionless.
    pub friction_coefficient: Measured,
    /// Axial ratio of the yield criterion, dimensionless, thesis eq. (47).
    pub axial_ratio: Measured,
    /// Weibull modulus expected for large samples, dimensionless; the thesis uses 5.
    pub weibull_modulus: Measured,
    /// Coefficient of restitution of spheres of 1 m at 1 m/s, dimensionless.
    pub restitution: Measured,
    /// Dynamic viscosity of the surrounding air in Pa s.
    pub air_viscosity: Measured,
}

/// Granite, with the values quoted in thesis sections 4.1 and 4.3.
pub const GRANITE: Granite = Granite {
    density: measured(2.7e3, 0.1e3),
    youngs_modulus: measured(50e9, 20e9),
    poissons_ratio: measured(0.22, 0.12),
    strength_normal: measured(280e6, 30e6),
    friction_coefficient: measured(0.7, 0.1),
    axial_ratio: measured(0.6, 0.1),
    weibull_modulus: measured(15.0, 10.0),
    restitution: measured(0.83, 0.06),
    air_viscosity: measured(18e-6, 3e-6),
};

impl Granite {
    /// Elastic constants, at the central values.
    pub fn elastic(self) -> Elastic {
        Elastic {
            youngs_modulus: self.youngs_modulus.value,
            poissons_ratio: self.poissons_ratio.value,
        }
    }
}
