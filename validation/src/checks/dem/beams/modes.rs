//! Modes of two bonded particles.

use super::oscillation::{decay_and_turn_a_step, turn_a_step};
use super::stiffness::{Rest, coordinates, modes};
use crate::checks::extrapolation::to_no_step;
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::beams::{Sphere, Springs, pair};
use crate::scenes::{Draft, Grain};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, EulerBernoulli};
use gouge_scalars::Dual;
use std::f64::consts::TAU;

/// The checks.
pub fn checks() -> Vec<Check> {
    const PAIRS: &str = "Three bonded pairs: touching equal spheres of 1 mm; separated spheres of 1 and 0.5 mm; overlapping spheres of 0.4 and 1.1 mm; all oblique, with unequal stiffness and damping for stretching and bending except in the first";
    vec![
        Check {
            id: "beams.pair-matrix",
            claim: "The derivatives of a bond's forces have three rigid modes and the modes of stretching, counter-rotation and shear, with the frequencies and decay rates calculated by hand.",
            equations: thesis("(33)-(34), (43)-(45), (51)-(53)"),
            scene: PAIRS,
            oracle: "Closed form for any radii and distance; sqrt(2k/m), sqrt(5k/2m), sqrt(7k/2m) for touching equal spheres",
            norm: "Error of the eigenvalues of stiffness and damping over inertia, in units of the largest",
            origin: Origin::Exact,
            reason: "An eigenvalue moves by at most the norm of the rounding of a 6 x 6 matrix: 64 units of 2^-52",
            effort: Effort::Quick,
            measure: matrix,
        },
        Check {
            id: "beams.pair-run",
            claim: "Small undamped oscillations of a bond have the frequencies of its modes, after correction for the known frequency shift of the time step.",
            equations: thesis("(43)-(45), (51)-(53)"),
            scene: PAIRS,
            oracle: "Closed form of the frequencies; velocity Verlet advances the phase of a mode by theta per step, with 2 sin(theta / 2) = w dt",
            norm: "Relative error of the frequency over fifty periods of sixty steps",
            origin: Origin::Exact,
            reason: "In 3000 steps, roundings of at most 2^-52 per operation accumulate to 2e-15 of the phase of 300 rad; about ten operations per step make it 2e-14",
            effort: Effort::Quick,
            measure: free_run,
        },
        Check {
            id: "beams.pair-swing",
            claim: "Stretching and counter-rotation of a bond are harmonic at any amplitude: oscillations of a tenth of a radius per sphere and of half a radian have the frequencies of infinitesimal ones.",
            equations: thesis("(43)-(45), (51)-(53)"),
            scene: "Two touching bonded spheres of 1 mm, k = 1e7 kg/s^2, launched apart or with opposite spins, in double precision",
            oracle: "sqrt(2k/m) and sqrt(5k/2m); velocity Verlet advances the phase of a mode by theta per step, with 2 sin(theta / 2) = w dt",
            norm: "Relative error of the frequency over fifty periods of sixty steps",
            origin: Origin::Exact,
            reason: "In 3000 steps, roundings of 2^-52 relative to an amplitude of a tenth of the distance accumulate to 2e-13 of the phase of 300 rad",
            effort: Effort::Quick,
            measure: swing,
        },
        Check {
            id: "beams.pair-damped",
            claim: "Damped small oscillations of a bond have the decay rates and frequencies of its modes.",
            equations: thesis("(43)-(45), (51)-(53)"),
            scene: PAIRS,
            oracle: "Closed form of the damped modes",
            norm: "Error of decay rate and frequency in units of the frequency, extrapolated from time steps of 1/400 to 1/6400 of a period",
            origin: Origin::Convergent,
            reason: "Extrapolation removes the errors of second to fifth order. The sixth leaves (2 pi / 400)^6 / 2^14 = 1e-15, times a factor of about a thousand under strong damping",
            effort: Effort::Quick,
            measure: damped_run,
        },
    ]
}

struct Pair {
    ends: [Sphere; 2],
    distance: f64,
    direction: f64,
    springs: Springs,
    dashpots: Springs,
}

