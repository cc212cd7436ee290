//! Thresholds: the state just below and the state just above each.

use crate::checks::dem::scenes::sphere;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::scenes::{Draft, Grain};
use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_dem::bonds::BondStart;
use gouge_dem::contacts::ContactStart;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Controller, CundallStrack, Driven, Driving, KelvinVoigt, TangentialLaw,
    TangentialMotion,
};
use gouge_dem::model::{BondLaws, ContactLaws, ContactNormal, ContactTangential, Model};
use gouge_dem::particles::Particles;
use gouge_dem::{ModelError, Start, StepError, World};
use std::f64::consts::PI;

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "laws.thresholds",
            claim: "Every threshold switches at the right value: the friction limit with its stored energy, both directions of the rate-limited controller, and the rejection of narrow boxes, long bonds, masses without a finite inverse, and bonded grains that move by more than a diameter per step. Two spheres that just touch have no contact. Motion that overflows is stopped.",
            equations: thesis("(22), (42), (64), (76), (98)"),
            scene: "For each threshold, a state 1e-7 below it and a state 1e-7 above it, relative to the threshold; spheres that just touch, with and without a stored contact; grains at 1e308 m/s and rad/s",
            oracle: "The side of the threshold on which the state lies",
            norm: "Number of states on the wrong side",
            origin: Origin::Exact,
            reason: "1e-7 is far above rounding, so no state may be on the wrong side",
            effort: Effort::Quick,
            measure: thresholds,
        },
        Check {
            id: "laws.letting-go",
            claim: "The printed Cundall-Strack spring releases its stored energy F^2 / 2k as heat when it starts to slide; when it sticks again, the energy that it then stores is booked as negative heat.",
            equations: thesis("(42), (78), E15"),
            scene: "A printed Cundall-Strack spring of 2^20 kg/s^2 with a friction limit of 2^9 N, moved to half its limiting displacement, to the limit, to twice the limit and back to half of it",
            oracle: "2^18 / 2^21 J at the limit, minus a quarter of that on the return, and zero otherwise",
            norm: "Largest absolute error in J",
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
            reduces_pull_and_load(side),
            !increases_pull_and_load(side),
            is_wide(side)?,
            is_long(side)?,
            is_heavy(side)?,
            is_too_fast(side)?,
        ];
        wrong += found.iter().filter(|&&found| found != beyond).count();
    }
    wrong += usize::from(!is_refused_at_touch()?) + contacts_at_touch()?;
    wrong += usize::from(!is_wide(1.0)?);
    for axis in 0..3 {
        for periodic in [false, true] {
            wrong += usize::from(!stops_on_overflow(axis, periodic)?);
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

fn frictional() -> ContactLaws {
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

/// Number of contacts of two spheres that just touch.
fn contacts_at_touch() -> Result<usize, Failure> {
    let model = Model {
        contact: Some(frictional()),
        ..Model::new(Integrator::Euler, 1e-6)
    };
    let world: World = World::new(model, pair([1.0, 1.5], 2.5), &Start::default())?;
    Ok(world.number_of_contacts())
}

/// Whether a scene is refused that declares a contact between two spheres that just touch.
fn is_refused_at_touch() -> Result<bool, Failure> {
    let start = Start {
        contacts: vec![ContactStart {
            between: [0, 1],
            initial_angles: [0.0, -PI],
        }],
        ..Start::default()
    };
    let model = Model {
        contact: Some(frictional()),
        ..Model::new(Integrator::Euler, 1e-6)
    };
    match World::<f64>::new(model, pair([1.0, 1.5], 2.5), &start) {
        Ok(_) => Ok(false),
        Err(ModelError::NoOverlap { .. }) => Ok(true),
        Err(other) => Err(other.into()),
    }
}

/// Whether a contact with an overlap of 0.5 m, sheared by a multiple of the displacement at the
/// friction limit, stores no energy in shear.
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
        contact: Some(frictional()),
        ..Model::new(Integrator::Euler, 1e-6)
    };
    let world: World = World::new(model, pair(radii, radii[0] + radii[1] - 0.5), &start)?;
    let pressed = 0.5 * STIFFNESS * 0.25;
    Ok(world.energy().contact < pressed + 0.25 * STIFFNESS * shear * shear)
}

/// Change of the driving force in 0.5 s at a maximum rate of 8 N/s. The mean speed is the given
/// multiple of the required 3 m/s, and the reaction is the same multiple of the load of 10 N.
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

fn reduces_pull_and_load(multiple: f64) -> bool {
    change(multiple) == [-4.0, 4.0]
}

fn increases_pull_and_load(multiple: f64) -> bool {
    change(multiple) == [4.0, -4.0]
}

/// Whether a periodic box is accepted whose width is the given multiple of two cells.
fn is_wide(multiple: f64) -> Result<bool, Failure> {
    let model = Model {
        contact: Some(frictional()),
        domain: Domain {
            width: Some(multiple * 4.0 * 1.5),
            height: None,
            periodic: true,
        },
        ..Model::new(Integrator::Euler, 1e-6)
    };
    match World::<f64>::new(model, pair([1.0, 1.5], 2.5), &Start::default()) {
        Ok(_) => Ok(true),
        Err(ModelError::NarrowBox { .. }) => Ok(false),
        Err(other) => Err(other.into()),
    }
}

/// Whether a bond is refused whose length is the given multiple of half the period. The bond is
/// oblique, because the displacement along x never exceeds half the period.
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
        ..Model::new(Integrator::Euler, 1e-6)
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

/// Whether a mass is accepted that is the given multiple of the smallest mass with a finite inverse.
fn is_heavy(multiple: f64) -> Result<bool, Failure> {
    let mut particles = pair([1.0, 1.0], 3.0);
    particles.mass[1] = multiple / f64::MAX;
    let model = Model::new(Integrator::Euler, 1e-6);
    match World::<f64>::new(model, particles, &Start::default()) {
        Ok(_) => Ok(true),
        Err(ModelError::Parameter { .. }) => Ok(false),
        Err(other) => Err(other.into()),
    }
}

/// Whether a bonded grain that moves by the given multiple of the largest diameter in one step is
/// stopped.
fn is_too_fast(multiple: f64) -> Result<bool, Failure> {
    let (step, radius) = (1e-6, 1.5e-3);
    let draft = Draft::open_box(Integrator::Euler, step)
        .law(AdjustedKelvinVoigt {
            stiffness: 1.0,
            damping: 0.0,
        })
        .grain(Grain::at([0.0; 2], 1e-3).moving([2.0 * radius * multiple / step, 0.0]))
        .grain(Grain::at([3e-3, 0.0], radius))
        .bonded(0, 1);
    let mut world: World = draft.world()?;
    match world.step().and_then(|()| world.check()) {
        Ok(()) => Ok(false),
        Err(StepError::TooFast { .. }) => Ok(true),
        Err(other) => Err(other.into()),
    }
}

/// Whether a grain whose x, y or angle overflows in one step is stopped, in open and in periodic boxes.
fn stops_on_overflow(axis: usize, periodic: bool) -> Result<bool, Failure> {
    let mut rates = [0.0; 3];
    rates[axis] = 1e308;
    let [x, y, spin] = rates;
    let grain = sphere(Vec2::zero(), Vec2::new(x, y), spin, 1.0);
    let mut model = Model::new(Integrator::Euler, 10.0);
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
