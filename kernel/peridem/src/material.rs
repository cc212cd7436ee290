//! What bonds are made of: weights, stiffness, critical stretch.

use crate::error::{SetupError, require, require_product};
use core::f64::consts::PI;
use gouge_equations::rendered;

/// How the stiffness of a bond depends on its reference length r.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weight {
    /// $ w = 1 $: the prototype microelastic brittle material.
    #[default]
    Constant,
    /// $ w = 1 - r/\epsilon $
    Conic,
    /// $ w = 1 - (r/\epsilon)^2 $; not in the source.
    Parabolic,
}

/// Which of the two plane problems of elasticity a grain approximates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plane {
    /// A thin plate: Poisson's ratio of the bonds is 1/3.
    #[default]
    Stress,
    /// A long prism: Poisson's ratio of the bonds is 1/4.
    Strain,
}

impl Plane {
    /// Poisson's ratio of central bonds.
    pub fn poisson_ratio_of_bonds(self) -> f64 {
        match self {
            Self::Stress => 1.0 / 3.0,
            Self::Strain => 0.25,
        }
    }
}

/// A brittle elastic material, as an experiment gives it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus in Pa.
    pub young_modulus: f64,
    /// Poisson's ratio. Central bonds act as one of 1/3 (plane stress) or 1/4 (plane strain), whatever is given here.
    pub poisson_ratio: f64,
    /// Energy to open a crack, in J/m^2.
    pub fracture_energy: f64,
    /// Density in kg/m^3.
    pub density: f64,
    /// The plane problem.
    pub plane: Plane,
}

/// Stiffness and critical stretch of bonds; both from the same weight.
#[rendered]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondConstants {
    /// The weight.
    pub weight: Weight,
    /// Horizon $\epsilon$ in m.
    pub horizon: f64,
    /// Stiffness c in N/m^6 per metre of depth: times two areas and a stretch, it is a force per metre of depth.
    pub stiffness: f64,
    /// Critical stretch $s_0$, dimensionless.
    pub critical_stretch: f64,
}

/// Numbers in which the weights differ: integrals over the horizon.
struct Moments {
    /// $\int_0^1 w(t) t^2 dt$ of the energy of an isotropic stretch.
    dilation: f64,
    /// $\int_0^1 w(t) t^3 dt$ of the energy that separates two half planes.
    separation: f64,
}

#[rendered]
impl Weight {
    /// Weight w, dimensionless, of a bond of reference length r in m for a horizon in m.
    #[inline(always)]
    pub fn at(self, length: f64, horizon: f64) -> f64 {
        let ratio = length / horizon;
        match self {
            Self::Constant => 1.0,
            Self::Conic => 1.0 - ratio,
            Self::Parabolic => 1.0 - ratio * ratio,
        }
    }

    fn moments(self) -> Moments {
        let (dilation, separation) = match self {
            Self::Constant => (1.0 / 3.0, 1.0 / 4.0),
            Self::Conic => (1.0 / 12.0, 1.0 / 20.0),
            Self::Parabolic => (2.0 / 15.0, 1.0 / 12.0),
        };
        Moments {
            dilation,
            separation,
        }
    }
}

#[rendered]
impl Material {
    /// Energy density of an isotropic stretch of one, in Pa.
    ///
    /// $$ \frac{W}{s^2} = \frac{E}{1 - \nu} \quad \text{or} \quad \frac{E}{(1 + \nu)(1 - 2 \nu)} $$
    ///
    /// for plane stress or plane strain.
    fn dilation_modulus(&self) -> f64 {
        let (modulus, ratio) = (self.young_modulus, self.poisson_ratio);
        match self.plane {
            Plane::Stress => modulus / (1.0 - ratio),
            Plane::Strain => modulus / ((1.0 + ratio) * (1.0 - 2.0 * ratio)),
        }
    }

    /// Young's modulus in Pa of the bonds. It is the given one only if Poisson's ratio is that of the bonds, too: bonds have
    /// the given energy of an isotropic stretch.
    pub fn young_modulus_of_bonds(&self) -> f64 {
        let of_bonds = Self {
            poisson_ratio: self.plane.poisson_ratio_of_bonds(),
            ..*self
        };
        self.young_modulus * (self.dilation_modulus() / of_bonds.dilation_modulus())
    }

    /// Stiffness and critical stretch of bonds of this material.
    ///
    /// $$ c = \frac{2 W/s^2}{\pi \epsilon^3 \int_0^1 w t^2 dt}, \qquad s_0 = \sqrt{\frac{G_c}{c \, \epsilon^4 \int_0^1 w t^3 dt}} $$
    ///
    /// Table 1 of peridem: the energy of an isotropic stretch is that of an elastic plate, and to separate two half planes
    /// costs the fracture energy. The printed $s_0$ is this one for a Poisson's ratio of 1/3, which is that of the bonds.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a number outside its range, and [`SetupError::Product`] for numbers with which the
    /// stiffness, the critical stretch or the speed of waves under- or overflow.
    pub fn bond_constants(
        &self,
        weight: Weight,
        horizon: f64,
    ) -> Result<BondConstants, SetupError> {
        self.validate()?;
        require("horizon", horizon, "positive", horizon > 0.0)?;
        let moments = weight.moments();
        let stiffness = 2.0 * self.dilation_modulus() / (PI * horizon.powi(3) * moments.dilation);
        let separation = stiffness * horizon.powi(4) * moments.separation;
        let critical_stretch = (self.fracture_energy / separation).sqrt();
        let modulus = ("young_modulus", self.young_modulus, 1);
        let factors = [modulus, ("horizon", horizon, -3)];
        require_product("the stiffness of bonds in N/m^6", stiffness, &factors)?;
        let factors = [modulus, ("density", self.density, -1)];
        let speed_squared = self.young_modulus / self.density;
        let name = "the square of the speed of waves in m^2/s^2";
        require_product(name, speed_squared, &factors)?;
        // Any other stretch is accepted: some scenes make bonds unbreakable with a huge fracture energy.
        if !(critical_stretch > 0.0 && critical_stretch.is_finite()) {
            let factors = [("fracture_energy", self.fracture_energy, 1)];
            require_product("the critical stretch", critical_stretch, &factors)?;
        }
        Ok(BondConstants {
            weight,
            horizon,
            stiffness,
            critical_stretch,
        })
    }

    fn validate(&self) -> Result<(), SetupError> {
        let positive = [
            ("young_modulus", self.young_modulus),
            ("density", self.density),
            ("fracture_energy", self.fracture_energy),
        ];
        for (name, value) in positive {
            require(name, value, "positive", value > 0.0)?;
        }
        let ratio = self.poisson_ratio;
        require(
            "poisson_ratio",
            ratio,
            "above -1 and below 0.5",
            ratio > -1.0 && ratio < 0.5,
        )
    }
}
