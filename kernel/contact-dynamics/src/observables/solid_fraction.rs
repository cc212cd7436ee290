//! The area that bodies cover in a horizontal slab.

use crate::assembly::{Assembly, Configuration};
use crate::detection::Placed;
use gouge_common::geometry::Vec2;
use gouge_equations::rendered;

/// The space between two horizontal lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slab {
    /// Lower line in m.
    pub bottom: f64,
    /// Upper line in m.
    pub top: f64,
}

impl Slab {
    /// Whether a height in m is inside.
    #[inline]
    pub fn contains(self, height: f64) -> bool {
        height >= self.bottom && height < self.top
    }
}

/// The area in m^2 of a shape, whose centre is at the given height in m, inside a slab. Exact for polygons and discs.
pub fn area_in_slab(shape: &Placed, height: f64, slab: Slab) -> f64 {
    let reach = shape.circumradius();
    if height + reach <= slab.bottom || height - reach >= slab.top {
        return 0.0;
    }
    let square = shape.scale * shape.scale;
    let below_top = match height + reach <= slab.top {
        true => square * shape.outline.measures.area,
        false => area_below(shape, slab.top - height),
    };
    match height - reach >= slab.bottom {
        true => below_top,
        false => below_top - area_below(shape, slab.bottom - height),
    }
}

/// The area in m^2 that all bodies cover in a slab.
///
/// Over the area of the slab it is the solid fraction $\nu$. Overlaps count twice. In a box that is periodic in x, a
/// body that leaves at one side enters at the other one, so that no part is lost.
#[rendered]
pub fn solid_area(assembly: &Assembly, configuration: &Configuration, slab: Slab) -> f64 {
    let bodies = assembly.shape.iter().zip(&assembly.scale);
    let poses = configuration.position.iter().zip(&configuration.angle);
    let area = |((&shape, &scale), (&position, &angle)): ((_, &f64), (&Vec2, &f64))| {
        let outline = assembly.shapes.outline(shape);
        let reach = scale * outline.measures.circumradius;
        let is_inside = position.y - reach >= slab.bottom && position.y + reach <= slab.top;
        if is_inside {
            return scale * scale * outline.measures.area;
        }
        area_in_slab(&Placed::new(outline, scale, angle), position.y, slab)
    };
    bodies.zip(poses).map(area).sum()
}

/// The area of a shape below a line at `level` above its centre.
fn area_below(shape: &Placed, level: f64) -> f64 {
    match shape.disc_radius() {
        Some(radius) => disc_below(radius, level),
        None => polygon_below(shape, level),
    }
}

/// A segment of a disc: $R^2 \arccos(-h/R) + h \sqrt{R^2 - h^2}$.
fn disc_below(radius: f64, level: f64) -> f64 {
    let level = level.max(-radius).min(radius);
    let half_chord = libm::sqrt((radius - level) * (radius + level));
    // The angle from the lowest point to the end of the chord, without the loss of digits of an arc cosine.
    let angle = libm::atan2(half_chord, -level);
    radius * radius * angle + level * half_chord
}

/// Half the sum of cross products of the ends of all sides, cut at the line. With the origin on the line, the part of
/// the line that closes the outline adds nothing.
fn polygon_below(shape: &Placed, level: f64) -> f64 {
    let count = shape.outline.vertices.len();
    let vertex = |k: usize| {
        let v = shape.to_space(shape.vertex(k));
        Vec2::new(v.x, v.y - level)
    };
    let mut twice_area = 0.0;
    let mut begin = vertex(count - 1);
    for k in 0..count {
        let end = vertex(k);
        let cut = || {
            let part = begin.y / (begin.y - end.y);
            Vec2::new(begin.x + part * (end.x - begin.x), 0.0)
        };
        twice_area += match (begin.y <= 0.0, end.y <= 0.0) {
            (true, true) => begin.cross(end),
            (true, false) => begin.cross(cut()),
            (false, true) => cut().cross(end),
            (false, false) => 0.0,
        };
        begin = end;
    }
    0.5 * twice_area
}
