//! Contact of two faces, as a sum over their nodes and as an integral.

use crate::quadrature::integrate;
use gouge_common::geometry::Vec2;
use gouge_peridem::contact_law::{
    ContactLaw, ContactReading, ContactSpring, FrictionStep, Node, NodePair,
};
use std::f64::consts::PI;

const LAW: ContactLaw = ContactLaw {
    radius: 1e-4,
    damping_ratio: 0.8,
    friction: 0.8,
    reading: ContactReading::Symmetric,
};

const STEP: FrictionStep = FrictionStep {
    time_step: 7e-8,
    stick_share: 1.0,
};

fn spring() -> ContactSpring {
    LAW.between_grains(2.8e23)
}

/// Force per length in N/m^2 of two lattices whose faces are at a distance of `gap`, for nodes on the faces with a part of
/// the area of a cell.
fn push_of_faces(gap: f64, spacing: f64, on_face: f64) -> f64 {
    let rows = (LAW.radius / spacing) as usize + 2;
    let node = |row: usize| Node {
        area: spacing * spacing * if row == 0 { on_face } else { 1.0 },
        density: 1200.0,
    };
    let mut sum = 0.0;
    for (below, above) in (0..rows).flat_map(|i| (0..rows).map(move |j| (i, j))) {
        for column in 0..2 * rows {
            let along = (column as f64 - rows as f64) * spacing;
            let pair = NodePair {
                separation: Vec2::new(along, gap + (below + above) as f64 * spacing),
                velocity: Vec2::zero(),
                x: node(below),
                y: node(above),
            };
            sum -= LAW.force(&pair, &spring(), &STEP).repulsion.y;
        }
    }
    sum / spacing
}

/// Integral of (4.1) over two half-planes: pairs at a distance r and an angle up to acos(gap/r) from the normal.
fn push_of_half_planes(gap: f64) -> f64 {
    let radius = LAW.radius;
    let of_distance = |r: f64| {
        let angle = (gap / r).acos();
        (radius - r) * r * (r * angle - gap * angle.sin())
    };
    spring().stiffness * integrate(gap, radius, of_distance)
}

#[test]
fn faces_push_as_half_planes_on_fine_meshes_only() {
    let radius = LAW.radius;
    // Faces without a gap, in closed form.
    let touching = PI / 24.0 * spring().stiffness * radius.powi(4);
    assert!((push_of_half_planes(0.0) / touching - 1.0).abs() < 1e-12);
    let gap = 0.5 * radius;
    let excess = |cells: f64, on_face: f64| {
        push_of_faces(gap, radius / cells, on_face) / push_of_half_planes(gap) - 1.0
    };
    let [coarse, middle, fine] = [10.0, 20.0, 40.0].map(|cells| excess(cells, 0.5).abs());
    assert!(middle < coarse / 3.0 && fine < middle / 3.0 && fine < 0.005);
    // At 1.7 cells to the radius only nodes on the faces touch: their areas count with the square.
    let usual = excess(1.7, 0.5) + 1.0;
    let larger = excess(1.7, 0.5 * 1.7_f64.sqrt()) + 1.0;
    assert!(usual > 2.0, "{usual}");
    assert!((larger / usual - 1.7).abs() < 1e-12);
}
