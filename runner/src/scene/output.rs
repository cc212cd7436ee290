//! `[output]`: what a run writes and how often.

use super::Result;
use super::shape::{Rectangle, region};
use super::table::{Range, Table};
use crate::error::SceneError;

/// `[output]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Time between samples in s.
    pub interval: f64,
    /// Format of the trajectory.
    pub trajectory: Trajectory,
    /// Whether each frame is accompanied by one of all contacts and bonds, with their forces.
    pub links: bool,
    /// Whether the energy balance is kept and written.
    pub energy: bool,
    /// What else is measured at every sample, in the order of its columns.
    pub measure: Vec<Measure>,
    /// The grains whose strain is measured are those whose centre was in here at t = 0; `None` for all free grains.
    pub strain_region: Option<Rectangle>,
    /// The error that refuses this region, except for the reason.
    pub region_refusal: Option<SceneError>,
}

/// Format of the trajectory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trajectory {
    /// No frames.
    None,
    /// Legacy VTK files.
    Vtk,
    /// Extended XYZ files.
    Extxyz,
}

/// Quantities that the series holds only if a scene asks for them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// Speeds of rolling and of slip in the debris.
    Rolling,
    /// Mean stress in the free grains.
    Stress,
    /// Mean number of contacts and bonds per grain.
    Coordination,
    /// Packing fraction of the free grains.
    PackingFraction,
    /// Mean resultant force over mean force of contacts and bonds.
    UnbalancedForce,
    /// Largest overlap over the smaller radius.
    LargestOverlap,
    /// Strain of the free grains since t = 0.
    Strain,
}

/// Names of the quantities, in the order of their columns.
const MEASURES: [(&str, Measure); 7] = [
    ("rolling", Measure::Rolling),
    ("stress", Measure::Stress),
    ("coordination", Measure::Coordination),
    ("packing-fraction", Measure::PackingFraction),
    ("unbalanced-force", Measure::UnbalancedForce),
    ("largest-overlap", Measure::LargestOverlap),
    ("strain", Measure::Strain),
];

impl Trajectory {
    /// Read the key `trajectory` of `[output]`.
    pub(crate) fn read(table: &Table) -> Result<Self> {
        Ok(table
            .optional_choice("trajectory", &FORMATS)?
            .unwrap_or(Self::None))
    }
}

const FORMATS: [(&str, Trajectory); 3] = [
    ("none", Trajectory::None),
    ("vtk", Trajectory::Vtk),
    ("extxyz", Trajectory::Extxyz),
];

/// Whether a scene leaves the time between samples to us.
///
/// # Errors
/// `[output]` that is no table.
pub(crate) fn has_default_interval(root: &Table) -> Result<bool> {
    let output = root.optional_table("output")?;
    Ok(!output.is_some_and(|table| table.has("interval")))
}

/// Read `[output]` of a scene that ends at a time.
pub(super) fn output(root: &Table, end: f64) -> Result<Output> {
    let mut output = Output {
        interval: if end > 0.0 { end / 200.0 } else { 1.0 },
        trajectory: Trajectory::None,
        links: false,
        energy: true,
        measure: Vec::new(),
        strain_region: None,
        region_refusal: None,
    };
    let Some(table) = root.optional_table("output")? else {
        return Ok(output);
    };
    table.allow(&[
        "interval",
        "trajectory",
        "links",
        "energy",
        "measure",
        "strain_region",
    ])?;
    if let Some(interval) = table.optional_number("interval", Range::Positive)? {
        output.interval = interval;
    }
    output.trajectory = Trajectory::read(&table)?;
    output.links = table.optional_truth("links")?.unwrap_or(false);
    if output.links && output.trajectory == Trajectory::None {
        let accepted = "needs frames: output.trajectory = \"vtk\" or \"extxyz\"";
        return Err(table.error("links", accepted));
    }
    output.energy = table.optional_truth("energy")?.unwrap_or(true);
    output.measure = table.optional_choices("measure", &MEASURES)?;
    output.measure.sort_unstable();
    output.strain_region = region(&table, "strain_region")?;
    if output.strain_region.is_some() && !output.measure.contains(&Measure::Strain) {
        let accepted = "needs output.measure with \"strain\"";
        return Err(table.error("strain_region", accepted));
    }
    let is_limited = output.strain_region.is_some();
    output.region_refusal = is_limited.then(|| table.error("strain_region", ""));
    Ok(output)
}
