//! Events that several files use, each with the parts that it leaves open as arguments.

use super::draft::{Draft, Method};
use super::grain::{Bond, Grain};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::AdjustedKelvinVoigt;
use std::f64::consts::PI;

/// Radius of the grains of these events in m.
pub const RADIUS: f64 = 1e-3;

/// Two equal grains that just touch and approach head on, each with a speed in m/s.
pub fn head_on(method: impl Into<Method>, step: f64, speed: f64) -> Draft {
    rubbing(method, step, speed, [0.0; 2])
}

/// Two equal grains that just touch and approach head on, each with a speed in m/s and a spin in rad/s of its own.
pub fn rubbing(method: impl Into<Method>, step: f64, speed: f64, spins: [f64; 2]) -> Draft {
    let just = RADIUS.next_down();
    let grain = |side: f64, spin: f64| {
        Grain::at([side * just, 0.0], RADIUS)
            .moving([-side * speed, 0.0])
            .spinning(spin)
    };
    Draft::open_box(method, step)
        .grain(grain(-1.0, spins[0]))
        .grain(grain(1.0, spins[1]))
}

/// A grain with a spin in rad/s between two fixed ones, one below and one above at a distance in m.
pub fn held(method: impl Into<Method>, step: f64, distance: f64, spin: f64) -> Draft {
    let fixed = |y: f64| Grain::at([0.0, y], RADIUS).fixed();
    Draft::open_box(method, step)
        .grain(Grain::at([0.0; 2], RADIUS).spinning(spin))
        .grain(fixed(-distance))
        .grain(fixed(distance))
}

/// A grain of 1 kg in a harmonic well of angular frequency 1/s, released at 1 m, in a drag with a damping ratio.
pub fn oscillator(method: impl Into<Method>, step: f64, damping_ratio: f64) -> Draft {
    let radius = (3.0 / (4.0 * PI * 2700.0)).cbrt();
    Draft::open_box(method, step)
        .grain(Grain::at([0.0, 1.0], radius))
        .with("box.height", 1e-300)
        .harmonic_well(1.0)
        .creeping_drag(2.0 * damping_ratio / (6.0 * PI * radius))
}

/// Ten grains in a row along a unit vector, bonded by undamped springs of 1e7 kg/s^2 that began at a distance of 2 mm
/// and now have another one in m.
pub fn stretched_chain(direction: [f64; 2], distance: f64) -> Draft {
    let grain = |i: u32| Grain::at(direction.map(|d| f64::from(i) * distance * d), RADIUS);
    let bond = |i: usize| Bond::between(i - 1, i).of_length(2.0 * RADIUS);
    let chain = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .grains((0..10).map(grain));
    (1..10).map(bond).fold(chain, Draft::bond)
}
