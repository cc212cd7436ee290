//! Waves along a chain.

use super::modes::bond;
use super::oscillation::turn_a_step;
use super::stiffness::{Rest, coordinates, modes};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::beams::waves::{Lattice, Wave};
use crate::oracles::beams::{Sphere, Springs};
use crate::scenes::{Draft, Grain};
use gouge_dem::integrators::Integrator;
use gouge_scalars::Dual;
use std::f64::consts::TAU;

/// The checks.
pub fn checks() -> Vec<Check> {
    const CHAIN: &str =
        "A ring of 24 bonded particles, radius 1 mm at a distance of 2.1 mm, in a periodic box";
    vec![
        Check {
            id: "beams.chain-spectrum",
            claim: "All 72 frequencies of a ring of bonded particles lie on the three dispersion curves of a chain.",
            equations: thesis("(43)-(45), (51)-(53), (64)"),
            scene: CHAIN,
            oracle: "2 sqrt(k/m) abs(sin(q D / 2)) for waves along the chain, the roots of a 2 x 2 matrix for waves across it",
            norm: "Error of the squared frequencies, from the derivatives of all forces, in units of the largest",
            origin: Origin::Exact,
            reason: "Rounding of a symmetric 72 x 72 matrix and of its eigenvalues: below 256 units of 2^-52",
            effort: Effort::Quick,
            measure: spectrum,
        },
        Check {
            id: "beams.chain-waves",
            claim: "Standing waves of a ring have the frequencies of the dispersion curves, after correction for the known frequency shift of the time step.",
            equations: thesis("(43)-(45), (51)-(53), (64)"),
            scene: CHAIN,
            oracle: "The same curves; velocity Verlet advances the phase of a mode by theta per step, with 2 sin(theta / 2) = w dt",
            norm: "Relative error of the frequency after 800 steps; if the phase advances by less than half a radian per step, it is multiplied by the square of twice that angle",
            origin: Origin::Exact,
            reason: "In infinitesimal motion the phase accumulates about 800 x 2^-52 = 2e-13 of rounding. The rounding of a force adds to a slow mode an error that grows with the squared ratio of the frequencies",
            effort: Effort::Quick,
            measure: waves,
        },
    ]
}

const BODIES: usize = 24;

fn lattice() -> Lattice {
    Lattice {
        sphere: Sphere {
            radius: 1e-3,
            density: 2700.0,
        },
        distance: 2.1e-3,
        springs: Springs {
            normal: 1e7,
            tangential: 0.7e7,
        },
    }
}

fn rest(lattice: &Lattice) -> Result<Rest, Failure> {
    let width = BODIES as f64 * lattice.distance;
    let mut draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .and(&bond(
            lattice.springs,
            Springs {
                normal: 0.0,
                tangential: 0.0,
            },
        ))
        .with("box.width", width)
        .with("box.boundary", "periodic-x");
    for n in 0..BODIES {
        let x = n as f64 * lattice.distance;
        draft = draft.grain(Grain::at([x, 0.0], lattice.sphere.radius));
    }
    for n in 0..BODIES {
        draft = draft.bonded(n, (n + 1) % BODIES);
    }
    Rest::of_draft(&draft)
}

fn phase(number: usize) -> f64 {
    TAU * number as f64 / BODIES as f64
}

fn spectrum() -> Outcome {
    let lattice = lattice();
    let rest = rest(&lattice)?;
    let (squares, _) = modes(&rest.stiffness()?, &rest.inertia());
    let branches = |n: usize| {
        let across = lattice
            .chain_transverse(phase(n))
            .map(|wave| wave.frequency);
        [lattice.chain_longitudinal(phase(n)), across[0], across[1]]
    };
    let mut exact: Vec<f64> = (0..BODIES).flat_map(branches).map(|w| w * w).collect();
    exact.sort_by(f64::total_cmp);
    let largest = exact[exact.len() - 1];
    let compare = |(exact, found): (&f64, &f64)| {
        Measurement::scaled(*exact, *found, largest, 256.0 * f64::EPSILON)
    };
    Ok(Measurement::worst(exact.iter().zip(&squares).map(compare)).into())
}

/// Number of steps of a run, and the largest phase advance per step of the mode, in rad.
const STEPS: usize = 800;
const FASTEST: f64 = 0.5;

/// Frequency of a standing wave with the given rates of x, y and angle.
fn frequency(rest: &Rest, rates: &[f64], step: f64) -> Result<f64, Failure> {
    let duals: Vec<Dual> = rates.iter().map(|&rate| Dual::new(0.0, rate)).collect();
    let mut world = rest.launched(&duals, Integrator::VelocityVerlet, step)?;
    let inertia = rest.inertia();
    let mut samples = vec![0.0];
    for _ in 0..STEPS {
        world.step()?;
        let now = coordinates(&world);
        let weigh = |((x, rate), m): ((&Dual, &f64), &f64)| x.slope() * rate * m;
        samples.push(now.iter().zip(rates).zip(&inertia).map(weigh).sum());
    }
    let turn = turn_a_step(&samples).unwrap_or(f64::NAN);
    Ok(2.0 * (0.5 * turn).sin() / step)
}

fn waves() -> Outcome {
    let lattice = lattice();
    let rest = rest(&lattice)?;
    let mut found: [Vec<[f64; 2]>; 3] = Default::default();
    let mut measured = Vec::new();
    for number in 1..BODIES / 2 {
        let phase = phase(number);
        let along = Wave {
            frequency: lattice.chain_longitudinal(phase),
            displacement: 1.0,
            turn: 0.0,
        };
        let [slow, fast] = lattice.chain_transverse(phase);
        for (branch, (wave, axis)) in [(along, 0), (slow, 1), (fast, 1)].into_iter().enumerate() {
            let rate = |n: usize| {
                let (s, c) = (phase * n as f64).sin_cos();
                let mut rates = [0.0, 0.0, wave.turn * s];
                rates[axis] = wave.displacement * c;
                rates
            };
            let rates: Vec<f64> = (0..BODIES).flat_map(rate).collect();
            // Slow modes use the longest step that the fastest mode allows.
            let step = (FASTEST / wave.frequency).min(1.0 / fast.frequency.max(along.frequency));
            let value = frequency(&rest, &rates, step)?;
            let share = (wave.frequency * step / FASTEST).powi(2);
            measured.push(Measurement::scaled(
                wave.frequency,
                value,
                wave.frequency / share,
                1e-12,
            ));
            found[branch].push([phase, value]);
        }
    }
    Ok(Measurement::worst(measured).showing([Exhibit::Figure(curves(&lattice, found))]))
}

fn curves(lattice: &Lattice, found: [Vec<[f64; 2]>; 3]) -> Figure {
    let phases = || (1..=100).map(|n| f64::from(n) * TAU / 200.0);
    let transverse =
        |n: usize| phases().map(move |q| [q, lattice.chain_transverse(q)[n].frequency]);
    let [along, slow, fast] = found;
    Figure::new(
        "Standing waves of a ring of bonded particles lie on the dispersion curves of a chain",
        Axis::linear("phase q D between neighbours", "rad"),
        Axis::linear("angular frequency", "rad/s"),
        vec![
            Curve::line(
                "along the chain, closed form",
                phases().map(|q| [q, lattice.chain_longitudinal(q)]),
            ),
            Curve::line("bending, closed form", transverse(0)),
            Curve::line("rotation, closed form", transverse(1)),
            Curve::marks("along the chain, kernel", along),
            Curve::marks("bending, kernel", slow),
            Curve::marks("rotation, kernel", fast),
        ],
    )
}
