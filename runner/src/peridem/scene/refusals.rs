//! Errors about keys of a scene whose reasons only the kernel finds, when the grains have nodes.

use super::{ContactTable, Result, outline};
use crate::error::SceneError;
use crate::scene::table::Table;

/// Errors without their reasons.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Refusals {
    /// About `time.step`.
    pub step: Option<SceneError>,
    /// About `contact.radius`.
    pub radius: Option<SceneError>,
    /// About each grain.
    pub grains: Vec<GrainRefusals>,
}

/// Errors about a grain without their reasons.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GrainRefusals {
    /// About the grain as a whole.
    pub whole: SceneError,
    /// About the key that gives its shape.
    pub shape: SceneError,
    /// About its cuts.
    pub cuts: SceneError,
    /// About its position.
    pub position: SceneError,
    /// About its velocity, if it is given.
    pub velocity: Option<SceneError>,
    /// About its angular velocity, if it is given.
    pub angular_velocity: Option<SceneError>,
    /// About `clamped`.
    pub clamped: SceneError,
    /// About `loads`.
    pub loads: SceneError,
}

impl Refusals {
    /// The errors about a scene with these tables.
    pub(super) fn of(
        root: &Table,
        time: &Table,
        contact: Option<&ContactTable>,
        grains: &[Table],
    ) -> Result<Self> {
        let radius = match contact {
            Some(_) => Some(root.table("contact")?.error("radius", "")),
            None => None,
        };
        let of_grain = |table: &Table| {
            let given = |key: &str| table.has(key).then(|| table.error(key, ""));
            GrainRefusals {
                whole: table.own_error(""),
                shape: table.error(outline::shape_key(table), ""),
                cuts: table.error("cuts", ""),
                position: table.error("position", ""),
                velocity: given("velocity"),
                angular_velocity: given("angular_velocity"),
                clamped: table.error("clamped", ""),
                loads: table.error("loads", ""),
            }
        };
        Ok(Self {
            step: Some(time.error("step", "")),
            radius,
            grains: grains.iter().map(of_grain).collect(),
        })
    }
}
