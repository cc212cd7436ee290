//! The estimate of the stable step, on which the program's warning is based.

use super::network::linearise;
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use crate::oracles::amplification::Method;
use crate::scenes::{Draft, Grain};
use gouge_dem::laws::{AdjustedKelvinVoigt, Bshp, EulerBernoulli, KelvinVoigt};
use gouge_dem::{World, stable_step_estimate};

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "time-step.estimate",
        claim: "For a pair of equal masses with one kind of spring, the estimate of the stable step is the largest stable step itself. For a beam this holds in the limit of very unequal radii, where the stiffest mode tends to (2 + 1/c) k/m, 9/2 k/m for spheres. The moment of inertia is c m r^2.",
        equations: thesis("(36)-(45), (59)-(60)"),
        scene: "Two touching or bonded spheres of equal mass: Kelvin-Voigt; viscoelastic at an overlap of a tenth of the smaller radius; sticking friction of three laws; a stretching bond; a beam between radii of ratio ten million. Moments of inertia of 2/5, 1/2 and 3/5 m r^2 where they matter; velocity Verlet and symplectic Euler",
        oracle: "Stiffness and damping of the pair by dual numbers; critical step from the definiteness of the method's polynomial at minus one, by bisection",
        norm: "Relative error of the step",
        origin: Origin::Exact,
        reason: "The stability test behind the estimate tolerates a growth of 1e-9 per step and divides by it, which turns a rounding into 2.2e-7, half of that in the step. The oracle's bisection ends at 1e-10; overlaps and softer springs contribute 1e-12. The beam is below its limit by 2/(2 + 1/c) times the ratio of radii, 4.4e-8 for spheres",
        effort: Effort::Quick,
        measure: attained,
    }]
}

/// A pair of equal masses.
struct Case {
    name: &'static str,
    laws: Draft,
    radii: [f64; 2],
    /// Overlap in units of the smaller radius.
    overlap: f64,
    bonded: bool,
    inertia_factor: f64,
    tolerance: f64,
}

const SPHERE: f64 = 0.4;
const TOUCH: f64 = 1e-12;
const SHARP: f64 = 1.2e-7;

fn contact(name: &'static str, laws: Draft, overlap: f64) -> Case {
    Case {
        name,
        laws,
        radii: [1e-3, 1.7e-3],
        overlap,
        bonded: false,
        inertia_factor: SPHERE,
        tolerance: SHARP,
    }
}

fn bond(name: &'static str, laws: Draft, radii: [f64; 2], tolerance: f64) -> Case {
    Case {
        name,
        laws,
        radii,
        overlap: 0.0,
        bonded: true,
        inertia_factor: SPHERE,
        tolerance,
    }
}

fn cases() -> [Case; 7] {
    let touching =
        |stiffness: f64, damping: f64| Draft::empty().law(KelvinVoigt { stiffness, damping });
    let bars = Draft::empty().law(AdjustedKelvinVoigt {
        stiffness: 1e7,
        damping: 3.0,
    });
    let beams = bars.clone().law(EulerBernoulli {
        stiffness: 8e6,
        damping: 4.0,
    });
    let viscoelastic = Draft::empty().law(Bshp {
        youngs_modulus: 5e10,
        poissons_ratio: 0.22,
        dissipative_constant: 1e-6,
    });
    [
        contact("Kelvin-Voigt contact", touching(1e7, 3.0), TOUCH),
        contact("viscoelastic contact", viscoelastic, 0.1),
        contact(
            "Cundall-Strack friction",
            touching(1e7, 0.0).friction("cundall-strack", 0.5, 9e6),
            TOUCH,
        ),
        contact(
            "truncated Cundall-Strack friction",
            touching(1e7, 0.0).friction("cundall-strack-truncated", 0.5, 9e6),
            TOUCH,
        ),
        contact(
            "Haff-Werner friction",
            touching(1e-5, 0.0).friction("haff-werner", 0.5, 10.0),
            TOUCH,
        ),
        bond("stretching bond", bars, [1e-3, 1.7e-3], SHARP),
        bond("beam of unlike radii", beams, [1e-8, 1e-1], SHARP + 4.4e-8),
    ]
}

/// Cases whose stiffest mode involves rotation, with the inertia of a disc and with that of the
/// author's program.
fn turning() -> impl Iterator<Item = Case> {
    let with = |inertia_factor: f64| {
        cases()
            .into_iter()
            .filter(|case| case.laws.has("contact.tangential") || case.laws.has("bond.tangential"))
            .map(move |case| Case {
                inertia_factor,
                tolerance: SHARP
                    + if case.bonded {
                        2e-7 / (2.0 + 1.0 / inertia_factor)
                    } else {
                        0.0
                    },
                ..case
            })
    };
    with(0.5).chain(with(0.6))
}

impl Case {
    fn world(&self, integrator: &str, swapped: bool) -> Result<World, Failure> {
        let mut radii = self.radii;
        if swapped {
            radii.reverse();
        }
        let smaller = radii[0].min(radii[1]);
        let distance = radii[0] + radii[1] - self.overlap * smaller;
        let mut draft = Draft::open_box(integrator, 1e-12)
            .with("material.inertia_factor", self.inertia_factor)
            .and(&self.laws);
        // The motion is negligible, but viscous friction has no derivative at rest.
        for (x, speed, radius) in [(0.0, 1e-25, radii[0]), (distance, 0.0, radii[1])] {
            let grain = Grain::at([x, 0.0], radius).moving([0.0, speed]);
            draft = draft.grain(grain.of_density(2.7e-6 / radius.powi(3)));
        }
        if self.bonded {
            draft = draft.bonded(0, 1);
        }
        Ok(draft.world()?)
    }
}

fn attained() -> Outcome {
    let mut measured = Vec::new();
    let mut table = Table::new(
        "Largest stable step of pairs of equal mass with velocity Verlet, in s",
        &["pair", "J in m r^2", "estimate", "by the matrices"],
    );
    let methods = [
        ("velocity-verlet", Method::VelocityVerlet),
        ("symplectic-euler", Method::SymplecticEuler),
    ];
    for case in cases().into_iter().chain(turning()) {
        for (name, method) in methods {
            for swapped in [false, true] {
                let mut world = case.world(name, swapped)?;
                world.evaluate_if_pending()?;
                let estimate = stable_step_estimate(&world);
                let network = linearise(&world, *world.model())?.network;
                let exact = network.critical_step(method).unwrap_or(f64::NAN);
                measured.push(Measurement::relative(exact, estimate, case.tolerance));
                if method == Method::VelocityVerlet && !swapped {
                    let steps = [estimate, exact].map(|step| format!("{step:.10e}"));
                    let cells = [case.name.to_owned(), case.inertia_factor.to_string()];
                    table.push(cells.into_iter().chain(steps));
                }
            }
        }
    }
    Ok(Measurement::worst(measured).showing([Exhibit::Table(table)]))
}
