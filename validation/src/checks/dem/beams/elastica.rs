//! Large deflections of a clamped chain.

use super::cantilever::{Cantilever, Load};
use crate::checks::extrapolation::to_no_step;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::beams::Springs;
use crate::oracles::beams::cantilever::{Chain, ELASTICA};
use gouge_common::scalar::Real;
use gouge_scalars::DoubleDouble;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "beams.elastica",
        claim: "At large deflections, clamped chains deviate from linear theory like the elastica: by -4/35 (P L^2 / E I)^2.",
        equations: thesis("(5), (33)-(34), (43)-(45)"),
        scene: "Horizontal chains of 8, 16, 32 and 64 beams of touching spheres of 1 mm, the first particle fixed, the weight on the last; equilibrium in double-double under a load and under twice that load",
        oracle: "Expansion of the elastica to third order",
        norm: "Relative error of the coefficient, extrapolated to a slender beam",
        origin: Origin::Convergent,
        reason: "The coefficient of a chain deviates in even powers of 1 / M. Extrapolation removes those up to the sixth; the next is 4e-15 times its factor, and the fourth order in the load adds 1e-8",
        effort: Effort::Quick,
        measure: departure,
    }]
}

fn chain(beams: usize, load: f64) -> Cantilever {
    let springs = Springs {
        normal: 1e7,
        tangential: 1e7,
    };
    let chain = Chain {
        beams,
        distance: 2e-3,
        radius: 1e-3,
        springs,
    };
    let length = chain.distance * beams as f64;
    Cantilever {
        chain,
        direction: 0.0,
        load: Load::End,
        weight: load * chain.bending_stiffness() / (length * length),
    }
}

/// Deflection of the end under a load in units of E I / L^2.
fn deflection(beams: usize, load: f64) -> Result<DoubleDouble, Failure> {
    let displacement = chain(beams, load).equilibrium()?;
    Ok(-displacement[displacement.len() - 2])
}

/// Coefficient of the deviation from a deflection proportional to the load.
fn coefficient(beams: usize, load: f64) -> Result<f64, Failure> {
    let ratio = deflection(beams, 2.0 * load)? / (deflection(beams, load)? * 2.0);
    let excess = ratio - DoubleDouble::from_f64(1.0);
    Ok(excess.to_f64() / (3.0 * load * load))
}

fn departure() -> Outcome {
    let sizes = [8, 16, 32, 64];
    let coefficients: Result<Vec<f64>, Failure> = sizes
        .iter()
        .map(|&beams| coefficient(beams, 1e-4))
        .collect();
    let coefficients = coefficients?;
    let levels = coefficients.iter().map(|&c| vec![[c]]).collect();
    let thin = to_no_step(levels, &[2, 4, 6]);
    let thin = thin.first().map_or(f64::NAN, |&[c]| c);
    let deviation = |(&beams, c): (&usize, &f64)| [beams as f64, c / ELASTICA - 1.0];
    let deviations: Vec<[f64; 2]> = sizes.iter().zip(&coefficients).map(deviation).collect();
    let last = deviations[3];
    let slope = sizes.map(|m| [m as f64, last[1] * (last[0] / m as f64).powi(2)]);
    let plot = Figure::new(
        "The deviation of clamped chains from linear theory tends to that of the elastica with the square of their slenderness",
        Axis::logarithmic("number of beams M", ""),
        Axis::logarithmic("relative deviation of the coefficient from -4/35", ""),
        vec![
            Curve::line("slope of -2", slope),
            Curve::marks("kernel", deviations),
        ],
    );
    let one = Measurement::relative(ELASTICA, thin, 1e-7);
    Ok(one.showing([Exhibit::Figure(plot)]))
}
