//! What is glued to the walls of a cell.

use crate::assembly::{Assembly, Body, Configuration};
use crate::cell::{Cell, LOWER, UPPER};
use crate::detection::Placed;
use crate::error::SetupError;
use crate::units::{InverseMass, Velocity};
use gouge_common::geometry::Vec2;

/// Glue the bodies within a distance in m of a wall to it, and bring everything to rest.
///
/// Glued bodies move with their wall and do not turn. The upper wall gets the mass of the bodies glued to it, whose
/// density in kg/m² is given. All impulses are forgotten.
///
/// # Errors
/// [`SetupError::Nothing`] if nothing is near one of the walls, [`SetupError::NothingFree`] if all is.
pub fn glue(cell: &Cell, distance: f64, density: f64) -> Result<Cell, SetupError> {
    let unit_of = |body| glued_to(cell, body, distance);
    let owners: Vec<_> = (0..cell.assembly.shape.len()).map(unit_of).collect();
    for (unit, near) in [(LOWER, "the lower wall"), (UPPER, "the upper wall")] {
        if !owners.contains(&Some(unit)) {
            return Err(SetupError::Nothing { near });
        }
    }
    if owners.iter().all(Option::is_some) {
        return Err(SetupError::NothingFree);
    }
    let mass: f64 = (0..owners.len())
        .filter(|&body| owners[body] == Some(UPPER))
        .map(|body| density * cell.assembly.area(body))
        .sum();
    let inverse_mass = InverseMass {
        y: 1.0 / mass,
        ..InverseMass::IMPOSED
    };
    let shapes = cell.assembly.shapes.clone();
    let mut glued = Cell::new(cell.width(), cell.height(), inverse_mass, shapes)?;
    let (assembly, configuration) = (&mut glued.assembly, &mut glued.state.configuration);
    for (body, owner) in owners.into_iter().enumerate() {
        add(cell, body, owner, (assembly, configuration))?;
    }
    Ok(glued)
}

fn add(
    cell: &Cell,
    index: usize,
    owner: Option<u32>,
    (assembly, configuration): (&mut Assembly, &mut Configuration),
) -> Result<(), SetupError> {
    let (old, before) = (&cell.assembly, &cell.state.configuration);
    let body = Body {
        shape: old.shape[index],
        scale: old.scale[index],
        position: before.position[index],
        angle: before.angle[index],
    };
    let unit = match owner {
        Some(unit) => unit,
        None => {
            let mass = old.inverse_mass[old.unit[index] as usize];
            assembly.add_unit(configuration, mass, Velocity::default())?
        }
    };
    assembly.add_body(configuration, body, unit)?;
    Ok(())
}

/// The wall to which a body is near enough.
fn glued_to(cell: &Cell, body: usize, distance: f64) -> Option<u32> {
    let (assembly, configuration) = (&cell.assembly, &cell.state.configuration);
    let outline = assembly.shapes.outline(assembly.shape[body]);
    let placed = Placed::new(outline, assembly.scale[body], configuration.angle[body]);
    let y = configuration.position[body].y;
    let reach = |direction: Vec2| placed.reach(direction);
    let above_floor = y - reach(Vec2::new(0.0, -1.0));
    let below_roof = cell.height() - y - reach(Vec2::new(0.0, 1.0));
    match above_floor <= below_roof {
        true => (above_floor <= distance).then_some(LOWER),
        false => (below_roof <= distance).then_some(UPPER),
    }
}
