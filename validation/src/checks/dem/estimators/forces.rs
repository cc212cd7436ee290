//! Friction, stress, packing and coordination.

use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use crate::scenes::events::stretched_chain;
use crate::scenes::{Draft, Grain};
use gouge_common::estimators::packing_fraction;
use gouge_dem::World;
use gouge_dem::estimators::{friction_feedback, friction_load};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{AdjustedKelvinVoigt, Controller, EulerBernoulli, HaffWerner, KelvinVoigt};
use gouge_runner::scene::DrivingTable;
use rand::RngExt;
use rand_pcg::Pcg64;
use std::f64::consts::PI;

pub fn checks() -> Vec<Check> {
    vec![block(), chain(), virial(), packing()]
}

fn block() -> Check {
    Check {
        id: "estimators.friction.sliding-block",
        claim: "A block that slides at the Coulomb limit has the friction coefficient of its contact, both from the load and from the reaction.",
        equations: thesis("(85)-(86)"),
        scene: "A driven grain of 1 mm slides over a fixed sphere of 1 m at 1 m/s under a load of 5 N, which its overlap of 0.5 um balances; Haff-Werner friction with mu = 0.7",
        oracle: "mu times the sum of the radii over the distance of the centres, which follows from the torques on both spheres",
        norm: "Relative error of both coefficients",
        origin: Origin::Exact,
        reason: "The overlap of 0.5 um is a difference of lengths of 1 m, so it and the load are accurate to 2e-10. The ratio from the reaction does not depend on it, and its tolerance is 1e-12",
        effort: Effort::Quick,
        measure: measure_block,
    }
}

fn measure_block() -> Outcome {
    const MU: f64 = 0.7;
    let (large, small, overlap) = (1.0, 1e-3, 0.5e-6);
    let draft = Draft::open_box(Integrator::VelocityVerlet, 1e-9)
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 0.0,
        })
        .law(HaffWerner {
            friction: MU,
            damping: 1e6,
        })
        .driving(DrivingTable {
            controller: Controller::Exact,
            speed: 1.0,
            pressure: 2.5,
            area: Some(2.0),
            initial_force: [0.0; 2],
        })
        .grain(Grain::at([0.0, -large], large).fixed())
        .grain(
            Grain::at([0.0, small - overlap], small)
                .moving([1.0, 0.0])
                .driven(),
        );
    let mut world = draft.world()?;
    world.evaluate_if_pending()?;
    let expected = MU * (large + small) / (large + small - overlap);
    Ok(Measurement::worst([
        Measurement::relative(expected, friction_feedback(world.drive()), 1e-12),
        Measurement::relative(expected, friction_load(world.drive()), 1e-9),
    ])
    .into())
}

fn chain() -> Check {
    Check {
        id: "estimators.stress.chain",
        claim: "The mean stress of a stretched chain is its force over its cross-section, along its direction, and positive in tension.",
        equations: thesis("(43)"),
        scene: "Ten bonded grains in a row at 30 degrees, stretched by a thousandth, in a volume of nine bonds of 2.002 mm times 1 mm^2",
        oracle: "Stiffness times extension over cross-section, times the products of the direction cosines",
        norm: "Relative error of each component",
        origin: Origin::Exact,
        reason: "An extension of 2 um is the difference of lengths of 2 mm at positions of 2 cm: 10^4 units in the last place of 2 um",
        effort: Effort::Quick,
        measure: measure_chain,
    }
}

fn measure_chain() -> Outcome {
    let direction = [0.75_f64.sqrt(), 0.5];
    let stress = stretched_chain(direction, 2.002e-3)
        .world()?
        .contact_network()
        .mean_stress(9.0 * 2.002e-3 * 1e-6);
    let tension = 1e7 * 2e-6 / 1e-6;
    let mut all = Vec::new();
    for (row, a) in stress.iter().zip(direction) {
        for (found, b) in row.iter().zip(direction) {
            all.push(Measurement::relative(tension * a * b, *found, 1e-11));
        }
    }
    Ok(Measurement::worst(all).into())
}

/// Bonds among 25 grains in rows of five; the last two join grains that do not touch.
const BONDS: [[usize; 2]; 10] = [
    [0, 1],
    [2, 3],
    [5, 6],
    [7, 8],
    [10, 15],
    [12, 17],
    [13, 14],
    [20, 21],
    [22, 24],
    [4, 18],
];

