//! Heat of contacts.

use super::spheres::{RADIUS, inertia, mass};
use crate::checks::dem::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, thesis,
};
use crate::oracles::dissipation::viscoelastic_restitution;
use crate::oracles::oscillator::truncated_restitution;
use crate::scenes::{Draft, Grain, events};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{Bshp, KelvinVoigt};

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "closure.heat-of-collision",
            claim: "A damped collision books 1 - e^2 of the kinetic energy as heat.",
            equations: thesis("(36), (72), (78)"),
            scene: "Two equal spheres collide head on, truncated Kelvin-Voigt, damping ratios from 0.01 to 3; velocity Verlet, at least 5000 steps per unit of time",
            oracle: "Closed form of the restitution e of the truncated oscillator",
            norm: "Heat over kinetic energy, minus 1 - e^2",
            origin: Origin::Convergent,
            reason: "h^2, with h the time step in units of the fastest rate: local errors of h^3/12 in the velocity and h^3/6 in the position over about two units of time, and a kink of the force at the end of the same order",
            effort: Effort::Quick,
            measure: collision,
        },
        Check {
            id: "closure.heat-of-viscoelastic-collision",
            claim: "A collision of viscoelastic spheres books 1 - e^2 of the kinetic energy as heat.",
            equations: thesis("(37), (40), (72), (78)"),
            scene: "Two equal granite spheres collide head on, six dissipative constants; velocity Verlet, 1e4 steps per unit of time",
            oracle: "Restitution e by extrapolated integration of x'' = -sqrt(x) (x + b x')",
            norm: "Heat over kinetic energy, minus 1 - e^2",
            origin: Origin::Convergent,
            reason: "2 |Z(-1/2)| b h^(3/2) + h^2, with Z(-1/2) = -0.2079 from Riemann's zeta function: at the onset the dissipative force is b sqrt(t), and the trapezoidal rule makes a velocity error of Z(-1/2) b h^(3/2), which counts twice in the heat",
            effort: Effort::Quick,
            measure: viscoelastic,
        },
        Check {
            id: "closure.heat-of-sliding",
            claim: "A sphere that spins between two fixed ones under constant load books the friction limit times the sliding distance.",
            equations: thesis("(41), (42), (78)"),
            scene: "A sphere between two fixed ones that press it with 15 mN each spins and slides for 2000 steps of velocity Verlet; Haff-Werner, printed and truncated Cundall-Strack",
            oracle: "mu N times the sliding distance. Haff-Werner: the distance under constant deceleration. Truncated law: the path of the surface minus the stretch mu N / k. Printed law: the path minus half the stretch, whose energy is booked when sliding starts, plus half a step, because the power is summed by the trapezoidal rule across the switch",
            norm: "Relative error of the heat",
            origin: Origin::Exact,
            reason: "At most one rounding of 2^-53 per step in each of two sums, 2000 steps; for the printed law also k d^2 / 2 of stored energy, with d the path in the step in which sliding starts",
            effort: Effort::Quick,
            measure: sliding,
        },
    ]
}

/// Heat of a collision over its kinetic energy, with the given time step.
fn heat_share(contact: &Draft, step: f64, speed: f64) -> Result<f64, Failure> {
    let mut world = events::head_on(Integrator::VelocityVerlet, step, speed)
        .and(contact)
        .world()?;
    while world.number_of_contacts() > 0 {
        advance(&mut world, 64)?;
    }
    Ok(world.energy().friction / (mass(RADIUS) * speed * speed))
}

