//! Geometry compared with identities and quadrature.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use gouge_common::geometry::{Metric, Open, PeriodicX, Vec2};
use gouge_common::scalar::Real;
use gouge_dem::geometry::{
    Arm, FocalArm, MeanArm, PairFrame, RadiusArm, angle_of, contact_area, contact_half_length,
    cylinder_contact_area, cylinder_displaced_volume, displaced_volume, focal_distance,
    focal_point, mean_distance, mean_distance_of_extremities, overlap_factor, reversed, turn,
    wrapped,
};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// Midpoint rule.
fn integral(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    let n = 200_000;
    let h = (high - low) / f64::from(n);
    (0..n)
        .map(|k| f(low + (f64::from(k) + 0.5) * h))
        .sum::<f64>()
        * h
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_focal_point_is_the_same_from_both_sides(
        r in 1e-4..1e-1_f64, s in 1e-4..1e-1_f64, x in -0.2..0.2_f64, y in -0.2..0.2_f64,
    ) {
        let d = Vec2::new(x, y);
        prop_assume!(d.norm() > 1e-3);
        let (b, c) = (overlap_factor([r, s], d.norm()), overlap_factor([s, r], d.norm()));
        let scale = b.abs().max(c.abs()).max(1.0);
        prop_assert!(abs_diff_eq!(b + c, 1.0, epsilon = 4.0 * f64::EPSILON * scale));
        let (here, there) = (Vec2::new(0.3, -0.2), Vec2::new(0.3, -0.2) + d);
        let seen = focal_point(here, d, b) - focal_point(there, -d, c);
        prop_assert!(seen.norm() <= 16.0 * f64::EPSILON * scale);
        // Equal power with respect to both circles: the radical axis.
        let o = focal_point(Vec2::zero(), d, b);
        let power = |centre: Vec2, r: f64| (o - centre).norm_squared() - r * r;
        let size = o.norm_squared() + (o - d).norm_squared() + r * r + s * s;
        let tolerance = 32.0 * f64::EPSILON * size;
        prop_assert!(abs_diff_eq!(power(Vec2::zero(), r), power(d, s), epsilon = tolerance));
    }

    #[test]
    fn crossing_circles_meet_at_the_ends_of_the_contact(
        r in 1e-3..1e-2_f64, s in 1e-3..1e-2_f64, overlap in 0.01..0.9,
    ) {
        let distance = (r + s) - overlap * 2.0 * r.min(s);
        let [y, w] = FocalArm.distances([r, s], distance);
        let tolerance = 4.0 * f64::EPSILON * (y.abs() + w.abs());
        prop_assert!(abs_diff_eq!(y + w, distance, epsilon = tolerance));
        let (z, other) = (contact_half_length(r, y), contact_half_length(s, w));
        let tolerance = 64.0 * f64::EPSILON * (r * r + s * s);
        prop_assert!(abs_diff_eq!(z * z, other * other, epsilon = tolerance));
    }

    #[test]
    fn turns_are_additive_and_antisymmetric(a in -PI..PI, b in -0.2..0.2_f64) {
        let unit = |angle: f64| Vec2::new(angle.cos(), angle.sin());
        let (turned, _) = turn(unit(a), unit(a + b));
        prop_assert!(abs_diff_eq!(turned, b, epsilon = 8.0 * f64::EPSILON));
        let (back, _) = turn(unit(a + b), unit(a));
        prop_assert!(abs_diff_eq!(turned, -back, epsilon = 1e-17 + 2.0 * f64::EPSILON * b.abs()));
        prop_assert!(abs_diff_eq!(angle_of(unit(a)), a, epsilon = 4.0 * f64::EPSILON * PI));
        let opposite = reversed(angle_of(unit(a)));
        prop_assert!((unit(opposite) + unit(a)).norm() <= 8.0 * f64::EPSILON);
        prop_assert!((-PI..PI).contains(&wrapped(a * 37.0)));
        prop_assert!(((wrapped(a * 37.0) - a * 37.0) / TAU).fract().abs() < 1e-12
            || ((wrapped(a * 37.0) - a * 37.0) / TAU).fract().abs() > 1.0 - 1e-12);
    }

    #[test]
    fn the_minimum_image_is_the_nearest(
        l in 0.5..3.0_f64, x in 0.0..1.0_f64, y in 0.0..1.0_f64, h in -1.0..1.0_f64,
    ) {
        let (a, b) = (Vec2::new(x * l, 0.0), Vec2::new(y * l, h));
        let metric = PeriodicX { length: l };
        let found = metric.displacement(a, b).norm();
        let images = [-1.0, 0.0, 1.0].map(|k| Open.displacement(a, b + Vec2::new(k * l, 0.0)).norm());
        let nearest = images.into_iter().fold(f64::INFINITY, f64::min);
        prop_assert!(abs_diff_eq!(found, nearest, epsilon = 8.0 * f64::EPSILON * l));
    }
}

