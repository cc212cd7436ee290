//! Figure 2: the parts of the disc of a node beyond walls, their areas and centroids.

use super::drawing::{BLUE, Drawing, GREY, INK, ORANGE, PALE, Pen, arc};
use crate::study::illustration::Illustration;
use gouge_common::geometry::Vec2;
use gouge_page::{Axis, Curve, Figure};
use gouge_peridem::wall_law::{WallLaw, WallReading};

/// Distances of the node from the walls that are drawn, in contact radii.
const DISTANCES: [f64; 2] = [0.4, 0.3];
/// Pixels per contact radius.
const SCALE: f64 = 150.0;
/// The node of the corner, in contact radii from that of the single wall.
const SECOND: [f64; 2] = [3.3, 0.0];

fn law(reading: WallReading) -> WallLaw {
    WallLaw {
        radius: 1.0,
        stiffness: 1.0,
        damping_ratio: 0.0,
        friction: 0.0,
        reading,
    }
}

/// The drawing of one wall and of a corner.
pub(super) fn drawing() -> Illustration {
    let mut drawing = Drawing::new(Vec2::new(-1.25, -1.6), Vec2::new(5.6, 1.45), SCALE);
    one_wall(&mut drawing);
    corner(&mut drawing);
    Illustration::Drawing(
        drawing.svg(),
        "Figure 2: the part of the disc of a node (radius R_c) beyond (a) one wall and (b) both walls of a corner, filled, \
         with its centroid and its area as the kernel computes them. Grey: the walls."
            .to_owned(),
    )
}

fn disc(drawing: &mut Drawing, at: Vec2) {
    let ring = arc(at, 1.0, [0.0, std::f64::consts::TAU]);
    drawing.area([&ring[..]], "none", Pen::dashed(INK, 1.5));
    drawing.dot(at, 5.0, INK);
    drawing.text(at + Vec2::new(-0.3, -0.14), "p(x, t)");
}

/// A centroid with its distance from the node.
fn centroid(drawing: &mut Drawing, node: Vec2, at: Vec2, label: &str) {
    drawing.segments([[node, at]], Pen::solid(BLUE, 2.0));
    drawing.dot(at, 6.0, BLUE);
    drawing.text(node + Vec2::new(-0.75, 1.15), label);
}

fn one_wall(drawing: &mut Drawing) {
    let law = law(WallReading::Paper);
    let d = DISTANCES[0];
    let wall = [[d, -1.2], [1.15, -1.2], [1.15, 1.2], [d, 1.2]].map(|[x, y]| Vec2::new(x, y));
    drawing.area([&wall[..]], PALE, Pen::solid(GREY, 0.0));
    let half = d.acos();
    let segment = arc(Vec2::zero(), 1.0, [-half, half]);
    drawing.area([&segment[..]], "#f3c9a8", Pen::solid(ORANGE, 2.0));
    disc(drawing, Vec2::zero());
    let centre = law.centroid(d);
    let label = format!(
        "S = {:.4} R_c², centroid at {centre:.4} R_c",
        law.area_beyond(d)
    );
    centroid(drawing, Vec2::zero(), Vec2::new(centre, 0.0), &label);
    drawing.text(Vec2::new(-0.75, -1.45), &format!("(a) d = {d} R_c"));
}

fn corner(drawing: &mut Drawing) {
    let node = Vec2::new(SECOND[0], SECOND[1]);
    let law = law(WallReading::Paper);
    let [a, b] = DISTANCES;
    let at = |x: f64, y: f64| node + Vec2::new(x, y);
    let wall = [
        [-1.2, b],
        [a, b],
        [a, -1.2],
        [1.15, -1.2],
        [1.15, 1.1],
        [-1.2, 1.1],
    ]
    .map(|[x, y]| at(x, y));
    drawing.area([&wall[..]], PALE, Pen::solid(GREY, 0.0));
    let mut both = vec![at(a, b)];
    both.extend(arc(node, 1.0, [b.asin(), a.acos()]));
    drawing.area([&both[..]], "#f3c9a8", Pen::solid(ORANGE, 2.0));
    disc(drawing, node);
    let overlap = law.overlap([a, b]);
    let [x, y] = overlap.moments.map(|moment| moment / overlap.area);
    let label = format!(
        "S = {:.4} R_c², centroid at ({x:.4}, {y:.4}) R_c",
        overlap.area
    );
    centroid(drawing, node, at(x, y), &label);
    drawing.text(at(-0.75, -1.45), &format!("(b) d = {a} R_c and {b} R_c"));
}

/// Forces of walls in their readings.
pub(super) fn forces() -> Figure {
    let curve = |(name, reading)| {
        let law = law(reading);
        let distances = (-100..=100).map(|k| f64::from(k) / 100.0);
        Curve::line(name, distances.map(|d| [d, law.push(d, 1.0)]))
    };
    let readings = [
        ("at the centroid, as printed", WallReading::Paper),
        ("integral of (4.1)", WallReading::Exact),
        ("program of the authors", WallReading::Authors),
    ];
    Figure::new(
        "Force of the wall of figure 2a on a node of area V. Only the printed law pushes back a node that is behind the wall \
         ever harder.",
        Axis::linear("distance to the wall in contact radii", ""),
        Axis::linear("force over K V R_c³", ""),
        readings.map(curve).into(),
    )
}
