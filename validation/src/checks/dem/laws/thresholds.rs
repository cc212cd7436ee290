//! Where something begins or ends: a state just before and one just after.

use crate::checks::dem::scenes::{empty_model, head, particle, sphere, world};
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_dem::bonds::BondStart;
use gouge_dem::contacts::ContactStart;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    Controller, CundallStrack, Driven, Driving, KelvinVoigt, TangentialLaw, TangentialMotion,
};
use gouge_dem::model::{BondLaws, ContactLaws, ContactNormal, ContactTangential, Model};
use gouge_dem::particles::Particles;
use gouge_dem::{ModelError, Start, StepError, World};
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "laws.thresholds",
            claim: "What a comparison decides is decided where it should be: sliding with its stored energy, the moves of the rate-limited controller, and what is refused: narrow boxes, long bonds, inertias without an inverse, flights beyond a diameter and beyond all numbers.",
            equations: thesis("(22), (42), (64), (76), (98)"),
            scene: "For each, a state a ten-millionth before the threshold and one as far beyond it; a contact that is said to have begun before the spheres overlap",
            oracle: "Which side the state is on",
            norm: "Number of states on the wrong side",
            origin: Origin::Exact,
            reason: "A ten-millionth is far above rounding: none may be wrong",
            effort: Effort::Quick,
            measure: thresholds,
        },
        Check {
            id: "laws.letting-go",
            claim: "A spring of friction that begins to slide turns what it stored at the limit into heat, F^2 / 2k, and takes it back where it sticks again.",
            equations: thesis("(42), (78), E15"),
            scene: "A printed Cundall-Strack spring of 2^20 kg/s^2, moved to its limit of 2^9 N and back",
            oracle: "2^18 / 2^21 J",
            norm: "Absolute difference in J",
            origin: Origin::Exact,
            reason: "All numbers are powers of two",
            effort: Effort::Quick,
            measure: letting_go,
        },
    ]
}

/// Relative distance of the states from a threshold.
const NEAR: f64 = 1e-7;
const STIFFNESS: f64 = 1e5;

fn thresholds() -> Outcome {
    let mut wrong = 0;
    for (side, beyond) in [(1.0 - NEAR, false), (1.0 + NEAR, true)] {
        let found = [
            slides([1.0, 1.5], side)?,
            slides([1.5, 1.0], side)?,
            lifts_and_slows(side),
            !pushes_and_lowers(side),
            is_wide(side)?,
            is_long(side)?,
            is_heavy(side)?,
            flies(side)?,
        ];
        wrong += found.iter().filter(|&&found| found != beyond).count();
    }
    wrong += usize::from(!is_refused_at_touch()?) + contacts_at_touch()?;
    wrong += usize::from(!is_wide(1.0)?);
    for axis in 0..3 {
        for periodic in [false, true] {
            wrong += usize::from(!stops_beyond_numbers(axis, periodic)?);
        }
    }
    Ok(Measurement::count(wrong).into())
}

/// Two spheres at a distance along x.
fn pair(radii: [f64; 2], distance: f64) -> Particles {
    [(0.0, radii[0]), (distance, radii[1])]
        .map(|(x, radius)| sphere(Vec2::new(x, 0.0), Vec2::zero(), 0.0, radius))
        .into_iter()
        .collect()
}

fn sticky() -> ContactLaws {
    ContactLaws {
        distance: ContactDistance::Radius,
        normal: ContactNormal::KelvinVoigt(KelvinVoigt {
            stiffness: STIFFNESS,
            damping: 0.0,
        }),
        tangential: Some(ContactTangential::CundallStrack(CundallStrack {
            friction: 0.25,
            stiffness: STIFFNESS,
            grips_at_rest: false,
        })),
    }
}

/// Contacts of spheres that just touch.
fn contacts_at_touch() -> Result<usize, Failure> {
    let model = Model {
        contact: Some(sticky()),
        ..empty_model(Integrator::Euler, 1e-6)
    };
    let world: World = World::new(model, pair([1.0, 1.5], 2.5), &Start::default())?;
    Ok(world.number_of_contacts())
}

