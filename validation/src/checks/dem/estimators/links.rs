//! The reported state of a contact or bond.

use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::scenes::{Bond, Draft, Grain};
use gouge_dem::forces::{Interaction, InteractionKind};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, CundallStrackTruncated, EulerBernoulli, KelvinVoigt};

pub fn checks() -> Vec<Check> {
    vec![state()]
}

fn state() -> Check {
    Check {
        id: "estimators.links.state",
        claim: "A bond and a contact report their geometry, motion, forces and torques correctly. The focal point has the same power with respect to both spheres, and the torques balance the moment of the tangential force.",
        equations: thesis("(3)-(5), (28)-(34), (43)-(45)"),
        scene: "Grains of 1 mm and 0.7 mm at a distance of 1.6 mm and 30 degrees that move, spin and have rotated, as a bond of length 1.65 mm and as a sticking contact",
        oracle: "Kinematics of two rigid spheres in the frame of the pair, calculated by hand",
        norm: "Largest error in units of the scale of each quantity",
        origin: Origin::Exact,
        reason: "Displacements of 50 um and rotations of 0.02 rad are differences of 1.6 mm and of angles near pi: 200 units in the last place",
        effort: Effort::Quick,
        measure: measure_state,
    }
}

const RADII: [f64; 2] = [1e-3, 0.7e-3];
const DISTANCE: f64 = 1.6e-3;
const LENGTH: f64 = 1.65e-3;
/// Relative velocity along the normal and the tangent, in m/s.
const MOTION: [f64; 2] = [-0.4, 0.3];
const SPINS: [f64; 2] = [150.0, -80.0];
/// Rotation of the ends in the frame of the pair, in rad.
const TURNS: [f64; 2] = [0.02, -0.013];
const STIFFNESS: [f64; 2] = [1e7, 4e6];
const DAMPING: [f64; 2] = [3.0, 2.0];

/// The only interaction of the pair under the given laws.
fn link(laws: &Draft, begun: impl Fn([f64; 2]) -> Draft) -> Result<Interaction, Failure> {
    let (sine, cosine) = std::f64::consts::FRAC_PI_6.sin_cos();
    let [along, across] = MOTION;
    let velocity = [
        along * cosine - across * sine,
        along * sine + across * cosine,
    ];
    // The initial angles of the ends in the frame of the pair.
    let initial = [
        -std::f64::consts::FRAC_PI_6 - TURNS[0],
        std::f64::consts::PI - std::f64::consts::FRAC_PI_6 - TURNS[1],
    ];
    let draft = Draft::open_box(Integrator::Euler, 1e-9)
        .and(laws)
        .grain(Grain::at([0.0, 0.0], RADII[0]).spinning(SPINS[0]))
        .grain(
            Grain::at([DISTANCE * cosine, DISTANCE * sine], RADII[1])
                .moving(velocity)
                .spinning(SPINS[1]),
        )
        .and(&begun(initial));
    let links = draft.world()?.interactions();
    let only = links.first().filter(|_| links.len() == 1).copied();
    only.ok_or_else(|| Failure::Oracle("the pair does not have exactly one interaction".to_owned()))
}

