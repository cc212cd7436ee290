//! The thesis's modes with its integrator and time step.

use super::modes::{Linearised, Mode, RADIUS, mass};
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::amplification::{Method, boundary, spectral_radius};
use crate::scenes::{Draft, Grain};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{HaffWerner, KelvinVoigt};
use std::f64::consts::TAU;

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "time-step.thesis.growth",
            claim: "With explicit Euler and 10 ns, the thesis's sticking spring (1e8 kg/s^2, undamped) grows by a factor of 1.00309 per step, e-fold in 3.2 us, while its damped bonds and contacts decay; the kernel grows and decays at the predicted rates.",
            equations: thesis("(36), (41)-(45), (55)"),
            scene: "Modes of grains of 1 mm with the constants of thesis section 4.2, 400 steps of 10 ns",
            oracle: "Largest eigenvalue of the one-step matrix",
            norm: "Largest relative error of the factor per step",
            origin: Origin::Exact,
            reason: "The determinant of three successive amplitudes loses digits by a factor of the squared phase, 5e-5. The root of order 800 of its growth retains a 400th of that error; 1e-12 allows a hundred roundings",
            effort: Effort::Quick,
            measure: growth,
        },
        Check {
            id: "time-step.thesis.viscous",
            claim: "If all grains rotate alike, z viscous contacts slow a grain at the rate 5 z gamma/m, so explicit Euler allows 11.3 ns with four contacts and 7.5 ns with six; with six this is less than the thesis's step. For the smallest grains the limits are 6.4 and 4.3 ns, both less.",
            equations: thesis("(22), (41), (53), (55)"),
            scene: "A grain of 1 mm inside a square and inside a hexagon of equal grains, all with the same spin, Haff-Werner friction of 100 kg/s below its limit",
            oracle: "A slip velocity of 2 r w at each contact and a moment of inertia of 2/5 m r^2",
            norm: "Relative error of the rate; error of the quoted steps in their last digit",
            origin: Origin::Exact,
            reason: "About twenty roundings per contact: 64 roundings; half a unit of the last digit quoted",
            effort: Effort::Quick,
            measure: viscous,
        },
    ]
}

/// Time step of thesis section 4.2 in s.
const STEP: f64 = 10e-9;

/// Constants of a mode in the thesis: stiffness in kg/s^2 and damping in kg/s.
fn constants(mode: Mode) -> [f64; 2] {
    match mode {
        Mode::Sticking => [1e8, 0.0],
        Mode::Viscous => [0.0, 100.0],
        _ => [1e7, 10.0],
    }
}

/// Factor per step by which a run multiplies its mode: without stiffness, that of the speed; otherwise
/// from the growth of y(n) y(n + 2) - y(n + 1)^2, which an oscillation multiplies by the squared
/// factor.
fn measured(mode: Mode, steps: usize) -> Result<f64, Failure> {
    let mut run = Linearised::new(mode, Method::Euler, STEP, constants(mode))?;
    let mut course = vec![run.state()];
    for _ in 0..steps + 2 {
        run.advance()?;
        course.push(run.state());
    }
    if mode == Mode::Viscous {
        let ratio = course[2][1] / course[1][1];
        return Ok(ratio.abs());
    }
    let invariant = |n: usize| {
        let [a, b, c] = [0, 1, 2].map(|ahead| course[n + ahead][0]);
        a * c - b * b
    };
    Ok((invariant(steps) / invariant(0)).powf(0.5 / steps as f64))
}

fn growth() -> Outcome {
    let mut all = Vec::new();
    let mut table = Table::new(
        "Modes of the thesis under explicit Euler with 10 ns",
        &[
            "mode",
            "rate in 1/s",
            "damping ratio",
            "critical step in ns",
            "factor per step, theory",
            "factor per step, kernel",
            "time for a factor of e in us",
        ],
    );
    let modes = [
        Mode::Sticking,
        Mode::Viscous,
        Mode::Squeezed,
        Mode::Axial,
        Mode::Bending,
        Mode::Shearing,
    ];
    for mode in modes {
        let [k, c] = mode.rates(constants(mode));
        let expected = spectral_radius(Method::Euler, k * STEP * STEP, c * STEP);
        // The one-step matrix has an eigenvalue of one if no force restores the position.
        let expected = if k > 0.0 {
            expected
        } else {
            (1.0 - c * STEP).abs()
        };
        let found = measured(mode, 400)?;
        all.push(Measurement::relative(expected, found, 1e-12));
        let critical = boundary(Method::Euler, [k, c], 1e-13);
        table.push([
            mode.name().to_owned(),
            format!("{:.4e}", if k > 0.0 { k.sqrt() } else { c }),
            format!("{:.3}", 0.5 * c / k.sqrt()),
            if c > 0.0 {
                format!("{:.1}", 1e9 * critical)
            } else {
                "none".to_owned()
            },
            format!("{expected:.12}"),
            format!("{found:.12}"),
            format!("{:.3}", 1e6 * STEP / expected.ln()),
        ]);
    }
    let sticking = mode_factor(Mode::Sticking);
    all.push(Measurement::absolute(1.00309, sticking, 5e-6));
    let micro = 1e6 * STEP / sticking.ln();
    all.push(Measurement::absolute(3.2, micro, 0.05));
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

/// Theoretical factor per step of a mode of the thesis.
fn mode_factor(mode: Mode) -> f64 {
    let [k, c] = mode.rates(constants(mode));
    spectral_radius(Method::Euler, k * STEP * STEP, c * STEP)
}

/// Rate in 1/s at which the central grain slows down if all grains have the same spin.
fn slowing(contacts: u32) -> Result<f64, Failure> {
    const SPIN: f64 = 1e-6;
    let ring = (0..contacts).map(|n| {
        let (sine, cosine) = (TAU * f64::from(n) / f64::from(contacts)).sin_cos();
        [1.999 * RADIUS * cosine, 1.999 * RADIUS * sine]
    });
    let grains = std::iter::once([0.0, 0.0]).chain(ring);
    let draft = Draft::open_box(Integrator::Euler, STEP)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .law(HaffWerner {
            friction: 0.7,
            damping: 100.0,
        })
        .grains(grains.map(|at| Grain::at(at, RADIUS).spinning(SPIN)));
    let mut world = draft.world()?;
    world.evaluate_if_pending()?;
    let inertia = 0.4 * mass() * RADIUS * RADIUS;
    Ok(-world.forces().torque[0] / (inertia * SPIN))
}

fn viscous() -> Outcome {
    let smallest = (2.0 / (1.0 + 2.0_f64.sqrt())).powi(3);
    let mut all = Vec::new();
    for (contacts, mean, small) in [(4, 11.3, 6.4), (6, 7.5, 4.3)] {
        let expected = 5.0 * f64::from(contacts) * 100.0 / mass();
        let found = slowing(contacts)?;
        all.push(Measurement::relative(expected, found, 64.0 * f64::EPSILON));
        let bound = 1e9 * boundary(Method::Euler, [0.0, found], 1e-13);
        all.push(Measurement::absolute(mean, bound, 0.05));
        all.push(Measurement::absolute(small, bound * smallest, 0.05));
    }
    Ok(Measurement::worst(all).into())
}
