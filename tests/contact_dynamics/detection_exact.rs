//! Predicates of detection against exact arithmetic.

use crate::generators::{lattice_polygon, vectors};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::detection::{DetectionSettings, Placed, detect};
use gouge_contact_dynamics::shape::Shapes;
use num_rational::Ratio;
use proptest::prelude::*;

type Exact = Ratio<i128>;

/// For each side of a: the least cross product of the side with the vertices of b, exactly, and the length of the side.
fn side_values(a: &[(i64, i64)], b: &[(i64, i64)], d: (i64, i64)) -> Vec<(i128, f64)> {
    (0..a.len())
        .map(|k| {
            let (p, q) = (a[k], a[(k + 1) % a.len()]);
            let (ex, ey) = (q.0 - p.0, q.1 - p.1);
            let outside = |v: &(i64, i64)| ey * (v.0 + d.0 - p.0) - ex * (v.1 + d.1 - p.1);
            let least = b.iter().map(outside).min().unwrap();
            (i128::from(least), ((ex * ex + ey * ey) as f64).sqrt())
        })
        .collect()
}

/// A polygon that is symmetric about the origin, which is then its centroid, exactly.
fn symmetric(points: &[(i64, i64)]) -> Vec<(i64, i64)> {
    let mut all: Vec<Vec2> = vectors(points);
    all.extend(vectors(points).iter().map(|&v| -v));
    let lattice = all.iter().map(|v| (v.x as i64, v.y as i64)).collect();
    crate::generators::hull(lattice)
}

proptest! {
    #[test]
    fn overlap_is_decided_as_by_exact_arithmetic(
        one in lattice_polygon(),
        other in lattice_polygon(),
        d in (-30i64..=30, -30i64..=30),
    ) {
        let (one, other) = (symmetric(&one), symmetric(&other));
        let mut shapes = Shapes::new();
        let added = [&one, &other].map(|points| shapes.add_polygon(&vectors(points)));
        let [Ok(first), Ok(second)] = added else { return Ok(()); };
        let mut values = side_values(&one, &other, d);
        values.extend(side_values(&other, &one, (-d.0, -d.1)));
        let expected = values.iter().map(|&(value, length)| value as f64 / length).fold(f64::MIN, f64::max);
        let exact = |value: i128| Exact::from_integer(value);
        let is_apart = values.iter().any(|&(value, _)| exact(value) > exact(0));
        let settings = DetectionSettings { alert_distance: 1e9, ..DetectionSettings::for_diameter(1e-6) };
        let [first, second] = [first, second].map(|s| Placed::new(shapes.outline(s), 1.0, 0.0));
        let found = detect(&first, &second, Vec2::new(d.0 as f64, d.1 as f64), &settings, &mut Vec::new());
        prop_assert!((found.distance - expected).abs() < 1e-12);
        if expected.abs() > 1e-12 {
            prop_assert_eq!(found.distance > 0.0, is_apart);
        }
    }
}
