//! Cells that are sheared, from the stored start states of LMGC90.

use super::system::{detection, law, moving};
use crate::checks::Failure;
use crate::references::{Grain, Packing};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::assembly::Body;
use gouge_contact_dynamics::cell::{Cell, Drive, LOWER, Speed, UPPER};
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::shape::{ShapeId, Shapes};
use gouge_contact_dynamics::step::{Scheme, StepSettings};
use gouge_contact_dynamics::sweep::{StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::InverseMass;
use gouge_contact_dynamics::world::World;

/// The cell of a stored start state.
pub fn cell(packing: &Packing) -> Result<Cell, Failure> {
    let mut shapes = Shapes::new();
    let sides = packing.grains.first().map_or(0, |grain| grain.sides);
    let shape = match sides {
        0 => shapes.add_disc(),
        sides => shapes.add_regular(sides)?,
    };
    let roof = InverseMass {
        y: packing.inverse_wall_mass,
        ..InverseMass::IMPOSED
    };
    let mut cell = Cell::new(packing.width, packing.height, roof, shapes)?;
    for grain in &packing.grains {
        add(&mut cell, grain, shape)?;
    }
    Ok(cell)
}

fn add(cell: &mut Cell, grain: &Grain, shape: ShapeId) -> Result<(), Failure> {
    let body = Body {
        shape,
        scale: grain.radius,
        position: Vec2::new(grain.position[0], grain.position[1]),
        angle: grain.angle,
    };
    let (assembly, configuration) = (&mut cell.assembly, &mut cell.state.configuration);
    match grain.role {
        "bottom" => assembly.add_body(configuration, body, LOWER).map(drop)?,
        "top" => assembly.add_body(configuration, body, UPPER).map(drop)?,
        _ => assembly
            .add_free(configuration, body, 1.0, moving(0.0, 0.0, 0.0))
            .map(drop)?,
    }
    Ok(())
}

/// Steps of a sheared cell: a strain per step at a rate in 1/s, and the tolerance of the sweeps relative to the mean
/// impulse. Overlaps beyond 0.002 diameters are reduced by a twentieth per step.
pub fn settings(packing: &Packing, strain_per_step: f64, tolerance: f64) -> StepSettings {
    let time_step = strain_per_step / packing.rate;
    let gap = GapRule::Stabilized {
        fraction: 0.05,
        allowed_overlap: 0.002,
    };
    StepSettings {
        time_step,
        scheme: Scheme::Midpoint,
        detection: detection(1.0),
        law: law(packing.friction, 0.0, gap),
        sweeps: SweepSettings {
            stop: StopCriterion::Increment {
                tolerance,
                floor: 1e-12 * time_step,
            },
            max_sweeps: 2000,
            ..SweepSettings::default()
        },
        warm_start_distance: 0.3,
    }
}

/// The cell of a stored start state, sheared at its rate under the normal stress 1 Pa.
pub fn sheared(packing: &Packing, settings: StepSettings) -> Result<World, Failure> {
    let drive = Drive::Shear {
        normal_stress: 1.0,
        speed: Speed::Rate(packing.rate),
    };
    Ok(World::of_cell(cell(packing)?, settings, drive)?)
}
