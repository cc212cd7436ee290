//! The limit of zero time step, from runs of the kernel in double-double or of another program.

use super::case::{Case, Origin, Truth, wide};
use crate::checks::dem::scenes::advance;
use crate::checks::{Failure, largest};
use gouge_common::geometry::Vec2;
use gouge_dem::integrators::Integrator;
use gouge_scalars::DoubleDouble;
use std::ops::Range;
use xprec::Df64;

type Places = Vec<[Df64; 2]>;

/// Final positions of the particles with the time step of a rung.
fn ending(case: &Case, origin: &Origin, method: Integrator, rung: u32) -> Result<Places, Failure> {
    let (step, steps) = case.rung(rung);
    let mut world = origin.world::<DoubleDouble>(method, step)?;
    advance(&mut world, steps)?;
    let positions = &world.particles().position;
    Ok(positions.iter().map(|x| [wide(x.x), wide(x.y)]).collect())
}

/// Eliminates a power of the time step from neighbouring results: (2^p fine - coarse) / (2^p - 1).
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

/// The best extrapolation of results, each with half the time step of the previous one, which
/// eliminates as many powers of the step as possible starting with the first; and the extrapolation
/// that eliminates one power less.
fn extrapolated(mut results: Vec<Places>, first: i32) -> [Places; 2] {
    let mut before = Places::new();
    for power in (first..).take(results.len().saturating_sub(1)) {
        before = results.pop().unwrap_or_default();
        results.push(before.clone());
        results = eliminate(&results, power);
    }
    [results.pop().unwrap_or_default(), before]
}

/// The extrapolations of a method of order two.
fn of_method(
    case: &Case,
    origin: &Origin,
    method: Integrator,
    rungs: Range<u32>,
) -> Result<[Places; 2], Failure> {
    let results = rungs.map(|rung| ending(case, origin, method, rung));
    Ok(extrapolated(results.collect::<Result<_, _>>()?, 2))
}

/// The limit of velocity Verlet. Its error is estimated by the larger distance to two other results:
/// the limit with one power less eliminated, and the limit of Beeman's method.
pub fn limit(case: &Case, origin: &Origin, rungs: Range<u32>) -> Result<Truth, Failure> {
    let [best, before] = of_method(case, origin, Integrator::VelocityVerlet, rungs.clone())?;
    let [other, _] = of_method(case, origin, Integrator::Beeman, rungs)?;
    let off = apart(origin, &best, &before).max(apart(origin, &best, &other));
    Ok(origin.truth(best, off))
}

/// The limit of a program's final positions in m, from runs each with half the time step of the
/// previous one and errors of all powers of the step. The error is estimated by the limit with one
/// power less eliminated.
pub fn limit_of(origin: &Origin, endings: &[Vec<Vec2>]) -> Truth {
    let places = |ending: &Vec<Vec2>| ending.iter().map(|x| [wide(x.x), wide(x.y)]).collect();
    let [best, before] = extrapolated(endings.iter().map(places).collect(), 1);
    let off = apart(origin, &best, &before);
    origin.truth(best, off)
}

#[cfg(test)]
mod tests {
    use super::limit_of;
    use crate::checks::dem::work_precision::PAIR;
    use approx::abs_diff_eq;
    use gouge_common::geometry::Vec2;

    #[test]
    fn a_polynomial_of_the_step_has_its_constant_as_limit() {
        let origin = (PAIR.origin)();
        assert!(origin.is_ok());
        let Ok(origin) = origin else { return };
        let ending = |step: f64| {
            let x = 2.0 + step * (3.0 + step * (5.0 + 7.0 * step));
            vec![Vec2::new(x, 1.0), Vec2::new(-x, 1.0)]
        };
        let endings = [1.0, 0.5, 0.25, 0.125].map(ending);
        let truth = limit_of(&origin, &endings);
        assert!(truth.uncertainty > 0.0);
        for (place, x) in truth.positions.iter().zip([2.0, -2.0]) {
            assert!(abs_diff_eq!(place[0].hi(), x, epsilon = 1e-14) && place[1].hi() == 1.0);
        }
    }
}
