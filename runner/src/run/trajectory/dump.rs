//! Links as a LAMMPS dump of local data: the bonds of a trajectory in OVITO.

use super::super::table::Values;
use super::LinkFrame;
use std::fmt::Write;

/// A frame as text. Bond types count from 1: weak, strong.
pub fn text(frame: &LinkFrame) -> String {
    let columns = &frame.links.columns;
    let number = columns.first().map_or(0, |(_, values)| values.rows());
    let [low, high] = frame.bounds;
    let mut text = format!(
        "ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ENTRIES\n{number}\nITEM: BOX BOUNDS {} ff ff\n",
        frame.steps,
        if frame.is_periodic { "pp" } else { "ff" }
    );
    let _ = writeln!(
        text,
        "{:?} {:?}\n{:?} {:?}\n0 0",
        low.x, high.x, low.y, high.y
    );
    text.push_str("ITEM: ENTRIES");
    for (name, _) in columns {
        let _ = write!(text, " {name}");
    }
    text.push('\n');
    for row in 0..number {
        for (place, (_, values)) in columns.iter().enumerate() {
            if place > 0 {
                text.push(' ');
            }
            match values {
                Values::Kinds(kinds) => {
                    let _ = write!(text, "{}", kinds.codes[row] + 1);
                }
                values => values.print(row, &mut text),
            }
        }
        text.push('\n');
    }
    text
}
