//! The limit of vanishing steps, from runs of the kernel in double-double.

use super::case::{Case, Origin, Truth, wide};
use crate::checks::scenes::advance;
use crate::checks::{Failure, largest};
use crate::scalars::DoubleDouble;
use gouge_kernel::integrators::Integrator;
use std::ops::Range;
use xprec::Df64;

type Places = Vec<[Df64; 2]>;

/// Where the particles end with a rung's step.
fn ending(case: &Case, origin: &Origin, method: Integrator, rung: u32) -> Result<Places, Failure> {
    let (step, steps) = case.rung(rung);
    let mut world = origin.world::<DoubleDouble>(method, step)?;
    advance(&mut world, steps)?;
    let positions = &world.particles().position;
    Ok(positions.iter().map(|x| [wide(x.x), wide(x.y)]).collect())
}

/// Eliminate a power of the step from neighbouring results: (2^p fine - coarse) / (2^p - 1).
fn eliminate(results: &[Places], power: i32) -> Vec<Places> {
    let weight = Df64::from(1.0) / (2.0_f64.powi(power) - 1.0);
    let better = |coarse: &Places, fine: &Places| -> Places {
        let one = |a: &[Df64; 2], b: &[Df64; 2]| [0, 1].map(|k| b[k] + (b[k] - a[k]) * weight);
        coarse.iter().zip(fine).map(|(a, b)| one(a, b)).collect()
    };
    let neighbors = results.windows(2);
    neighbors.map(|pair| better(&pair[0], &pair[1])).collect()
}

fn apart(origin: &Origin, a: &Places, b: &Places) -> f64 {
    largest(a.iter().zip(b).map(|(a, b)| origin.distance(*a, *b)))
}

/// The best extrapolation of a method, which eliminates as many powers of the step as it can, and the one
/// with a power less.
fn extrapolated(
    case: &Case,
    origin: &Origin,
    method: Integrator,
    rungs: Range<u32>,
) -> Result<[Places; 2], Failure> {
    let powers = 2..rungs.len() as i32 + 1;
    let mut results = rungs
        .map(|rung| ending(case, origin, method, rung))
        .collect::<Result<Vec<Places>, Failure>>()?;
    let mut before = Places::new();
    for power in powers {
        before = results.pop().unwrap_or_default();
        results.push(before.clone());
        results = eliminate(&results, power);
    }
    Ok([results.pop().unwrap_or_default(), before])
}

/// The limit of velocity Verlet. How far off it is tell the last power that was eliminated and the limit
/// of Beeman's method, whichever lies farther.
pub fn limit(case: &Case, origin: &Origin, rungs: Range<u32>) -> Result<Truth, Failure> {
    let [best, before] = extrapolated(case, origin, Integrator::VelocityVerlet, rungs.clone())?;
    let [other, _] = extrapolated(case, origin, Integrator::Beeman, rungs)?;
    let off = apart(origin, &best, &before).max(apart(origin, &best, &other));
    Ok(origin.truth(best, off))
}
