//! Pay for use.

use super::scenes::{advance, head, particle, world};
use super::{Check, Effort, Failure, Measurement, Origin, Outcome, Topic};
use crate::scene::INTEGRATORS;
use gouge_kernel::World;

/// The topic.
pub fn topic() -> Topic {
    Topic {
        id: "economy",
        title: "Pay for use",
        about: "What a scene does not name costs nothing: absent and zero give the same bits.",
        checks: vec![
            Check {
                id: "economy.absent-is-zero",
                claim: "For every optional term and every integrator, absent and coefficient zero give the same bits.",
                equations: "(8)-(45), (63)-(64), (67), (72)",
                scene: "Five grains that collide, spin and fall apart, and three that are bonded; each optional term in turn with a coefficient of zero, 1000 steps",
                oracle: "The same scene without the term",
                norm: "Scenes of which any number of the state differs in any bit",
                origin: Origin::Exact,
                reason: "Adding zero changes no number, and what is absent must not be a rounding away from it",
                effort: Effort::Quick,
                measure: absent_is_zero,
            },
            Check {
                id: "economy.no-memory",
                claim: "A scene without frictional memory, bonds or driving keeps no array and no state for them.",
                equations: "-",
                scene: "The same grains with contacts alone, and with Haff-Werner friction",
                oracle: "What the world shows of its arrays",
                norm: "Arrays that are there although nothing asked for them",
                origin: Origin::Exact,
                reason: "A count that must be zero",
                effort: Effort::Quick,
                measure: no_memory,
            },
        ],
    }
}

const CONTACT: &str = "[contact.normal]\nlaw = \"kelvin-voigt\"\nstiffness = 1e7\ndamping = 2.0\n";
const BOND: &str = "[bond.normal]\nstiffness = 1e7\ndamping = 2.0\n";

fn loose(integrator: &str, more: &str) -> String {
    let grain = |i: u32| {
        let x = f64::from(i);
        particle(
            [1.9e-3 * x, 0.2e-3 * x * x],
            [2.0 - x, 0.3 * x],
            100.0 * x,
            1e-3,
        )
    };
    head(integrator, 1e-8) + more + CONTACT + &(0..5).map(grain).collect::<String>()
}

fn bonded(integrator: &str, more: &str) -> String {
    let grain = |i: u32| {
        let x = f64::from(i);
        particle(
            [2.05e-3 * x, 0.1e-3 * x * x],
            [0.5 - 0.4 * x, 0.2],
            200.0 * x,
            1e-3,
        )
    };
    let links = "[[bonds]]\nbetween = [0, 1]\n[[bonds]]\nbetween = [1, 2]\n";
    head(integrator, 1e-8) + more + BOND + &(0..3).map(grain).collect::<String>() + links
}

/// Optional terms with a coefficient of zero, for loose grains.
const FOR_LOOSE: &[&str] = &[
    "[ambient]\nlaw = \"creeping\"\nviscosity = 0.0\n",
    "[external]\nlaw = \"gravity\"\nacceleration = 0.0\n",
    "[box]\nheight = 1.0\n[external]\nlaw = \"harmonic-well\"\nstiffness = 0.0\n",
    "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 0.0\ndamping = 1.0\n",
    "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 1.0\ndamping = 0.0\n",
    "[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 0.0\nstiffness = 1e7\n",
    "[contact.tangential]\nlaw = \"cundall-strack\"\nfriction = 1.0\nstiffness = 0.0\n",
    "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 0.0\nstiffness = 1e7\n",
    "[contact.tangential]\nlaw = \"cundall-strack-truncated\"\nfriction = 1.0\nstiffness = 0.0\n",
    "[output]\nenergy = false\n",
    "[box]\nwidth = 1e3\n",
    "[contact]\ndistance = \"focal\"\n",
];

/// The same for bonded grains; a bond that is too strong to break is one without yielding.
const FOR_BONDED: &[&str] = &[
    "[bond.tangential]\nlaw = \"euler-bernoulli\"\nstiffness = 0.0\ndamping = 0.0\n",
    "[bond.yielding]\nlaw = \"zhang-eckert\"\nnormal_strength = 1e30\ntangential_strength = 1e30\n",
    "[ambient]\nlaw = \"creeping\"\nviscosity = 0.0\n",
    "[external]\nlaw = \"gravity\"\nacceleration = 0.0\n",
    "[output]\nenergy = false\n",
];

fn outcome(text: &str) -> Result<Vec<u64>, Failure> {
    let mut world = world(text)?;
    advance(&mut world, 1000)?;
    let p = world.particles();
    let vectors = p
        .position
        .iter()
        .chain(&p.velocity)
        .flat_map(|v| [v.x, v.y]);
    let all = vectors
        .chain(p.angle.iter().copied())
        .chain(p.angular_velocity.iter().copied());
    Ok(all.map(f64::to_bits).collect())
}

fn absent_is_zero() -> Outcome {
    let mut different = 0;
    for (integrator, _) in INTEGRATORS {
        let bare = outcome(&loose(integrator, ""))?;
        for term in FOR_LOOSE {
            different += usize::from(outcome(&loose(integrator, term))? != bare);
        }
        let bare = outcome(&bonded(integrator, ""))?;
        for term in FOR_BONDED {
            different += usize::from(outcome(&bonded(integrator, term))? != bare);
        }
    }
    Ok(Measurement::count(different).into())
}

fn no_memory() -> Outcome {
    let mut kept = 0;
    let rubbing = "[contact.tangential]\nlaw = \"haff-werner\"\nfriction = 0.5\ndamping = 10.0\n";
    for more in ["", rubbing] {
        let mut world: World = world(&loose("symplectic-euler", more))?;
        advance(&mut world, 100)?;
        kept += world.weak_links().map_or(0, |weak| weak.memory.capacity());
        kept += usize::from(world.strong_links().is_some());
        kept += usize::from(world.drive().force.norm() != 0.0);
    }
    Ok(Measurement::count(kept).into())
}
