//! Friction and heat over time, of the runs that figures of the thesis show.

use super::curves::CurvePlan;
use crate::columns::Columns;
use std::ops::Range;

/// Pressures whose curves are kept, in units of the normal strength: those of thesis figure 14 and one of each decade.
pub const PRESSURES: [f64; 5] = [0.075, 0.1, 0.15, 0.3, 0.6];

/// The coefficient of friction and the heat in J.
pub const FRICTION: CurvePlan = CurvePlan {
    names: ["friction", "heat"],
    is_shown: |run| PRESSURES.contains(&run.pressure()),
    numbers,
};

/// Mean horizontal over mean vertical driving force, and the heat at the end.
fn numbers(series: &Columns, rows: Range<usize>) -> Option<[f64; 2]> {
    let sum = |name| Some(series.get(name)?[rows.clone()].iter().sum::<f64>());
    let heat = series.get("friction")?[rows.end - 1];
    Some([-sum("drive_force_x")? / sum("drive_force_y")?, heat])
}
