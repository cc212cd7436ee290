//! Frames, angles and images.

use super::{identity, vector, worst};
use crate::checks::random::Random;
use crate::checks::{Check, Outcome, largest};
use gouge_kernel::geometry::{
    Metric, PairFrame, PairMotion, PeriodicX, Vec2, angle_of, focal_point, reversed, turn, wrapped,
};
use std::f64::consts::{PI, TAU};
use xprec::Df64;

const EPSILON: f64 = f64::EPSILON;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            reason: "A root, an inverse and a product, each rounded once, squared: four units of one",
            ..identity(
                "identities.frames",
                "Pair frames are of unit length, right-handed, and opposite from the other side, bit for bit.",
                "(5), (110), (111)",
                frames,
            )
        },
        Check {
            reason: "One rounding each of the factor, of the product and of the sum, of positions and of the way between them",
            ..identity(
                "identities.focal-point",
                "Both sides see one focal point.",
                "(3), (4)",
                focal_points,
            )
        },
        Check {
            reason: "Rounding of an arctangent and of pi",
            ..identity(
                "identities.angles",
                "The angle of the opposite vector is the reversed angle, and a turn is the angle between two directions.",
                "(106)-(109)",
                angles,
            )
        },
        Check {
            reason: "A comparison with all images of the point; one rounding of the width",
            ..identity(
                "identities.minimum-image",
                "The displacement in a periodic box is that of the nearest image, and opposite from the other side.",
                "(63), (64)",
                images,
            )
        },
        Check {
            reason: "Two products and a sum, each rounded once, of the sizes of their terms",
            oracle: "The rate of the distance and of the direction from the scalar and vector product, in double-double",
            ..identity(
                "identities.pair-motion",
                "Normal velocity, shear velocity and turning of the frame are those of the relative velocity.",
                "(34), (110)",
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
        let b =
            [[i, j], [j, i]].map(|radii| gouge_kernel::geometry::overlap_factor(radii, distance));
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

fn images() -> Outcome {
    worst(14, 1.0, |random| {
        let length = random.magnitude(1e-3, 1e3);
        let metric = PeriodicX { length };
        let point =
            |random: &mut Random| Vec2::new(length * random.between(0.0, 1.0), vector(random).y);
        let (from, to) = (point(random), point(random));
        let there = metric.displacement(from, to);
        if there != -metric.displacement(to, from) && there.x.abs() < 0.5 * length {
            return f64::NAN;
        }
        let image = |turns: f64| Vec2::new(to.x - from.x + turns * length, to.y - from.y).norm();
        let nearest = [-2.0, -1.0, 0.0, 1.0, 2.0]
            .map(image)
            .into_iter()
            .fold(f64::INFINITY, f64::min);
        let far = Vec2::new(to.x + 7.0 * length, to.y);
        let strayed = (metric.wrap(far).x - to.x).abs() / (8.0 * EPSILON * length);
        let missed = (there.norm() - nearest).abs() / (EPSILON * (length + nearest));
        largest([missed, strayed])
    })
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
