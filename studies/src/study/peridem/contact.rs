//! How stiff contacts between the planks and the notched square are, over meshes.

use gouge_common::geometry::Vec2;
use gouge_page::{Axis, Curve, Figure};
use gouge_peridem::mesh::Mesh;
use gouge_peridem::shape::Outline;

/// Contact radius in m, and stiffness K in N/m^6, of the scene and of the public script.
const RADIUS: f64 = 1e-3 / 3.0;
const STIFFNESS: f64 = 8.5944e21;
/// Length in m of the faces.
const FACE: f64 = 4e-3;

/// Sum of the repulsions (4.1) of the nodes of a plank and of the square in the public case: gap over contact radius, and
/// force in N per metre of depth. The mean over its two planks.
const PUBLIC: [[f64; 2]; 10] = [
    [0.1, 56726.0],
    [0.2, 42709.0],
    [0.3, 34560.0],
    [0.4, 30215.0],
    [0.5, 24758.0],
    [0.6, 18769.0],
    [0.7, 12780.0],
    [0.8, 6168.0],
    [0.9, 3084.0],
    [1.0, 0.0],
];

/// Depth of the nodes near the faces below them, their place along them, and their area.
type Layer = Vec<(Vec2, f64)>;

/// The nodes of the square below its upper face; none if it cannot be meshed.
fn of_square(size: f64) -> Option<Layer> {
    let corners = [
        [-2e-3, -2e-3],
        [2e-3, -2e-3],
        [2e-3, -2e-4],
        [0.0, -2e-4],
        [-2e-4, 0.0],
        [0.0, 2e-4],
        [2e-3, 2e-4],
        [2e-3, 2e-3],
        [-2e-3, 2e-3],
    ];
    layer(&corners, size, |point| Vec2::new(point.x, 2e-3 - point.y))
}

/// The nodes of the upper plank above its lower face.
fn of_plank(size: f64) -> Option<Layer> {
    let corners = [[-2e-3, -5e-4], [2e-3, -5e-4], [2e-3, 5e-4], [-2e-3, 5e-4]];
    layer(&corners, size, |point| Vec2::new(point.x, point.y + 5e-4))
}

fn layer(corners: &[[f64; 2]], size: f64, depth: impl Fn(Vec2) -> Vec2) -> Option<Layer> {
    let ring = corners.iter().map(|&[x, y]| Vec2::new(x, y)).collect();
    let outline = Outline::new(ring, Vec::new(), Vec::new()).ok()?;
    let mesh = Mesh::triangulated(&outline, size).ok()?;
    let nodes = mesh.position.iter().zip(&mesh.area);
    let placed = nodes.map(|(&point, &area)| (depth(point), area));
    Some(placed.filter(|(place, _)| place.y < RADIUS).collect())
}

/// Sum of (4.1) across the faces at a gap in m, in N per metre of depth.
fn force(square: &Layer, plank: &Layer, gap: f64) -> f64 {
    let pair = |(x, v): &(Vec2, f64), (y, w): &(Vec2, f64)| {
        let apart = Vec2::new(y.x - x.x, x.y + y.y + gap);
        let distance = apart.norm();
        match distance > 0.0 && distance < RADIUS {
            true => STIFFNESS * (RADIUS - distance) * v * w * apart.y / distance,
            false => 0.0,
        }
    };
    let of_node = |x: &(Vec2, f64)| plank.iter().map(|y| pair(x, y)).sum::<f64>();
    square.iter().map(of_node).sum()
}

/// The integral of (4.1) over two half planes at a gap in m, over the length of the faces.
///
/// Nodes w apart across the gap have w - g ways to share it, and those beside them add
/// 2 w (R asinh(s/w) - s) with s^2 = R^2 - w^2.
fn integral(gap: f64) -> f64 {
    const PIECES: u32 = 2000;
    let width = (RADIUS - gap) / f64::from(PIECES);
    let of = |k: u32| {
        let w = gap + width * (f64::from(k) + 0.5);
        let half = (RADIUS * RADIUS - w * w).sqrt();
        2.0 * w * (w - gap) * (RADIUS * (half / w).asinh() - half)
    };
    STIFFNESS * FACE * width * (0..PIECES).map(of).sum::<f64>()
}

/// Forces between the faces over the gap.
pub(super) fn figure() -> Option<Figure> {
    let gaps = || (4..=40).map(|k| f64::from(k) / 40.0);
    let of_mesh = |(label, size)| {
        let (square, plank) = (of_square(size)?, of_plank(size)?);
        let point = |gap: f64| [gap, 1e-3 * force(&square, &plank, gap * RADIUS)];
        Some(Curve::line(label, gaps().map(point)))
    };
    let meshes = [
        ("our mesh of 0.2 mm", 2e-4),
        ("our mesh of 0.1 mm", 1e-4),
        ("our mesh of 0.05 mm", 5e-5),
    ];
    let mut curves: Vec<Curve> = meshes.into_iter().filter_map(of_mesh).collect();
    let points = gaps().map(|gap| [gap, 1e-3 * integral(gap * RADIUS)]);
    curves.push(Curve::dashed("integral of (4.1)", points));
    let public = PUBLIC.map(|[gap, force]| [gap, 1e-3 * force]);
    curves.push(Curve::marked_line(
        "mesh of the public case, 0.2 mm",
        public,
    ));
    (curves.len() > 2).then(|| {
        Figure::new(
            "Force between a plank and the notched square over the gap between their faces, with the same stiffness K. Where \
             the planks are stopped, at gaps of half a contact radius, the mesh of the public case is 1.7 times as stiff as \
             ours of equal spacing.",
            Axis::linear("gap over contact radius", ""),
            Axis::linear("force", "kN/m"),
            curves,
        )
    })
}
