//! Whether a run judges itself rightly: scenes whose results are known to be good or bad.
//!
//! What is right is found without the energy balance and the bounds: by comparing the outcome of a scene with that of
//! the same scene at a much smaller step.

use crate::worlds::scene;
use gouge_dem::integrators::{Integrator, Oscillator, critical_step};
use gouge_dem::laws::{AdjustedKelvinVoigt, Bshp, EulerBernoulli, KelvinVoigt, ZhangEckert};
use gouge_runner::error::Error;
use gouge_runner::run::{Event, RunOptions, Summary, run};
use gouge_validation::scenes::events::{RADIUS, held, oscillator, rubbing};
use gouge_validation::scenes::fault::brief;
use gouge_validation::scenes::{Draft, Grain};
use std::f64::consts::PI;

/// Mass of a grain in kg.
const MASS: f64 = 2700.0 * 4.0 / 3.0 * PI * RADIUS * RADIUS * RADIUS;
/// Stiffness of contacts and bonds in kg/s^2.
const STIFFNESS: f64 = 1e7;
/// Factor between the step of a scene and that of the run that tells what is right.
const FINER: f64 = 32.0;
/// Error of the outcome below which results are good.
const GOOD: f64 = 0.05;
/// Error of the outcome above which results are bad.
const BAD: f64 = 0.1;

/// Spin of a held grain in rad/s.
const SPIN: f64 = 100.0;

const ALL: [Integrator; 5] = [
    Integrator::Euler,
    Integrator::SymplecticEuler,
    Integrator::Taylor,
    Integrator::VelocityVerlet,
    Integrator::Beeman,
];

/// A scene as a function of its step.
struct Case {
    name: String,
    draft: Box<dyn Fn(f64) -> Draft>,
    step: f64,
    is_good: bool,
    /// Energy in J that errors are compared with; if absent, the largest one.
    scale: Option<f64>,
}

fn case(name: &str, step: f64, is_good: bool, draft: impl Fn(f64) -> Draft + 'static) -> Case {
    Case {
        name: name.to_owned(),
        draft: Box::new(draft),
        step,
        is_good,
        scale: None,
    }
}

/// A good and a bad case of a scene, with the steps in units of a bound.
fn both(
    name: &str,
    bound: f64,
    shares: [f64; 2],
    draft: impl Fn(f64) -> Draft + Clone + 'static,
) -> [Case; 2] {
    [true, false].map(|is_good| {
        let share = shares[usize::from(!is_good)];
        case(
            &format!("{name}, {share} of the bound"),
            share * bound,
            is_good,
            draft.clone(),
        )
    })
}

/// Cases whose errors are compared with an energy in J.
fn beside(energy: f64, cases: [Case; 2]) -> [Case; 2] {
    cases.map(|case| Case {
        scale: Some(energy),
        ..case
    })
}

/// The energies of the last state, or none if the run stopped at an error; and whether the run doubts its results.
fn outcome(draft: &Draft) -> (Option<[f64; 4]>, bool) {
    let folder = tempfile::tempdir().expect("a folder");
    let options = RunOptions {
        resume: false,
        overwrite: false,
        data_only: false,
        checkpoint_interval: f64::INFINITY,
    };
    let mut warnings = 0;
    let mut observer = |event: Event<'_>| {
        if matches!(event, Event::Warning(_)) {
            warnings += 1;
        }
    };
    match run(&scene(draft), folder.path(), options, &mut observer) {
        Ok(summary) => (Some(energies(&summary)), warnings > 0),
        Err(Error::Step { .. } | Error::Energy { .. }) => (None, true),
        Err(error) => panic!("{error}"),
    }
}

fn energies(summary: &Summary) -> [f64; 4] {
    let energy = summary.energy.as_ref().expect("energies");
    let of = |name: &str| energy[name].as_f64().expect("a number");
    ["kinetic", "contact", "external", "driving"].map(of)
}

/// Largest difference of two outcomes, in units of the largest energy of the good one, or of its beginning.
fn error_of(found: Option<[f64; 4]>, right: [f64; 4], scale: f64) -> f64 {
    let Some(found) = found else {
        return f64::INFINITY;
    };
    let errors = found.iter().zip(right).map(|(a, b)| (a - b).abs());
    let error = errors.fold(0.0, f64::max) / scale;
    if error.is_nan() { f64::INFINITY } else { error }
}

