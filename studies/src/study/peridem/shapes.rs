//! Figures 3 and 11: shapes, their areas, and bonds that would leave them.

use super::drawing::{BLUE, Drawing, GREY, INK, ORANGE, PALE, Pen};
use crate::study::illustration::Illustration;
use gouge_common::geometry::Vec2;
use gouge_peridem::interior::{Interceptors, Interior, SectionFive};
use gouge_peridem::mesh::Mesh;
use gouge_peridem::shape::Outline;
use std::f64::consts::{PI, TAU};

/// Roundness and sides of perturbed discs.
const ROUNDNESS: f64 = 0.6;
const SIDES: usize = 20;
/// Ratios of the inner to the outer radius of the plus and of the ring.
const PLUS: f64 = 0.2;
pub(super) const RING: f64 = 0.6;
/// Distance of nodes and horizon in figure 3, in radii of the shapes.
const SPACING: f64 = 0.14;
const HORIZON: f64 = 0.4;
/// How far the boundary is moved outwards, in radii.
const MOVED: f64 = 0.02;
/// Distance of shapes in a drawing, in radii.
const APART: f64 = 2.35;
/// Pixels per radius.
const SCALE: f64 = 110.0;

/// The shapes of figure 11, in discs of radius one.
pub(super) fn outlines() -> Vec<(&'static str, Outline)> {
    let numbers: Vec<f64> = (0..SIDES).map(|k| (k * 37 % 20) as f64 / 20.0).collect();
    let all = [
        (
            "perturbed disc",
            Outline::perturbed_disc(1.0, ROUNDNESS, &numbers),
        ),
        ("square", Outline::square(1.0)),
        ("plus", Outline::plus(1.0, PLUS)),
        ("ring", Outline::annulus(1.0, RING, 80)),
    ];
    all.into_iter()
        .filter_map(|(name, outline)| Some((name, outline.ok()?)))
        .collect()
}

/// Mean area of perturbed discs in units of R^2: that of independent radii at N equal angles.
pub(super) fn mean_area() -> f64 {
    let sides = SIDES as f64;
    0.5 * sides * (TAU / sides).sin() * (0.5 * (1.0 + ROUNDNESS)).powi(2)
}

/// Area of the plus in units of R^2, printed in table 3 and that of the polygon.
pub(super) fn plus_areas() -> [f64; 2] {
    let root = (2.0 / (PLUS * PLUS) - 1.0).sqrt();
    [1.0 + 4.0 * root, 4.0 * root - 2.0].map(|sum| PLUS * PLUS * sum)
}

/// Printed area of the mean perturbed disc in units of R^2.
pub(super) fn printed_mean_area() -> f64 {
    0.25 * PI * (1.0 + ROUNDNESS).powi(2)
}

fn canvas(shapes: usize) -> Drawing {
    let right = APART * shapes as f64 - APART / 2.0;
    Drawing::new(Vec2::new(-1.1, -1.78), Vec2::new(right, 1.1), SCALE)
}

/// Figure 11.
pub(super) fn drawing() -> Illustration {
    let outlines = outlines();
    let mut drawing = canvas(outlines.len());
    for (k, (name, outline)) in outlines.iter().enumerate() {
        let shift = Vec2::new(APART * k as f64, 0.0);
        let rings: Vec<Vec<Vec2>> = moved(outline, shift);
        drawing.area(rings.iter().map(Vec::as_slice), PALE, Pen::solid(BLUE, 2.0));
        let circle = super::drawing::arc(shift, 1.0, [0.0, TAU]);
        drawing.area([&circle[..]], "none", Pen::dashed(GREY, 1.2));
        let below = shift + Vec2::new(-0.95, -1.25);
        drawing.text(below, name);
        let area = format!("area {:.3} R²", outline.area());
        drawing.text(below + Vec2::new(0.0, -0.23), &area);
    }
    Illustration::Drawing(
        drawing.svg(),
        format!(
            "Figure 11: the shapes in their security discs of radius R, with the areas of the polygons. Perturbed discs of \
             {SIDES} sides have {:.3} R² on average (printed: {:.3} R²), the plus {:.3} R² (table 3: {:.3} R²). The ring is \
             drawn with 80 sides; a round one has {:.3} R².",
            mean_area(),
            printed_mean_area(),
            plus_areas()[1],
            plus_areas()[0],
            PI * (1.0 - RING * RING),
        ),
    )
}

