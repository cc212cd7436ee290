//! Overlaps up to coincidence, speeds up to one diameter per step, and the same motion in other units.

use super::pairs::{free, kelvin_voigt, mass, model, world};
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, thesis};
use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_dem::forces::Interaction;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{Bshp, CundallStrack, CundallStrackTruncated, HaffWerner};
use gouge_dem::model::{ContactLaws, ContactNormal, ContactTangential, Model};
use gouge_dem::particles::{Particle, Particles};
use gouge_dem::{ModelError, Start, StepError, World};

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "extremes.coincidence",
            claim: "Down to coincident centres, normal forces and Haff-Werner friction stay finite and approach their limits, for both normal laws and three lever arms.",
            equations: thesis("(4), (5), (28)-(42), (114)"),
            scene: "Two spheres of equal or unequal radii at distances from a tenth of the radius down to 1e-145 m and zero, with equal spins; three lever arms; Haff-Werner friction, or Cundall-Strack with zero friction; two normal laws",
            oracle: "Limits: normal force k (r_i + r_j) and (4/3) E* sqrt(R*) (r_i + r_j)^(3/2). Tangential force mu F_n (d_i + d_j) / D, with d_i + d_j the sum of radii, the distance itself (where Haff-Werner friction becomes viscous), or for equal radii twice r/2",
            norm: "Relative error of forces, and number of values that are not finite",
            origin: Origin::Convergent,
            reason: "Forces depend on the distance by D / r to first order, times at most 3/2, plus ten roundings. Focal lever arms are differences, which for unequal radii lose r^2 / D^2 of a rounding; they are compared where this loss is below one per mille",
            effort: Effort::Quick,
            measure: coincidence,
        },
        Check {
            id: "extremes.speed",
            claim: "Two equal spheres may move by up to twice the sum of their radii per step relative to each other and then find the contact in which they land; beyond that, the step ends with a typed error for every integrator.",
            equations: thesis("(98), (99)"),
            scene: "A sphere of 1 mm moves by (1 -+ 1e-9) 4 mm per step towards an equal sphere at rest, in a box smaller than both; all integrators",
            oracle: "The longest way on which they overlap, 4 mm: from touch to coincidence and to touch again. A sphere moves by its diameter relative to the mean velocity",
            norm: "Number of wrong outcomes: an error or a missed contact below the limit, no error or another error above it",
            origin: Origin::Exact,
            reason: "No outcome may be wrong",
            effort: Effort::Quick,
            measure: speed,
        },
        Check {
            id: "extremes.units",
            claim: "The same collision has the same bits in units from 2^-400 to 2^400 m or kg and from 2^-190 to 2^190 s.",
            equations: thesis("(26)-(58)"),
            scene: "Two unequal spinning spheres collide obliquely, 600 steps; Kelvin-Voigt and viscoelastic, three friction laws, all integrators, eight systems of units",
            oracle: "The run in SI units, scaled",
            norm: "Number of runs in which any bit of a position, velocity, angle or spin differs",
            origin: Origin::Exact,
            reason: "Multiplication by powers of two is exact; square roots are too, because lengths scale by powers of four",
            effort: Effort::Quick,
            measure: units,
        },
        Check {
            id: "extremes.subnormal",
            claim: "If stiffnesses and forces are subnormal numbers, a collision is correct up to the remaining resolution of the force. A moment of inertia whose inverse overflows is a typed error.",
            equations: thesis("(26)-(58)"),
            scene: "Head-on collisions in units in which forces shrink by powers of two down to 2^-1066, and in units in which masses shrink; velocity Verlet, 2000 steps",
            oracle: "The run in SI units, scaled",
            norm: "Relative error of the separation velocity; a wrong outcome for a mass counts as one",
            origin: Origin::Exact,
            reason: "Stiffness, damping, force and their sum are each off by at most half a quantum of 2^-1074, which is twice the quantum over the force k v / w in the impulse, with a factor of two because the force is smaller at the ends; plus one rounding per step, 2000 steps",
            effort: Effort::Quick,
            measure: subnormal,
        },
    ]
}

const K: f64 = 1e7;
const MU: f64 = 0.4;
/// Spin of both spheres in rad/s, and damping of Haff-Werner friction in kg/s.
const SPIN: f64 = 3000.0;
const GRIP: f64 = 1e9;

