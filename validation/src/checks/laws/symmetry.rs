//! Nothing depends on the observer, on the order of particles, on the direction of time or on the units.

use super::cluster::{Cluster, Rubbing, SI, Units};
use crate::checks::scenes::advance;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome};
use gouge_kernel::World;
use gouge_kernel::geometry::Vec2;

pub(super) fn checks() -> Vec<Check> {
    let scene = "Eight grains, six of them bonded, two thrown at the others: rubbing contacts, breaking bonds, drag and gravity, 3000 steps";
    let check = |id, claim, norm, reason, measure| Check {
        id,
        claim,
        equations: "(3)-(58)",
        scene,
        oracle: "The same scene seen by the other observer",
        norm,
        origin: Origin::Exact,
        reason,
        effort: Effort::Quick,
        measure,
    };
    vec![
        check(
            "laws.units",
            "Metre, second and kilogram may be scaled by powers of two: the motion has the same bits.",
            "Numbers of the state that differ in any bit",
            "Scaling by a power of two commutes with every rounding; square roots see even powers",
            units,
        ),
        check(
            "laws.mirror",
            "The mirror image of a scene moves as the mirror image, bit for bit.",
            "Numbers of the state that differ in any bit",
            "Changing the sign of a coordinate commutes with every rounding",
            mirror,
        ),
        check(
            "laws.relabelling",
            "The order in which particles are listed changes the motion by rounding only.",
            "Largest distance of positions after 100 steps over the spacing of numbers at the extent of the scene and the number of steps",
            "Sums of forces in another order: a few roundings of the forces a step, each of which moves a grain by far less than one rounding of its position; one rounding of the position a step remains",
            relabelling,
        ),
        check(
            "laws.observer",
            "A translation, a rotation and a boost of the observer change the forces by rounding only.",
            "Largest change of a force over the rounding of positions times the largest stiffness, of velocities times the largest damping, and of the force itself",
            "Eight roundings of the relative position and velocity of a pair",
            observer,
        ),
        Check {
            scene: "The same grains without damping, sliding, drag, gravity and breaking: 2000 steps of velocity Verlet forth and as many back",
            oracle: "The initial state",
            ..check(
                "laws.time-reversal",
                "Elastic motion runs back to its beginning when all velocities are reversed.",
                "Largest distance from the initial positions over the spacing of numbers at the extent of the scene and the root of the number of steps",
                "A rounding of the position each step, which the stiff modes do not amplify; sixteen of them for a margin over a random walk",
                time_reversal,
            )
        },
    ]
}

fn numbers<'a>(world: &'a World, scale: [f64; 4]) -> impl Iterator<Item = f64> + 'a {
    let p = world.particles();
    (0..p.len()).flat_map(move |i| {
        let (x, v) = (p.position[i], p.velocity[i]);
        [
            x.x * scale[0],
            x.y * scale[0],
            v.x * scale[1],
            v.y * scale[1],
            p.angle[i] * scale[2],
            p.angular_velocity[i] * scale[3],
        ]
    })
}

fn differing(a: impl Iterator<Item = f64>, b: impl Iterator<Item = f64>) -> usize {
    a.zip(b).filter(|(a, b)| a != b).count()
}

fn run(cluster: &Cluster, steps: u64) -> Result<World, Failure> {
    let mut world = cluster.world()?;
    advance(&mut world, steps)?;
    Ok(world)
}

fn units() -> Outcome {
    let other = Units {
        length: 1024.0,
        time: 0.125,
        mass: 4096.0,
    };
    let mut different = 0;
    for rubbing in [Rubbing::Viscous, Rubbing::Spring] {
        let there = run(&Cluster::new(rubbing, true, SI), 3000)?;
        let here = run(&Cluster::new(rubbing, true, other), 3000)?;
        let back = [
            1.0 / other.length,
            other.time / other.length,
            1.0,
            other.time,
        ];
        different += differing(numbers(&there, [1.0; 4]), numbers(&here, back));
        let broken = |world: &World| world.strong_links().map_or(0, |strong| strong.links.len());
        different += broken(&there).abs_diff(broken(&here));
    }
    Ok(Measurement::count(different).into())
}

fn mirror() -> Outcome {
    let mut different = 0;
    for rubbing in [Rubbing::Viscous, Rubbing::Spring] {
        let cluster = Cluster::new(rubbing, true, SI);
        let mut reflected = cluster.clone();
        for grain in &mut reflected.grains {
            grain.position.x = -grain.position.x;
            grain.velocity.x = -grain.velocity.x;
            grain.angular_velocity = -grain.angular_velocity;
        }
        let (there, here) = (run(&cluster, 3000)?, run(&reflected, 3000)?);
        let signs = [-1.0, 1.0, -1.0, 1.0, -1.0, -1.0];
        let seen = numbers(&here, [1.0; 4])
            .enumerate()
            .map(|(n, value)| value * signs[n % 6]);
        different += differing(numbers(&there, [1.0; 4]), seen);
    }
    Ok(Measurement::count(different).into())
}

