//! The residual of the balance falls with the order of the method.

use crate::checks::scenes::{advance, head, particle, world};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Plot,
};
use crate::scene::INTEGRATORS;
use gouge_kernel::World;

pub(super) fn checks() -> Vec<Check> {
    let check = |id, claim, scene, measure| Check {
        id,
        claim,
        equations: "(72)-(79)",
        scene,
        oracle: "Zero residual in the limit of small steps",
        norm: "Distance of the order of the residual, from the two finest steps, to that of theory",
        origin: Origin::Convergent,
        reason: "One for both Euler methods and Taylor, two for velocity Verlet and Beeman, as for the motion; the next term is smaller by w dt, below 0.03",
        effort: Effort::Quick,
        measure,
    };
    vec![
        check(
            "closure.beam",
            "The balance of a swinging, damped beam under gravity in a viscous medium closes with the order of each method.",
            "Five bonded grains of falling size, the first fixed, released under gravity; all terms of the balance but friction and breaking",
            beam,
        ),
        check(
            "closure.rubbing",
            "So does that of a viscoelastic collision that rubs viscously.",
            "Two spheres that overlap and fly past each other with Haff-Werner friction below its limit and BSHP contact, while they touch",
            rubbing,
        ),
        check(
            "closure.sticking",
            "So does that of a collision that sticks to a tangential spring.",
            "Two spheres that overlap, with Kelvin-Voigt contact and a Cundall-Strack spring below its limit, while they touch",
            sticking,
        ),
    ]
}

const ORDERS: [f64; 5] = [1.0, 1.0, 1.0, 2.0, 2.0];

/// Residuals for some numbers of steps that cover the same time, for each method.
fn study(scene: impl Fn(&str, f64) -> String, end: f64, steps: [u64; 4]) -> Outcome {
    let (mut orders, mut curves) = (Vec::new(), Vec::new());
    for ((name, _), order) in INTEGRATORS.iter().zip(ORDERS) {
        let residual = |&steps: &u64| -> Result<f64, Failure> {
            let mut world: World = world(&scene(name, end / steps as f64))?;
            advance(&mut world, steps)?;
            Ok(world.energy().residual.abs())
        };
        let found = steps
            .iter()
            .map(residual)
            .collect::<Result<Vec<f64>, Failure>>()?;
        orders.push(Measurement::absolute(
            order,
            (found[2] / found[3]).log2(),
            0.05,
        ));
        let points = steps
            .iter()
            .zip(&found)
            .map(|(&n, &residual)| [end / n as f64, residual]);
        curves.push(Curve::marked_line(name, points));
    }
    let plot = Plot {
        title: "Residual of the balance at the end against the step".to_owned(),
        x: Axis::logarithmic("step in s"),
        y: Axis::logarithmic("residual in J"),
        curves,
    };
    Ok(Measurement::worst(orders).showing([Exhibit::Plot(plot)]))
}

fn beam() -> Outcome {
    let scene = |integrator: &str, step: f64| {
        let mut text = head(integrator, step)
            + "[bond.normal]\nstiffness = 1e6\ndamping = 1.0\n\
               [bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 1e6\ndamping = 1.0\n\
               [ambient]\nlaw = \"creeping\"\nviscosity = 0.1\n\
               [external]\nlaw = \"gravity\"\nacceleration = 1e4\n\
               [[particles]]\nposition = [0.0, 0.0]\nradius = 1e-3\nrole = \"fixed\"\n";
        for i in 1..5 {
            let place = f64::from(i);
            text += &particle([2e-3 * place, 0.0], [0.0, 0.0], 0.0, 1e-3 - 1e-4 * place);
            text += &format!("[[bonds]]\nbetween = [{}, {i}]\n", i - 1);
        }
        text
    };
    study(scene, 1e-4, [2000, 4000, 8000, 16_000])
}

fn pair(integrator: &str, step: f64, laws: &str, spin: f64) -> String {
    head(integrator, step)
        + laws
        + &particle([0.0, 0.0], [0.2, 0.1], spin, 1e-3)
        + &particle([1.95e-3, 0.3e-3], [-0.3, 0.15], -0.5 * spin, 1.1e-3)
}

fn rubbing() -> Outcome {
    let laws = "[contact.normal]\nlaw = \"bshp\"\nyoungs_modulus = 5e9\npoissons_ratio = 0.2\ndissipative_constant = 1e-7\n\
        [contact.tangential]\nlaw = \"haff-werner\"\nfriction = 1e6\ndamping = 2.0\n";
    study(
        |integrator, step| pair(integrator, step, laws, 300.0),
        1e-6,
        [500, 1000, 2000, 4000],
    )
}

fn sticking() -> Outcome {
    let laws = "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 1.0\n\
        [contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 1e6\nstiffness = 3e6\n";
    study(
        |integrator, step| pair(integrator, step, laws, 300.0),
        1e-6,
        [500, 1000, 2000, 4000],
    )
}
