//! The shapes of the study.

use core::f64::consts::{FRAC_PI_4, PI, TAU};

/// Numbers of sides; 0 is the disc.
pub const SIDES: [u32; 14] = [0, 60, 40, 30, 17, 11, 10, 9, 8, 7, 6, 5, 4, 3];
/// The shapes whose sensitivity is tested.
pub const TESTED: [u32; 3] = [0, 6, 3];

/// Angularity: the exterior angle 2 pi/n in rad; 0 for a disc.
pub fn angularity(sides: u32) -> f64 {
    match sides {
        0 => 0.0,
        sides => TAU / f64::from(sides),
    }
}

/// A shape in words.
pub fn name(sides: u32) -> String {
    match sides {
        0 => "disc".to_owned(),
        3 => "triangle".to_owned(),
        4 => "square".to_owned(),
        5 => "pentagon".to_owned(),
        6 => "hexagon".to_owned(),
        sides => format!("{sides} sides"),
    }
}

/// Width in mean diameters of a box that a sheared packing fills about as high.
///
/// A body covers the part n sin(2 pi/n)/(2 pi) of its circle, and the mean of d^2 is the product of the smallest and
/// the largest diameter, 1.171 mean diameters squared.
pub fn width(sides: u32, bodies: u32) -> f64 {
    let covered = match sides {
        0 => 1.0,
        sides => f64::from(sides) * (TAU / f64::from(sides)).sin() / (2.0 * PI),
    };
    let fraction = if sides == 0 { 0.83 } else { 0.80 };
    let smallest = 0.75 / 4.0f64.ln();
    let area = FRAC_PI_4 * 4.0 * smallest * smallest * covered * f64::from(bodies);
    (10.0 * (area / fraction).sqrt()).round() / 10.0
}