/// Compares the geometry and motion, which bonds and contacts share.
fn motion(link: &Interaction, all: &mut Vec<Measurement>) {
    let mut near = |expected: f64, found: f64, scale: f64| {
        all.push(Measurement::scaled(
            expected,
            found,
            scale,
            200.0 * f64::EPSILON,
        ));
    };
    let (sine, cosine) = std::f64::consts::FRAC_PI_6.sin_cos();
    near(cosine, link.normal.x, 1.0);
    near(sine, link.normal.y, 1.0);
    near(DISTANCE, link.distance, DISTANCE);
    near(
        RADII[0] + RADII[1] - DISTANCE,
        link.normal_displacement,
        1e-3,
    );
    near(-MOTION[0], link.normal_velocity, 1.0);
    // The focal point lies on the line of centres and has the same power with respect to both spheres.
    let along = link.focal_point.x * cosine + link.focal_point.y * sine;
    let aside = link.focal_point.y * cosine - link.focal_point.x * sine;
    let power = |distance: f64, radius: f64| (distance - radius) * (distance + radius);
    near(0.0, aside, DISTANCE);
    near(link.overlap_factor, along / DISTANCE, 1.0);
    near(
        power(along, RADII[0]),
        power(DISTANCE - along, RADII[1]),
        DISTANCE * DISTANCE,
    );
    let frame_rate = MOTION[1] / DISTANCE;
    for end in [0, 1] {
        near(
            RADII[end] * TURNS[end],
            link.tangential_displacement[end],
            1e-3,
        );
        let speed = RADII[end] * (SPINS[end] - frame_rate);
        near(speed, link.tangential_velocity[end], 1.0);
    }
    near(
        (link.torque[0] + link.torque[1]) / DISTANCE,
        link.tangential_force,
        1e3,
    );
}

fn measure_state() -> Outcome {
    let (bond, contact) = both()?;
    let mut all = Vec::new();
    motion(&bond, &mut all);
    motion(&contact, &mut all);
    forces(&bond, &contact, &mut all);
    let kinds = [
        bond.kind == InteractionKind::Bond,
        contact.kind == InteractionKind::Contact,
    ];
    let wrong = kinds.iter().filter(|right| !**right).count();
    all.push(Measurement::count(wrong));
    Ok(Measurement::worst(all).into())
}

/// The pair as a bond and as a contact.
fn both() -> Result<(Interaction, Interaction), Failure> {
    let [stiffness, bending] = STIFFNESS;
    let [damping, creaking] = DAMPING;
    let bond = Draft::empty()
        .law(AdjustedKelvinVoigt { stiffness, damping })
        .law(EulerBernoulli {
            stiffness: bending,
            damping: creaking,
        });
    let contact =
        Draft::empty()
            .law(KelvinVoigt { stiffness, damping })
            .law(CundallStrackTruncated {
                friction: 1e3,
                stiffness: bending,
            });
    let bonded = |angles| Draft::empty().bond(Bond::between(0, 1).of_length(LENGTH).since(angles));
    let touching = |angles| Draft::empty().touching_since(0, 1, angles);
    Ok((link(&bond, bonded)?, link(&contact, touching)?))
}

/// Compares displacements from rest, forces and torques.
fn forces(bond: &Interaction, contact: &Interaction, all: &mut Vec<Measurement>) {
    let mut near = |expected: f64, found: f64, scale: f64| {
        all.push(Measurement::scaled(
            expected,
            found,
            scale,
            400.0 * f64::EPSILON,
        ));
    };
    let shortening = LENGTH - DISTANCE;
    let overlap = RADII[0] + RADII[1] - DISTANCE;
    near(shortening, bond.adjusted_normal_displacement, LENGTH);
    near(0.0, contact.adjusted_normal_displacement, LENGTH);
    let push = |displacement: f64| -(STIFFNESS[0] * displacement - DAMPING[0] * MOTION[0]);
    near(push(shortening), bond.normal_force, STIFFNESS[0] * LENGTH);
    near(push(overlap), contact.normal_force, STIFFNESS[0] * LENGTH);
    let zeta = [0, 1].map(|end| RADII[end] * TURNS[end]);
    for end in [0, 1] {
        let rate = RADII[end] * (SPINS[end] - MOTION[1] / DISTANCE);
        let bending = -(STIFFNESS[1] * zeta[end] + DAMPING[1] * rate);
        let rubbing = -STIFFNESS[1] * (zeta[0] + zeta[1]);
        near(RADII[end] * bending, bond.torque[end], 4.0);
        near(RADII[end] * rubbing, contact.torque[end], 4.0);
    }
}