fn check(case: &Case) -> Result<(), String> {
    let (found, is_doubted) = outcome(&(case.draft)(case.step));
    let (right, _) = outcome(&(case.draft)(case.step / FINER));
    let right = right.expect("a fine step is stable");
    let start = energies_at_start(&(case.draft)(case.step / FINER));
    let scale = right.iter().chain(&start).copied().map(f64::abs);
    let largest = scale.fold(f64::MIN_POSITIVE, f64::max);
    let error = error_of(found, right, case.scale.unwrap_or(largest));
    let is_as_known = if case.is_good {
        error < GOOD
    } else {
        error > BAD
    };
    if !is_as_known {
        return Err(format!(
            "{}: the scene is not as good or bad as said: {error:e}",
            case.name
        ));
    }
    match is_doubted == case.is_good {
        true if case.is_good => Err(format!("{}: false alarm, error {error:e}", case.name)),
        true => Err(format!("{}: silent, error {error:e}", case.name)),
        false => Ok(()),
    }
}

fn energies_at_start(draft: &Draft) -> [f64; 4] {
    let energy = scene(draft).initial_world().map(|world| world.energy());
    energy.map_or([0.0; 4], |one| [one.kinetic, one.contact, 0.0, 0.0])
}

/// The step in s at which the oscillation of a pair with a damping ratio grows.
fn pair_bound(method: Integrator, damping_ratio: f64) -> f64 {
    let frequency = (2.0 * STIFFNESS / MASS).sqrt();
    critical_step(
        method,
        Oscillator {
            frequency_squared: frequency * frequency,
            damping_rate: 2.0 * damping_ratio * frequency,
        },
    )
}

/// Two grains that are 0.1 um apart and collide head on, in a frame that moves with a velocity in m/s.
fn collision(method: Integrator, step: f64, damping_ratio: f64, frame: f64) -> Draft {
    let frequency = (2.0 * STIFFNESS / MASS).sqrt();
    let grain =
        |side: f64| Grain::at([side * 1.0001 * RADIUS, 0.0], RADIUS).moving([frame - side, 0.0]);
    Draft::open_box(method, step)
        .ending_at(2.0 * PI / frequency)
        .law(KelvinVoigt {
            stiffness: STIFFNESS,
            damping: damping_ratio * frequency * MASS,
        })
        .grain(grain(-1.0))
        .grain(grain(1.0))
}

fn collisions() -> Vec<Case> {
    let mut cases = Vec::new();
    for method in ALL {
        let name = format!("damped collision, {method:?}");
        let bound = pair_bound(method, 0.2);
        cases.extend(both(&name, bound, [0.05, 2.5], move |step| {
            collision(method, step, 0.2, 0.0)
        }));
    }
    for method in [Integrator::SymplecticEuler, Integrator::VelocityVerlet] {
        let name = format!("elastic collision, {method:?}");
        let bound = pair_bound(method, 0.0);
        cases.extend(both(&name, bound, [0.05, 1.3], move |step| {
            collision(method, step, 0.0, 0.0)
        }));
    }
    // Below the bound, a contact that begins inside a step gains energy; only the balance shows it.
    let verlet = pair_bound(Integrator::VelocityVerlet, 0.0);
    cases.push(case("late contact", 0.9 * verlet, false, |step| {
        collision(Integrator::VelocityVerlet, step, 0.0, 0.0)
    }));
    // Falling together, or beside a fast grain that touches nothing, two grains collide like at rest.
    for (name, hiding) in [("falling", 1), ("beside a fast grain", 2)] {
        let draft = move |step: f64| {
            let draft = collision(Integrator::VelocityVerlet, step, 0.0, 0.0);
            match hiding {
                1 => draft
                    .gravity(1e-9)
                    .replacing("particles.0.velocity", vec![1.0, -30.0])
                    .replacing("particles.1.velocity", vec![-1.0, -30.0]),
                _ => draft
                    .grain(Grain::at([0.0, 1.0], RADIUS).moving([0.0, 30.0]))
                    .grain(Grain::at([0.0, -1.0], RADIUS).fixed()),
            }
        };
        cases.extend(beside(MASS, both(name, verlet, [0.05, 0.9], draft)));
    }
    // The energy of the common motion is 10^4 times that of the collision.
    let moving = both("moving frame", verlet, [0.05, 0.9], |step| {
        collision(Integrator::VelocityVerlet, step, 0.0, 100.0)
    });
    cases.extend(beside(MASS, moving));
    cases
}

