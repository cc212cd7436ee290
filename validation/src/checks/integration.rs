//! Order of the integrators on smooth motion.

use super::{Check, Measurement, Origin, advance, impossible, world};
use crate::oracles::oscillator::released;

/// Checks of observed orders.
pub fn checks() -> Vec<Check> {
    let check = |id, equations, measure| Check {
        id,
        claim: "The error on a damped oscillator falls with the order of the method.",
        equations,
        origin: Origin::Convergent,
        measure,
    };
    vec![
        check("order.euler", "(55)", || order("euler", 1.0)),
        check("order.symplectic-euler", "-", || {
            order("symplectic-euler", 1.0)
        }),
        check("order.taylor", "(56)", || order("taylor", 1.0)),
        check("order.velocity-verlet", "-", || {
            order("velocity-verlet", 2.0)
        }),
        check("order.beeman", "(57), (58)", || order("beeman", 2.0)),
    ]
}

const ZETA: f64 = 0.3;
const END: f64 = 3.0;

fn error(integrator: &str, steps: u64) -> Option<f64> {
    let radius = (3.0 / (4.0 * std::f64::consts::PI * 2700.0)).cbrt();
    let viscosity = 2.0 * ZETA / (6.0 * std::f64::consts::PI * radius);
    let text = format!(
        "[time]\nstep = {:e}\nend = 9.0\nintegrator = \"{integrator}\"\n\
         [material]\ndensity = 2700.0\n[box]\nheight = 1e-300\n\
         [external]\nlaw = \"harmonic-well\"\nstiffness = 1.0\n\
         [ambient]\nlaw = \"creeping\"\nviscosity = {viscosity:e}\n\
         [[particles]]\nposition = [0.0, 1.0]\nradius = {radius:e}\n",
        END / steps as f64
    );
    let mut world = world(&text)?;
    let ok = advance(&mut world, steps);
    ok.then(|| (world.particles().position[0].y - released(END, ZETA)).abs())
}

fn order(integrator: &str, expected: f64) -> Measurement {
    let errors = [1600, 3200, 6400].map(|steps| error(integrator, steps));
    let [Some(_), Some(coarse), Some(fine)] = errors else {
        return impossible();
    };
    Measurement::absolute(expected, (coarse / fine).log2(), 0.01)
}
