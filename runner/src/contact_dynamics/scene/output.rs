//! `[output]`: what a run writes and how often.

use super::Result;
use crate::scene::Trajectory;
use crate::scene::table::{Range, Table};

/// `[output]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Time between samples in s.
    pub interval: f64,
    /// Format of the trajectory.
    pub trajectory: Trajectory,
    /// Whether the work of every step is booked and written.
    pub energy: bool,
    /// What else is measured at every sample.
    pub measure: Vec<Measure>,
}

/// Quantities that a run writes only if a scene asks for them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// Stress and the sums over the contact network from which its means follow.
    Network,
}

const MEASURES: [(&str, Measure); 1] = [("network", Measure::Network)];

/// Read `[output]` of a scene that ends at a time.
pub(super) fn output(root: &Table, end: f64) -> Result<Output> {
    let mut output = Output {
        interval: if end > 0.0 { end / 200.0 } else { 1.0 },
        trajectory: Trajectory::None,
        energy: true,
        measure: Vec::new(),
    };
    let Some(table) = root.optional_table("output")? else {
        return Ok(output);
    };
    table.allow(&["interval", "trajectory", "energy", "measure"])?;
    if let Some(interval) = table.optional_number("interval", Range::Positive)? {
        output.interval = interval;
    }
    output.trajectory = Trajectory::read(&table)?;
    output.energy = table.optional_truth("energy")?.unwrap_or(true);
    output.measure = table.optional_choices("measure", &MEASURES)?;
    Ok(output)
}