fn bshp() -> Vec<Case> {
    let draft = |method: Integrator, step: f64| {
        let grain = |side: f64| {
            Grain::at([side * 1.0001 * RADIUS, 0.0], RADIUS).moving([-side * 10.0, 0.0])
        };
        Draft::open_box(method, step)
            .ending_at(20e-6)
            .law(Bshp {
                youngs_modulus: 60e9,
                poissons_ratio: 0.25,
                dissipative_constant: 1e-7,
            })
            .grain(grain(-1.0))
            .grain(grain(1.0))
    };
    let methods = [Integrator::VelocityVerlet, Integrator::Taylor];
    let pairs = methods.map(|method| {
        both(
            &format!("viscoelastic collision, {method:?}"),
            1e-6,
            [0.01, 2.0],
            move |step| draft(method, step),
        )
    });
    pairs.into_iter().flatten().collect()
}

/// Two grains that collide while they rub.
fn friction() -> Vec<Case> {
    let draft = |law: &str, constant: f64, step: f64| {
        rubbing(Integrator::VelocityVerlet, step, 1.0, [300.0, 300.0])
            .ending_at(12e-6)
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping: 1.0,
            })
            .friction(law, 0.5, constant)
    };
    // A grain that turns between two fixed ones, without damping of the normal motion.
    let viscous = |step: f64| {
        held(Integrator::VelocityVerlet, step, 1.99 * RADIUS, SPIN)
            .ending_at(2e-6)
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .friction("haff-werner", 0.5, 300.0)
    };
    let bound = 2.0 * MASS / (2.0 * 2.5 * 300.0);
    let turning = 0.5 * 0.4 * MASS * (RADIUS * SPIN).powi(2);
    let turned = both("haff-werner", bound, [0.02, 3.0], viscous);
    let mut cases = Vec::from(beside(turning, turned));
    let elastic = 2.0 / (2.0 / MASS * 3.5 * 3.0 * STIFFNESS).sqrt();
    for law in ["cundall-strack-truncated", "cundall-strack"] {
        cases.extend(both(law, elastic, [0.02, 3.0], move |step| {
            draft(law, 3.0 * STIFFNESS, step)
        }));
    }
    cases
}

