//! Events and the energy balance: each leaves a first-order residual whose coefficient follows from
//! theory.

use super::heat::{FRICTION, HELD, SPIN, SPRING, SQUEEZE, STIFFNESS, held_at};
use super::spheres::{RADIUS, inertia, mass};
use crate::checks::dem::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::sliding::Rubbing;
use crate::scenes::{Draft, Grain, events};
use gouge_dem::laws::{AdjustedKelvinVoigt, KelvinVoigt, ZhangEckert};
use gouge_runner::scene::INTEGRATORS;
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "closure.order-at-breaking",
            claim: "A bond that breaks leaves a first-order residual with every integrator, with the coefficient of theory.",
            equations: thesis("(48), (54)-(58), (72)"),
            scene: "Two bonded spheres that fly apart until the undamped bond breaks; five integrators, three time steps",
            oracle: "Residual per unit of time step. For velocity Verlet, Beeman and symplectic Euler it is F v / 2, with F and v the force and the speed at breaking from energy conservation: the stored energy is removed at the end of a step during half of which the force acted. For Euler it is w^2 E t, the energy growth of an oscillator, and for Taylor the mean of the two",
            norm: "Relative error of the residual per time step",
            origin: Origin::Convergent,
            reason: "The moment of breaking is known to one step, which is 2 k v dt / F of the force; other errors are of the same order and smaller",
            effort: Effort::Quick,
            measure: breaking,
        },
        Check {
            id: "closure.order-of-sliding",
            claim: "Sliding of the truncated law under a changing load leaves a first-order residual even with second-order methods, with the coefficient of theory.",
            equations: thesis("(42), (72), (78)"),
            scene: "Two spheres with equal spins collide head on and slide on each other until they part; velocity Verlet and Beeman, four time steps",
            oracle: "Half the integral of dL/dt over the slip, with L the friction limit, by extrapolated integration of the motion: heat is booked with the limit at the end of each step",
            norm: "Relative error of the residual per time step",
            origin: Origin::Convergent,
            reason: "The next term is of second order in the step: 10 w dt, with w the frequency of the collision",
            effort: Effort::Quick,
            measure: sliding,
        },
        Check {
            id: "closure.order-of-letting-go",
            claim: "When the printed Cundall-Strack spring starts to slide, the balance gains half the friction limit times the sliding distance of one step.",
            equations: thesis("(42), (76), (78)"),
            scene: "A sphere that spins between two fixed ones, with the printed Cundall-Strack law; velocity Verlet and Beeman, two time steps",
            oracle: "L v dt / 2 per contact, with v the surface speed at the end of the sticking oscillation in closed form",
            norm: "Relative error of the residual per time step",
            origin: Origin::Convergent,
            reason: "The moment is known to one step, which is k v dt / L of the limit",
            effort: Effort::Quick,
            measure: letting_go,
        },
        Check {
            id: "closure.negative-heat",
            claim: "The printed Cundall-Strack law creates energy: when a contact that has slid sticks again, k zeta^2 / 2 appears and is booked as negative heat.",
            equations: thesis("(42), (76), (78)"),
            scene: "Two spheres with equal spins collide head on, slide until friction has stopped the relative motion of the surfaces, and stick once the load has grown enough; velocity Verlet",
            oracle: "Slip distance up to the stop, by extrapolated integration of the motion",
            norm: "Relative error of the largest negative heat booked in one step",
            origin: Origin::Convergent,
            reason: "10 w dt: the moment of the stop is known to one step, and until the contact sticks it oscillates within the slip distance of one step",
            effort: Effort::Quick,
            measure: negative,
        },
    ]
}

/// Residuals at the end of runs with several time steps, compared with the coefficient of theory.
fn compare(
    steps: &[f64],
    coefficient: f64,
    relative: f64,
    run: impl Fn(f64) -> Result<f64, Failure>,
) -> Result<(Measurement, Vec<[f64; 2]>), Failure> {
    let (mut all, mut points) = (Vec::new(), Vec::new());
    for &step in steps {
        let residual = run(step)?;
        all.push(Measurement::relative(
            coefficient,
            residual / step,
            relative * step,
        ));
        points.push([step, residual.abs()]);
    }
    Ok((Measurement::worst(all), points))
}

/// A figure of measured residuals and lines of theory.
fn figure(title: &str, curves: Vec<Curve>) -> Exhibit {
    Exhibit::Figure(Figure::new(
        title.to_owned(),
        Axis::logarithmic("time step", "s"),
        Axis::logarithmic("residual", "J"),
        curves,
    ))
}

