//! `[external]` of the models that have only gravity.

use super::table::{Range, Table};
use crate::error::SceneError;
use gouge_common::geometry::Vec2;

/// The acceleration of gravity in m/s², downwards unless it has another direction.
pub(crate) fn gravity(root: &Table) -> Result<Vec2, SceneError> {
    let Some(table) = root.optional_law("external")? else {
        return Ok(Vec2::zero());
    };
    table.allow(&["law", "acceleration", "direction"])?;
    table.choice("law", &[("gravity", ())])?;
    let acceleration = table.number("acceleration", Range::Finite)?;
    let [x, y] = table.optional_pair("direction")?.unwrap_or([0.0, -1.0]);
    let largest = x.abs().max(y.abs());
    if largest == 0.0 {
        return Err(table.error("direction", "must not be [0, 0]"));
    }
    // The squares of very large and small components are no usable numbers.
    let scale = if (1e-150..1e150).contains(&largest) {
        1.0
    } else {
        largest
    };
    let direction = Vec2::new(x / scale, y / scale);
    Ok(direction * (acceleration / direction.norm()))
}
