//! The focal point, and the distances, areas and volumes of a contact.

use super::{Spheres, identity, worst};
use crate::checks::random::Random;
use crate::checks::{Check, Outcome, thesis};
use crate::oracles::lens;
use gouge_dem::geometry::{
    contact_half_length, cylinder_displaced_volume, displaced_volume, focal_distance,
    mean_distance, overlap_factor,
};
use std::f64::consts::PI;
use xprec::Df64;

const EPSILON: f64 = f64::EPSILON;

pub(super) fn checks() -> Vec<Check> {
    let mut checks = length_checks();
    checks.extend(volume_checks());
    checks
}

/// Checks of distances and lengths.
fn length_checks() -> Vec<Check> {
    vec![
        Check {
            reason: "Both factors come from the same rounded asymmetry with opposite signs. Each is rounded once, and so is their sum: one unit of the larger",
            ..identity(
                "identities.overlap-factor",
                "The overlap factors of the two sides add up to one.",
                thesis("(4)"),
                overlap_factors,
            )
        },
        Check {
            reason: "Four roundings of the distance to the focal point, each amplified by the derivative 2 D of the difference of powers",
            ..identity(
                "identities.equal-power",
                "The focal point has the same power with respect to both circles.",
                thesis("(3), (4), (112)"),
                powers,
            )
        },
        Check {
            reason: "Two factors, a product and a square root, each rounded once",
            ..identity(
                "identities.half-length",
                "The focal distance and the half-length of the contact are the legs of a right triangle whose hypotenuse is the radius.",
                thesis("(112), (113)"),
                half_lengths,
            )
        },
        Check {
            reason: "Rounding of the elementary function and of six operations on terms of one sign: four units. Near touch, the cancellation in r / |y| - 1 adds at most a third of a unit of r",
            oracle: "The integral in its logarithmic form, (r z + y^2 log((r + z) / |y|)) / (2 z), in double-double",
            ..identity(
                "identities.mean-distance",
                "The mean distance to the contact is the average of sqrt(s^2 + y^2) over the length of the contact.",
                thesis("(114)"),
                mean_distances,
            )
        },
    ]
}

/// Checks of displaced volumes.
fn volume_checks() -> Vec<Check> {
    vec![
        Check {
            reason: "A dozen roundings of the two caps, and one rounding of the focal distances. The latter moves the wall between the caps, whose area is pi z^2, or the area that one rounding of the distance encloses if that is less",
            oracle: "Volume of the lens of two spheres from radii and distance alone, pi (R + r - D)^2 (D^2 + 2 D (R + r) - 3 (R - r)^2) / (12 D), in double-double",
            norm: "Largest error, in units of rounding of the volumes of both caps and of the area of the contact times the larger focal distance",
            ..identity(
                "identities.sphere-volume",
                "The displaced volume of two spheres is the volume of their lens.",
                thesis("(117)"),
                volumes,
            )
        },
        Check {
            reason: "A dozen roundings of the two segments. The inverse cosine amplifies the rounding of y / r by r / z; the rounding of the focal distance moves the chord of length 2 z",
            oracle: "Area of the lens of two circles, with angles from two-argument arctangents, in double-double",
            norm: "Largest error, in units of rounding of the areas of both sectors, with that amplification",
            ..identity(
                "identities.cylinder-volume",
                "The displaced volume of two cylinders is the area of the lens of their circles times their length.",
                thesis("(118)-(120)"),
                areas,
            )
        },
    ]
}

fn overlap_factors() -> Outcome {
    worst(1, 1.0, |random| {
        let one = Spheres::random(random);
        let [i, j] = one.radii;
        let b = [
            overlap_factor([i, j], one.distance),
            overlap_factor([j, i], one.distance),
        ];
        let largest = b[0].abs().max(b[1].abs()).max(1.0);
        (b[0] + b[1] - 1.0) / (EPSILON * largest)
    })
}

fn powers() -> Outcome {
    worst(2, 4.0, |random| {
        let one = Spheres::random(random);
        let [i, j] = one.radii.map(Df64::from);
        let y = Df64::from(focal_distance(one.radii, one.distance));
        let rest = Df64::from(one.distance) - y;
        let difference = f64::from((y * y - i * i) - (rest * rest - j * j));
        let y = f64::from(y).abs().max(one.distance);
        difference / (EPSILON * 2.0 * one.distance * y)
    })
}

fn half_lengths() -> Outcome {
    worst(3, 4.0, |random| {
        let one = Spheres::crossing(random);
        let y = focal_distance(one.radii, one.distance);
        if y.abs() >= one.radii[0] {
            return 0.0;
        }
        let z = Df64::from(contact_half_length(one.radii[0], y));
        let (r, y) = (Df64::from(one.radii[0]), Df64::from(y));
        let legs = z * z + y * y - r * r;
        f64::from(legs) / (EPSILON * f64::from(z * z))
    })
}

fn mean_distances() -> Outcome {
    worst(4, 4.0, |random| {
        let one = Spheres::crossing(random);
        let y = focal_distance(one.radii, one.distance);
        if y.abs() >= one.radii[0] {
            return 0.0;
        }
        if mean_distance(one.radii[0], 0.0) != 0.5 * one.radii[0] {
            return f64::NAN;
        }
        let found = mean_distance(one.radii[0], y);
        let exact = lens::mean_distance(one.radii[0], y);
        f64::from(Df64::from(found) - exact) / (EPSILON * f64::from(exact))
    })
}

/// Spheres that intersect, or of which one contains the other, often only just; the flag is true if one
/// contains the other.
fn meeting(random: &mut Random) -> (Spheres, bool) {
    let one = Spheres::crossing(random);
    let inside = (one.radii[0] - one.radii[1]).abs();
    let distance = inside * (1.0 + random.signed(1e-9, 9e-7));
    let [i, j] = one.radii;
    // A vanishing lens shows a wrongly chosen branch only if the smaller sphere is much smaller.
    if random.below(4) > 0 || i.min(j) > 0.3 * i.max(j) {
        return (one, false);
    }
    let contains = distance <= inside;
    (Spheres { distance, ..one }, contains)
}

fn volumes() -> Outcome {
    worst(5, 8.0, |random| {
        let (one, contains) = meeting(random);
        let found = displaced_volume(one.radii, one.distance);
        if contains {
            let r = one.radii[0].min(one.radii[1]);
            return (found / (4.0 / 3.0 * PI * r * r * r) - 1.0) / EPSILON;
        }
        let lens = lens::Lens::new(one.radii, one.distance);
        f64::from(Df64::from(found) - lens.volume()) / (EPSILON * lens.volume_scale())
    })
}

fn areas() -> Outcome {
    worst(6, 8.0, |random| {
        let (one, contains) = meeting(random);
        let found = cylinder_displaced_volume(1.0, one.radii, one.distance);
        if contains {
            let r = one.radii[0].min(one.radii[1]);
            return (found / (PI * r * r) - 1.0) / EPSILON;
        }
        let lens = lens::Lens::new(one.radii, one.distance);
        f64::from(Df64::from(found) - lens.area()) / (EPSILON * lens.area_scale())
    })
}