/// Bonded and touching grains that move and spin at random.
fn frame() -> Result<World, Failure> {
    let mut random = Pcg64::new(7, 7);
    let mut noise = |scale: f64| scale * (random.random::<f64>() - 0.5);
    let mut draft = Draft::open_box(Integrator::SymplecticEuler, 1e-9)
        .law(AdjustedKelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .law(EulerBernoulli {
            stiffness: 1e7,
            damping: 10.0,
        })
        .law(KelvinVoigt {
            stiffness: 1e7,
            damping: 10.0,
        })
        .law(HaffWerner {
            friction: 0.7,
            damping: 3.0,
        });
    for k in 0..25 {
        let at = [k % 5, k / 5].map(|n| f64::from(n) * 1.9e-3 + noise(1e-4));
        draft = draft.grain(
            Grain::at(at, 1e-3)
                .moving([noise(1.0), noise(1.0)])
                .spinning(noise(500.0)),
        );
    }
    for [i, j] in BONDS {
        draft = draft.bonded(i, j);
    }
    let mut world = draft.world()?;
    world.evaluate_if_pending()?;
    Ok(world)
}

fn virial() -> Check {
    Check {
        id: "estimators.stress.virial",
        claim: "The mean stress is the virial of the forces on the particles, and its antisymmetric part is the sum of their torques.",
        equations: thesis("(26)-(27), (45)"),
        scene: "25 grains that move and spin at random, with ten bonds and with frictional contacts; volume 2 m^3",
        oracle: "Sums over particles instead of contacts and bonds: minus force times position, and torques",
        norm: "Error of each component and of the antisymmetric part, in units of the largest component",
        origin: Origin::Exact,
        reason: "About fifty terms, whose moments about a corner of the frame cancel by a factor of ten",
        effort: Effort::Quick,
        measure: measure_virial,
    }
}

fn measure_virial() -> Outcome {
    const VOLUME: f64 = 2.0;
    let world = frame()?;
    let stress = world.contact_network().mean_stress(VOLUME);
    let forces = world.forces();
    let mut virial = [[0.0; 2]; 2];
    for (force, x) in forces.force.iter().zip(&world.particles().position) {
        for (row, force) in virial.iter_mut().zip([force.x, force.y]) {
            row[0] -= force * x.x / VOLUME;
            row[1] -= force * x.y / VOLUME;
        }
    }
    let scale = virial
        .iter()
        .flatten()
        .fold(0.0, |m: f64, x| m.max(x.abs()));
    let pairs = stress.iter().flatten().zip(virial.iter().flatten());
    let mut all: Vec<Measurement> = pairs
        .map(|(found, expected)| Measurement::scaled(*expected, *found, scale, 1e-13))
        .collect();
    let torque = forces.torque.iter().sum::<f64>() / VOLUME;
    let skew = stress[0][1] - stress[1][0];
    all.push(Measurement::scaled(-torque, skew, scale, 1e-13));
    Ok(Measurement::worst(all).into())
}

fn packing() -> Check {
    Check {
        id: "estimators.packing",
        claim: "Touching equal discs fill pi over twice the square root of three of a hexagonal cell; the coordination number counts every contact and bond twice.",
        equations: thesis("(68), (103)"),
        scene: "200 radii in the area of 200 hexagonal cells; the 25 grains of estimators.stress.virial",
        oracle: "Geometry of the cell; pairs that overlap or are bonded, counted one by one",
        norm: "Relative error",
        origin: Origin::Exact,
        reason: "Two hundred roundings of the same sign in the sum, a few elsewhere",
        effort: Effort::Quick,
        measure: measure_packing,
    }
}

fn measure_packing() -> Outcome {
    let radius = 1.3e-3;
    let cell = 2.0 * 3.0_f64.sqrt() * radius * radius;
    let filled = packing_fraction(&[radius; 200], 200.0 * cell);
    let world = frame()?;
    let p = world.particles();
    let mut links = 0;
    for j in 0..p.len() {
        for i in 0..j {
            let distance =
                (p.position[j].x - p.position[i].x).hypot(p.position[j].y - p.position[i].y);
            links += usize::from(distance < p.radius[i] + p.radius[j] || BONDS.contains(&[i, j]));
        }
    }
    let mean = 2.0 * links as f64 / p.len() as f64;
    Ok(Measurement::worst([
        Measurement::relative(PI / (2.0 * 3.0_f64.sqrt()), filled, 1e-13),
        Measurement::relative(mean, world.contact_network().coordination_number(), 1e-15),
    ])
    .into())
}
