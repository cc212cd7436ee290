//! The tables of a scene that choose laws.

use super::table::{Range, Table};
use crate::error::SceneError;
use gouge_common::geometry::{Domain, Vec2};
use gouge_dem::calibration::{rebounding_bshp, rebounding_kelvin_voigt};
use gouge_dem::geometry::{ContactDistance, Lever, MixedArms, Translation};
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Bshp, Controller, CorrelationDrag, CreepingDrag, CundallStrack,
    CundallStrackTruncated, Driving, EulerBernoulli, Gravity, HaffWerner, HarmonicWell,
    KelvinVoigt, ZhangEckert,
};
use gouge_dem::material::Elastic;
use gouge_dem::model::{
    Ambient, BondLaws, ContactLaws, ContactNormal, ContactTangential, External, Reading, Yielding,
};

type Result<T> = std::result::Result<T, SceneError>;

#[derive(Clone, Copy)]
enum Normal {
    KelvinVoigt,
    Bshp,
}

#[derive(Clone, Copy)]
enum Tangential {
    HaffWerner,
    CundallStrack,
    CundallStrackTruncated,
}

/// `[contact]`.
pub fn contact(root: &Table, reading: Reading) -> Result<Option<ContactLaws>> {
    let Some(table) = root.optional_table("contact")? else {
        return Ok(None);
    };
    table.allow(&["distance", "normal", "tangential"])?;
    let distance = contact_distance(&table)?;
    let normal = contact_normal(&table.table("normal")?)?;
    let tangential = match table.optional_law("tangential")? {
        Some(table) => Some(contact_tangential(&table, reading)?),
        None => None,
    };
    Ok(Some(ContactLaws {
        distance,
        normal,
        tangential,
    }))
}

/// One of the thesis's distances, or a table that reproduces the conventions of another program.
fn contact_distance(table: &Table) -> Result<ContactDistance> {
    if table.has_table("distance") {
        let mixed = table.table("distance")?;
        mixed.allow(&["kinematic", "translation", "torque"])?;
        let levers = [
            ("radius", Lever::Radius),
            ("focal", Lever::Focal),
            ("half-overlap", Lever::HalfOverlap),
        ];
        let translations = [
            ("whole", Translation::Whole),
            ("levers", Translation::Levers),
        ];
        return Ok(ContactDistance::Mixed(MixedArms {
            kinematic: mixed.choice("kinematic", &levers)?,
            translation: mixed.choice("translation", &translations)?,
            torque: mixed.choice("torque", &levers)?,
        }));
    }
    let distances = [
        ("radius", ContactDistance::Radius),
        ("focal", ContactDistance::Focal),
        ("mean", ContactDistance::Mean),
    ];
    let distance = table.optional_choice("distance", &distances)?;
    Ok(distance.unwrap_or(ContactDistance::Radius))
}

fn contact_normal(table: &Table) -> Result<ContactNormal> {
    let laws = [
        ("kelvin-voigt", Normal::KelvinVoigt),
        ("bshp", Normal::Bshp),
    ];
    match table.choice("law", &laws)? {
        Normal::KelvinVoigt => kelvin_voigt(table),
        Normal::Bshp => bshp(table),
    }
}

fn kelvin_voigt(table: &Table) -> Result<ContactNormal> {
    table.allow(&["law", "stiffness", "damping", "restitution"])?;
    let stiffness = table.number("stiffness", Range::NonNegative)?;
    Ok(match restitution(table, "damping")? {
        Some(restitution) => {
            ContactNormal::ReboundingKelvinVoigt(rebounding_kelvin_voigt(stiffness, restitution))
        }
        None => ContactNormal::KelvinVoigt(KelvinVoigt {
            stiffness,
            damping: table.number("damping", Range::NonNegative)?,
        }),
    })
}

fn bshp(table: &Table) -> Result<ContactNormal> {
    table.allow(&[
        "law",
        "youngs_modulus",
        "poissons_ratio",
        "dissipative_constant",
        "restitution",
        "restitution_speed",
    ])?;
    let youngs_modulus = table.number("youngs_modulus", Range::NonNegative)?;
    let poissons_ratio = table.number("poissons_ratio", Range::Between(-1.0, 0.5))?;
    if let Some(restitution) = restitution(table, "dissipative_constant")? {
        let elastic = Elastic {
            youngs_modulus: table.number("youngs_modulus", Range::Positive)?,
            poissons_ratio,
        };
        let speed = table.number("restitution_speed", Range::Positive)?;
        let law = rebounding_bshp(elastic, restitution, speed);
        return Ok(ContactNormal::ReboundingBshp(law));
    }
    if table.has("restitution_speed") {
        let accepted = "belongs to contact.normal.restitution, which is absent";
        return Err(table.error("restitution_speed", accepted));
    }
    Ok(ContactNormal::Bshp(Bshp {
        youngs_modulus,
        poissons_ratio,
        dissipative_constant: table.number("dissipative_constant", Range::NonNegative)?,
    }))
}