fn breaking() -> Outcome {
    let (k, speed) = (1e7, 80.0);
    let (force, reduced) = (280e6 * PI * RADIUS * RADIUS, 0.5 * mass(RADIUS));
    let rate = f64::sqrt(k / reduced);
    let energy = 0.5 * reduced * (2.0 * speed) * (2.0 * speed);
    let left = (2.0 * (energy - 0.5 * force * force / k) / reduced).sqrt();
    let time = (force / k * rate / (2.0 * speed)).asin() / rate;
    let (jump, growth) = (0.5 * force * left, rate * rate * energy * time);
    let run = |integrator: &str, step: f64| {
        let draft = Draft::open_box(integrator, step)
            .law(AdjustedKelvinVoigt {
                stiffness: k,
                damping: 0.0,
            })
            .law(ZhangEckert {
                normal_strength: 280e6,
                tangential_strength: 168e6,
            })
            .grain(Grain::at([-RADIUS, 0.0], RADIUS).moving([-speed, 0.0]))
            .grain(Grain::at([RADIUS, 0.0], RADIUS).moving([speed, 0.0]))
            .bonded(0, 1);
        let mut world = draft.world()?;
        advance(&mut world, (2.0 * time / step) as u64)?;
        Ok(world.energy().residual)
    };
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    let theory = [growth, jump, 0.5 * (growth + jump), jump, jump];
    for ((integrator, _), coefficient) in INTEGRATORS.iter().zip(theory) {
        let steps = [1e-3, 3e-4, 1e-4].map(|h| h / rate);
        let bound = 2.0 * k * left / force;
        let (one, points) = compare(&steps, coefficient, bound, |step| run(integrator, step))?;
        all.push(one);
        let line = steps.map(|step| [step, coefficient * step]);
        curves.push(Curve::line(&format!("{integrator}, theory"), line));
        curves.push(Curve::marks(integrator, points));
    }
    let plot = figure(
        "Residual left by a breaking bond against the time step",
        curves,
    );
    Ok(Measurement::worst(all).showing([plot]))
}

/// Two spheres with equal spins that collide head on.
fn rubbing(of: &Rubbing, law: &str, integrator: &str, step: f64) -> Draft {
    events::rubbing(integrator, step, of.speed, [of.spin; 2])
        .law(KelvinVoigt {
            stiffness: of.stiffness,
            damping: 0.0,
        })
        .friction(law, of.friction, of.spring)
}

const RUBBING: Rubbing = Rubbing {
    radius: RADIUS,
    density: 2700.0,
    stiffness: 1e7,
    friction: 0.3,
    spring: 2e7,
    speed: 1.0,
    spin: 1.2e4,
};

fn sliding() -> Outcome {
    let coefficient = RUBBING.lag();
    let rate = f64::sqrt(2.0 * RUBBING.stiffness / mass(RADIUS));
    let mut all = Vec::new();
    let mut curves = Vec::new();
    let steps = [1e-2, 3e-3, 1e-3, 3e-4].map(|h| h / rate);
    for integrator in ["velocity-verlet", "beeman"] {
        let run = |step: f64| {
            let mut world =
                rubbing(&RUBBING, "cundall-strack-truncated", integrator, step).world()?;
            while world.number_of_contacts() > 0 {
                advance(&mut world, 1)?;
            }
            Ok(world.energy().residual)
        };
        let (one, points) = compare(&steps, coefficient, 10.0 * rate, run)?;
        all.push(one);
        curves.push(Curve::marks(integrator, points));
    }
    let line = steps.map(|step| [step, coefficient.abs() * step]);
    curves.insert(0, Curve::line("theory", line));
    let title = "Residual left by sliding under a changing load against the time step";
    Ok(Measurement::worst(all).showing([figure(title, curves)]))
}

fn letting_go() -> Outcome {
    let limit = FRICTION * STIFFNESS * SQUEEZE;
    // Two springs with lever arm r turn the sphere: w^2 = 2 k r^2 / J.
    let rate = HELD * (2.0 * SPRING / inertia(HELD)).sqrt();
    let amplitude = HELD * SPIN / rate;
    let speed = HELD * SPIN * (1.0 - (limit / SPRING / amplitude).powi(2)).sqrt();
    let mut all = Vec::new();
    for integrator in ["velocity-verlet", "beeman"] {
        let run = |step: f64| {
            let mut world = held_at("cundall-strack", 0, integrator, step).world()?;
            advance(&mut world, (2e-5 / step) as u64)?;
            Ok(world.energy().residual)
        };
        let bound = 2.0 * SPRING * speed / limit;
        all.push(compare(&[1e-8, 2e-9], limit * speed, bound, run)?.0);
    }
    Ok(Measurement::worst(all).into())
}

fn negative() -> Outcome {
    let caught = Rubbing {
        spring: 1e8,
        spin: 70.0,
        ..RUBBING
    };
    let (stop, slide) = caught.stop();
    let rate = f64::sqrt(2.0 * caught.stiffness / mass(RADIUS));
    let step = 1e-4 / rate;
    let draft = rubbing(&caught, "cundall-strack", "velocity-verlet", step);
    let mut world = draft.world()?;
    let (mut before, mut lowest, mut heat) = (0.0, 0.0_f64, Vec::new());
    while world.number_of_contacts() > 0 {
        advance(&mut world, 1)?;
        let friction = world.energy().friction;
        lowest = lowest.min(friction - before);
        before = friction;
        if world.steps().is_multiple_of(128) {
            heat.push([world.time(), friction]);
        }
    }
    let expected = -0.5 * caught.spring * slide * slide;
    let plot = Figure::new(
        "Heat of a contact with the printed Cundall-Strack law: it creates energy when the contact sticks again",
        Axis::linear("time", "s"),
        Axis::linear("heat of contacts and bonds", "J"),
        vec![
            Curve::line("booked", heat),
            Curve::marks("surfaces at relative rest, theory", [[stop, 0.0]]),
        ],
    );
    Ok(
        Measurement::relative(expected, lowest, 10.0 * rate * step)
            .showing([Exhibit::Figure(plot)]),
    )
}
