//! A node at a wall and in a corner, with the contact radius and K V as units.

use super::constants::object;
use super::{Found, Sheet};
use crate::error::Fault;
use crate::fields::Fields;
use gouge_peridem::wall_law::{WallLaw, WallReading};
use serde_json::json;

/// Lists of cases.
pub(super) const LISTS: [&str; 2] = ["single", "corner"];

pub(super) fn solve(sheet: &mut Sheet) -> Result<(), Fault> {
    sheet.solve("single", &["d"], single)?;
    sheet.solve("corner", &["a", "b"], corner)
}

fn law(reading: WallReading) -> WallLaw {
    WallLaw {
        radius: 1.0,
        stiffness: 1.0,
        damping_ratio: 0.0,
        friction: 0.0,
        reading,
    }
}

fn single(case: &Fields) -> Result<Found, Fault> {
    let distance = case.number("d")?;
    let push = |reading| law(reading).push(distance, 1.0);
    let paper = law(WallReading::Paper);
    Ok(object([
        ("S", paper.area_beyond(distance).into()),
        ("centroid", paper.centroid(distance).into()),
        ("paper", push(WallReading::Paper).into()),
        ("exact", push(WallReading::Exact).into()),
        ("authors", push(WallReading::Authors).into()),
    ]))
}

fn corner(case: &Fields) -> Result<Found, Fault> {
    let distances = [case.number("a")?, case.number("b")?];
    let push = |reading| json!(law(reading).corner_push(distances, 1.0));
    let overlap = law(WallReading::Paper).overlap(distances);
    Ok(object([
        ("overlap_area", overlap.area.into()),
        ("I_x", overlap.moments[0].into()),
        ("I_y", overlap.moments[1].into()),
        ("paper_force", push(WallReading::Paper)),
        ("exact_force", push(WallReading::Exact)),
        ("overlap_counts", (overlap.area > 0.0).into()),
    ]))
}