/// The contact of two spheres with equal spins at a given distance, and whether its forces are finite.
fn contact_at(
    contact: ContactLaws,
    radii: [f64; 2],
    distance: f64,
) -> Result<(Interaction, bool), Failure> {
    let spinning = |particle: Particle| Particle {
        angular_velocity: SPIN,
        ..particle
    };
    let particles = [
        spinning(free([0.0; 2], [0.0; 2], radii[0])),
        spinning(free([0.6 * distance, 0.8 * distance], [0.0; 2], radii[1])),
    ];
    let mut world = world(model(contact, 1e-9), &particles)?;
    world.evaluate_if_pending()?;
    let forces = world.forces();
    let finite = forces.force.iter().all(|force| force.is_finite())
        && forces.torque.iter().all(|torque| torque.is_finite());
    let link = world.interactions().into_iter().next();
    let missing = || Failure::Oracle("no contact".to_owned());
    Ok((link.ok_or_else(missing)?, finite))
}

/// Friction laws whose contacts slide from the start; the second one has a friction coefficient of zero.
fn sliding() -> [ContactTangential; 2] {
    [
        ContactTangential::HaffWerner(HaffWerner {
            friction: MU,
            damping: GRIP,
        }),
        ContactTangential::CundallStrack(CundallStrack {
            friction: 0.0,
            stiffness: 1e8,
            grips_at_rest: false,
        }),
    ]
}

/// Compares the contact at a distance, for one lever arm, with the limits.
fn frictional_at(
    arm: ContactDistance,
    radii: [f64; 2],
    d: f64,
) -> Result<Vec<Measurement>, Failure> {
    let (r, sum) = (radii[0], radii[0] + radii[1]);
    let slack = 1.5 * d / r + 10.0 * f64::EPSILON;
    let mut all = Vec::new();
    for law in sliding() {
        let (link, finite) = contact_at(kelvin_voigt(K, 1.0, arm, Some(law)), radii, d)?;
        all.push(Measurement::count(usize::from(!finite)));
        all.push(Measurement::relative(-K * sum, link.normal_force, slack));
        let (ContactTangential::HaffWerner(_), true) = (law, d > 0.0) else {
            continue;
        };
        let limit = MU * link.normal_force.abs();
        let lost = 4.0 * f64::EPSILON * (radii[1] * radii[1] - r * r) / (d * d);
        let (expected, slack) = match arm {
            ContactDistance::Radius => (-limit * sum / d, slack),
            // The surfaces slide at D times the spin, so that the viscous branch applies at small D.
            ContactDistance::Focal => (-limit.min(GRIP * SPIN * d), slack + lost),
            ContactDistance::Mean => (-limit * r / d, d / r + 10.0 * f64::EPSILON),
            ContactDistance::Mixed(_) => continue,
        };
        if lost < 1e-3 && (arm != ContactDistance::Mean || radii[1] == r) {
            all.push(Measurement::relative(
                expected,
                link.tangential_force,
                slack,
            ));
        }
    }
    Ok(all)
}

/// Compares the contact of viscoelastic spheres at a distance with the limit.
fn viscoelastic_at(radii: [f64; 2], d: f64) -> Result<[Measurement; 2], Failure> {
    let law = Bshp {
        youngs_modulus: 50e9,
        poissons_ratio: 0.22,
        dissipative_constant: 1e-7,
    };
    let contact = ContactLaws {
        normal: ContactNormal::Bshp(law),
        ..kelvin_voigt(K, 0.0, ContactDistance::Radius, None)
    };
    let (link, finite) = contact_at(contact, radii, d)?;
    let (sum, modulus) = (radii[0] + radii[1], 50e9 / (2.0 * (1.0 - 0.22 * 0.22)));
    let reduced = radii[0] * radii[1] / sum;
    let hertz = -4.0 / 3.0 * modulus * reduced.sqrt() * sum.powf(1.5);
    let slack = 1.5 * d / radii[0] + 10.0 * f64::EPSILON;
    Ok([
        Measurement::count(usize::from(!finite)),
        Measurement::relative(hertz, link.normal_force, slack),
    ])
}

