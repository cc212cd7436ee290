//! Contact with straight walls: areas, forces and energies against quadrature, and what follows from them.

use crate::quadrature::{Random, derivative, integrate, integrate_pieces};
use gouge_common::geometry::Vec2;
use gouge_peridem::contact_law::{FrictionStep, Motion, Node, largest_step};
use gouge_peridem::wall_law::{NodeAtWall, WallLaw, WallReading};
use std::f64::consts::PI;

const READINGS: [WallReading; 4] = [
    WallReading::Paper,
    WallReading::Exact,
    WallReading::TwoFixes,
    WallReading::Authors,
];
const NODE: Node = Node {
    area: 3e-9,
    density: 1200.0,
};
const STEP: FrictionStep = FrictionStep {
    time_step: 7e-8,
    stick_share: 1.0,
};

/// All numbers in units of the contact radius and of K V.
fn unit(reading: WallReading) -> WallLaw {
    WallLaw {
        radius: 1.0,
        stiffness: 1.0,
        damping_ratio: 0.8,
        friction: 0.5,
        reading,
    }
}

fn push(reading: WallReading, distance: f64) -> f64 {
    unit(reading).push(distance, 1.0)
}

/// Integrals of 1, x, y and of the components of (1 - r) r/|r| over the part of the unit disc with x > a and y > b.
fn integrals(a: f64, b: f64) -> [f64; 5] {
    let half = |y: f64| ((1.0 - y) * (1.0 + y)).max(0.0).sqrt();
    let kink = half(b.clamp(-1.0, 1.0));
    [0, 1, 2, 3, 4].map(|k| {
        integrate_pieces(a.clamp(-1.0, 1.0), 1.0, &[-kink, 0.0, kink], |x| {
            let top = half(x);
            integrate_pieces(b.clamp(-top, top), top, &[0.0], |y| {
                let r = x.hypot(y);
                [1.0, x, y, (1.0 - r) * x / r, (1.0 - r) * y / r][k]
            })
        })
    })
}

/// The force at the centroid of a region.
fn at_centroid(region: &[f64; 5]) -> [f64; 2] {
    let [area, x, y, ..] = *region;
    let moment = x.hypot(y);
    if moment < 1e-13 {
        return [0.0; 2];
    }
    [x, y].map(|component| (1.0 - moment / area) * area * component / moment)
}

const DISTANCES: [f64; 13] = [
    -0.97, -0.8, -0.71, -0.6, -0.35, -0.1, 0.0, 0.13, 0.35, 0.6, 0.7, 0.85, 0.97,
];

#[test]
fn walls_act_as_the_segments_beyond_them() {
    for k in -49..50 {
        let d = 0.02 * f64::from(k) + 1e-3;
        let region = integrals(d, -1.0);
        let area = unit(WallReading::Paper).area_beyond(d);
        let paper = at_centroid(&region)[0];
        assert!((area - region[0]).abs() < 2e-13, "{d}");
        assert!((push(WallReading::Paper, d) - paper).abs() < 2e-13, "{d}");
        // The direction of the force jumps at the node: quadrature is less accurate if the node is in the segment.
        let tolerance = if d > 0.0 { 1e-13 } else { 1e-12 };
        let error = push(WallReading::Exact, d) - region[3];
        assert!(error.abs() < tolerance, "{d}: {error:e}");
        let mirrored = at_centroid(&integrals(d.abs(), -1.0))[0] * d.signum();
        let error = push(WallReading::TwoFixes, d) - mirrored;
        assert!(error.abs() < 2e-13, "{d}: {error:e}");
    }
}

#[test]
fn forces_keep_their_digits_where_contact_begins() {
    for exponent in 1..40 {
        let height = 0.7_f64.powi(exponent);
        let d = 1.0 - height;
        let height = 1.0 - d;
        let width = |u: f64| 2.0 * (u * (2.0 - u)).sqrt();
        let area = integrate(0.0, height, width);
        let paper = integrate(0.0, height, |u| u * width(u));
        let exact = integrate(0.0, height, |u| {
            let x = 1.0 - u;
            2.0 * integrate(0.0, 0.5 * width(u), |y| {
                let r = x.hypot(y);
                (u * (1.0 + x) - y * y) / (1.0 + r) * x / r
            })
        });
        let law = unit(WallReading::Paper);
        assert!((law.area_beyond(d) / area - 1.0).abs() < 1e-13, "{d}");
        assert!(
            (push(WallReading::Paper, d) / paper - 1.0).abs() < 1e-13,
            "{d}"
        );
        let error = push(WallReading::Exact, d) / exact - 1.0;
        assert!(error.abs() < 1e-12, "{d}: {error:e}");
    }
}