fn moved(outline: &Outline, shift: Vec2) -> Vec<Vec<Vec2>> {
    let ring = |ring: &[Vec2]| ring.iter().map(|&point| point + shift).collect();
    outline.rings().map(ring).collect()
}

/// Pairs of nodes of a shape within the horizon, as two methods judge them.
pub(super) struct Filtered {
    kept: Vec<[Vec2; 2]>,
    pub(super) removed: Vec<[Vec2; 2]>,
    /// How many pairs the repaired method of section 5 judges otherwise.
    pub(super) differences: usize,
    interceptors: Vec<[Vec2; 2]>,
}

/// The pairs of a shape; none if it cannot be meshed.
pub(super) fn filtered(outline: &Outline) -> Option<Filtered> {
    let nodes = Mesh::triangulated(outline, SPACING).ok()?.position;
    let exact = Interior::new(outline);
    let printed = SectionFive::new(outline, MOVED, Interceptors::BisectorsAndBoundary).ok()?;
    let earlier = |k: usize| nodes[..k].iter().copied();
    let pairs = nodes
        .iter()
        .enumerate()
        .flat_map(|(k, &to)| earlier(k).map(move |from| [from, to]));
    let near = pairs.filter(|[from, to]| (*to - *from).norm() <= HORIZON);
    let (kept, removed): (Vec<_>, Vec<_>) =
        near.partition(|&[from, to]| exact.admits_from_inside(from, to));
    let judged = |pairs: &[[Vec2; 2]], admitted: bool| {
        let other = |pair: &&[Vec2; 2]| printed.admits(pair[0], pair[1]) != admitted;
        pairs.iter().filter(other).count()
    };
    Some(Filtered {
        differences: judged(&kept, true) + judged(&removed, false),
        interceptors: printed.interceptors().to_vec(),
        kept,
        removed,
    })
}

/// Figure 3: bonds kept and removed.
pub(super) fn filters() -> Illustration {
    let outlines = outlines();
    let mut drawing = canvas(outlines.len());
    for (k, (name, outline)) in outlines.iter().enumerate() {
        let Some(filtered) = filtered(outline) else {
            continue;
        };
        let shift = Vec2::new(APART * k as f64, 0.0);
        let place = |[from, to]: [Vec2; 2]| [from + shift, to + shift];
        let shown = |pairs: &[[Vec2; 2]]| pairs.iter().map(|&pair| place(pair)).collect::<Vec<_>>();
        drawing.segments(shown(&filtered.kept), Pen::solid("#c3cbd2", 0.5));
        drawing.segments(shown(&filtered.removed), Pen::solid(ORANGE, 0.8));
        let is_inside = |ends: &&[Vec2; 2]| ends.iter().all(|end| end.norm() < 1.15);
        let near = filtered.interceptors.iter().filter(is_inside);
        drawing.segments(near.map(|&ends| place(ends)), Pen::dashed(BLUE, 1.5));
        let rings = moved(outline, shift);
        drawing.area(
            rings.iter().map(Vec::as_slice),
            "none",
            Pen::solid(INK, 1.5),
        );
        let below = shift + Vec2::new(-0.95, -1.25);
        let (kept, removed) = (filtered.kept.len(), filtered.removed.len());
        drawing.text(below, name);
        let numbers = format!("{kept} kept, {removed} removed");
        drawing.text(below + Vec2::new(0.0, -0.2), &numbers);
        let differences = format!("section 5 differs for {}", filtered.differences);
        drawing.text(below + Vec2::new(0.0, -0.38), &differences);
    }
    Illustration::Drawing(
        drawing.svg(),
        "Figure 3: pairs of nodes within the horizon that are bonded (grey) and that are not because the line between them \
         leaves the grain (orange), by the exact predicate. Dashed: what bonds may not cross by the method of section 5, with \
         its bisectors repaired; it does not treat the hole of the ring, so that all bonds across the hole remain there."
            .to_owned(),
    )
}
