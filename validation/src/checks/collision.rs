//! Two spheres head on.

use super::{Check, Measurement, Origin, advance, impossible, world};
use crate::oracles::oscillator::truncated_restitution;

/// Checks of head-on collisions.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "collision.restitution",
            claim: "The restitution of a truncated Kelvin-Voigt collision is its closed form, from damping ratio 0.05 to 2.",
            equations: "(35), (36)",
            origin: Origin::Convergent,
            measure: restitution,
        },
        Check {
            id: "collision.thesis-parameters",
            claim: "The parameters printed for granite give a restitution of 0.2228, not the 0.83 of granite.",
            equations: "(35), (36), section 4.3",
            origin: Origin::Convergent,
            measure: thesis_parameters,
        },
        Check {
            id: "collision.elastic-hertz",
            claim: "An undamped BSHP collision of two glass spheres of 10 mm at 10 m/s each lasts as long as Hertz says.",
            equations: "(37), (40)",
            origin: Origin::Convergent,
            measure: hertz_duration,
        },
    ]
}

const MASS: f64 = 4.0 / 3.0 * std::f64::consts::PI * 2700.0 * 1e-9;

/// Restitution that the kernel finds, resolved with a step of 1e-5 of 1/w.
fn found(zeta: f64) -> Option<f64> {
    let stiffness = 1e7_f64;
    let step = 1e-5 / (2.0 * stiffness / MASS).sqrt();
    let damping = zeta * (2.0 * stiffness * MASS).sqrt();
    let text = format!(
        "[time]\nstep = {step:e}\nend = 1.0\nintegrator = \"velocity-verlet\"\n\
         [material]\ndensity = 2700.0\n[contact.normal]\nlaw = \"kelvin-voigt\"\n\
         stiffness = {stiffness:e}\ndamping = {damping:e}\n\
         [[particles]]\nposition = [-0.99999999999e-3, 0.0]\nvelocity = [0.5, 0.0]\nradius = 1e-3\n\
         [[particles]]\nposition = [0.99999999999e-3, 0.0]\nvelocity = [-0.5, 0.0]\nradius = 1e-3\n"
    );
    let mut world = world(&text)?;
    let speed = |world: &gouge_kernel::World| {
        let v = &world.particles().velocity;
        v[1].x - v[0].x
    };
    advance(&mut world, 800_000).then(|| speed(&world))
}

fn restitution() -> Measurement {
    let mut worst = Measurement::relative(1.0, 1.0, 3e-5);
    for zeta in [0.05, 0.2, 0.5, 0.8, 0.99, 1.5, 2.0] {
        let expected = truncated_restitution(zeta);
        let Some(measured) = found(zeta) else {
            return impossible();
        };
        let one = Measurement::relative(expected, measured, 3e-5);
        if one.error > worst.error {
            worst = one;
        }
    }
    worst
}

fn thesis_parameters() -> Measurement {
    let zeta = 10.0 / (2.0 * 1e7 * MASS).sqrt();
    found(zeta).map_or_else(impossible, |e| {
        Measurement::relative(0.222_769_627_052, e, 3e-5)
    })
}

/// Duration 2.9432751847 delta / v with delta the largest overlap, for 4.8 10^10 Pa, 0.2 and 2800 kg/m^3.
fn hertz_duration() -> Measurement {
    let (step, expected) = (1e-9, 4.033_945_569e-5);
    let text = format!(
        "[time]\nstep = {step:e}\nend = 1.0\nintegrator = \"velocity-verlet\"\n\
         [material]\ndensity = 2800.0\n[contact.normal]\nlaw = \"bshp\"\nyoungs_modulus = 4.8e10\n\
         poissons_ratio = 0.2\ndissipative_constant = 0.0\n\
         [[particles]]\nposition = [-10e-3, 0.0]\nvelocity = [10.0, 0.0]\nradius = 10e-3\n\
         [[particles]]\nposition = [10e-3, 0.0]\nvelocity = [-10.0, 0.0]\nradius = 10e-3\n"
    );
    let Some(mut world) = world(&text) else {
        return impossible();
    };
    let mut steps = 0_u32;
    while steps == 0 || world.contacts() > 0 {
        if !advance(&mut world, 1) {
            return impossible();
        }
        steps += 1;
    }
    // The end falls between two steps.
    Measurement::relative(expected, (f64::from(steps) - 0.5) * step, step / expected)
}
