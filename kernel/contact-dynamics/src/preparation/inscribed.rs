//! Bodies in the circles of a deposit.

use super::Deposited;
use crate::assembly::Body;
use crate::cell::Cell;
use crate::error::SetupError;
use crate::shape::Shapes;
use crate::units::{InverseMass, Velocity};
use core::f64::consts::TAU;
use gouge_common::geometry::Vec2;

/// What fills the circles of a deposit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Filling {
    /// Number of sides of regular polygons; none for discs.
    pub sides: Option<usize>,
    /// Density in kg/m².
    pub density: f64,
    /// Mass per width of the roof in kg/m.
    pub roof_mass: f64,
}

/// A cell at rest whose bodies are inscribed in the circles of a deposit of diameters in m, each turned by a random
/// angle. The roof touches the highest circle.
///
/// # Errors
/// [`SetupError`] for a filling outside its range.
pub fn inscribe(
    deposited: &Deposited,
    diameters: &[f64],
    width: f64,
    filling: &Filling,
    mut uniform: impl FnMut() -> f64,
) -> Result<Cell, SetupError> {
    let mut shapes = Shapes::new();
    let shape = match filling.sides {
        Some(sides) => shapes.add_regular(sides)?,
        None => shapes.add_disc(),
    };
    let roof = InverseMass {
        y: 1.0 / (filling.roof_mass * width),
        ..InverseMass::IMPOSED
    };
    let mut cell = Cell::new(width, deposited.height, roof, shapes)?;
    for (&centre, &diameter) in deposited.centres.iter().zip(diameters) {
        let body = Body {
            shape,
            scale: 0.5 * diameter,
            position: Vec2::new(centre.x, centre.y),
            angle: TAU * uniform(),
        };
        let configuration = &mut cell.state.configuration;
        cell.assembly
            .add_free(configuration, body, filling.density, Velocity::default())?;
    }
    Ok(cell)
}
