//! Newton's third law and angular momentum of contacts.

use super::{PAIRS, identity};
use crate::checks::dem::scenes::sphere;
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Failure, Measurement, Outcome, thesis};
use gouge_common::geometry::Vec2;
use gouge_dem::geometry::{Arm, ContactDistance, FocalArm, Lever, MeanArm, MixedArms, Translation};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{HaffWerner, KelvinVoigt};
use gouge_dem::model::{ContactLaws, ContactNormal, ContactTangential, Model, Reading};
use gouge_dem::{Start, World};

const ARMS: [ContactDistance; 4] = [
    ContactDistance::Radius,
    ContactDistance::Focal,
    ContactDistance::Mean,
    ContactDistance::Mixed(MixedArms {
        kinematic: Lever::Radius,
        translation: Translation::Whole,
        torque: Lever::HalfOverlap,
    }),
];

pub(super) fn checks() -> Vec<Check> {
    let scene = "Random contacts with friction, with each contact distance and in both readings: radii over two decades, overlaps of up to half the sum of radii, any speed and spin";
    vec![
        Check {
            scene,
            oracle: "The sum of the forces on the two particles",
            norm: "Number of contacts whose forces do not cancel exactly",
            reason: "The same number is added to both particles with opposite signs, so the sum must be zero",
            effort: Effort::Thorough,
            ..identity(
                "identities.third-law",
                "The forces of two particles on each other cancel exactly.",
                thesis("(6)"),
                || third_law(PAIRS),
            )
        },
        Check {
            scene,
            oracle: "The total torque about the centre of i. It is zero in the corrected reading. As printed, and with separate lever arms for torque and motion as in another program, it is (d_ij + d_ji - D) F, which vanishes only for focal distances",
            norm: "Largest error, in units of rounding of the torques",
            reason: "Torques on both particles, and the moment of a force that is their sum divided by the distance and multiplied by it: eight roundings",
            effort: Effort::Thorough,
            ..identity(
                "identities.angular-momentum",
                "A contact conserves angular momentum in the corrected reading. As printed, or with the lever arms of another program, it violates conservation by exactly the stated defect.",
                thesis("(6), (7), E10"),
                || angular_momentum(PAIRS),
            )
        },
    ]
}

/// A contact with its forces evaluated, and its radii, reading and lever arms.
struct Rubbing {
    world: World,
    radii: [f64; 2],
    reading: Reading,
    arm: ContactDistance,
}

fn rubbing(random: &mut Random) -> Result<Rubbing, Failure> {
    let (reading, arm) = (
        random.choice(&[Reading::Corrected, Reading::Thesis]),
        random.choice(&ARMS),
    );
    let radii = [random.magnitude(1e-4, 1e-2), random.magnitude(1e-4, 1e-2)];
    let distance = (radii[0] + radii[1]) * random.between(0.5, 1.0);
    let angle = random.between(0.0, 6.3);
    let at = Vec2::new(distance * libm::cos(angle), distance * libm::sin(angle));
    let speed =
        |random: &mut Random| Vec2::new(random.signed(1e-3, 10.0), random.signed(1e-3, 10.0));
    let spin = |random: &mut Random| random.signed(1.0, 1e4);
    let particles = [(Vec2::zero(), radii[0]), (at, radii[1])]
        .map(|(position, radius)| sphere(position, speed(random), spin(random), radius));
    let mut model = Model::new(Integrator::Euler, 1e-9);
    model.reading = reading;
    model.contact = Some(ContactLaws {
        distance: arm,
        normal: ContactNormal::KelvinVoigt(KelvinVoigt {
            stiffness: 1e7,
            damping: 1.0,
        }),
        tangential: Some(ContactTangential::HaffWerner(HaffWerner {
            friction: 0.7,
            damping: 100.0,
        })),
    });
    let mut world = World::new(model, particles.into_iter().collect(), &Start::default())?;
    world.evaluate_if_pending()?;
    Ok(Rubbing {
        world,
        radii,
        reading,
        arm,
    })
}

fn third_law(contacts: usize) -> Outcome {
    let mut random = Random::new(21);
    let mut broken = 0;
    for _ in 0..contacts {
        let rubbing = rubbing(&mut random)?;
        let forces = &rubbing.world.forces().force;
        broken += usize::from(forces[0] != -forces[1]);
    }
    Ok(Measurement::count(broken).into())
}

fn angular_momentum(contacts: usize) -> Outcome {
    let mut random = Random::new(22);
    let mut measured = Vec::with_capacity(contacts);
    for _ in 0..contacts {
        measured.push(torque_balance(&rubbing(&mut random)?));
    }
    Ok(Measurement::worst(measured).into())
}

/// Compares the total torque about the centre of i with the defect of the reading.
fn torque_balance(rubbing: &Rubbing) -> Measurement {
    let (world, forces) = (&rubbing.world, rubbing.world.forces());
    let way = world.particles().position[1] - world.particles().position[0];
    let moment = way.cross(forces.force[1]);
    let total = forces.torque[0] + forces.torque[1] + moment;
    let distance = way.norm();
    let arms = match rubbing.arm {
        ContactDistance::Radius => rubbing.radii,
        ContactDistance::Focal => FocalArm.distances(rubbing.radii, distance),
        ContactDistance::Mean => MeanArm.distances(rubbing.radii, distance),
        ContactDistance::Mixed(arms) => arms.distances(rubbing.radii, distance),
    };
    let friction = forces.torque[0] / arms[0];
    let defect = match (rubbing.reading, rubbing.arm) {
        (Reading::Thesis, _) | (_, ContactDistance::Mixed(_)) => {
            (arms[0] + arms[1] - distance) * friction
        }
        (Reading::Corrected, _) => 0.0,
    };
    let normal = forces.force[1].dot(way);
    let size = (arms[0].abs() + arms[1].abs() + distance) * friction.abs() + normal.abs();
    Measurement::scaled(defect, total, f64::EPSILON * size + f64::MIN_POSITIVE, 8.0)
}
