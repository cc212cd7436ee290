//! The criteria of the checks: orders, and accuracy of the reference. No timing.

use super::sweep::{Bench, Precision, Rung, Sweep};
use crate::checks::{Failure, Measurement};
use gouge_runner::scene::INTEGRATORS;

/// The error of the reference may be this fraction of the smallest error shown.
const A_TENTH: f64 = 0.1;

/// Whether each method reaches its order, and whether the reference is accurate enough.
pub fn verdict(bench: &Bench, sweeps: &[Sweep]) -> Measurement {
    let case = bench.case;
    let orders = sweeps.iter().zip(case.orders).map(|(sweep, order)| {
        Measurement::absolute(order, observed_order(bench, sweep), case.margin)
    });
    Measurement::worst(orders.chain([trust(bench, sweeps)]))
}

/// The uncertainty of the reference in units of the smallest error.
fn trust<'a>(bench: &Bench, sweeps: impl IntoIterator<Item = &'a Sweep>) -> Measurement {
    let rungs = sweeps.into_iter().flat_map(|sweep| &sweep.rungs);
    let smallest = rungs.map(|rung| rung.error).fold(f64::INFINITY, f64::min);
    Measurement::absolute(0.0, bench.truth.uncertainty / smallest, A_TENTH)
}

/// Slope of the logarithm of the error against that of the time step, over the rungs that are
/// asymptotic and above rounding.
pub fn observed_order(bench: &Bench, sweep: &Sweep) -> f64 {
    let (coarsest, _) = bench.case.rung(bench.case.brief.start);
    let settled = sweep.rungs.iter().filter(|rung| rung.step <= coarsest);
    slope(settled.filter(|rung| rung.error > rounding(bench, sweep.precision, rung)))
}

/// Bound of rounding: half a unit in the last place of the largest coordinate in every step, all in the
/// same direction, as in a flight at constant velocity.
fn rounding(bench: &Bench, precision: Precision, rung: &Rung) -> f64 {
    let positions = bench.origin.particles.position.iter();
    let extent = positions.map(|x| x.x.abs().max(x.y.abs()));
    let extent = extent.fold(0.0, f64::max) / bench.truth.scale;
    precision.roundoff() * extent * rung.steps as f64
}

/// Least-squares slope of the logarithm of the error against that of the time step.
pub fn slope<'a>(rungs: impl Iterator<Item = &'a Rung>) -> f64 {
    let points: Vec<[f64; 2]> = rungs
        .map(|rung| [rung.step.log2(), rung.error.log2()])
        .collect();
    let number = points.len() as f64;
    let mean = [0, 1].map(|k| points.iter().map(|point| point[k]).sum::<f64>() / number);
    let sum = |k: usize| {
        let product = |point: &[f64; 2]| (point[0] - mean[0]) * (point[k] - mean[k]);
        points.iter().map(product).sum::<f64>()
    };
    sum(1) / sum(0)
}

/// Orders of all methods in double, from a few rungs.
pub fn orders(bench: &Bench) -> Result<Measurement, Failure> {
    let sweep = |method| bench.sweep(method, Precision::Double, bench.case.brief.clone());
    let sweeps: Vec<Sweep> = (0..INTEGRATORS.len())
        .map(sweep)
        .collect::<Result<_, _>>()?;
    Ok(verdict(bench, &sweeps))
}

/// Velocity Verlet in the three number types: double and double-double converge at order two where
/// single precision no longer does, though its error stays within the rounding bound.
pub fn scalars(bench: &Bench) -> Result<Measurement, Failure> {
    let sweep = |precision, rungs| bench.sweep(super::VERLET, precision, rungs);
    let brief = bench.case.brief.clone();
    let single = sweep(Precision::Single, brief.clone())?;
    let bounds = single.rungs.iter().map(|rung| {
        Measurement::absolute(
            0.0,
            rung.error / rounding(bench, Precision::Single, rung),
            1.0,
        )
    });
    let falls = slope(single.rungs.iter());
    let rest = Measurement {
        expected: 0.0,
        measured: falls,
        error: falls.max(0.0),
        tolerance: 0.0,
    };
    let start = brief.start - DEARER;
    let wide = sweep(Precision::DoubleDouble, start..brief.end - DEARER)?;
    let double = sweep(Precision::Double, brief)?;
    let trust = trust(bench, [&double, &wide]);
    let orders = [&double, &wide]
        .map(|one| Measurement::absolute(2.0, slope(one.rungs.iter()), bench.case.margin));
    Ok(Measurement::worst(
        bounds.chain([rest, trust]).chain(orders),
    ))
}

/// Number of halvings of the time step by which double-double stops earlier, because it takes about
/// thirty times longer.
pub const DEARER: u32 = 5;