fn bonds() -> Vec<Case> {
    let bonded = |step: f64, speed: [f64; 2], spin: f64| {
        let grain = |side: f64| {
            Grain::at([side * RADIUS, 0.0], RADIUS)
                .moving(speed.map(|v| side * v))
                .spinning(side * spin)
        };
        Draft::open_box(Integrator::VelocityVerlet, step)
            .ending_at(15e-6)
            .law(AdjustedKelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .law(EulerBernoulli {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .grain(grain(-1.0))
            .grain(grain(1.0))
            .bonded(0, 1)
    };
    let axial = 2.0 / (2.0 * STIFFNESS / MASS).sqrt();
    let shear = 2.0 / (3.5 * STIFFNESS / MASS).sqrt();
    let breaking = move |step: f64| {
        bonded(step, [1.0, 0.0], 0.0).law(ZhangEckert {
            normal_strength: 1e9,
            tangential_strength: 1e9,
        })
    };
    let torn = move |step: f64| {
        bonded(step, [5.0, 0.0], 0.0).law(ZhangEckert {
            normal_strength: 3e6,
            tangential_strength: 3e6,
        })
    };
    let mut cases = Vec::new();
    cases.extend(both("stretched bond", axial, [0.05, 1.1], move |step| {
        bonded(step, [1.0, 0.0], 0.0)
    }));
    cases.extend(both("sheared bond", shear, [0.05, 1.1], move |step| {
        bonded(step, [0.0, 0.0], 500.0)
    }));
    cases.extend(both("bond that holds", axial, [0.05, 1.1], breaking));
    cases.push(case("bond that breaks", 0.003 * axial, true, torn));
    cases
}

fn fields() -> Vec<Case> {
    let verlet = pair_bound(Integrator::VelocityVerlet, 0.0);
    let bounce = |step: f64| {
        Draft::open_box(Integrator::VelocityVerlet, step)
            .ending_at(80e-6)
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .gravity(1e5)
            .grain(Grain::at([0.0, 2.05 * RADIUS], RADIUS))
            .grain(Grain::at([0.0, 0.0], RADIUS).fixed())
    };
    // A light grain between heavy ones sets the bound.
    let mixed = |step: f64| {
        let heavy =
            |side: f64| Grain::at([side * 1.101 * RADIUS, 0.0], RADIUS).moving([-side, 0.0]);
        Draft::open_box(Integrator::VelocityVerlet, step)
            .ending_at(12e-6)
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .grain(heavy(-1.0))
            .grain(heavy(1.0))
            .grain(Grain::at([0.0, 0.0], 0.1 * RADIUS))
    };
    let light = 2.0 / (2.0 * STIFFNESS / (1e-3 * MASS)).sqrt();
    // A method of first order has no energy to speak of in its first steps from rest.
    let falling = |step: f64| {
        Draft::open_box(Integrator::Euler, step)
            .ending_at(1e-2)
            .gravity(10.0)
            .grain(Grain::at([0.0; 2], RADIUS))
    };
    let mut cases = vec![case("fall from rest, Euler", 5e-5, true, falling)];
    cases.push(case("bouncing in gravity", 0.02 * verlet, true, bounce));
    // The energy of the light grain is small beside that of the others.
    let between = both("light between heavy", light, [0.05, 3.0], mixed);
    cases.extend(beside(1e-3 * MASS, between));
    cases.extend(both("harmonic well", 2.0, [0.05, 1.1], |step| {
        oscillator(Integrator::VelocityVerlet, step, 0.0).ending_at(12.0)
    }));
    cases.extend(both("drag", 0.05, [0.02, 1.2], |step| {
        let draft = oscillator(Integrator::VelocityVerlet, step, 20.0);
        draft
            .ending_at(4.0)
            .with("particles.0.velocity", vec![0.0, 10.0])
    }));
    cases
}

fn set_ups() -> Vec<Case> {
    let fault = |law: Option<(&'static str, f64, f64)>, step: f64| {
        let draft = brief()
            .replacing("time.end", 40e-6)
            .replacing("time.step", step);
        match law {
            Some((law, friction, constant)) => draft
                .without("contact.tangential")
                .friction(law, friction, constant),
            None => draft,
        }
    };
    vec![
        case("small fault", 5e-9, true, move |step| fault(None, step)),
        case(
            "small fault, strong drag of friction",
            100e-9,
            false,
            move |step| fault(Some(("haff-werner", 0.7, 1e2)), step),
        ),
    ]
}

#[test]
fn the_verdict_of_a_run_on_itself_is_right() {
    let cases: Vec<Case> = [
        collisions(),
        bshp(),
        friction(),
        bonds(),
        fields(),
        set_ups(),
    ]
    .into_iter()
    .flatten()
    .collect();
    assert!(cases.len() >= 40, "{}", cases.len());
    let wrong: Vec<String> = cases.iter().filter_map(|case| check(case).err()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A floor of the size of a hill: its potential energy, 1e17 J, would take the digits of all other terms.
#[test]
fn the_balance_beside_a_huge_fixed_grain_keeps_its_digits() {
    let draft = Draft::open_box(Integrator::VelocityVerlet, 2e-6)
        .ending_at(0.02)
        .law(KelvinVoigt {
            stiffness: 1e4,
            damping: 0.02,
        })
        .friction("cundall-strack-truncated", 0.3, 1e4)
        .gravity(9.81)
        .grain(Grain::at([0.0, 0.999_99e-3], 1e-3).moving([0.5, 0.0]))
        .grain(Grain::at([0.0, -1000.0], 1000.0).fixed());
    let (energies, is_doubted) = outcome(&draft);
    let [kinetic, _, external, _] = energies.expect("the run succeeds");
    assert!(!is_doubted && external.abs() < kinetic, "{energies:?}");
}