fn coincidence() -> Outcome {
    let r = 1e-3;
    let arms = [
        ContactDistance::Radius,
        ContactDistance::Focal,
        ContactDistance::Mean,
    ];
    let mut all = Vec::new();
    for radii in [[r, r], [r, 1.5 * r]] {
        for d in [1e-4, 1e-6, 1e-9, 1e-15, 1e-60, 1.1e-145, 0.0] {
            for arm in arms {
                all.extend(frictional_at(arm, radii, d)?);
            }
            all.extend(viscoelastic_at(radii, d)?);
        }
    }
    Ok(Measurement::worst(all).into())
}

fn speed() -> Outcome {
    let (radius, step, way) = (1e-3, 1e-6, 4e-3);
    let mut wrong = 0;
    for integrator in Integrator::ALL {
        for factor in [1.0 - 1e-9, 1.0 + 1e-9] {
            let mut model = model(kelvin_voigt(1.0, 0.0, ContactDistance::Radius, None), step);
            model.integrator = integrator;
            model.domain = Domain {
                width: Some(radius),
                height: Some(radius),
                periodic: false,
            };
            let fast = free([1e-3, 5e-3], [factor * way / step, 0.0], radius);
            let resting = free([1e-3 + 2.0 * way - 0.5e-3, 5e-3], [0.0; 2], radius);
            // Two steps: the second one ends 0.5 mm beyond the other sphere's centre, unless it fails.
            let mut world = world(model, &[fast, resting])?;
            let outcome = world.step().and_then(|()| world.step());
            let landed = outcome.and_then(|()| world.refresh_neighbors());
            let right = match landed {
                Ok(()) => factor < 1.0 && world.number_of_contacts() == 1,
                Err(StepError::TooFast { particle, .. }) => factor > 1.0 && particle == 0,
                Err(_) => false,
            };
            wrong += usize::from(!right);
        }
    }
    Ok(Measurement::count(wrong).into())
}

/// A system of units: binary logarithms of the units of length, time and mass. That of length is even.
type Units = [i32; 3];

/// Power of two, computed as two factors because a power above 2^1023 overflows.
fn power(exponent: i32) -> f64 {
    2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2)
}

/// The oblique collision in a system of units.
fn oblique(integrator: Integrator, bshp: bool, law: usize, units: Units) -> Result<World, Failure> {
    let [length, time, weight] = units;
    let (per_length, per_time) = (power(length), power(time));
    let stiffness = |k: f64| k * power(weight - 2 * time);
    let (r, other, step) = (1e-3, 1.3e-3, 2e-9);
    let tangential = match law {
        0 => ContactTangential::HaffWerner(HaffWerner {
            friction: MU,
            damping: 20.0 * power(weight - time),
        }),
        1 => ContactTangential::CundallStrack(CundallStrack {
            friction: MU,
            stiffness: stiffness(8e6),
            grips_at_rest: false,
        }),
        _ => ContactTangential::CundallStrackTruncated(CundallStrackTruncated {
            friction: MU,
            stiffness: stiffness(8e6),
        }),
    };
    let damping = 2.0 * power(weight - time);
    let mut contact = kelvin_voigt(
        stiffness(K),
        damping,
        ContactDistance::Radius,
        Some(tangential),
    );
    if bshp {
        contact.normal = ContactNormal::Bshp(Bshp {
            youngs_modulus: 5e9 * power(weight - length - 2 * time),
            poissons_ratio: 0.22,
            dissipative_constant: 1e-7 * per_time,
        });
    }
    let mut model = Model {
        integrator,
        ..model(contact, step * per_time)
    };
    model.ledger = true;
    let mut particles: Particles = [
        free([0.0; 2], [20.0, 3.0], r),
        free([2.2e-3, 0.6e-3], [-30.0, 0.0], other),
    ]
    .into_iter()
    .collect();
    for i in 0..2 {
        let rate = per_length / per_time;
        particles.position[i] = particles.position[i] * per_length;
        particles.velocity[i] = particles.velocity[i] * rate;
        particles.angular_velocity[i] = [2000.0, -500.0][i] / per_time;
        particles.radius[i] *= per_length;
        particles.mass[i] *= power(weight);
        particles.moment_of_inertia[i] *= power(weight + 2 * length);
    }
    Ok(World::new(model, particles, &Start::default())?)
}