#[test]
fn corners_act_as_the_regions_beyond_them() {
    for (a, b) in DISTANCES.iter().flat_map(|&a| DISTANCES.map(|b| (a, b))) {
        let (first, second, both) = (integrals(a, -1.0), integrals(-1.0, b), integrals(a, b));
        let paper = unit(WallReading::Paper).corner_push([a, b], 1.0);
        let exact = unit(WallReading::Exact).corner_push([a, b], 1.0);
        let (f, s, t) = (
            at_centroid(&first),
            at_centroid(&second),
            at_centroid(&both),
        );
        for k in 0..2 {
            let expected = f[k] + s[k] - t[k];
            assert!(
                (paper[k] - expected).abs() < 1e-12,
                "{a} {b}: {paper:?} {expected}"
            );
            let expected = first[3 + k] + second[3 + k] - both[3 + k];
            assert!(
                (exact[k] - expected).abs() < 1e-12,
                "{a} {b}: {exact:?} {expected}"
            );
        }
    }
}

#[test]
fn a_corner_behind_a_wall_adds_nothing_to_it() {
    // The segment beyond the second wall lies beyond the first, although the corner is outside the disc.
    let [first, second] = unit(WallReading::Paper).corner_push([-0.9, 0.5], 1.0);
    assert_eq!(first, push(WallReading::Paper, -0.9));
    assert!(second.abs() < 1e-15);
    // Two walls that share no point of the disc act independently.
    for reading in READINGS {
        for [a, b] in [[0.8, 0.7], [0.97, 0.83]] {
            let forces = unit(reading).corner_push([a, b], 1.0);
            assert_eq!(forces, [push(reading, a), push(reading, b)]);
        }
    }
}

#[test]
fn authors_corners_subtract_nothing() {
    for reading in [WallReading::TwoFixes, WallReading::Authors] {
        let forces = unit(reading).corner_push([0.1, 0.2], 1.0);
        assert_eq!(forces, [push(reading, 0.1), push(reading, 0.2)]);
    }
}

#[test]
fn a_wall_pushes_with_minus_the_gradient_of_its_energy() {
    for reading in READINGS {
        let law = unit(reading);
        for k in -47..49 {
            let d = 0.02 * f64::from(k) + 0.011;
            let slope = derivative(d, 1e-3, |d| law.energy(d, 1.0));
            assert!((law.push(d, 1.0) + slope).abs() < 1e-9, "{reading:?} {d}");
            let slope = derivative(d, 1e-3, |d| law.push(d, 1.0));
            if !matches!(reading, WallReading::Exact) || d.abs() > 0.1 {
                assert!((law.slope(d, 1.0) + slope).abs() < 1e-7, "{reading:?} {d}");
            }
        }
        assert_eq!(law.energy(1.0, 1.0), 0.0);
    }
}

#[test]
fn exact_corners_have_an_energy_and_the_papers_have_none() {
    let law = unit(WallReading::Exact);
    let energy = |a, b| law.corner_energy([a, b], 1.0).unwrap();
    for (a, b) in DISTANCES.iter().flat_map(|&a| DISTANCES.map(|b| (a, b))) {
        let forces = law.corner_push([a, b], 1.0);
        let slopes = [
            derivative(a, 3e-4, |a| energy(a, b)),
            derivative(b, 3e-4, |b| energy(a, b)),
        ];
        for k in 0..2 {
            assert!(
                (forces[k] + slopes[k]).abs() < 3e-8,
                "{a} {b}: {forces:?} {slopes:?}"
            );
        }
    }
    let paper = unit(WallReading::Paper);
    let curl = derivative(0.2, 1e-3, |b| paper.corner_push([0.4, b], 1.0)[0])
        - derivative(0.4, 1e-3, |a| paper.corner_push([a, 0.2], 1.0)[1]);
    assert!(curl.abs() > 1e-3, "{curl}");
    assert_eq!(paper.corner_energy([0.4, 0.2], 1.0), None);
    let apart = paper.energy(0.8, 1.0) + paper.energy(0.7, 1.0);
    assert_eq!(paper.corner_energy([0.8, 0.7], 1.0), Some(apart));
}

#[test]
fn energies_keep_their_digits_where_contact_begins() {
    for d in [0.5000001, 0.9, 0.99, 0.999999] {
        for reading in [WallReading::Paper, WallReading::Authors] {
            let energy = integrate(d, 1.0, |x| push(reading, x));
            let ratio = unit(reading).energy(d, 1.0) / energy;
            assert!((ratio - 1.0).abs() < 1e-9, "{reading:?} {d}: {ratio}");
        }
    }
}

