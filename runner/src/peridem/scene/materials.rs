//! `[materials.NAME]` and `[bonds]`: what grains are made of.

use super::Result;
use crate::error::SceneError;
use crate::scene::table::{Range, Table};
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::contact_law::ContactMaterial;
use gouge_peridem::error::SetupError;
use gouge_peridem::material::{BondConstants, Material, Plane, Weight};
use gouge_peridem::mode::Mode;

/// Ratio of the stiffness of conic bonds to that of bonds of the constant weight.
const AUTHORS_FACTOR: f64 = 4.0;

/// `[materials.NAME]`.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialTable {
    /// Its name.
    pub name: String,
    /// Young's modulus in Pa.
    pub young_modulus: f64,
    /// Density in kg/m³.
    pub density: f64,
    /// Energy to open a crack in J/m²; none if it never breaks.
    pub fracture_energy: Option<f64>,
    /// Poisson's ratio.
    pub poisson_ratio: f64,
    /// Bulk modulus in Pa of the contact, if the contact needs it.
    pub bulk_modulus: Option<f64>,
    /// The plane problem.
    pub plane: Plane,
}

/// `[bonds]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondTable {
    /// Horizon in m.
    pub horizon: f64,
    /// How the stiffness depends on the length.
    pub weight: Weight,
    /// Which bonds break; none if nothing does.
    pub breaking: Option<BreakingRule>,
    /// Whether bonds act in the step in which they break.
    pub order: BreakOrder,
    /// Where stiffness and critical stretch come from.
    pub constants: Constants,
}

/// Where stiffness and critical stretch of bonds come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constants {
    /// Both from the weight of the bonds.
    Consistent,
    /// The constant weight with the stiffness of the conic one, four times as stiff.
    Authors,
}

/// The materials of a scene, in alphabetical order.
pub(super) fn materials(root: &Table) -> Result<Vec<MaterialTable>> {
    let all = root.table("materials")?;
    let materials = all.names().map(|name| material(&all.table(name)?, name));
    let materials: Vec<MaterialTable> = materials.collect::<Result<_>>()?;
    match materials.is_empty() {
        true => Err(root.error(
            "materials",
            "must have a table per material: [materials.NAME]",
        )),
        false => Ok(materials),
    }
}

fn material(table: &Table, name: &str) -> Result<MaterialTable> {
    table.allow(&[
        "young_modulus",
        "density",
        "fracture_energy",
        "poisson_ratio",
        "bulk_modulus",
        "plane",
    ])?;
    let planes = [("stress", Plane::Stress), ("strain", Plane::Strain)];
    let plane = table.optional_choice("plane", &planes)?.unwrap_or_default();
    let ratio = table.optional_number("poisson_ratio", Range::Between(-1.0, 0.5))?;
    Ok(MaterialTable {
        name: name.to_owned(),
        young_modulus: table.number("young_modulus", Range::Positive)?,
        density: table.number("density", Range::Positive)?,
        fracture_energy: table.optional_number("fracture_energy", Range::Positive)?,
        poisson_ratio: ratio.unwrap_or(plane.poisson_ratio_of_bonds()),
        bulk_modulus: table.optional_number("bulk_modulus", Range::Positive)?,
        plane,
    })
}

/// Read `[bonds]`.
pub(super) fn bonds(root: &Table, mode: Mode) -> Result<BondTable> {
    let table = root.table("bonds")?;
    table.allow(&["horizon", "weight", "breaking", "order", "constants"])?;
    let weights = [
        ("constant", Weight::Constant),
        ("conic", Weight::Conic),
        ("parabolic", Weight::Parabolic),
    ];
    let rules = [
        ("tension-only", Some(BreakingRule::TensionOnly)),
        ("two-sided", Some(BreakingRule::TwoSided)),
        ("none", None),
    ];
    let orders = [
        ("break-first", BreakOrder::BreakFirst),
        ("force-first", BreakOrder::ForceFirst),
    ];
    let origins = [
        ("consistent", Constants::Consistent),
        ("authors", Constants::Authors),
    ];
    let weight = table
        .optional_choice("weight", &weights)?
        .unwrap_or_default();
    let by_mode = match mode.is_of_authors() && weight == Weight::Constant {
        true => Constants::Authors,
        false => Constants::Consistent,
    };
    let constants = table
        .optional_choice("constants", &origins)?
        .unwrap_or(by_mode);
    if constants == Constants::Authors && weight != Weight::Constant {
        return Err(table.error("constants", "needs bonds.weight = \"constant\""));
    }
    let breaking = table.optional_choice("breaking", &rules)?;
    let order = table.optional_choice("order", &orders)?;
    Ok(BondTable {
        horizon: table.number("horizon", Range::Positive)?,
        weight,
        breaking: breaking.unwrap_or(Some(mode.breaking())),
        order: order.unwrap_or(mode.break_order()),
        constants,
    })
}

impl MaterialTable {
    fn material(&self) -> Material {
        Material {
            young_modulus: self.young_modulus,
            poisson_ratio: self.poisson_ratio,
            // A material that never breaks needs none: its critical stretch is not used.
            fracture_energy: self.fracture_energy.unwrap_or(1.0),
            density: self.density,
            plane: self.plane,
        }
    }

    /// Stiffness and critical stretch of its bonds.
    ///
    /// # Errors
    /// Numbers that the kernel refuses.
    pub fn constants(&self, bonds: &BondTable) -> std::result::Result<BondConstants, SetupError> {
        let constants = self
            .material()
            .bond_constants(bonds.weight, bonds.horizon)?;
        Ok(BondConstants {
            stiffness: constants.stiffness * factor(bonds),
            critical_stretch: match self.fracture_energy {
                Some(_) => constants.critical_stretch,
                None => f64::INFINITY,
            },
            ..constants
        })
    }

    /// What the stiffness of contacts depends on.
    pub fn contact(&self, bonds: &BondTable) -> ContactMaterial {
        let material = self.material();
        ContactMaterial {
            material: Material {
                young_modulus: material.young_modulus * factor(bonds),
                ..material
            },
            bulk_modulus: self.bulk_modulus.unwrap_or(f64::NAN),
            horizon: bonds.horizon,
        }
    }
}

/// The error of a scene for a reason that the kernel gives, about the key of a material or of the bonds that it names.
pub(super) fn refused(root: &Table, material: &MaterialTable, reason: &SetupError) -> SceneError {
    let name = match reason {
        SetupError::Product { name, .. } | SetupError::Parameter { name, .. } => *name,
        _ => "",
    };
    let at = |table: Result<Table>, key: &str| match table {
        Ok(table) => table.error(key, &reason.to_string()),
        Err(error) => error,
    };
    match name {
        "horizon" => at(root.table("bonds"), name),
        "contact radius" => at(root.table("contact"), "radius"),
        "contact stiffness" | "" => at(root.table("contact"), "stiffness"),
        _ => {
            let all = root.table("materials");
            at(all.and_then(|all| all.table(&material.name)), name)
        }
    }
}

fn factor(bonds: &BondTable) -> f64 {
    match bonds.constants {
        Constants::Consistent => 1.0,
        Constants::Authors => AUTHORS_FACTOR,
    }
}
