//! Momentum of links.

use super::{Check, Measurement, Origin, advance, impossible, world};
use gouge_kernel::World;

/// Checks of conserved momenta.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "links.weak-angular-momentum",
            claim: "A frictional contact of unequal spheres conserves angular momentum, with each contact distance.",
            equations: "(5)-(7), (32)-(34), (42)",
            origin: Origin::Exact,
            measure: weak_angular_momentum,
        },
        Check {
            id: "links.strong-angular-momentum",
            claim: "A bent and sheared beam between unequal spheres conserves angular momentum.",
            equations: "(43)-(45)",
            origin: Origin::Exact,
            measure: strong_angular_momentum,
        },
    ]
}

fn angular_momentum(world: &World) -> f64 {
    let p = world.particles();
    let of = |i: usize| {
        p.mass[i] * p.position[i].cross(p.velocity[i])
            + p.moment_of_inertia[i] * p.angular_velocity[i]
    };
    (0..p.len()).map(of).sum()
}

fn drift(text: &str, steps: u64) -> Measurement {
    let Some(mut world) = world(text) else {
        return impossible();
    };
    let before = angular_momentum(&world);
    if !advance(&mut world, steps) {
        return impossible();
    }
    // A few roundings a step, in units of the angular momentum itself.
    let tolerance = 4.0 * f64::EPSILON * steps as f64;
    Measurement::relative(before, angular_momentum(&world), tolerance)
}

const PAIR: &str = "[[particles]]\nposition = [0.0, 0.0]\nvelocity = [3.0, -1.0]\n\
    angular_velocity = 700.0\nradius = 1e-3\n\
    [[particles]]\nposition = [2.0e-3, 1.2e-3]\nvelocity = [-2.0, 1.5]\n\
    angular_velocity = -200.0\nradius = 1.7e-3\n";

const HEAD: &str = "[time]\nstep = 1e-9\nend = 1.0\nintegrator = \"symplectic-euler\"\n\
    [material]\ndensity = 2700.0\n";

fn weak_angular_momentum() -> Measurement {
    let of = |distance: &str| {
        drift(
            &format!(
                "{HEAD}[contact]\ndistance = \"{distance}\"\n[contact.normal]\n\
                 law = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 1.0\n[contact.tangential]\n\
                 law = \"cundall-strack-truncated\"\nfriction = 0.7\nstiffness = 3e6\n{PAIR}"
            ),
            500,
        )
    };
    let all = ["radius", "focal", "mean"].map(of);
    all.into_iter().fold(
        all[0],
        |worst, one| if one.error > worst.error { one } else { worst },
    )
}

fn strong_angular_momentum() -> Measurement {
    drift(
        &format!(
            "{HEAD}[bond.normal]\nstiffness = 1e7\ndamping = 10.0\n[bond.tangential]\n\
             law = \"euler-bernoulli\"\nstiffness = 1e7\ndamping = 10.0\n{PAIR}\
             [[bonds]]\nbetween = [0, 1]\n"
        ),
        5000,
    )
}