#[test]
fn only_the_papers_wall_is_a_barrier() {
    for k in 0..99 {
        let d = 0.01 * f64::from(k) + 5e-3;
        assert!((push(WallReading::Exact, d) - push(WallReading::Exact, -d)).abs() < 1e-14);
        assert!(push(WallReading::Paper, -d) > push(WallReading::Paper, -d + 5e-3));
        assert!(push(WallReading::TwoFixes, -d) < 0.0 && push(WallReading::Authors, -d) < 0.0);
    }
    assert!((push(WallReading::Exact, 0.0) - 1.0 / 3.0).abs() < 1e-15);
    assert_eq!(push(WallReading::Exact, -1.0), 0.0);
}

#[test]
fn the_steepest_slope_is_the_largest_one() {
    for reading in READINGS {
        let law = unit(reading);
        let slopes = (-999..1000).map(|k| law.slope(1e-3 * f64::from(k), 1.0));
        let largest = slopes.fold(0.0, f64::max);
        let bound = law.steepest(1.0);
        assert!(largest <= bound * (1.0 + 1e-14), "{reading:?} {largest}");
        assert!(largest >= bound * (1.0 - 1e-5), "{reading:?} {largest}");
    }
    assert_eq!(unit(WallReading::Paper).slope(0.0, 1.0), 2.0);
}

#[test]
fn a_million_states_have_finite_forces_that_begin_without_a_jump() {
    let mut random = Random(11);
    for k in 0..250_000 {
        let law = unit(READINGS[k % 4]);
        let mut distance = || match k % 5 {
            0 => random.between(-1e-300, 1e-300),
            1 => 1.0 - random.between(-1e-12, 1e-12),
            _ => random.between(-1.2, 1.2),
        };
        let distances = [distance(), distance()];
        let forces = law.corner_push(distances, 1.0);
        assert!(forces.iter().all(|f| f.is_finite()), "{distances:?}");
        for d in distances {
            assert!(law.energy(d, 1.0).is_finite() && law.slope(d, 1.0).is_finite());
            assert!(law.push(d, 1.0).is_finite() && law.area_beyond(d).is_finite());
            assert!(d < 1.0 - 1e-11 || law.push(d, 1.0).abs() < 1e-15);
        }
    }
}

fn metric(reading: WallReading) -> WallLaw {
    WallLaw {
        radius: 1e-4,
        stiffness: 2.8e23,
        ..unit(reading)
    }
}

fn at_floor(velocity: Vec2) -> NodeAtWall {
    NodeAtWall {
        node: NODE,
        distance: 3e-5,
        outward: Vec2::new(0.0, -1.0),
        velocity,
    }
}

#[test]
fn a_floor_pushes_up_damps_and_rubs() {
    let law = metric(WallReading::Paper);
    let push = law.push(3e-5, NODE.area);
    let stuck = law.force(&at_floor(Vec2::new(1e-3, 0.0)), push, &STEP);
    assert_eq!(stuck.motion, Motion::Stick);
    assert!(stuck.repulsion.y == push && push > 0.0);
    let gain = stuck.friction.x * STEP.time_step / NODE.mass();
    assert!((gain / -1e-3 - 1.0).abs() < 1e-14);
    let sliding = law.force(&at_floor(Vec2::new(-1e3, -2.0)), push, &STEP);
    assert_eq!(sliding.motion, Motion::Slip);
    assert!((sliding.friction.x / (0.5 * push) - 1.0).abs() < 1e-14);
    assert!(sliding.damping.y > 0.0 && sliding.damping.x == 0.0);
    let above = NodeAtWall {
        distance: 1e-4,
        ..at_floor(Vec2::new(1.0, 1.0))
    };
    assert_eq!(law.force(&above, 0.0, &STEP).motion, Motion::Separate);
}

#[test]
fn damping_of_a_wall_is_that_of_one_node_as_large_as_the_segment() {
    // A spring of stiffness K V S on the mass of the node, with the damping ratio of the law.
    let law = metric(WallReading::Paper);
    let spring = law.stiffness * NODE.area * law.area_beyond(3e-5);
    let critical = 2.0 * (spring * NODE.mass()).sqrt();
    assert!((law.damping(3e-5, &NODE) / critical - law.damping_ratio).abs() < 1e-14);
}

#[test]
fn a_node_on_a_wall_is_stable_below_the_largest_step_only() {
    let law = metric(WallReading::Paper);
    let frequency_squared = law.steepest(NODE.area) / NODE.mass();
    let limit = largest_step(frequency_squared, 0.0);
    // A load holds the node where the wall is steepest.
    let rest = law.push(-5e-5, NODE.area);
    for (ratio, is_stable) in [(0.99, true), (1.02, false)] {
        let step = ratio * limit;
        let acceleration = |d: f64| (law.push(d, NODE.area) - rest) / NODE.mass();
        let (mut d, mut v) = (-5e-5 + 1e-10, 0.0);
        let mut largest: f64 = 0.0;
        for _ in 0..300 {
            v += 0.5 * step * acceleration(d);
            d += step * v;
            v += 0.5 * step * acceleration(d);
            largest = largest.max((d + 5e-5).abs());
        }
        assert_eq!(largest < 2e-9, is_stable, "{ratio}: {largest}");
    }
}

