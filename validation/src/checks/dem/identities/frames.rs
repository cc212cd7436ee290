//! Frames, angles and periodic images.

use super::{identity, vector, worst};
use crate::checks::random::Random;
use crate::checks::{Check, Measurement, Outcome, largest, thesis};
use gouge_common::geometry::{Metric, PeriodicX, Vec2};
use gouge_common::scalar::Real;
use gouge_dem::geometry::{PairFrame, PairMotion, angle_of, focal_point, reversed, turn, wrapped};
use std::f64::consts::{PI, TAU};
use xprec::Df64;

const EPSILON: f64 = f64::EPSILON;

pub(super) fn checks() -> Vec<Check> {
    let mut checks = frame_checks();
    checks.extend(angle_checks());
    checks.extend(motion_checks());
    checks
}

/// Checks of the geometry of a pair.
fn frame_checks() -> Vec<Check> {
    vec![
        Check {
            reason: "A square root, an inverse and a product, each rounded once, then squared: four units of one",
            ..identity(
                "identities.frames",
                "Pair frames have unit vectors and are right-handed. Seen from the other particle, they are exactly opposite.",
                thesis("(5), (110), (111)"),
                frames,
            )
        },
        Check {
            reason: "One rounding each of the factor, the product and the sum, relative to the positions and the vector between them",
            ..identity(
                "identities.focal-point",
                "Both sides of a contact compute the same focal point.",
                thesis("(3), (4)"),
                focal_points,
            )
        },
    ]
}

/// Checks of angles.
fn angle_checks() -> Vec<Check> {
    vec![
        Check {
            reason: "Rounding of an arctangent and of pi",
            ..identity(
                "identities.angles",
                "Reversing an angle gives the angle of the opposite vector, and a turn is the angle between two directions.",
                thesis("(106)-(109)"),
                angles,
            )
        },
        Check {
            scene: "Vectors along the negative x axis whose y component is zero of either sign, and turns from one direction to the opposite one",
            oracle: "pi",
            norm: "Number of angles other than pi",
            reason: "The result must be exact",
            ..identity(
                "identities.half-turn",
                "Half a turn is +pi for both signs of zero.",
                thesis("(107)"),
                half_turns,
            )
        },
        Check {
            scene: "100 000 odd multiples of pi up to 201 pi in absolute value, and angles within a relative 1e-7 of them",
            oracle: "The representative lies in [-pi, pi) and differs from the angle by whole turns",
            reason: "One rounding of the angle, and one of 2 pi times the number of turns",
            ..identity(
                "identities.wrapped",
                "The representative of an angle lies in [-pi, pi) and differs from it by whole turns, also near odd multiples of pi.",
                thesis("(106)"),
                representatives,
            )
        },
        Check {
            scene: "The polynomial at one, far beyond the small sines for which it is used",
            oracle: "The sum of the coefficients by their recurrence c_(k+1) = c_k (2 k + 1)^2 / ((2 k + 2) (2 k + 3))",
            norm: "Difference in units of rounding",
            reason: "Rounding of a sum of six terms of one sign",
            ..identity(
                "identities.arcsine",
                "The polynomial for the rotation of a frame is the arcsine series up to the eleventh power: its coefficients have the right sum.",
                thesis("(106)"),
                arcsine,
            )
        },
    ]
}

/// Checks of images and of motion.
fn motion_checks() -> Vec<Check> {
    vec![
        Check {
            oracle: "The nearest of five images, in double-double",
            reason: "One rounding, 2^-53, of each difference and two of the norm: half a unit of the width and three halves of the distance. A representative has eight roundings of up to eight widths",
            ..identity(
                "identities.minimum-image",
                "The displacement in a periodic box points to the nearest image; seen from the other particle it is exactly opposite.",
                thesis("(63), (64)"),
                images,
            )
        },
        Check {
            reason: "Two products and a sum, each rounded once, relative to the size of their terms",
            oracle: "The rates of the distance and of the direction from the scalar and vector products, in double-double",
            ..identity(
                "identities.pair-motion",
                "Normal velocity, shear velocity and rotation rate of the frame follow from the relative velocity.",
                thesis("(34), (110)"),
                motion,
            )
        },
    ]
}

fn frames() -> Outcome {
    worst(11, 4.0, |random| {
        let displacement = vector(random);
        let (there, back) = (PairFrame::new(displacement), PairFrame::new(-displacement));
        let (n, t) = (there.normal, there.tangent());
        if n != -back.normal || t != -back.tangent() || n.dot(t) != 0.0 {
            return f64::NAN;
        }
        let along = (n.dot(displacement) / there.distance - 1.0).abs();
        largest([(n.cross(t) - 1.0).abs(), along]) / EPSILON
    })
}

fn focal_points() -> Outcome {
    worst(12, 4.0, |random| {
        let spheres = super::Spheres::random(random);
        let direction = PairFrame::new(vector(random)).normal;
        let (from, way) = (vector(random), direction * spheres.distance);
        let to = from + way;
        let [i, j] = spheres.radii;
        let way = to - from;
        let distance = way.norm();
        let b = [[i, j], [j, i]].map(|radii| gouge_dem::geometry::overlap_factor(radii, distance));
        let difference = focal_point(from, way, b[0]) - focal_point(to, -way, b[1]);
        let size = from.norm().max(to.norm()) + (b[0].abs() + 1.0) * distance;
        difference.norm() / (EPSILON * size)
    })
}

