//! The residual of the balance against the order of the method.

use super::spheres::{RADIUS, mass};
use crate::checks::dem::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, largest,
    thesis,
};
use crate::scenes::{Draft, Grain};
use gouge_dem::laws::{AdjustedKelvinVoigt, Bshp, Controller, EulerBernoulli, KelvinVoigt};
use gouge_runner::scene::{DrivingTable, INTEGRATORS};

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
pub(super) fn largest_residual(draft: &Draft, steps: u64) -> Result<f64, Failure> {
    let mut world = draft.world()?;
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
pub(super) fn bonds() -> Draft {
    let (stiffness, damping) = (1e6, 1.0);
    Draft::empty()
        .law(AdjustedKelvinVoigt { stiffness, damping })
        .law(EulerBernoulli { stiffness, damping })
}

fn beam() -> Draft {
    let mut draft = bonds()
        .creeping_drag(0.1)
        .gravity(1e4)
        .grain(Grain::at([0.0; 2], RADIUS).fixed());
    for i in 1..5 {
        let x = i as f64;
        draft = draft.grain(Grain::at([2e-3 * x, 0.0], 1e-3 - 1e-4 * x));
        draft = draft.bonded(i - 1, i);
    }
    draft
}

/// A sphere that bounces on a fixed one without losing contact, pressed by a strong field.
fn bouncing(contact: &Draft, viscosity: f64) -> Draft {
    contact
        .clone()
        .gravity(1e6)
        .correlation_drag(viscosity, 100.0)
        .grain(Grain::at([0.0; 2], 1.2e-3).fixed())
        .grain(
            Grain::at([1e-4, 2.19e-3], RADIUS)
                .moving([0.05, -1.0])
                .spinning(30.0),
        )
}

fn driven() -> Draft {
    bonds()
        .harmonic_well(1e5)
        .with("box.height", 1e-3)
        .creeping_drag(1.0)
        .driving(DrivingTable {
            controller: Controller::Exact,
            speed: 1.0,
            pressure: 40.0,
            area: Some(1.0),
            initial_force: [0.0; 2],
        })
        .grain(Grain::at([0.0, 0.0], RADIUS).moving([1.0, 0.0]).driven())
        .grain(
            Grain::at([1.9e-3, 2e-4], 0.8e-3)
                .moving([-1.0, 0.5])
                .spinning(200.0),
        )
        .bonded(0, 1)
}

/// Name, laws and particles, and unit of time in s.
fn scenes() -> [(&'static str, Draft, f64); 4] {
    let unit = (mass(RADIUS) / 1e6_f64).sqrt();
    let viscous = Draft::empty()
        .law(KelvinVoigt {
            stiffness: 1e6,
            damping: 1.0,
        })
        .friction("haff-werner", 0.9, 0.5);
    let sticking = Draft::empty()
        .law(Bshp {
            youngs_modulus: 5e8,
            poissons_ratio: 0.22,
            dissipative_constant: 1e-7,
        })
        .friction("cundall-strack-truncated", 5.0, 2e5);
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
        for ((integrator, _), order) in INTEGRATORS.into_iter().zip([1.0, 1.0, 1.0, 2.0, 2.0]) {
            let run = |n: u64| {
                let step = 5.0 * unit / n as f64;
                Ok([
                    step / unit,
                    largest_residual(&Draft::open_box(integrator, step).and(&scene), n)?,
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
        exhibits.push(Exhibit::Figure(Figure::new(
            format!("Largest residual of the balance against the time step: {name}"),
            Axis::logarithmic("time step in units of sqrt(m / k)", ""),
            Axis::logarithmic("residual over kinetic energy", ""),
            curves,
        )));
    }
    Ok(Measurement::worst(orders).showing(exhibits))
}
