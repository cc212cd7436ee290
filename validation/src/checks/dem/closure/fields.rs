//! Heat of the ambient medium and work of driving.

use super::spheres::{RADIUS, inertia, mass};
use crate::checks::dem::scenes::advance;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::oracles::dissipation::slowed;
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::Controller;
use gouge_runner::scene::DrivingTable;
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "closure.heat-of-drag",
            claim: "The heat booked by drag equals the kinetic energy, translational and rotational, lost in an exact decay.",
            equations: thesis("(11)-(19), (74)"),
            scene: "A free sphere that flies and spins in a medium, with creeping and with correlation drag, for two time constants in 2e4 steps of velocity Verlet, sampled eight times",
            oracle: "Exponential decay of speed and spin; for correlation drag, extrapolated integration of v' = -(a v + b v^(3/2) + c v^2)",
            norm: "Error of the heat over the initial kinetic energy",
            origin: Origin::Convergent,
            reason: "h^2, with h the step over the time constant: the method decays at the rate 1 - 5 h^2 / 12, so energies are off by at most 0.31 h^2, and the trapezoidal sum of powers by as much",
            effort: Effort::Quick,
            measure: drag,
        },
        Check {
            id: "closure.work-of-driving",
            claim: "The work booked by the driving force is force times path: under a constant load, a constant pull against drag, and a linear ramp.",
            equations: thesis("(20)-(22), (79)"),
            scene: "A driven sphere that is pressed down freely, dragged at constant speed through a viscous medium, or pulled by a force whose two components grow at a constant rate; 1000 steps of velocity Verlet",
            oracle: "F^2 t^2 / (2 m); 6 pi eta r v^2 t; R^2 t^4 / (4 m)",
            norm: "Relative error of the work",
            origin: Origin::Convergent,
            reason: "The method is exact in the first two cases: 4 N roundings of 2^-53. On the ramp, powers use predicted velocities, which lack R dt^2 / (2 m), so the relative error of the work is 2 / N^2, and the trapezoidal rule adds 2 / N^2",
            effort: Effort::Quick,
            measure: driving,
        },
    ]
}

const VISCOSITY: f64 = 0.02;
const SPEED: f64 = 3.0;
const SPIN: f64 = 4000.0;
const FLUID: f64 = 50.0;

/// Compares the heat of the medium with the loss of kinetic energy eight times; the oracle gives the
/// remaining kinetic energy at a time.
fn decay(medium: &Draft, time: f64, left: impl Fn(f64) -> f64) -> Result<Measurement, Failure> {
    const STEPS: u32 = 20_000;
    let h = 2.0 / f64::from(STEPS);
    let step = h * time;
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .and(medium)
        .grain(
            Grain::at([0.0; 2], RADIUS)
                .moving([0.6 * SPEED, 0.8 * SPEED])
                .spinning(SPIN),
        );
    let mut world = draft.world()?;
    let whole = left(0.0);
    let mut all = Vec::new();
    for look in 1..=8 {
        advance(&mut world, u64::from(STEPS / 8))?;
        let lost = whole - left(f64::from(look) / 8.0 * 2.0 * time);
        let heat = world.energy().ambient;
        all.push(Measurement::scaled(lost, heat, whole, h * h));
    }
    Ok(Measurement::worst(all))
}

fn drag() -> Outcome {
    let (m, j) = (mass(RADIUS), inertia(RADIUS));
    let rate = 6.0 * PI * VISCOSITY * RADIUS / m;
    let turning = 8.0 * PI * VISCOSITY * RADIUS.powi(3) / j;
    let spin = |t: f64| 0.5 * j * (SPIN * (-turning * t).exp()).powi(2);
    let creeping = |t: f64| 0.5 * m * (SPEED * (-rate * t).exp()).powi(2) + spin(t);
    // Re = 2 rho r v / eta; C Re^2 = 24 Re + 3 Re^(3/2) + 0.42 Re^2; force = pi eta^2 C Re^2 / (8 rho).
    let reynolds = 2.0 * FLUID * RADIUS / VISCOSITY;
    let unit = PI * VISCOSITY * VISCOSITY / (8.0 * FLUID) / m;
    let terms = [
        24.0 * reynolds * unit,
        3.0 * reynolds.powf(1.5) * unit,
        0.42 * reynolds * reynolds * unit,
    ];
    let correlation = |t: f64| 0.5 * m * slowed(SPEED, t, terms).powi(2) + spin(t);
    // The shortest time constants: spin decays 10/3 times as fast as velocity under creeping drag.
    let fastest = turning.max(terms[0] + terms[1] * SPEED.sqrt() + terms[2] * SPEED);
    let viscous = Draft::empty().creeping_drag(VISCOSITY);
    let fluid = Draft::empty().correlation_drag(VISCOSITY, FLUID);
    Ok(Measurement::worst([
        decay(&viscous, 1.0 / turning, creeping)?,
        decay(&fluid, 1.0 / fastest, correlation)?,
    ])
    .into())
}

/// A driven sphere with the given velocity.
fn driven(step: f64, law: &Draft, speed: f64) -> Result<World, Failure> {
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .and(law)
        .grain(Grain::at([0.0; 2], RADIUS).moving([speed, 0.0]).driven());
    Ok(draft.world()?)
}

fn driving() -> Outcome {
    const STEPS: u32 = 1000;
    let (step, m, n) = (1e-6, mass(RADIUS), f64::from(STEPS));
    let time = n * step;
    let exact = 4.0 * n * 0.5 * f64::EPSILON;
    let work = |law: &Draft, speed: f64| -> Result<f64, Failure> {
        let mut world = driven(step, law, speed)?;
        advance(&mut world, u64::from(STEPS))?;
        Ok(world.energy().driving)
    };
    let (force, rate) = (0.75, 40.0);
    let pressed = work(
        &Draft::empty().driving(DrivingTable {
            controller: Controller::Exact,
            speed: 0.0,
            pressure: force,
            area: Some(1.0),
            initial_force: [0.0; 2],
        }),
        0.0,
    )?;
    let dragged = work(
        &Draft::empty()
            .creeping_drag(VISCOSITY)
            .driving(DrivingTable {
                controller: Controller::Exact,
                speed: SPEED,
                pressure: 0.0,
                area: Some(1.0),
                initial_force: [0.0; 2],
            }),
        SPEED,
    )?;
    let pulled = work(
        &Draft::empty().driving(DrivingTable {
            controller: Controller::RateLimited { force_rate: rate },
            speed: 1e9,
            pressure: -1e9,
            area: Some(1.0),
            initial_force: [0.0; 2],
        }),
        0.0,
    )?;
    let viscous = 6.0 * PI * VISCOSITY * RADIUS * SPEED * SPEED * time;
    Ok(Measurement::worst([
        Measurement::relative(force * force * time * time / (2.0 * m), pressed, exact),
        Measurement::relative(viscous, dragged, exact),
        Measurement::relative(
            rate * rate * time.powi(4) / (4.0 * m),
            pulled,
            4.0 / (n * n),
        ),
    ])
    .into())
}