fn collision() -> Outcome {
    let (stiffness, h) = (1e7, 2e-4);
    let rate = (2.0 * stiffness / mass(RADIUS)).sqrt();
    let (mut all, mut marks) = (Vec::new(), Vec::new());
    for zeta in [
        0.01, 0.0616, 0.1, 0.2, 0.35, 0.5, 0.665, 0.8, 0.99, 1.5, 3.0,
    ] {
        let damping = zeta * (2.0 * stiffness * mass(RADIUS)).sqrt();
        let fastest = rate * (1.0_f64).max(2.0 * zeta);
        let share = heat_share(
            &Draft::empty().law(KelvinVoigt { stiffness, damping }),
            h / fastest,
            0.5,
        )?;
        let e = truncated_restitution(zeta);
        all.push(Measurement::absolute(1.0 - e * e, share, h * h));
        marks.push([zeta, share]);
    }
    let line = (0..=120).map(|i| {
        let zeta = 0.01 * 300.0_f64.powf(f64::from(i) / 120.0);
        [zeta, 1.0 - truncated_restitution(zeta).powi(2)]
    });
    let plot = Figure::new(
        "Heat of a truncated Kelvin-Voigt collision against the damping ratio",
        Axis::logarithmic("damping ratio", ""),
        Axis::linear("heat over kinetic energy", ""),
        vec![
            Curve::line("1 - e^2, closed form", line),
            Curve::marks("heat booked", marks),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

fn viscoelastic() -> Outcome {
    let (modulus, ratio, speed, h) = (50e9, 0.22, 0.5, 1e-4);
    // Hertz: force = (4/3) E* sqrt(R*) x^(3/2), E* = Y / (2 (1 - nu^2)) and R* = r / 2 for equal spheres.
    let force = 4.0 / 3.0 * modulus / (2.0 * (1.0 - ratio * ratio)) * (0.5 * RADIUS).sqrt();
    let kappa: f64 = force / (0.5 * mass(RADIUS));
    let time = kappa.powf(-0.4) * f64::powf(2.0 * speed, -0.2);
    let mut all = Vec::new();
    for b in [0.01, 0.05, 0.17, 0.5, 1.0, 2.0] {
        let contact = Draft::empty().law(Bshp {
            youngs_modulus: modulus,
            poissons_ratio: ratio,
            dissipative_constant: b * time,
        });
        let share = heat_share(&contact, h * time, speed)?;
        let e = viscoelastic_restitution(b);
        let tolerance = 2.0 * 0.207886 * b * h.powf(1.5) + h * h;
        all.push(Measurement::absolute(1.0 - e * e, share, tolerance));
    }
    Ok(Measurement::worst(all).into())
}

/// Radius, overlap, stiffness and friction coefficient of the sphere between two fixed ones; length and
/// overlap are powers of two, so that lengths and loads are exact.
pub(super) const HELD: f64 = 0.0009765625;
pub(super) const SQUEEZE: f64 = 1.52587890625e-5;
pub(super) const STIFFNESS: f64 = 1e3;
pub(super) const FRICTION: f64 = 0.5;
pub(super) const SPIN: f64 = 5000.0;
const STEP: f64 = 1e-7;
/// Stiffness of the laws with a tangential spring.
pub(super) const SPRING: f64 = 1e3;

/// A sphere that spins between two fixed ones; `place` is its position in the list of particles.
pub(super) fn held(law: &str, place: usize) -> Draft {
    held_at(law, place, "velocity-verlet", STEP)
}

/// The same with a given integrator and time step.
pub(super) fn held_at(law: &str, place: usize, integrator: &str, step: f64) -> Draft {
    let reach = 2.0 * HELD - SQUEEZE;
    let parameter = if law == "haff-werner" { 1e3 } else { SPRING };
    let mut spheres = vec![
        Grain::at([-reach, 0.0], HELD).fixed(),
        Grain::at([reach, 0.0], HELD).fixed(),
    ];
    spheres.insert(place, Grain::at([0.0; 2], HELD).spinning(SPIN));
    Draft::open_box(integrator, step)
        .law(KelvinVoigt {
            stiffness: STIFFNESS,
            damping: 0.0,
        })
        .friction(law, FRICTION, parameter)
        .grains(spheres)
}

fn sliding() -> Outcome {
    const STEPS: u32 = 2000;
    let limit = FRICTION * STIFFNESS * SQUEEZE;
    let rounding = 2.0 * f64::from(STEPS) * 0.5 * f64::EPSILON;
    let mut all = Vec::new();
    for law in ["haff-werner", "cundall-strack-truncated", "cundall-strack"] {
        let mut world = held(law, 0).world()?;
        advance(&mut world, u64::from(STEPS))?;
        let time = f64::from(STEPS) * STEP;
        let deceleration = 2.0 * limit * HELD / inertia(HELD);
        let surface = HELD * world.particles().angle[0];
        let step = HELD * SPIN * STEP;
        let (distance, slack) = match law {
            "haff-werner" => (HELD * (SPIN * time - 0.5 * deceleration * time * time), 0.0),
            // The stored energy is booked when sliding starts: half the limit times the stretch.
            "cundall-strack" => (
                surface - 0.5 * limit / SPRING + 0.5 * step,
                0.5 * SPRING * step * step / (limit * surface),
            ),
            _ => (surface - limit / SPRING, 0.0),
        };
        let heat = world.energy().friction;
        all.push(Measurement::relative(
            2.0 * limit * distance,
            heat,
            rounding + slack,
        ));
    }
    Ok(Measurement::worst(all).into())
}