/// Spacing of numbers at the extent of the cluster in m.
const SPACING: f64 = 8e-3 * f64::EPSILON;

fn relabelling() -> Outcome {
    let order = [5, 2, 7, 0, 4, 1, 6, 3];
    let steps = 100;
    let cluster = Cluster::new(Rubbing::Spring, true, SI);
    let mut renamed = cluster.clone();
    let place = |old: usize| order.iter().position(|&one| one == old).unwrap_or(old);
    renamed.grains = order.iter().map(|&old| cluster.grains[old]).collect();
    for bond in &mut renamed.bonds {
        bond.between = bond.between.map(place);
    }
    let (there, here) = (run(&cluster, steps)?, run(&renamed, steps)?);
    let far = (0..order.len()).map(|new| {
        let (a, b) = (
            there.particles().position[order[new]],
            here.particles().position[new],
        );
        Measurement::scaled(0.0, (a - b).norm(), SPACING * steps as f64, 1.0)
    });
    Ok(Measurement::worst(far).into())
}

fn forces(cluster: &Cluster) -> Result<Vec<Vec2>, Failure> {
    let mut world: World = cluster.world()?;
    world.evaluate_if_pending()?;
    Ok(world.forces().force.clone())
}

fn turned(v: Vec2, [cosine, sine]: [f64; 2]) -> Vec2 {
    Vec2::new(cosine * v.x - sine * v.y, sine * v.x + cosine * v.y)
}

fn observer() -> Outcome {
    let mut worst = Vec::new();
    for rubbing in [Rubbing::Viscous, Rubbing::Spring] {
        let mut cluster = Cluster::new(rubbing, true, SI);
        // Drag and gravity belong to the laboratory.
        (cluster.model.ambient, cluster.model.external) = (None, None);
        let before = forces(&cluster)?;
        let (far, fast, turn) = (
            Vec2::new(0.37, -1.1),
            Vec2::new(12.0, 5.0),
            [libm::cos(0.7), libm::sin(0.7)],
        );
        let mut other = cluster.clone();
        for grain in &mut other.grains {
            grain.position = turned(grain.position, turn) + far;
            grain.velocity = turned(grain.velocity, turn) + fast;
        }
        let roundings = f64::EPSILON * (2e7 * far.norm() + 30.0 * fast.norm());
        let pairs = before.iter().zip(forces(&other)?);
        worst.extend(pairs.map(|(&f, g)| {
            let scale = roundings + f64::EPSILON * f.norm();
            Measurement::scaled(0.0, (turned(f, turn) - g).norm(), scale, 8.0)
        }));
    }
    Ok(Measurement::worst(worst).into())
}

fn time_reversal() -> Outcome {
    let steps = 2000;
    let mut cluster = Cluster::new(Rubbing::Spring, false, SI);
    if let Some(contact) = &mut cluster.model.contact {
        contact.tangential = None;
    }
    let there = run(&cluster, steps)?;
    let world = run(&reversed(&cluster, &there), steps)?;
    let far = cluster
        .grains
        .iter()
        .zip(&world.particles().position)
        .map(|(grain, &x)| {
            Measurement::scaled(
                0.0,
                (grain.position - x).norm(),
                SPACING * (steps as f64).sqrt(),
                16.0,
            )
        });
    Ok(Measurement::worst(far).into())
}

/// The cluster in the state of a world with all velocities reversed; bonds are measured from their
/// beginning in the cluster.
fn reversed(cluster: &Cluster, there: &World) -> Cluster {
    let mut back = cluster.clone();
    let p = there.particles();
    for (i, grain) in back.grains.iter_mut().enumerate() {
        (grain.position, grain.velocity) = (p.position[i], -p.velocity[i]);
        (grain.angle, grain.angular_velocity) = (p.angle[i], -p.angular_velocity[i]);
    }
    for bond in &mut back.bonds {
        let [i, j] = bond.between.map(|end| cluster.grains[end]);
        let way = j.position - i.position;
        bond.initial_distance = Some(way.norm());
        let lambda = way.y.atan2(way.x);
        bond.initial_angles = Some([i.angle - lambda, j.angle - lambda - std::f64::consts::PI]);
    }
    back
}
