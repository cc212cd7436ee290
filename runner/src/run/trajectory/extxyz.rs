//! Extended XYZ: one line per particle; the second line names the columns.

use super::super::table::Values;
use super::Frame;
use std::fmt::Write;

/// Our column names that differ from those of OVITO, and OVITO's names.
const NAMES: [(&str, &str); 1] = [("velocity", "velo")];
/// Every reader expects a chemical element; this is the symbol for none.
const ELEMENT: &str = "X";

fn name(own: &'static str) -> &'static str {
    let known = NAMES.iter().find(|(ours, _)| *ours == own);
    known.map_or(own, |(_, theirs)| theirs)
}

/// A frame as text.
pub fn text(frame: &Frame) -> String {
    let mut text = head(frame);
    for (i, position) in frame.positions.iter().enumerate() {
        let _ = write!(text, "{i} {ELEMENT}");
        let vectors = frame.vectors.iter().map(|(_, column)| &column[i]);
        for vector in std::iter::once(position).chain(vectors) {
            let _ = write!(text, " {:?} {:?} 0", vector.x, vector.y);
        }
        let _ = write!(text, " {:?}", frame.radii()[i]);
        for (_, values) in &frame.scalars.columns {
            text.push(' ');
            values.print(i, &mut text);
        }
        text.push('\n');
    }
    text
}

/// The first two lines: the number of particles; the box, the columns and the time.
fn head(frame: &Frame) -> String {
    let mut text = format!("{}\n", frame.positions.len());
    text += &lattice(frame).unwrap_or_default();
    text += "Properties=id:I:1:species:S:1:pos:R:3:";
    for (own, _) in &frame.vectors {
        let _ = write!(text, "{}:R:3:", name(own));
    }
    text += "radius:R:1";
    for (own, values) in &frame.scalars.columns {
        let kind = match values {
            Values::Numbers(_) => 'R',
            Values::Integers(_) => 'I',
            Values::Kinds(_) => 'S',
        };
        let _ = write!(text, ":{}:{kind}:1", name(own));
    }
    let periodic = if frame.domain.periodic { "T" } else { "F" };
    let _ = write!(text, " pbc=\"{periodic} F F\" Time={:?}", frame.time);
    if !frame.note.is_empty() {
        let _ = write!(text, " {}", frame.note.replace(" = ", "="));
    }
    text.push('\n');
    text
}

/// The box. A periodic box without a height is as high as its grains.
fn lattice(frame: &Frame) -> Option<String> {
    let width = frame.domain.width?;
    let (bottom, height) = match frame.domain.height {
        Some(height) => (0.0, height),
        None if frame.domain.periodic => extent(frame),
        None => return None,
    };
    let depth = 2.0 * frame.radii().iter().copied().fold(0.0, f64::max);
    let origin = match bottom {
        0.0 => String::new(),
        bottom => format!("Origin=\"0 {bottom:?} 0\" "),
    };
    Some(format!(
        "Lattice=\"{width:?} 0 0 0 {height:?} 0 0 0 {depth:?}\" {origin}"
    ))
}

/// Lowest point of all grains, and the distance from there to the highest one.
fn extent(frame: &Frame) -> (f64, f64) {
    let grains = || frame.positions.iter().zip(frame.radii());
    let low = grains().map(|(x, r)| x.y - r).fold(f64::INFINITY, f64::min);
    let high = grains()
        .map(|(x, r)| x.y + r)
        .fold(f64::NEG_INFINITY, f64::max);
    (low, high - low)
}