fn pairs() -> [Pair; 3] {
    let pair = |radii: [f64; 2], distance, direction, springs: [f64; 2], dashpots: [f64; 2]| Pair {
        ends: radii.map(|radius| Sphere {
            radius,
            density: 2700.0,
        }),
        distance,
        direction,
        springs: both(springs),
        dashpots: both(dashpots),
    };
    [
        pair([1e-3, 1e-3], 2e-3, 0.3, [1e7, 1e7], [10.0, 10.0]),
        pair([1e-3, 0.5e-3], 1.55e-3, -1.2, [1e7, 3e6], [3.0, 1.0]),
        pair([0.4e-3, 1.1e-3], 1.4e-3, 2.5, [2e7, 3e7], [2.0, 1.0]),
    ]
}

fn both([normal, tangential]: [f64; 2]) -> Springs {
    Springs { normal, tangential }
}

/// The `[bond]` section of a scene with the given constants.
pub fn bond(springs: Springs, dashpots: Springs) -> Draft {
    Draft::empty()
        .law(AdjustedKelvinVoigt {
            stiffness: springs.normal,
            damping: dashpots.normal,
        })
        .law(EulerBernoulli {
            stiffness: springs.tangential,
            damping: dashpots.tangential,
        })
}

impl Pair {
    fn rest(&self, dashpots: Springs) -> Result<Rest, Failure> {
        let (s, c) = self.direction.sin_cos();
        let [a, b] = self.ends.map(|end| end.radius);
        let there = [self.distance * c, self.distance * s];
        let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
            .and(&bond(self.springs, dashpots))
            .grain(Grain::at([0.0; 2], a))
            .grain(Grain::at(there, b))
            .bonded(0, 1);
        Rest::of_draft(&draft)
    }

    /// Squared frequencies for the given constants in ascending order; the first three belong to rigid
    /// modes.
    fn squares(&self, constants: Springs) -> [f64; 6] {
        let [axial, slow, fast] = pair::modes(self.ends, self.distance);
        let t = constants.tangential;
        let mut squares = [0.0, 0.0, 0.0, constants.normal * axial, t * slow, t * fast];
        squares.sort_by(f64::total_cmp);
        squares
    }
}

fn matrix() -> Outcome {
    let mut measured = Vec::new();
    for pair in pairs() {
        let rest = pair.rest(pair.dashpots)?;
        let inertia = rest.inertia();
        let cases = [
            (rest.stiffness()?, pair.springs),
            (rest.damping()?, pair.dashpots),
        ];
        for (slopes, constants) in cases {
            let exact = pair.squares(constants);
            let (values, _) = modes(&slopes, &inertia);
            let compare = |(value, exact_one): (&f64, &f64)| {
                Measurement::scaled(*exact_one, *value, exact[5], 64.0 * f64::EPSILON)
            };
            measured.extend(values.iter().zip(&exact).map(compare));
        }
    }
    Ok(Measurement::worst(measured).into())
}

/// Samples of a mode's amplitude in a run started with the velocities of that mode.
fn samples(rest: &Rest, mode: &[f64], step: f64, steps: usize) -> Result<Vec<f64>, Failure> {
    let inertia = rest.inertia();
    let rates: Vec<Dual> = mode.iter().map(|&rate| Dual::new(0.0, rate)).collect();
    let mut world = rest.launched(&rates, Integrator::VelocityVerlet, step)?;
    let mut samples = vec![0.0];
    for _ in 0..steps {
        world.step()?;
        let weigh = |((x, rate), m): ((&Dual, &f64), &f64)| x.slope() * rate * m;
        let now = coordinates(&world);
        samples.push(now.iter().zip(mode).zip(&inertia).map(weigh).sum());
    }
    Ok(samples)
}

const NAMES: [&str; 3] = ["first", "second", "third"];

fn free_run() -> Outcome {
    let mut measured = Vec::new();
    let mut table = Table::new(
        "Angular frequencies of bonded pairs, in closed form and measured in runs",
        &[
            "pair",
            "mode",
            "closed form, rad/s",
            "kernel, rad/s",
            "relative error",
        ],
    );
    for (number, pair) in pairs().iter().enumerate() {
        let rest = pair.rest(both([0.0; 2]))?;
        let (_, shapes) = modes(&rest.stiffness()?, &rest.inertia());
        let exact = pair.squares(pair.springs);
        for (n, (square, shape)) in exact.iter().zip(&shapes).enumerate().skip(3) {
            let frequency = square.sqrt();
            let step = TAU / (60.0 * frequency);
            let turn = turn_a_step(&samples(&rest, shape, step, 3000)?);
            let found = 2.0 * (0.5 * turn.unwrap_or(f64::NAN)).sin() / step;
            let one = Measurement::relative(frequency, found, 1e-13);
            table.push([
                (number + 1).to_string(),
                NAMES[n - 3].to_owned(),
                format!("{frequency:.9e}"),
                format!("{found:.9e}"),
                format!("{:.1e}", one.error),
            ]);
            measured.push(one);
        }
    }
    Ok(Measurement::worst(measured).showing([Exhibit::Table(table)]))
}

