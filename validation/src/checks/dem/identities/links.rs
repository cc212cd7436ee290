//! Third law and angular momentum of contacts.

use super::{PAIRS, identity};
use crate::checks::dem::scenes::{empty_model, sphere};
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Failure, Measurement, Outcome, thesis};
use gouge_common::geometry::Vec2;
use gouge_dem::geometry::{Arm, ContactDistance, FocalArm, Lever, MeanArm, MixedArms, Translation};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{HaffWerner, KelvinVoigt};
use gouge_dem::model::{ContactLaws, ContactNormal, ContactTangential, Reading};
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
    let scene = "Random rubbing contacts with each contact distance and in both readings: radii over two decades, overlaps up to half, any speed and spin";
    vec![
        Check {
            scene,
            oracle: "The sum of the forces on both",
            norm: "Contacts whose forces do not cancel bit for bit",
            reason: "The same number with opposite signs is added to both: nothing may be left",
            effort: Effort::Thorough,
            ..identity(
                "identities.third-law",
                "The forces of two particles on each other cancel to the last bit.",
                thesis("(6)"),
                || third_law(PAIRS),
            )
        },
        Check {
            scene,
            oracle: "The total torque about the centre of i: zero as corrected; (d_ij + d_ji - D) F as printed and with the arms of another program, which is zero for focal distances only",
            norm: "Largest difference in units of rounding of the torques",
            reason: "Torques of both ends, and a moment of force that is their sum divided by the distance and multiplied by it: eight roundings",
            effort: Effort::Thorough,
            ..identity(
                "identities.angular-momentum",
                "A contact changes no angular momentum as corrected, and as printed or with the arms of another program just by the stated defect.",
                thesis("(6), (7), E10"),
                || angular_momentum(PAIRS),
            )
        },
    ]
}

/// A contact with its forces evaluated, and the radii and lever arms that it has.
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
    let mut model = empty_model(Integrator::Euler, 1e-9);
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

/// Total torque about the centre of i against the defect of the reading.
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
