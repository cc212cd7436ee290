//! The area of shapes in slabs, against closed forms, rational arithmetic and the rule of complements.

use crate::generators::{Uniform, lattice_polygon, sides, vectors};
use crate::systems::{OPEN, System, law};
use core::f64::consts::{FRAC_PI_4, PI};
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::detection::Placed;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::observables::{Slab, area_in_slab, solid_area};
use gouge_contact_dynamics::shape::Shapes;
use gouge_contact_dynamics::units::Velocity;
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use proptest::prelude::*;

fn slab(bottom: f64, top: f64) -> Slab {
    Slab { bottom, top }
}

fn rational(x: f64) -> BigRational {
    BigRational::from_float(x).unwrap()
}

type Point = (BigRational, BigRational);

/// The part of a polygon for which `sign * (y - level)` is not negative, by Sutherland and Hodgman's rule.
fn cut(polygon: &[Point], level: &BigRational, sign: i32) -> Vec<Point> {
    let sign = rational(f64::from(sign));
    let inside = |p: &Point| (&p.1 - level) * &sign >= BigRational::zero();
    let mut kept = Vec::new();
    for (k, a) in polygon.iter().enumerate() {
        let b = &polygon[(k + 1) % polygon.len()];
        if inside(a) {
            kept.push(a.clone());
        }
        if inside(a) != inside(b) {
            let part = (level - &a.1) / (&b.1 - &a.1);
            kept.push((&a.0 + part * (&b.0 - &a.0), level.clone()));
        }
    }
    kept
}

fn area(polygon: &[Point]) -> f64 {
    let mut twice = BigRational::zero();
    for (k, a) in polygon.iter().enumerate() {
        let b = &polygon[(k + 1) % polygon.len()];
        twice += &a.0 * &b.1 - &a.1 * &b.0;
    }
    0.5 * twice.to_f64().unwrap()
}

proptest! {
    #[test]
    fn areas_are_those_of_exact_clipping(
        polygon in lattice_polygon(),
        angle in 0.0f64..7.0,
        low in -12.0f64..12.0,
        height in 0.0f64..12.0,
    ) {
        let mut shapes = Shapes::new();
        let id = shapes.add_polygon(&vectors(&polygon)).unwrap();
        let shape = Placed::new(shapes.outline(id), 0.75, angle);
        let found = area_in_slab(&shape, 0.5, slab(low, low + height));
        let vertex = |k| {
            let v = shape.to_space(shape.vertex(k));
            (rational(v.x), rational(v.y) + rational(0.5))
        };
        let all: Vec<_> = (0..polygon.len()).map(vertex).collect();
        let kept = cut(&cut(&all, &rational(low), 1), &rational(low + height), -1);
        // Coordinates up to 25 in products of two.
        prop_assert!((found - area(&kept)).abs() < 1e-11, "{} {}", found, area(&kept));
    }

    #[test]
    fn slabs_on_top_of_each_other_cover_the_shape(
        sides in sides(), angle in 0.0f64..7.0, first in -1.2f64..1.2, second in -1.2f64..1.2,
    ) {
        let mut shapes = Shapes::new();
        for id in [shapes.add_regular(sides).unwrap(), shapes.add_disc()] {
            let shape = Placed::new(shapes.outline(id), 1.0, angle);
            let (low, high) = (first.min(second), first.max(second));
            let parts = [slab(-9.0, low), slab(low, high), slab(high, 9.0)];
            let sum: f64 = parts.map(|part| area_in_slab(&shape, 0.0, part)).iter().sum();
            prop_assert!((sum - shape.outline.measures.area).abs() < 1e-13);
        }
    }
}

#[test]
fn discs_are_the_limit_of_polygons() {
    let mut shapes = Shapes::new();
    let disc = shapes.add_disc();
    let many = shapes.add_regular(20_000).unwrap();
    let mut random = Uniform::new(4);
    for _ in 0..50 {
        let part = slab(random.within(-1.1, 0.5), random.within(0.5, 1.1));
        let areas = [disc, many]
            .map(|id| area_in_slab(&Placed::new(shapes.outline(id), 1.0, 0.1), 0.0, part));
        // A polygon of n sides lacks 2/3 pi^3/n^2 of the area.
        assert!((areas[0] - areas[1]).abs() < 6e-8, "{areas:?}");
    }
}

#[test]
fn closed_forms_of_cut_shapes() {
    let mut shapes = Shapes::new();
    let (disc, square) = (shapes.add_disc(), shapes.add_regular(4).unwrap());
    let disc = Placed::new(shapes.outline(disc), 2.0, 0.3);
    let near = |x: f64, y: f64| assert!((x - y).abs() < 1e-13, "{x} {y}");
    near(area_in_slab(&disc, 1.0, slab(1.0, 9.0)), 2.0 * PI);
    // A segment at half the radius: R^2 (pi/3 - sqrt(3)/4).
    near(
        area_in_slab(&disc, 1.0, slab(2.0, 9.0)),
        4.0 * (PI / 3.0 - 0.75f64.sqrt() / 2.0),
    );
    near(area_in_slab(&disc, 1.0, slab(3.0, 9.0)), 0.0);
    // A square on a corner, cut at a quarter of its height; and one on a side.
    let corner = Placed::new(shapes.outline(square), 1.0, 0.0);
    near(area_in_slab(&corner, 0.0, slab(-1.0, -0.5)), 0.25);
    let flat = Placed::new(shapes.outline(square), 0.5f64.sqrt(), FRAC_PI_4);
    near(area_in_slab(&flat, 0.5, slab(0.25, 0.5)), 0.25);
}

#[test]
fn a_packing_covers_the_sum_of_its_parts() {
    let mut system = System::new(1e-3, law(0.0, 0.0, GapRule::Closed));
    for (k, sides) in [0, 3, 4, 5, 60].into_iter().enumerate() {
        let at = (3.0 * k as f64, 0.1 * k as f64);
        system.body(sides, 0.9, at, 0.3, Velocity::default());
    }
    let (assembly, configuration) = (&system.assembly, &system.state.configuration);
    assert_eq!(assembly.domain, OPEN);
    let area = |bottom, top| solid_area(assembly, configuration, slab(bottom, top));
    let measures = assembly
        .shape
        .iter()
        .map(|&id| assembly.shapes.outline(id).measures.area);
    let all = 0.81 * measures.sum::<f64>();
    assert!((area(-5.0, 5.0) - all).abs() < 1e-13);
    assert!((area(-5.0, 0.2) + area(0.2, 5.0) - all).abs() < 1e-13);
    // The slab moves with the bodies.
    let mut moved = configuration.clone();
    for position in &mut moved.position {
        *position += Vec2::new(17.0, 4.0);
    }
    let shifted = solid_area(assembly, &moved, slab(4.0, 4.2));
    assert!((shifted - area(0.0, 0.2)).abs() < 1e-12);
}
