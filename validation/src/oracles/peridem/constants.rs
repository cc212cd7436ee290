//! Constants of bonds by quadrature of their definitions.

use super::WeightFunction;
use crate::oracles::quadrature::integral;
use std::f64::consts::TAU;

/// Stiffness for which a point stretched by s in all directions has the energy `modulus` s^2.
///
/// Half of the energy of each bond, c w s^2 r/2, belongs to the point: an integral over the disc of the horizon.
pub fn stiffness(modulus: f64, horizon: f64, weight: WeightFunction) -> f64 {
    let energy = |r: f64| 0.25 * weight(r / horizon) * r * TAU * r;
    modulus / integral(0.0, horizon, energy)
}

/// Critical stretch for which it costs the energy `release` per length to cut all bonds across a line.
///
/// A point at a distance z from the line has bonds across it at angles of at most acos(z/r) from its normal.
pub fn critical_stretch(release: f64, stiffness: f64, horizon: f64, weight: WeightFunction) -> f64 {
    let across = |z: f64| {
        integral(z, horizon, |r| {
            let energy = 0.5 * stiffness * weight(r / horizon) * r;
            2.0 * (z / r).acos() * energy * r
        })
    };
    (release / integral(0.0, horizon, across)).sqrt()
}
