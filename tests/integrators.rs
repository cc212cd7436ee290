//! Order and stability of the integrators, measured on a damped oscillator in the kernel.

use crate::worlds::{advance, world};
use approx::{abs_diff_eq, assert_abs_diff_eq};
use gouge_dem::World;
use gouge_dem::integrators::{Integrator, Oscillator, critical_step};
use gouge_validation::scenes::events;

const NAMES: [(&str, Integrator); 6] = [
    ("euler", Integrator::Euler),
    ("symplectic-euler", Integrator::SymplecticEuler),
    ("taylor", Integrator::Taylor),
    ("velocity-verlet", Integrator::VelocityVerlet),
    ("beeman", Integrator::Beeman),
    (
        "velocity-verlet-half-step",
        Integrator::VelocityVerletHalfStep,
    ),
];

/// A particle of 1 kg in a harmonic well of angular frequency 1/s, with drag of the given damping ratio.
fn oscillator(integrator: &str, step: f64, damping_ratio: f64) -> World {
    world(&events::oscillator(integrator, step, damping_ratio))
}

/// Closed form of the height of the oscillator, released at rest at 1 m.
fn exact(time: f64, zeta: f64) -> f64 {
    let omega = (1.0 - zeta * zeta).sqrt();
    let phase = omega * time;
    (-zeta * time).exp() * (phase.cos() + zeta / omega * phase.sin())
}

fn error(integrator: &str, steps: u64, zeta: f64) -> f64 {
    let end = 3.0;
    let mut world = oscillator(integrator, end / steps as f64, zeta);
    advance(&mut world, steps);
    (world.particles().position[0].y - exact(end, zeta)).abs()
}

#[test]
fn convergence_orders_match_theory() {
    for (zeta, half_step) in [(0.0, 2.0), (0.3, 1.0)] {
        let orders = [1.0, 1.0, 1.0, 2.0, 2.0, half_step];
        for ((name, _), order) in NAMES.iter().zip(orders) {
            let (coarse, fine) = (error(name, 1600, zeta), error(name, 3200, zeta));
            let observed = (coarse / fine).log2();
            assert!(
                abs_diff_eq!(observed, order, epsilon = 0.02),
                "{name} at damping ratio {zeta}: observed {observed}, theory {order}"
            );
        }
    }
}

/// Whether the amplitude has grown after many steps of the given size.
fn grows(name: &str, step: f64, zeta: f64) -> bool {
    let mut world = oscillator(name, step, zeta);
    let size = |world: &World| {
        let p = world.particles();
        p.position[0].y.hypot(p.velocity[0].y)
    };
    advance(&mut world, 2000);
    let early = size(&world);
    advance(&mut world, 4000);
    let late = size(&world);
    // A growing run ends by overflow: in an infinity or, one step later, in a typed error.
    !late.is_finite() || late > early.max(1e-290)
}

#[test]
fn stability_limits_match_the_amplification_matrix() {
    for (name, integrator) in NAMES {
        for zeta in [0.1, 0.3, 0.5, 0.6649, 1.0, 2.0] {
            let oscillator = Oscillator {
                frequency_squared: 1.0,
                damping_rate: 2.0 * zeta,
            };
            let critical = critical_step(integrator, oscillator);
            for (factor, expected) in [(0.995, false), (1.005, true)] {
                let step = critical * factor;
                let found = std::panic::catch_unwind(|| grows(name, step, zeta)).unwrap_or(true);
                assert_eq!(found, expected, "{name}, damping ratio {zeta}, step {step}");
            }
        }
    }
}

#[test]
fn critical_steps_have_their_closed_forms() {
    let critical = |integrator, zeta: f64| {
        critical_step(
            integrator,
            Oscillator {
                frequency_squared: 1.0,
                damping_rate: 2.0 * zeta,
            },
        )
    };
    for zeta in [0.05, 0.2, 0.5, 0.9, 1.5, 4.0_f64] {
        let root = (1.0 + zeta * zeta).sqrt();
        let euler = if zeta <= 1.0 {
            2.0 * zeta
        } else {
            2.0 * (zeta - (zeta * zeta - 1.0).sqrt())
        };
        let verlet = (16.0 * zeta * zeta + 4.0).sqrt() - 4.0 * zeta;
        let beeman = ((400.0 * zeta * zeta + 84.0).sqrt() - 20.0 * zeta) / 7.0;
        let forms = [
            (Integrator::Euler, euler),
            (Integrator::SymplecticEuler, 2.0 * (root - zeta)),
            (Integrator::VelocityVerletHalfStep, 2.0 * (root - zeta)),
            (Integrator::Taylor, (4.0 * zeta).min(1.0 / zeta)),
            (Integrator::VelocityVerlet, verlet),
            (Integrator::Beeman, beeman),
        ];
        for (integrator, form) in forms {
            let found = critical(integrator, zeta);
            assert!(
                abs_diff_eq!(found / form, 1.0, epsilon = 1e-6),
                "{integrator:?} {zeta}: {found}, {form}"
            );
        }
    }
    for integrator in [Integrator::SymplecticEuler, Integrator::VelocityVerlet] {
        assert_abs_diff_eq!(critical(integrator, 0.0), 2.0, epsilon = 1e-6);
    }
}
