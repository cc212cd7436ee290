//! The amplification of one step: two independent theories, and the kernel.

use super::modes::{Linearised, Mode};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::amplification::{
    Method, boundary, characteristic, closed_boundary, course, one_step,
};
use gouge_dem::integrators::{Integrator, Oscillator, characteristic_polynomial, critical_step};

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "time-step.amplification.polynomial",
            claim: "The kernel's stability polynomials of its five integrators are the characteristic polynomials of the one-step matrices of the methods.",
            equations: thesis("(55)-(58)"),
            scene: "120 pairs of squared frequency and damping, in units of the time step: both from 1e-4 to 10, damping also zero",
            oracle: "One step of each method as a matrix written from its definition; coefficients by the Faddeev-LeVerrier algorithm",
            norm: "Largest error of the n-th coefficient, in units of the n-th power of the matrix norm",
            origin: Origin::Exact,
            reason: "The n-th coefficient is a sum of products of n entries, each accurate to a few roundings: 32 roundings in all",
            effort: Effort::Quick,
            measure: polynomials,
        },
        Check {
            id: "time-step.amplification.boundary",
            claim: "At the kernel's critical step, the largest eigenvalue of the one-step matrix exceeds one by 1e-9, the growth that the kernel tolerates; damping ratios from 0 to 20.",
            equations: thesis("(55)-(58)"),
            scene: "An oscillator of unit frequency, 29 damping ratios, five integrators",
            oracle: "Bisection of the spectral radius, with eigenvalues by nalgebra",
            norm: "Largest relative error of a critical step",
            origin: Origin::Convergent,
            reason: "Eigenvalues are accurate to about 1e-15, and a relative change of the step raises the spectral radius by more than 1e-4 of that change. Without damping, two roots of symplectic Euler and velocity Verlet meet, which are accurate to the square root of a rounding, 1.5e-8. The other methods then grow at any step; they may have no critical step beyond 0.01047, where the weakest growth, Beeman's (w dt)^4 / 12, reaches the growth tolerated",
            effort: Effort::Quick,
            measure: boundaries,
        },
        Check {
            id: "time-step.amplification.closed",
            claim: "The steps at which the one-step matrices become unstable have closed forms: 2 zeta or 2 (zeta - sqrt(zeta^2 - 1)) for Euler, 2 (sqrt(1 + zeta^2) - zeta) for symplectic Euler, min(4 zeta, 1/zeta) for Taylor, 2 (sqrt(1 + 4 zeta^2) - 2 zeta) for velocity Verlet and, from 2 % of critical damping, (sqrt(400 zeta^2 + 84) - 20 zeta)/7 for Beeman.",
            equations: thesis("(55)-(58)"),
            scene: "Oscillators of unit frequency with 29 damping ratios from 0.02 to 20",
            oracle: "Closed forms from the conditions that the determinant is one or a root is minus one",
            norm: "Largest relative error of a critical step",
            origin: Origin::Convergent,
            reason: "The bisection tolerates a growth of 1e-13, and a relative change of the step raises the spectral radius by more than 2 zeta^2, 8e-4, of that change",
            effort: Effort::Quick,
            measure: closed_forms,
        },
        Check {
            id: "time-step.amplification.course",
            claim: "Sixty steps of the kernel, linearised by dual numbers, equal sixty products with the one-step matrix: for axial, shearing and bending modes of bonds, for squeezed, sticking and viscous contacts and for drag.",
            equations: thesis("(17)-(19), (36), (41)-(45), (55)-(58)"),
            scene: "Seven modes of two or three grains of 1 mm, five integrators, up to five damping ratios, three time steps from stable to unstable",
            oracle: "Powers of the one-step matrix with the stiffness and damping of the mode in closed form",
            norm: "Largest error of amplitude and speed, in units of the largest value so far",
            origin: Origin::Exact,
            reason: "Each step adds about twenty roundings relative to the terms of the force, which are up to ten times the amplitude, and sixty steps accumulate them: 60 x 20 x 10 roundings",
            effort: Effort::Quick,
            measure: courses,
        },
    ]
}

/// The kernel's integrator.
pub fn integrator(method: Method) -> Integrator {
    match method {
        Method::Euler => Integrator::Euler,
        Method::SymplecticEuler => Integrator::SymplecticEuler,
        Method::Taylor => Integrator::Taylor,
        Method::VelocityVerlet => Integrator::VelocityVerlet,
        Method::Beeman => Integrator::Beeman,
    }
}

/// A geometric sequence between two positive numbers.
pub fn geometric(from: f64, to: f64, number: usize) -> impl Iterator<Item = f64> {
    let ratio = (to / from).ln() / (number - 1) as f64;
    (0..number).map(move |n| from * (ratio * n as f64).exp())
}