#[test]
fn geometry_stays_finite_at_coincident_and_nearly_coincident_centres() {
    for d in [0.0, 1e-320, 1e-200, 1e-160, 1e-150, 1e-100] {
        let frame = PairFrame::new(Vec2::new(d, -d));
        assert!(frame.inverse_distance.is_finite() && frame.distance.is_finite());
        assert!(
            abs_diff_eq!(frame.normal.norm(), 1.0_f64, epsilon = 1e-12),
            "{d:e}"
        );
    }
    assert_eq!(overlap_factor([1.0, 2.0], 0.0), 0.5);
    for arms in [
        RadiusArm.distances([1.0, 2.0], 0.0),
        FocalArm.distances([1.0, 2.0], 0.0),
        MeanArm.distances([1.0, 2.0], 0.0),
    ] {
        assert!(arms.iter().all(|arm: &f64| arm.is_finite()), "{arms:?}");
    }
}

#[test]
fn the_mean_distance_is_the_average_over_the_contact() {
    for (r, y) in [
        (1.0, 0.95),
        (1.0, 0.3),
        (1.0, 1e-3),
        (1.0, -0.4),
        (2.5, -2.4_f64),
    ] {
        let z = (r * r - y * y).sqrt();
        let average = integral(-z, z, |s| (s * s + y * y).sqrt()) / (2.0 * z);
        assert!(
            abs_diff_eq!(mean_distance(r, y), average, epsilon = 1e-9),
            "{r} {y}"
        );
    }
    // Near touch the mean of the extreme values overestimates u - y by one half.
    let (r, y) = (1.0, 0.999);
    let ratio = (mean_distance_of_extremities(r, y) - y) / (mean_distance(r, y) - y);
    assert_abs_diff_eq!(ratio, 1.5, epsilon = 1e-3);
}

#[test]
fn areas_and_volumes_match_quadrature() {
    for (radii, distance) in [([1.0, 1.0], 1.7), ([1.0, 0.6], 1.2), ([2.0, 0.7], 1.6_f64)] {
        let [r, s] = radii;
        let y = focal_distance(radii, distance);
        // Slices at x have the smaller of both half-heights.
        let half = |x: f64| {
            let a = r * r - x * x;
            let b = s * s - (x - distance) * (x - distance);
            a.min(b).max(0.0).sqrt()
        };
        let sphere = integral(-r, distance + s, |x| PI * half(x) * half(x));
        assert_abs_diff_eq!(displaced_volume(radii, distance), sphere, epsilon = 1e-6);
        let cylinder = integral(-r, distance + s, |x| 3.0 * 2.0 * half(x));
        assert_abs_diff_eq!(
            cylinder_displaced_volume(3.0, radii, distance),
            cylinder,
            epsilon = 1e-5
        );
        let z = contact_half_length(r, y);
        assert_abs_diff_eq!(contact_area(z), PI * half(y) * half(y), epsilon = 1e-12);
        assert_abs_diff_eq!(
            cylinder_contact_area(3.0, z),
            6.0 * half(y),
            epsilon = 1e-12
        );
    }
    assert_eq!(displaced_volume([1.0, 2.0], 3.0), 0.0);
    assert_abs_diff_eq!(
        displaced_volume([1.0, 2.0], 0.5),
        4.0 / 3.0 * PI,
        epsilon = 1e-14
    );
    assert_abs_diff_eq!(
        cylinder_displaced_volume(2.0, [1.0, 2.0], 0.5),
        2.0 * PI,
        epsilon = 1e-14
    );
}

#[test]
fn small_inverse_sine_agrees_with_the_general_one() {
    for step in -1000..=1000 {
        let s = f64::from(step) * 5.5e-5;
        let (fast, reference) = (s.asin_small(), libm::asin(s));
        assert_abs_diff_eq!(
            fast,
            reference,
            epsilon = 2.0 * f64::EPSILON * reference.abs()
        );
    }
}

#[test]
fn half_a_turn_is_positive_whatever_the_signs_of_zeros() {
    for signs in 0..4 {
        let zero = |bit: i32| if signs & bit == 0 { 0.0 } else { -0.0 };
        let reference = Vec2::new(1.0, zero(1));
        let opposite = Vec2::new(-1.0, zero(2));
        assert_eq!(turn(reference, opposite), (PI, false), "{signs}");
    }
}

#[test]
fn points_inside_a_periodic_box_are_their_own_images() {
    for step in 1..200 {
        let length = 0.013 * f64::from(step);
        let metric = PeriodicX { length };
        for x in [0.0, f64::MIN_POSITIVE, 0.3 * length, length.next_down()] {
            assert_eq!(
                metric.wrap(Vec2::new(x, 1.0)),
                Vec2::new(x, 1.0),
                "{length}"
            );
        }
    }
}