#[test]
fn centroids_and_overlaps_are_those_of_the_regions() {
    let law = WallLaw {
        radius: 2.0,
        ..unit(WallReading::Paper)
    };
    for a in DISTANCES {
        let region = integrals(a, -1.0);
        let error = law.centroid(2.0 * a) - 2.0 * region[1] / region[0];
        assert!(error.abs() < 1e-12, "{a}: {error:e}");
    }
    assert_eq!([2.0, 3.0].map(|d| law.centroid(d)), [2.0, 2.0]);
    let some = || DISTANCES.into_iter().step_by(3);
    for (a, b) in some().flat_map(|a| some().map(move |b| (a, b))) {
        let [area, x, y, ..] = integrals(a, b);
        let found = law.overlap([2.0 * a, 2.0 * b]);
        let errors = [
            found.area - 4.0 * area,
            found.moments[0] - 8.0 * x,
            found.moments[1] - 8.0 * y,
        ];
        assert!(
            errors.iter().all(|e| e.abs() < 1e-11),
            "{a} {b}: {errors:?}"
        );
    }
}

#[test]
fn the_whole_disc_is_beyond_a_wall_that_is_far_behind_a_node() {
    let law = unit(WallReading::Paper);
    for d in [-1.0, -1.5, -40.0] {
        assert!((law.area_beyond(d) / PI - 1.0).abs() < 1e-15, "{d}");
        assert!((law.push(d, 1.0) / PI - 1.0).abs() < 1e-15, "{d}");
    }
}

#[test]
fn the_exact_energy_vanishes_where_contact_begins() {
    for height in [1e-12, 1e-9, 1e-6] {
        // It grows with the height as a power of 7/2.
        let energy = unit(WallReading::Exact).energy(1.0 - height, 1.0);
        assert!(energy.abs() < 1e-15 * height.sqrt(), "{height}: {energy:e}");
    }
}

#[test]
fn the_steepest_slope_is_found_by_search() {
    for reading in READINGS {
        let law = unit(reading);
        let (mut best, mut reach) = (0.0, 1.0);
        for _ in 0..16 {
            let near = (-16..=16).map(|k| best + reach * f64::from(k) / 16.0);
            let inside = near.filter(|d| d.abs() < 1.0);
            let by_slope = |a: &f64, b: &f64| law.slope(*a, 1.0).total_cmp(&law.slope(*b, 1.0));
            best = inside.max_by(by_slope).unwrap();
            reach *= 0.25;
        }
        let error = law.slope(best, 1.0) / law.steepest(1.0) - 1.0;
        assert!(error.abs() < 1e-13, "{reading:?} {best}: {error:e}");
    }
}

#[test]
fn friction_and_damping_of_a_wall_begin_at_the_contact_radius() {
    let law = metric(WallReading::Paper);
    let velocity = Vec2::new(1e-3, -2.0);
    let inside = NodeAtWall {
        distance: 1e-4 * (1.0 - 5e-7),
        ..at_floor(velocity)
    };
    assert_ne!(law.force(&inside, 0.0, &STEP).motion, Motion::Separate);
    let push = law.push(3e-5, NODE.area);
    let damping = law.force(&at_floor(velocity), push, &STEP).damping.y;
    assert!((damping / (2.0 * law.damping(3e-5, &NODE)) - 1.0).abs() < 1e-14);
    let limit = 0.5 * push * STEP.time_step / NODE.mass();
    for (factor, motion) in [(1.0 - 1e-7, Motion::Stick), (1.0 + 1e-7, Motion::Slip)] {
        let at = at_floor(Vec2::new(factor * limit, 0.0));
        assert_eq!(law.force(&at, push, &STEP).motion, motion, "{factor}");
        let pulled = law.force(&at, -push, &STEP);
        assert_eq!(pulled.motion, motion, "the limit is that of the magnitude");
    }
}

#[test]
fn invalid_coefficients_are_refused() {
    let good = unit(WallReading::Paper);
    assert!(good.validate().is_ok());
    for bad in [
        WallLaw {
            radius: 0.0,
            ..good
        },
        WallLaw {
            stiffness: f64::NAN,
            ..good
        },
        WallLaw {
            damping_ratio: -0.1,
            ..good
        },
        WallLaw {
            friction: -0.1,
            ..good
        },
    ] {
        assert!(bad.validate().is_err());
    }
}