/// The wanted coefficient of restitution, if it is given instead of a constant of the law.
fn restitution(table: &Table, constant: &str) -> Result<Option<f64>> {
    let (is_wanted, is_given) = (table.has("restitution"), table.has(constant));
    if is_wanted && is_given {
        let accepted = format!(
            "must not be given together with {constant}; an override replaces the whole table, contact.normal={{ law = ..., restitution = ... }}"
        );
        return Err(table.error("restitution", &accepted));
    }
    if !is_wanted && !is_given {
        let number = Range::NonNegative.text();
        let accepted = format!("missing; {number}, unless restitution is given instead");
        return Err(table.error(constant, &accepted));
    }
    let accepted = "must be a number greater than 0, at most 1";
    match table.optional_number("restitution", Range::Finite)? {
        Some(number) if number <= 0.0 || number > 1.0 => Err(table.error("restitution", accepted)),
        restitution => Ok(restitution),
    }
}

fn contact_tangential(table: &Table, reading: Reading) -> Result<ContactTangential> {
    let laws = [
        ("haff-werner", Tangential::HaffWerner),
        ("cundall-strack", Tangential::CundallStrack),
        (
            "cundall-strack-truncated",
            Tangential::CundallStrackTruncated,
        ),
    ];
    let law = table.choice("law", &laws)?;
    let constant = if matches!(law, Tangential::HaffWerner) {
        "damping"
    } else {
        "stiffness"
    };
    table.allow(&["law", "friction", constant])?;
    let friction = table.number("friction", Range::NonNegative)?;
    let constant = table.number(constant, Range::NonNegative)?;
    Ok(match law {
        Tangential::HaffWerner => ContactTangential::HaffWerner(HaffWerner {
            friction,
            damping: constant,
        }),
        Tangential::CundallStrack => ContactTangential::CundallStrack(CundallStrack {
            friction,
            stiffness: constant,
            grips_at_rest: reading == Reading::Thesis,
        }),
        Tangential::CundallStrackTruncated => {
            ContactTangential::CundallStrackTruncated(CundallStrackTruncated {
                friction,
                stiffness: constant,
            })
        }
    })
}

/// `[bond]`.
pub fn bond(root: &Table) -> Result<Option<BondLaws>> {
    let Some(table) = root.optional_table("bond")? else {
        return Ok(None);
    };
    table.allow(&["normal", "tangential", "yielding"])?;
    let normal = table.table("normal")?;
    normal.allow(&["stiffness", "damping"])?;
    let normal = AdjustedKelvinVoigt {
        stiffness: normal.number("stiffness", Range::NonNegative)?,
        damping: normal.number("damping", Range::NonNegative)?,
    };
    let tangential = match table.optional_table("tangential")? {
        Some(table) => Some(beam(&table)?),
        None => None,
    };
    let yielding = match table.optional_table("yielding")? {
        Some(table) => Some(yielding(&table)?),
        None => None,
    };
    Ok(Some(BondLaws {
        normal,
        tangential,
        yielding,
    }))
}

fn beam(table: &Table) -> Result<EulerBernoulli> {
    table.choice("law", &[("euler-bernoulli", ())])?;
    table.allow(&["law", "stiffness", "damping"])?;
    Ok(EulerBernoulli {
        stiffness: table.number("stiffness", Range::NonNegative)?,
        damping: table.number("damping", Range::NonNegative)?,
    })
}

fn yielding(table: &Table) -> Result<Yielding> {
    table.choice("law", &[("zhang-eckert", ())])?;
    table.allow(&[
        "law",
        "normal_strength",
        "tangential_strength",
        "tensile_strength",
        "unbreakable_edges",
    ])?;
    Ok(Yielding {
        law: ZhangEckert {
            normal_strength: table.number("normal_strength", Range::Positive)?,
            tangential_strength: table.number("tangential_strength", Range::Positive)?,
        },
        tensile_strength: table.optional_number("tensile_strength", Range::Positive)?,
        unbreakable_edges: table.optional_truth("unbreakable_edges")?.unwrap_or(true),
    })
}

