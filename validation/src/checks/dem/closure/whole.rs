//! The balance of a whole run of the small fault, for every law of contacts.

use crate::checks::{
    Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, largest, thesis,
};
use crate::scenes::Draft;
use gouge_dem::laws::{Bshp, HaffWerner};
use gouge_runner::run::run_setup;

pub(super) fn checks() -> Vec<Check> {
    vec![Check {
        id: "closure.small-fault",
        claim: "The balance of the small fault closes over the whole run for the laws of contacts whose forces are continuous, each at a step that is stable for it, to a thousandth of its largest term.",
        equations: thesis("(72)-(79)"),
        scene: "Built-in scene granite-fault-small, its whole set-up and 12.5 ms of shear: Kelvin-Voigt with truncated Cundall-Strack friction at 10 ns, Kelvin-Voigt with Haff-Werner friction at 4 ns, viscoelastic contacts with truncated friction at 5 ns. For comparison 2.5 ms of the printed Cundall-Strack law at 1 ns, whose force jumps",
        oracle: "A residual of zero",
        norm: "Largest residual of 200 samples, in units of the largest term of the balance until then; the worst of the three laws",
        origin: Origin::Convergent,
        reason: "The residual is of first order in the time step; the limit is fixed, far below the scatter of friction between samples, and a law at an unstable step exceeds it by a factor of a thousand",
        effort: Effort::Report,
        measure: small_fault,
    }]
}

const TOLERANCE: f64 = 1e-3;
const SAMPLES: u64 = 200;

/// A law: its name, its scene, and whether its balance must close.
fn laws() -> [(&'static str, Draft, bool); 4] {
    let fault = |step: f64| Draft::builtin("granite-fault-small").replacing("time.step", step);
    let printed = fault(1e-9)
        .replacing("time.end", 2.5e-3)
        .replacing("contact.tangential.law", "cundall-strack");
    [
        ("Kelvin-Voigt, truncated Cundall-Strack", fault(10e-9), true),
        (
            "Kelvin-Voigt, Haff-Werner",
            fault(4e-9).without("contact.tangential").law(HaffWerner {
                friction: 0.7,
                damping: 1e2,
            }),
            true,
        ),
        (
            "viscoelastic, truncated Cundall-Strack",
            fault(5e-9).without("contact.normal").law(Bshp {
                youngs_modulus: 60e9,
                poissons_ratio: 0.25,
                dissipative_constant: 1e-7,
            }),
            true,
        ),
        ("Kelvin-Voigt, printed Cundall-Strack", printed, false),
    ]
}

/// Largest residual in units of the largest term until then, and the work of the drive in J.
fn worst(draft: &Draft) -> Result<[f64; 2], Failure> {
    let scene = draft.scene()?;
    let mut world = run_setup(&scene)?;
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    for sample in 1..=SAMPLES {
        while world.steps() < scene.steps() * sample / SAMPLES {
            world.step()?;
        }
        let energy = world.energy();
        let terms = energy.values();
        let (residual, terms) = (terms[8].abs(), &terms[..8]);
        most = terms.iter().fold(most, |all, term| all.max(term.abs()));
        worst = largest([worst, residual / most]);
    }
    Ok([worst, world.energy().driving])
}

fn small_fault() -> Outcome {
    let mut table = Table::new(
        "Balance of the small fault",
        &[
            "laws",
            "step in s",
            "residual over largest term",
            "work of the drive in J",
        ],
    );
    let mut all = 0.0_f64;
    for (name, draft, must_close) in laws() {
        let step = draft.scene()?.step;
        let [residual, work] = worst(&draft)?;
        let numbers = [step, residual, work].map(|number| format!("{number:.2e}"));
        let [step, shown, work] = numbers;
        table.push([name.to_owned(), step, shown, work]);
        if must_close {
            all = largest([all, residual]);
        }
    }
    Ok(Measurement::absolute(0.0, all, TOLERANCE).showing([Exhibit::Table(table)]))
}
