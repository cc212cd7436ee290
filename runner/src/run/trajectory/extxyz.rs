//! Extended XYZ: one line per particle; the second line names the columns.

use super::super::table::Values;
use super::Frame;
use std::fmt::Write;

/// Our column names that differ from those of OVITO, and OVITO's names.
const NAMES: [(&str, &str); 1] = [("velocity", "velo")];

fn name(own: &'static str) -> &'static str {
    let known = NAMES.iter().find(|(ours, _)| *ours == own);
    known.map_or(own, |(_, theirs)| theirs)
}

/// A frame as text; its first column of categories is the species.
pub fn text(frame: &Frame) -> String {
    let scalars = &frame.scalars.columns;
    let species = scalars
        .iter()
        .position(|(_, values)| matches!(values, Values::Kinds(_)));
    let mut text = head(frame, species);
    for (i, position) in frame.positions.iter().enumerate() {
        let _ = write!(text, "{i}");
        if let Some(place) = species {
            text.push(' ');
            scalars[place].1.print(i, &mut text);
        }
        let vectors = frame.vectors.iter().map(|(_, column)| &column[i]);
        for vector in std::iter::once(position).chain(vectors) {
            let _ = write!(text, " {:?} {:?} 0", vector.x, vector.y);
        }
        let _ = write!(text, " {:?}", frame.radii()[i]);
        for (place, (_, values)) in scalars.iter().enumerate() {
            if Some(place) != species {
                text.push(' ');
                values.print(i, &mut text);
            }
        }
        text.push('\n');
    }
    text
}

/// The first two lines: the number of particles; the box, the columns and the time.
fn head(frame: &Frame, species: Option<usize>) -> String {
    let mut text = format!("{}\n", frame.positions.len());
    if let (Some(width), Some(height)) = (frame.domain.width, frame.domain.height) {
        let depth = 2.0 * frame.radii().iter().copied().fold(0.0, f64::max);
        let _ = write!(
            text,
            "Lattice=\"{width:?} 0 0 0 {height:?} 0 0 0 {depth:?}\" "
        );
    }
    text += "Properties=id:I:1:";
    if species.is_some() {
        text += "species:S:1:";
    }
    text += "pos:R:3:";
    for (own, _) in &frame.vectors {
        let _ = write!(text, "{}:R:3:", name(own));
    }
    text += "radius:R:1";
    for (place, (own, values)) in frame.scalars.columns.iter().enumerate() {
        let kind = match values {
            Values::Numbers(_) => 'R',
            Values::Integers(_) => 'I',
            Values::Kinds(_) => 'S',
        };
        if Some(place) != species {
            let _ = write!(text, ":{}:{kind}:1", name(own));
        }
    }
    let periodic = if frame.domain.periodic { "T" } else { "F" };
    let _ = writeln!(text, " pbc=\"{periodic} F F\" Time={:?}", frame.time);
    text
}