/// `[ambient]` of the scene or of a phase.
pub fn ambient(parent: &Table, reading: Reading) -> Result<Option<Ambient>> {
    let Some(table) = parent.optional_law("ambient")? else {
        return Ok(None);
    };
    if table.choice("law", &[("creeping", true), ("correlation", false)])? {
        table.allow(&["law", "viscosity"])?;
        let viscosity = table.number("viscosity", Range::NonNegative)?;
        return Ok(Some(Ambient::Creeping(CreepingDrag { viscosity })));
    }
    table.allow(&["law", "viscosity", "density"])?;
    Ok(Some(Ambient::Correlation(CorrelationDrag {
        viscosity: table.number("viscosity", Range::Positive)?,
        density: table.number("density", Range::Positive)?,
        constant: match reading {
            Reading::Corrected => CorrelationDrag::CONSTANT,
            Reading::Thesis => CorrelationDrag::PRINTED_CONSTANT,
        },
    })))
}

/// `[external]` of the scene or of a phase.
pub fn external(parent: &Table, domain: &Domain) -> Result<Option<External>> {
    let Some(table) = parent.optional_law("external")? else {
        return Ok(None);
    };
    if table.choice("law", &[("gravity", true), ("harmonic-well", false)])? {
        table.allow(&["law", "acceleration"])?;
        let acceleration = table.number("acceleration", Range::Finite)?;
        return Ok(Some(External::Gravity(Gravity { acceleration })));
    }
    table.allow(&["law", "stiffness"])?;
    let Some(height) = domain.height else {
        let accepted =
            "needs box.height, because a harmonic well is centred at half the height of the box";
        return Err(table.error("law", accepted));
    };
    let stiffness = table.number("stiffness", Range::NonNegative)?;
    Ok(Some(External::HarmonicWell(HarmonicWell {
        stiffness,
        centre: 0.5 * height,
    })))
}

#[derive(Clone, Copy)]
enum Control {
    RateLimited,
    Exact,
    Steady,
}

/// `[driving]`, with the initial force. The default area depends on the particles, so it is found later.
pub fn driving(root: &Table) -> Result<Option<DrivingTable>> {
    let Some(table) = root.optional_table("driving")? else {
        return Ok(None);
    };
    let controllers = [
        ("rate-limited", Control::RateLimited),
        ("exact", Control::Exact),
        ("steady", Control::Steady),
    ];
    let control = table.choice("controller", &controllers)?;
    if matches!(control, Control::Steady) {
        return steady(&table).map(Some);
    }
    let mut known = vec!["controller", "speed", "pressure", "area", "initial_force"];
    if matches!(control, Control::RateLimited) {
        known.push("force_rate");
    }
    table.allow(&known)?;
    let controller = match control {
        Control::RateLimited => Controller::RateLimited {
            force_rate: table.number("force_rate", Range::NonNegative)?,
        },
        Control::Exact | Control::Steady => Controller::Exact,
    };
    Ok(Some(DrivingTable {
        controller,
        speed: table.number("speed", Range::Finite)?,
        pressure: table.number("pressure", Range::Finite)?,
        area: table.optional_number("area", Range::Positive)?,
        initial_force: table.optional_pair("initial_force")?.unwrap_or([0.0; 2]),
    }))
}

/// A prescribed velocity, which needs no target and no area.
fn steady(table: &Table) -> Result<DrivingTable> {
    table.allow(&["controller", "velocity"])?;
    let [x, y] = table.pair("velocity")?;
    Ok(DrivingTable {
        controller: Controller::Steady {
            velocity: Vec2::new(x, y),
        },
        speed: x,
        pressure: 0.0,
        area: Some(1.0),
        initial_force: [0.0; 2],
    })
}

/// The table `[driving]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrivingTable {
    /// The controller.
    pub controller: Controller,
    /// Target speed in m/s.
    pub speed: f64,
    /// Target pressure in Pa.
    pub pressure: f64,
    /// Area in m^2; by default the width times the characteristic length.
    pub area: Option<f64>,
    /// Total driving force at t = 0 in N.
    pub initial_force: [f64; 2],
}

impl DrivingTable {
    /// The law, for the width of the box and a characteristic length in m.
    pub fn law(&self, width: f64, length: f64) -> Driving {
        Driving {
            controller: self.controller,
            speed: self.speed,
            pressure: self.pressure,
            area: self.area.unwrap_or(width * length),
        }
    }
}
