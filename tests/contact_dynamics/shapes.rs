//! Areas, moments and the search for sides and vertices.

use crate::generators::{lattice_polygon, sides, vectors};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::error::SetupError;
use gouge_contact_dynamics::shape::{Measures, Shapes};
use num_rational::Ratio;
use num_traits::ToPrimitive;
use proptest::prelude::*;

fn regular(n: usize) -> Measures {
    let mut shapes = Shapes::new();
    let shape = shapes.add_regular(n).unwrap();
    shapes.outline(shape).measures
}

fn polygon(vertices: &[Vec2]) -> Result<Measures, SetupError> {
    let mut shapes = Shapes::new();
    let shape = shapes.add_polygon(vertices)?;
    Ok(shapes.outline(shape).measures)
}

#[test]
fn regular_polygons_have_their_areas_and_moments() {
    let root3 = 3.0f64.sqrt();
    let exact = [
        (3, 0.75 * root3, 0.25),
        (4, 2.0, 1.0 / 3.0),
        (6, 1.5 * root3, 5.0 / 12.0),
        (12, 3.0, (2.0 + 0.5 * root3) / 6.0),
    ];
    for (n, area, moment) in exact {
        let m = regular(n);
        assert!((m.area / area - 1.0).abs() < 1e-15 * n as f64);
        assert!((m.second_moment / m.area / moment - 1.0).abs() < 1e-15 * n as f64);
    }
    for (n, area, moment) in [
        (5, 2.3776, 0.3848),
        (17, 3.0706, 0.4887),
        (60, 3.1359, 0.4991),
    ] {
        let m = regular(n);
        assert!((m.area - area).abs() < 6e-5);
        assert!((m.second_moment / m.area - moment).abs() < 6e-5);
    }
}

#[test]
fn a_polygon_of_many_sides_tends_to_the_disc() {
    let mut shapes = Shapes::new();
    let disc = shapes.add_disc();
    let disc = shapes.outline(disc).measures;
    for n in [50usize, 100, 200] {
        let m = regular(n);
        let missing = 2.0 * core::f64::consts::PI.powi(2) / (3.0 * (n * n) as f64);
        assert!(((1.0 - m.area / disc.area) / missing - 1.0).abs() < 0.01);
        assert!(
            ((1.0 - m.second_moment / disc.second_moment) / (2.0 * missing) - 1.0).abs() < 0.01
        );
        assert!(m.circumradius == 1.0 || (m.circumradius - 1.0).abs() < 1e-15);
    }
}

#[test]
fn vertex_0_lies_on_the_x_axis_of_the_body() {
    let mut shapes = Shapes::new();
    for n in [3, 4, 7, 60] {
        let shape = shapes.add_regular(n).unwrap();
        let outline = shapes.outline(shape);
        assert_eq!(outline.vertices[0], Vec2::new(1.0, 0.0));
        assert!(outline.vertices[1].y > 0.0);
    }
}

#[test]
fn wrong_polygons_are_refused() {
    let point = |x: f64, y: f64| Vec2::new(x, y);
    let square = [
        point(0.0, 0.0),
        point(1.0, 0.0),
        point(1.0, 1.0),
        point(0.0, 1.0),
    ];
    assert!(polygon(&square).is_ok());
    let clockwise: Vec<_> = square.iter().rev().copied().collect();
    assert!(matches!(
        polygon(&clockwise),
        Err(SetupError::NotConvex { .. })
    ));
    let dart = [square[0], point(0.4, 0.5), square[1], square[2]];
    assert!(matches!(polygon(&dart), Err(SetupError::NotConvex { .. })));
    let star: Vec<_> = (0..5)
        .map(|k| {
            let angle = 0.8 * core::f64::consts::PI * f64::from(k);
            point(angle.cos(), angle.sin())
        })
        .collect();
    assert!(matches!(polygon(&star), Err(SetupError::NotConvex { .. })));
    let repeated = [square[0], square[1], square[1], square[2]];
    assert!(polygon(&repeated).is_err());
    let straight = [square[0], point(0.5, 0.0), square[1], square[2]];
    assert!(polygon(&straight).is_err());
    let not_finite = [square[0], point(f64::NAN, 0.0), square[2]];
    assert!(polygon(&not_finite).is_err());
    assert_eq!(
        polygon(&square[..2]),
        Err(SetupError::TooFewVertices { vertices: 2 })
    );
    assert!(Shapes::new().add_regular(2).is_err());
}

type Exact = Ratio<i128>;

/// Area and second moment about the centroid, from triangles with their own centroids and the parallel-axis theorem.
fn exact_measures(points: &[(i64, i64)]) -> (Exact, Exact) {
    let whole = |x: i64| Exact::from_integer(i128::from(x));
    let mut parts = Vec::new();
    for k in 1..points.len() - 1 {
        let [a, b, c] = [points[0], points[k], points[k + 1]].map(|(x, y)| (whole(x), whole(y)));
        let cross = (b.0 - a.0) * (c.1 - a.1) - (b.1 - a.1) * (c.0 - a.0);
        let area = cross / whole(2);
        let square = |p: (Exact, Exact), q: (Exact, Exact)| {
            (p.0 - q.0) * (p.0 - q.0) + (p.1 - q.1) * (p.1 - q.1)
        };
        let own = area * (square(a, b) + square(b, c) + square(c, a)) / whole(36);
        let centre = ((a.0 + b.0 + c.0) / whole(3), (a.1 + b.1 + c.1) / whole(3));
        parts.push((area, own, centre));
    }
    let area: Exact = parts.iter().map(|p| p.0).sum();
    let x = parts.iter().map(|p| p.0 * p.2.0).sum::<Exact>() / area;
    let y = parts.iter().map(|p| p.0 * p.2.1).sum::<Exact>() / area;
    let about = |p: &(Exact, Exact, (Exact, Exact))| {
        let (dx, dy) = (p.2.0 - x, p.2.1 - y);
        p.1 + p.0 * (dx * dx + dy * dy)
    };
    (area, parts.iter().map(about).sum())
}

proptest! {
    #[test]
    fn measures_agree_with_exact_arithmetic(points in lattice_polygon(), shift in -100.0..100.0) {
        let (area, moment) = exact_measures(&points);
        let shifted: Vec<_> = vectors(&points).iter().map(|&v| v + Vec2::new(shift, -shift)).collect();
        let m = polygon(&shifted).unwrap();
        prop_assert!((m.area / area.to_f64().unwrap() - 1.0).abs() < 1e-11);
        prop_assert!((m.second_moment / moment.to_f64().unwrap() - 1.0).abs() < 1e-10);
    }

    #[test]
    fn the_support_is_the_farthest_vertex(points in lattice_polygon(), n in sides(), angle in -7.0f64..7.0) {
        let mut shapes = Shapes::new();
        let direction = Vec2::new(angle.cos(), angle.sin());
        for shape in [shapes.add_polygon(&vectors(&points)).unwrap(), shapes.add_regular(n).unwrap()] {
            let outline = shapes.outline(shape);
            let farthest = outline.vertices.iter().map(|v| v.dot(direction)).fold(f64::MIN, f64::max);
            prop_assert_eq!(outline.support(direction).1, farthest);
            let facing = outline.side_facing(direction);
            let next = outline.next(facing);
            prop_assert!(outline.sides[facing].normal.cross(direction) > -1e-12);
            prop_assert!(outline.sides[next].normal.cross(direction) < 1e-12);
        }
    }
}