/// Whether a scene may not say of spheres that just touch how their contact began.
fn is_refused_at_touch() -> Result<bool, Failure> {
    let start = Start {
        contacts: vec![ContactStart {
            between: [0, 1],
            initial_angles: [0.0, -PI],
        }],
        ..Start::default()
    };
    let model = Model {
        contact: Some(sticky()),
        ..empty_model(Integrator::Euler, 1e-6)
    };
    match World::<f64>::new(model, pair([1.0, 1.5], 2.5), &start) {
        Ok(_) => Ok(false),
        Err(ModelError::NoOverlap { .. }) => Ok(true),
        Err(other) => Err(other.into()),
    }
}

/// Whether a contact with an overlap of 0.5 m, sheared by a multiple of what friction holds, stores
/// nothing in shear.
fn slides(radii: [f64; 2], multiple: f64) -> Result<bool, Failure> {
    let shear = 0.25 * 0.5 * multiple;
    let turn = shear / (radii[0] + radii[1]);
    let start = Start {
        contacts: vec![ContactStart {
            between: [0, 1],
            initial_angles: [-turn, -turn - PI],
        }],
        ..Start::default()
    };
    let model = Model {
        contact: Some(sticky()),
        ..empty_model(Integrator::Euler, 1e-6)
    };
    let world: World = World::new(model, pair(radii, radii[0] + radii[1] - 0.5), &start)?;
    let pressed = 0.5 * STIFFNESS * 0.25;
    Ok(world.energy().contact < pressed + 0.25 * STIFFNESS * shear * shear)
}

/// Change of the driving force in 0.5 s, at most 8 N/s, where the mean speed is a multiple of the 3 m/s
/// asked for and the reaction one of the load of 10 N.
fn change(multiple: f64) -> [f64; 2] {
    let law = Driving {
        controller: Controller::RateLimited { force_rate: 8.0 },
        speed: 3.0,
        pressure: 5.0,
        area: 2.0,
    };
    let driven = Driven {
        number: 2.0,
        velocity_sum: 6.0 * multiple,
        velocity_at_step_start: 0.0,
        velocity_gain: 1.0,
        reaction: Vec2::new(0.0, 10.0 * multiple),
        inverse_mass_sum: 1.0,
        acceleration_sum: 0.0,
    };
    let force = law.next_force(Vec2::zero(), &driven, 0.5);
    [force.x, force.y]
}

fn lifts_and_slows(multiple: f64) -> bool {
    change(multiple) == [-4.0, 4.0]
}

fn pushes_and_lowers(multiple: f64) -> bool {
    change(multiple) == [4.0, -4.0]
}

/// Whether a periodic box of a multiple of two cells is accepted.
fn is_wide(multiple: f64) -> Result<bool, Failure> {
    let model = Model {
        contact: Some(sticky()),
        domain: Domain {
            width: Some(multiple * 4.0 * 1.5),
            height: None,
            periodic: true,
        },
        ..empty_model(Integrator::Euler, 1e-6)
    };
    match World::<f64>::new(model, pair([1.0, 1.5], 2.5), &Start::default()) {
        Ok(_) => Ok(true),
        Err(ModelError::NarrowBox { .. }) => Ok(false),
        Err(other) => Err(other.into()),
    }
}

