//! Events that several files use, each with the parts that it leaves open as arguments.

use super::draft::{Draft, Method};
use super::grain::Grain;

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