fn swing() -> Outcome {
    let [pair, ..] = pairs();
    let ([radius, _], mass) = (pair.ends.map(|end| end.radius), pair.ends[0].mass());
    let mut measured = Vec::new();
    for (coefficient, turns) in [(2.0, false), (2.5, true)] {
        let frequency = (coefficient * pair.springs.normal / mass).sqrt();
        let step = TAU / (60.0 * frequency);
        // Speed of each sphere along the line of centres, or spin, for the amplitude given in the
        // claim.
        let (speed, spin) = match turns {
            false => (0.1 * radius * frequency, 0.0),
            true => (0.0, 0.5 * frequency),
        };
        let draft = Draft::open_box(Integrator::VelocityVerlet, step)
            .and(&bond(pair.springs, both([0.0; 2])))
            .grain(
                Grain::at([-radius, 0.0], radius)
                    .moving([-speed, 0.0])
                    .spinning(-spin),
            )
            .grain(
                Grain::at([radius, 0.0], radius)
                    .moving([speed, 0.0])
                    .spinning(spin),
            )
            .bonded(0, 1);
        let mut world = draft.world()?;
        let mut samples = vec![0.0];
        for _ in 0..3000 {
            world.step()?;
            let p = world.particles();
            samples.push(if turns {
                p.angle[1]
            } else {
                p.position[1].x - radius
            });
        }
        let turn = turn_a_step(&samples).unwrap_or(f64::NAN);
        let found = 2.0 * (0.5 * turn).sin() / step;
        measured.push(Measurement::relative(frequency, found, 2e-13));
    }
    Ok(Measurement::worst(measured).into())
}

fn damped_run() -> Outcome {
    let mut measured = Vec::new();
    let mut table = Table::new(
        "Decay rates and angular frequencies of damped bonded pairs, in closed form and measured in runs",
        &[
            "pair",
            "decay, closed form, 1/s",
            "decay, kernel, 1/s",
            "frequency, closed form, rad/s",
            "frequency, kernel, rad/s",
        ],
    );
    for (number, pair) in pairs().iter().enumerate() {
        let rest = pair.rest(pair.dashpots)?;
        let (_, shapes) = modes(&pair.rest(both([0.0; 2]))?.stiffness()?, &rest.inertia());
        let mut exact = pair::damped(pair.ends, pair.distance, pair.springs, pair.dashpots);
        exact.sort_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])));
        for (shape, exact) in shapes[3..].iter().zip(exact) {
            let scale = exact[0].hypot(exact[1]);
            let level = |steps: usize| {
                let step = TAU / (steps as f64 * scale);
                let samples = samples(&rest, shape, step, steps)?;
                // Use sparse samples, which are less sensitive to rounding; the spurious modes of the
                // method die out within the first few.
                let every = steps / 25;
                let thinned: Vec<f64> = samples.into_iter().step_by(every).skip(4).collect();
                let rates = decay_and_turn_a_step(&thinned);
                Ok(vec![rates.map(|rate| rate / (step * every as f64))])
            };
            let levels: Result<Vec<_>, Failure> = [400, 800, 1600, 3200, 6400]
                .map(level)
                .into_iter()
                .collect();
            let found = to_no_step(levels?, &[2, 3, 4, 5]);
            let found = found.first().copied().unwrap_or([f64::NAN; 2]);
            let both = exact.iter().zip(found);
            measured.extend(
                both.map(|(&exact, found)| Measurement::scaled(exact, found, scale, 1e-10)),
            );
            let cells = [exact[0], found[0], exact[1], found[1]].map(|x| format!("{x:.9e}"));
            table.push([(number + 1).to_string()].into_iter().chain(cells));
        }
    }
    Ok(Measurement::worst(measured).showing([Exhibit::Table(table)]))
}