/// Whether a bond with a length of a multiple of half the period is refused. It is slanted, since along
/// the period alone none could be longer.
fn is_long(multiple: f64) -> Result<bool, Failure> {
    let width = 40.0;
    let (length, x) = (0.5 * width * multiple, 12.0);
    let particles: Particles = [Vec2::zero(), Vec2::new(x, (length * length - x * x).sqrt())]
        .map(|position| sphere(position, Vec2::zero(), 0.0, 1.0))
        .into_iter()
        .collect();
    let model = Model {
        bond: Some(BondLaws {
            normal: gouge_dem::laws::AdjustedKelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            },
            tangential: None,
            yielding: None,
        }),
        domain: Domain {
            width: Some(width),
            height: None,
            periodic: true,
        },
        ..empty_model(Integrator::Euler, 1e-6)
    };
    let start = Start {
        bonds: vec![BondStart {
            between: [0, 1],
            strength_factor: 1.0,
            initial_distance: None,
            initial_angles: None,
        }],
        ..Start::default()
    };
    match World::<f64>::new(model, particles, &start) {
        Ok(_) => Ok(false),
        Err(ModelError::LongBond { .. }) => Ok(true),
        Err(other) => Err(other.into()),
    }
}

/// Whether a mass of a multiple of the least that has a finite inverse is accepted.
fn is_heavy(multiple: f64) -> Result<bool, Failure> {
    let mut particles = pair([1.0, 1.0], 3.0);
    particles.mass[1] = multiple / f64::MAX;
    let model = empty_model(Integrator::Euler, 1e-6);
    match World::<f64>::new(model, particles, &Start::default()) {
        Ok(_) => Ok(true),
        Err(ModelError::Parameter { .. }) => Ok(false),
        Err(other) => Err(other.into()),
    }
}

/// Whether a bonded grain that flies a multiple of the largest diameter in a step is stopped.
fn flies(multiple: f64) -> Result<bool, Failure> {
    let (step, radius) = (1e-6, 1.5e-3);
    let text = head("euler", step)
        + "[bond.normal]\nstiffness = 1.0\ndamping = 0.0\n"
        + &particle([0.0; 2], [2.0 * radius * multiple / step, 0.0], 0.0, 1e-3)
        + &particle([3e-3, 0.0], [0.0; 2], 0.0, radius)
        + "[[bonds]]\nbetween = [0, 1]\n";
    let mut world: World = world(&text)?;
    match world.step().and_then(|()| world.check()) {
        Ok(()) => Ok(false),
        Err(StepError::TooFast { .. }) => Ok(true),
        Err(other) => Err(other.into()),
    }
}

/// Whether a grain that leaves all numbers in one step, along x, along y or by turning, is stopped, also
/// in a periodic box.
fn stops_beyond_numbers(axis: usize, periodic: bool) -> Result<bool, Failure> {
    let mut rates = [0.0; 3];
    rates[axis] = 1e308;
    let [x, y, spin] = rates;
    let grain = sphere(Vec2::zero(), Vec2::new(x, y), spin, 1.0);
    let mut model = empty_model(Integrator::Euler, 10.0);
    (model.domain.width, model.domain.periodic) = (Some(100.0), periodic);
    let mut world: World = World::new(model, [grain].into_iter().collect(), &Start::default())?;
    match world.step().and_then(|()| world.check()) {
        Ok(()) => Ok(false),
        Err(StepError::NotFinite { particle, .. }) => Ok(particle == 0),
        Err(other) => Err(other.into()),
    }
}

fn letting_go() -> Outcome {
    let (load, stiffness) = (1024.0, 1_048_576.0);
    let law = CundallStrack {
        friction: 0.5,
        stiffness,
        grips_at_rest: false,
    };
    let mut memory = 0.0;
    let mut heat = |displacement: f64| {
        let slide = TangentialMotion {
            displacement,
            velocity: 1.0,
        };
        law.friction(slide, -load, &mut memory).heat
    };
    let limit = 0.5 * load / stiffness;
    let released = 0.5 * (0.5 * load) * limit;
    let expected = [0.0, released, 0.0, -0.25 * released];
    let path = [0.5 * limit, limit, 2.0 * limit, 0.5 * limit];
    let pairs = path.into_iter().zip(expected);
    let measured =
        pairs.map(|(z, expected)| Measurement::absolute(expected, heat(z), f64::MIN_POSITIVE));
    Ok(Measurement::worst(measured).into())
}
