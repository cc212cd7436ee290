//! The residual of the balance against the order of the method.

use super::text::{RADIUS, fixed, friction, kelvin_voigt, mass};
use crate::checks::dem::scenes::{advance, head, particle, world};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Plot, largest,
    thesis,
};
use gouge_runner::scene::INTEGRATORS;

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "closure.order",
        claim: "On smooth motion the residual of the balance falls with the order of the method: two for velocity Verlet and Beeman, one for both Euler methods and Taylor.",
        equations: thesis("(54)-(58), (72)-(79)"),
        scene: "A swinging beam of unequal grains with gravity and drag; a sphere that bounces on a fixed one without losing contact, Kelvin-Voigt with Haff-Werner friction or viscoelastic with a sticking truncated spring; a driven pair of bonded grains in a well",
        oracle: "Order of the method",
        norm: "Largest distance from the theoretical order of an order observed from the largest residuals with 1600 and 3200 steps",
        origin: Origin::Convergent,
        reason: "The next term of the error is smaller by the time step in units of the fastest rate, 3e-3, times a constant of about ten",
        effort: Effort::Quick,
        measure: smooth,
    }]
}

/// Largest residual of a run over its largest kinetic energy, sampled a hundred times.
pub(super) fn largest_residual(text: &str, steps: u64) -> Result<f64, Failure> {
    let mut world = world(text)?;
    let (mut residual, mut scale) = (0.0_f64, 0.0_f64);
    for _ in 0..100 {
        advance(&mut world, steps / 100)?;
        let energy = world.energy();
        residual = largest([residual, energy.residual.abs()]);
        scale = scale.max(energy.kinetic);
    }
    Ok(residual / scale)
}

/// Laws of bonds.
pub(super) const BONDS: &str = "[bond.normal]\nstiffness = 1e6\ndamping = 1.0\n\
    [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e6\ndamping = 1.0\n";

fn beam() -> String {
    let mut text = format!(
        "{BONDS}[ambient]\nlaw = \"creeping\"\nviscosity = 0.1\n\
         [external]\nlaw = \"gravity\"\nacceleration = 1e4\n"
    ) + &fixed([0.0; 2], RADIUS);
    for i in 1..5 {
        let x = f64::from(i);
        text += &particle([2e-3 * x, 0.0], [0.0; 2], 0.0, 1e-3 - 1e-4 * x);
        text += &format!("[[bonds]]\nbetween = [{}, {i}]\n", i - 1);
    }
    text
}

/// A sphere that bounces on a fixed one without losing contact, pressed by a strong field.
fn bouncing(contact: &str, viscosity: f64) -> String {
    contact.to_owned()
        + &format!(
            "[external]\nlaw = \"gravity\"\nacceleration = 1e6\n\
             [ambient]\nlaw = \"correlation\"\ndensity = 100.0\nviscosity = {viscosity:e}\n"
        )
        + &fixed([0.0; 2], 1.2e-3)
        + &particle([1e-4, 2.19e-3], [0.05, -1.0], 30.0, RADIUS)
}

fn driven() -> String {
    format!(
        "{BONDS}[external]\nlaw = \"harmonic-well\"\nstiffness = 1e5\n[box]\nheight = 1e-3\n\
         [ambient]\nlaw = \"creeping\"\nviscosity = 1.0\n\
         [driving]\ncontroller = \"exact\"\nspeed = 1.0\npressure = 40.0\narea = 1.0\n"
    ) + &particle([0.0, 0.0], [1.0, 0.0], 0.0, RADIUS)
        + "role = \"driven\"\n"
        + &particle([1.9e-3, 2e-4], [-1.0, 0.5], 200.0, 0.8e-3)
        + "[[bonds]]\nbetween = [0, 1]\n"
}

/// Name, laws and particles, and unit of time in s.
fn scenes() -> [(&'static str, String, f64); 4] {
    let unit = (mass(RADIUS) / 1e6_f64).sqrt();
    let viscous = kelvin_voigt(1e6, 1.0) + &friction("haff-werner", 0.9, 0.5);
    let sticking = "[contact.normal]\nlaw = \"bshp\"\nyoungs_modulus = 5e8\npoissons_ratio = 0.22\n\
        dissipative_constant = 1e-7\n"
        .to_owned() + &friction("cundall-strack-truncated", 5.0, 2e5);
    [
        ("beam", beam(), unit),
        ("Kelvin-Voigt, Haff-Werner", bouncing(&viscous, 0.5), unit),
        ("viscoelastic, sticking", bouncing(&sticking, 0.5), unit),
        ("driven", driven(), unit),
    ]
}

fn smooth() -> Outcome {
    let steps = [400, 800, 1600, 3200];
    let (mut orders, mut exhibits) = (Vec::new(), Vec::new());
    for (name, scene, unit) in scenes() {
        let mut curves = Vec::new();
        for ((integrator, _), order) in INTEGRATORS.iter().zip([1.0, 1.0, 1.0, 2.0, 2.0]) {
            let run = |n: u64| {
                let step = 5.0 * unit / n as f64;
                Ok([
                    step / unit,
                    largest_residual(&(head(integrator, step) + &scene), n)?,
                ])
            };
            let points = steps
                .into_iter()
                .map(run)
                .collect::<Result<Vec<_>, Failure>>()?;
            let observed = (points[2][1] / points[3][1]).log2();
            orders.push(Measurement::absolute(order, observed, 0.03));
            curves.push(Curve::marked_line(integrator, points));
        }
        exhibits.push(Exhibit::Plot(Plot {
            title: format!("Largest residual of the balance against the time step: {name}"),
            x: Axis::logarithmic("time step in units of sqrt(m / k)"),
            y: Axis::logarithmic("residual over kinetic energy"),
            curves,
        }));
    }
    Ok(Measurement::worst(orders).showing(exhibits))
}