fn polynomials() -> Outcome {
    let mut all = Vec::new();
    for method in Method::ALL {
        for k in geometric(1e-4, 10.0, 12) {
            for c in [0.0].into_iter().chain(geometric(1e-4, 10.0, 9)) {
                let expected = characteristic(method, k, c);
                let found = characteristic_polynomial(integrator(method), k, c);
                let size = one_step(method, k, c).norm();
                let missing = expected.len().abs_diff(found.len());
                all.push(Measurement::count(missing));
                let mut scale = 1.0;
                for (&expected, &found) in expected.iter().zip(&found) {
                    let tolerance = 16.0 * f64::EPSILON;
                    all.push(Measurement::scaled(expected, found, scale, tolerance));
                    scale *= size;
                }
            }
        }
    }
    Ok(Measurement::worst(all).into())
}

/// Damping ratios from zero to 20.
fn ratios() -> impl Iterator<Item = f64> {
    [0.0].into_iter().chain(geometric(0.02, 20.0, 28))
}

/// Whether the method keeps the amplitude of an undamped oscillator.
fn conserves(method: Method) -> bool {
    matches!(method, Method::SymplecticEuler | Method::VelocityVerlet)
}

/// Growth per step that the kernel's stability test tolerates.
const ADMITTED: f64 = 1e-9;

fn boundaries() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for method in Method::ALL {
        let mut points = Vec::new();
        for zeta in ratios() {
            let expected = boundary(method, [1.0, 2.0 * zeta], ADMITTED);
            let oscillator = Oscillator {
                frequency_squared: 1.0,
                damping_rate: 2.0 * zeta,
            };
            let found = critical_step(integrator(method), oscillator);
            all.push(if zeta > 0.0 {
                Measurement::relative(expected, found, 1e-9)
            } else if conserves(method) {
                // A double root, accurate to the square root of a rounding.
                Measurement::relative(expected, found, f64::EPSILON.sqrt())
            } else {
                // Never stable: the step is at most that at which the weakest growth, Beeman's (w dt)^4
                // / 12, reaches the growth tolerated, up to the next power of the step.
                Measurement::absolute(0.0, found, 1.001 * (12.0 * ADMITTED).powf(0.25))
            });
            points.push([zeta, found]);
        }
        curves.push(Curve::marked_line(
            super::modes::integrator_name(method),
            points,
        ));
    }
    let plot = Figure::new(
        "The damping ratio decides which integrator allows the longest time step",
        Axis::logarithmic("damping ratio", ""),
        Axis::logarithmic("critical step in units of 1/w", ""),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

fn closed_forms() -> Outcome {
    let mut all = Vec::new();
    for method in Method::ALL {
        for zeta in geometric(0.02, 20.0, 29) {
            if let Some(expected) = closed_boundary(method, zeta) {
                let found = boundary(method, [1.0, 2.0 * zeta], 1e-13);
                all.push(Measurement::relative(expected, found, 1e-9));
            }
        }
    }
    Ok(Measurement::worst(all).into())
}

fn courses() -> Outcome {
    const STEPS: usize = 60;
    const TOLERANCE: f64 = (STEPS * 20 * 10) as f64 * 0.5 * f64::EPSILON;
    let mut all = Vec::new();
    for mode in Mode::ALL {
        for method in Method::ALL {
            for zeta in mode.ratios(&[0.0, 0.05, 0.3, 1.0, 1.7]) {
                let constants = mode.constants(zeta);
                for scaled in [0.05, 0.6, 1.1] {
                    let step = 1e-6 * scaled;
                    let worst = course_error(mode, method, step, constants, STEPS)?;
                    all.push(Measurement::absolute(0.0, worst, TOLERANCE));
                }
            }
        }
    }
    Ok(Measurement::worst(all).into())
}

/// Largest error of a run against the powers of the matrix, in units of the largest state so far.
fn course_error(
    mode: Mode,
    method: Method,
    step: f64,
    constants: [f64; 2],
    steps: usize,
) -> Result<f64, Failure> {
    let [k, c] = mode.rates(constants);
    let mut run = Linearised::new(mode, method, step, constants)?;
    let expected = course(method, k * step * step, c * step, run.state(), steps);
    let (mut scale, mut worst): (f64, f64) = (0.0, 0.0);
    for state in expected {
        let found = run.state();
        for (expected, found) in state.into_iter().zip(found) {
            scale = scale.max(expected.abs());
            let error = (found - expected).abs() / scale;
            worst = if error.is_nan() {
                f64::NAN
            } else {
                worst.max(error)
            };
        }
        run.advance()?;
    }
    Ok(worst)
}