fn angles() -> Outcome {
    worst(13, 4.0, |random| {
        let (a, b) = (
            PairFrame::new(vector(random)).normal,
            PairFrame::new(vector(random)).normal,
        );
        let opposite = (reversed(angle_of(a)) - angle_of(-a)).abs();
        let exact = |v: Vec2| Df64::from(v.y).atan2(Df64::from(v.x));
        let angle = f64::from(Df64::from(angle_of(a)) - exact(a)).abs();
        let turned = f64::from(Df64::from(turn(a, b).0) - (exact(b) - exact(a)));
        let turned = wrapped(turned).abs();
        let opposite = if opposite > PI {
            (opposite - TAU).abs()
        } else {
            opposite
        };
        largest([opposite, angle, turned]) / (EPSILON * PI)
    })
}

fn half_turns() -> Outcome {
    let mut wrong = 0;
    for zero in [0.0, -0.0] {
        for length in [1e-300, 1.0, 1e300] {
            wrong += usize::from(angle_of(Vec2::new(-length, zero)) != PI);
        }
        for (from, to) in [
            (Vec2::new(1.0, zero), Vec2::new(-1.0, -zero)),
            (Vec2::new(zero, 1.0), Vec2::new(-zero, -1.0)),
        ] {
            wrong += usize::from(turn(from, to).0 != PI) + usize::from(turn(to, from).0 != PI);
        }
    }
    Ok(Measurement::count(wrong).into())
}

fn images() -> Outcome {
    worst(14, 1.5, |random| {
        let length = random.magnitude(1e-3, 1e3);
        let metric = PeriodicX { length };
        let point =
            |random: &mut Random| Vec2::new(length * random.between(0.0, 1.0), vector(random).y);
        let (from, mut to) = (point(random), point(random));
        if random.below(4) == 0 {
            // Close to half a period apart, on either side.
            let half = 0.5 * (1.0 + random.signed(1e-10, 5e-7));
            to.x = from.x + if from.x < 0.5 * length { half } else { -half } * length;
        }
        let there = metric.displacement(from, to);
        if there != -metric.displacement(to, from) && there.x.abs() < 0.5 * length {
            return f64::NAN;
        }
        let exact = |value: f64| Df64::from(value);
        let image = |turns: f64| {
            let x = exact(to.x) - from.x + exact(turns) * length;
            let y = exact(to.y) - from.y;
            (x * x + y * y).sqrt()
        };
        let images = [-2.0, -1.0, 0.0, 1.0, 2.0].map(image);
        let nearest = images.into_iter().fold(images[0], Df64::min);
        let missed = f64::from(exact(there.norm()) - nearest).abs();
        let missed = missed / (EPSILON * (length / 3.0 + f64::from(nearest)));
        largest([missed, wrapping_error(random, metric, to)])
    })
}

/// Error of the representative of a point that was shifted by whole periods, in units of rounding;
/// undefined if it lies outside the box. Every other point is next to an edge of the box.
fn wrapping_error(random: &mut Random, metric: PeriodicX, point: Vec2) -> f64 {
    let length = metric.length;
    let x = match random.below(2) {
        0 => point.x.clamp(0.0, length),
        _ => random.magnitude(1e-300, 5e-7) * length,
    };
    let periods = random.between(-8.0, 9.0).floor();
    let sign = random.choice(&[-1.0, 1.0]);
    let wrapped = metric.wrap(Vec2::new(periods * length + sign * x, point.y));
    if !(0.0..=length).contains(&wrapped.x) || wrapped.y != point.y {
        return f64::NAN;
    }
    let expected = if sign > 0.0 { x } else { length - x };
    let apart = (wrapped.x - expected).abs();
    apart.min((apart - length).abs()) / (8.0 * EPSILON * length)
}

fn representatives() -> Outcome {
    worst(16, 2.0, |random| {
        let odd = 2.0 * random.between(-101.0, 101.0).floor() + 1.0;
        let angle = odd * PI * (1.0 + random.signed(1e-14, 1e-7));
        let found = wrapped(angle);
        if !(-PI..PI).contains(&found) {
            return f64::NAN;
        }
        let turns = (angle - found) / TAU;
        (turns - turns.round()) * TAU / (EPSILON * angle.abs())
    })
}

fn arcsine() -> Outcome {
    let (mut coefficient, mut sum) = (1.0, 0.0);
    for k in 0..6 {
        sum += coefficient;
        let two = f64::from(2 * k);
        coefficient *= (two + 1.0) * (two + 1.0) / ((two + 2.0) * (two + 3.0));
    }
    let found = 1.0_f64.asin_small();
    Ok(Measurement::scaled(sum, found, EPSILON * sum, 4.0).into())
}

fn motion() -> Outcome {
    worst(15, 4.0, |random| {
        let (way, velocity) = (vector(random), vector(random));
        let frame = PairFrame::new(way);
        let found = PairMotion::new(&frame, velocity);
        let exact = |value: f64| Df64::from(value);
        let distance = (exact(way.x) * exact(way.x) + exact(way.y) * exact(way.y)).sqrt();
        let dot = exact(way.x) * exact(velocity.x) + exact(way.y) * exact(velocity.y);
        let cross = exact(way.x) * exact(velocity.y) - exact(way.y) * exact(velocity.x);
        let errors = [
            f64::from(exact(found.normal_velocity) + dot / distance),
            f64::from(exact(found.shear_velocity) - cross / distance),
            f64::from(exact(found.frame_rate) - cross / (distance * distance))
                * f64::from(distance),
        ];
        largest(errors.map(f64::abs)) / (EPSILON * velocity.norm())
    })
}
