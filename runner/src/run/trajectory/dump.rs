//! Links as a LAMMPS dump of local data: the bonds of a trajectory in OVITO.

use super::super::table::Values;
use super::LinkFrame;
use std::fmt::Write;

/// Names that OVITO knows, in place of ours.
const NAMES: [(&str, &str); 3] = [("i", "batom1"), ("j", "batom2"), ("kind", "btype")];

/// A frame as text. Bond types count from 1: weak, strong.
pub fn text(frame: &LinkFrame) -> String {
    let columns = &frame.links.columns;
    let number = columns.first().map_or(0, |(_, values)| values.len());
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
    for (own, _) in columns {
        let known = NAMES.iter().find(|(ours, _)| ours == own);
        let _ = write!(text, " {}", known.map_or(*own, |(_, theirs)| theirs));
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
