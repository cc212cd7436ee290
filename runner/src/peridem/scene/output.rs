//! `[output]` and `[[cracks]]`: what a run writes and measures.

use super::Result;
use crate::scene::Trajectory;
use crate::scene::table::{Range, Table};
use gouge_common::geometry::Vec2;

/// Damage beyond which a node belongs to a crack, by default.
const THRESHOLD: f64 = 0.35;
/// Most cracks of a scene.
pub const MOST_CRACKS: usize = 8;

/// `[output]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Time between samples in s.
    pub interval: f64,
    /// Format of the trajectory.
    pub trajectory: Trajectory,
    /// Whether energies are computed and written.
    pub energy: bool,
    /// Whether the final bonds are written.
    pub bonds: bool,
}

/// `[[cracks]]`: a crack whose direction and length are measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrackTable {
    /// The grain.
    pub grain: usize,
    /// Where it begins, in m, at t = 0.
    pub tip: Vec2,
    /// Damage beyond which a node belongs to it.
    pub threshold: f64,
    /// Smallest and largest distance in m of its nodes from the tip, at t = 0.
    pub within: [f64; 2],
    /// Whether damage must lead from its tip to them.
    pub connected: bool,
}

/// Read `[output]` of a scene that ends at a time.
pub(super) fn output(root: &Table, end: f64) -> Result<Output> {
    let mut output = Output {
        interval: if end > 0.0 { end / 200.0 } else { 1.0 },
        trajectory: Trajectory::None,
        energy: true,
        bonds: false,
    };
    let Some(table) = root.optional_table("output")? else {
        return Ok(output);
    };
    table.allow(&["interval", "trajectory", "energy", "bonds"])?;
    if let Some(interval) = table.optional_number("interval", Range::Positive)? {
        output.interval = interval;
    }
    output.trajectory = Trajectory::read(&table)?;
    output.energy = table.optional_truth("energy")?.unwrap_or(true);
    output.bonds = table.optional_truth("bonds")?.unwrap_or(false);
    Ok(output)
}

/// Read `[[cracks]]` of a scene with a number of grains.
pub(super) fn cracks(root: &Table, grains: usize) -> Result<Vec<CrackTable>> {
    let tables = root.tables("cracks")?;
    if tables.len() > MOST_CRACKS {
        return Err(root.error("cracks", &format!("must be at most {MOST_CRACKS} cracks")));
    }
    tables.iter().map(|table| crack(table, grains)).collect()
}

fn crack(table: &Table, grains: usize) -> Result<CrackTable> {
    table.allow(&["grain", "tip", "threshold", "within", "connected"])?;
    let last = grains.saturating_sub(1) as u64;
    let grain = table.optional_whole_within("grain", 0, last)?.unwrap_or(0);
    let [x, y] = table.pair("tip")?;
    let threshold = table.optional_number("threshold", Range::Between(0.0, 1.0))?;
    let within = match table.optional_pair("within")? {
        Some([low, high]) if !(0.0 <= low && low < high) => {
            let accepted = "must be two distances in m, not negative, the smaller one first";
            return Err(table.error("within", accepted));
        }
        given => given.unwrap_or([0.0, f64::INFINITY]),
    };
    Ok(CrackTable {
        grain: grain as usize,
        tip: Vec2::new(x, y),
        threshold: threshold.unwrap_or(THRESHOLD),
        within,
        connected: table.optional_truth("connected")?.unwrap_or(true),
    })
}