/// Positions, velocities, angles and spins, converted to SI units.
fn state(world: &World, [length, time, _]: Units) -> Vec<f64> {
    let p = world.particles();
    let back = |v: Vec2, exponent: i32| [v.x * power(-exponent), v.y * power(-exponent)];
    let of = |i: usize| {
        let [x, y] = back(p.position[i], length);
        let [u, v] = back(p.velocity[i], length - time);
        [x, y, u, v, p.angle[i], p.angular_velocity[i] * power(time)]
    };
    [of(0), of(1)].concat()
}

fn units() -> Outcome {
    let systems: [Units; 8] = [
        [-400, 0, 0],
        [400, 0, 0],
        [0, -190, 0],
        [0, 190, 0],
        [0, 0, -400],
        [0, 0, 400],
        [-200, -100, 200],
        [200, 100, -200],
    ];
    let mut wrong = 0;
    for integrator in Integrator::ALL {
        for (bshp, law) in [(false, 0), (false, 1), (true, 2)] {
            let run = |units: Units| -> Result<Vec<f64>, Failure> {
                let mut world = oblique(integrator, bshp, law, units)?;
                for _ in 0..600 {
                    world.step()?;
                }
                Ok(state(&world, units))
            };
            let reference = run([0; 3])?;
            for units in systems {
                wrong += usize::from(run(units)? != reference);
            }
        }
    }
    Ok(Measurement::count(wrong).into())
}

/// Relative velocity after a head-on collision, in units whose mass and time are the given powers of
/// two, converted back.
fn shrunk(weight: i32, time: i32) -> Result<f64, Failure> {
    let (radius, steps) = (0.0009765625, 2000);
    let m = mass(radius);
    let frequency = (2.0 * K / m).sqrt();
    let stiffness = K * power(weight - 2 * time);
    let damping = 0.4 * (0.5 * K * m).sqrt() * power(weight - time);
    let contact = kelvin_voigt(stiffness, damping, ContactDistance::Radius, None);
    let place = radius - f64::EPSILON * radius;
    let v = 0.5 * power(-time);
    let mut particles: Particles = [
        free([-place, 0.0], [v, 0.0], radius),
        free([place, 0.0], [-v, 0.0], radius),
    ]
    .into_iter()
    .collect();
    for i in 0..2 {
        particles.mass[i] *= power(weight);
        particles.moment_of_inertia[i] *= power(weight);
    }
    let model = model(contact, 2e-3 / frequency * power(time));
    let mut world = World::new(model, particles, &Start::default())?;
    for _ in 0..steps {
        world.step()?;
    }
    world.check()?;
    let velocity = &world.particles().velocity;
    Ok((velocity[1].x - velocity[0].x) * power(time))
}

fn subnormal() -> Outcome {
    let reference = shrunk(0, 0)?;
    let mut all = Vec::new();
    let mut table = Table::new(
        "Rebound with forces scaled by 2^e, relative to the run in SI units",
        &["e", "relative difference", "resolution of the force"],
    );
    // Forces are about k v / w, 0.4 N; stiffnesses are subnormal from e = -1045 on.
    let force = 0.5 * (0.5 * K * mass(0.0009765625)).sqrt();
    for time in [200, 210, 215, 220, 225, 230, 233] {
        let exponent = -600 - 2 * time;
        let quantum = power(-1074 - exponent) / force;
        let error = (shrunk(-600, time)? / reference - 1.0).abs();
        let tolerance = 4.0 * quantum + 2000.0 * f64::EPSILON;
        all.push(Measurement::absolute(0.0, error, tolerance));
        table.push([
            exponent.to_string(),
            format!("{error:.1e}"),
            format!("{quantum:.1e}"),
        ]);
    }
    for weight in [-985, -1005, -1040] {
        // The moment of inertia in SI units is 2^-37.7 kg m^2; inverses of numbers below 2^-1024
        // overflow.
        let right = match shrunk(weight, 0) {
            Ok(after) => weight == -985 && (after / reference - 1.0).abs() < 1e-12,
            Err(Failure::Model(ModelError::Parameter { .. })) => weight < -985,
            Err(_) => false,
        };
        all.push(Measurement::count(usize::from(!right)));
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}
