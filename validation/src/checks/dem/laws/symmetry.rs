//! Nothing depends on the observer, the order of particles, the direction of time or the units.

use super::cluster::{Cluster, Rubbing, SI, Units};
use crate::checks::dem::scenes::advance;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_dem::particles::Particles;
use gouge_dem::{Start, World};
use gouge_scalars::DoubleDouble;

pub(super) fn checks() -> Vec<Check> {
    let scene = "Eight grains, six of them bonded, two thrown at the others: contacts with friction, breaking bonds, drag and gravity, 3000 steps";
    let check = |id, claim, norm, reason, measure| Check {
        id,
        claim,
        equations: thesis("(3)-(58)"),
        scene,
        oracle: "The same scene, transformed",
        norm,
        origin: Origin::Exact,
        reason,
        effort: Effort::Quick,
        measure,
    };
    vec![
        check(
            "laws.units",
            "If metre, second and kilogram are scaled by powers of two, the motion is the same to the last bit.",
            "Number of state variables that differ in any bit",
            "Scaling by a power of two commutes with every rounding; only even powers occur under square roots",
            units,
        ),
        check(
            "laws.mirror",
            "The mirror image of a scene moves as the mirror image of the motion, bit for bit.",
            "Number of state variables that differ in any bit",
            "Changing the sign of a coordinate commutes with every rounding",
            mirror,
        ),
        check(
            "laws.relabelling",
            "The order in which particles are listed changes the motion by rounding only.",
            "Largest difference of positions after 3000 steps in double-double precision, in units of sixteen roundings per step",
            "A rounding in double-double precision is 1e-31 m, so that any larger dependence on the order shows. Positions and forces are rounded a few times per step; stiff modes carry these errors on but do not amplify them",
            relabelling,
        ),
        check(
            "laws.observer",
            "A translation, a rotation and a boost of the observer change the motion by rounding only.",
            "Largest difference of positions after 3000 steps in double-double precision, in units of sixteen roundings per step",
            "As for laws.relabelling, with positions 1.2 m from the origin. Drag and gravity are left out because they distinguish the laboratory frame",
            observer,
        ),
        Check {
            scene: "The same grains without damping, friction, drag, gravity and breaking: 2000 steps of velocity Verlet forward and 2000 back",
            oracle: "The initial state",
            ..check(
                "laws.time-reversal",
                "Elastic motion returns to its initial state when all velocities are reversed.",
                "Largest distance from the initial positions, in units of the spacing of numbers at the size of the cluster times the square root of the number of steps",
                "The position is rounded once per step, and stiff modes do not amplify the error; the tolerance is sixteen times a random walk of roundings",
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
        let there = run(&Cluster::new(rubbing, true, SI), STEPS)?;
        let here = run(&Cluster::new(rubbing, true, other), STEPS)?;
        let back = [
            1.0 / other.length,
            other.time / other.length,
            1.0,
            other.time,
        ];
        different += differing(numbers(&there, [1.0; 4]), numbers(&here, back));
        let broken = |world: &World| world.bonds().map_or(0, |strong| strong.len());
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
        let (there, here) = (run(&cluster, STEPS)?, run(&reflected, STEPS)?);
        let signs = [-1.0, 1.0, -1.0, 1.0, -1.0, -1.0];
        let seen = numbers(&here, [1.0; 4])
            .enumerate()
            .map(|(n, value)| value * signs[n % 6]);
        different += differing(numbers(&there, [1.0; 4]), seen);
    }
    Ok(Measurement::count(different).into())
}

/// Spacing of numbers at the size of the cluster, in m.
const SPACING: f64 = 8e-3 * f64::EPSILON;
const STEPS: u64 = 3000;
/// Sixteen double-double roundings per step of a position this far from the origin, in m.
const FAR: f64 = 1.2;
const ROUNDINGS: f64 = 16.0 * STEPS as f64 * FAR / (1u128 << 104) as f64;

type Place = Vec2<DoubleDouble>;

/// Runs a cluster in double-double precision after a transformation of its particles.
fn seen(
    cluster: &Cluster,
    see: impl Fn(&mut Particles<DoubleDouble>),
) -> Result<Vec<Place>, Failure> {
    let mut particles: Particles<DoubleDouble> = cluster.grains.iter().copied().collect();
    see(&mut particles);
    let start = Start {
        bonds: cluster.bonds.clone(),
        ..Start::default()
    };
    let mut world = World::new(cluster.model, particles, &start)?;
    advance(&mut world, STEPS)?;
    Ok(world.particles().position.clone())
}

fn apart(a: Place, b: Place) -> Measurement {
    Measurement::scaled(0.0, (a - b).norm().to_f64(), ROUNDINGS, 1.0)
}

fn relabelling() -> Outcome {
    let order = [5, 2, 7, 0, 4, 1, 6, 3];
    let mut worst = Vec::new();
    for rubbing in [Rubbing::Viscous, Rubbing::Spring] {
        let cluster = Cluster::new(rubbing, true, SI);
        let mut renamed = cluster.clone();
        let place = |old: usize| order.iter().position(|&one| one == old).unwrap_or(old);
        renamed.grains = order.iter().map(|&old| cluster.grains[old]).collect();
        for bond in &mut renamed.bonds {
            bond.between = bond.between.map(place);
        }
        let (there, here) = (seen(&cluster, |_| ())?, seen(&renamed, |_| ())?);
        worst.extend((0..order.len()).map(|new| apart(there[order[new]], here[new])));
    }
    Ok(Measurement::worst(worst).into())
}

/// An observer who moves, is displaced, and is turned by the larger acute angle of the 3-4-5 triangle.
struct Observer {
    cosine: DoubleDouble,
    sine: DoubleDouble,
    far: Place,
    fast: Place,
}

impl Observer {
    fn new() -> Self {
        let fifths = |n: f64| DoubleDouble::from_f64(n) / DoubleDouble::from_f64(5.0);
        Self {
            cosine: fifths(3.0),
            sine: fifths(4.0),
            far: Vec2::new(0.37, -1.1).cast(),
            fast: Vec2::new(12.0, 5.0).cast(),
        }
    }
    fn turned(&self, v: Place) -> Place {
        Vec2::new(
            self.cosine * v.x - self.sine * v.y,
            self.sine * v.x + self.cosine * v.y,
        )
    }
    fn place(&self, x: Place, time: DoubleDouble) -> Place {
        self.turned(x) + self.far + self.fast * time
    }
}

fn observer() -> Outcome {
    let observer = Observer::new();
    let mut worst = Vec::new();
    for rubbing in [Rubbing::Viscous, Rubbing::Spring] {
        let mut cluster = Cluster::new(rubbing, true, SI);
        // Drag and gravity distinguish the laboratory frame.
        (cluster.model.ambient, cluster.model.external) = (None, None);
        let there = seen(&cluster, |_| ())?;
        let here = seen(&cluster, |p| {
            let begin = DoubleDouble::default();
            p.position
                .iter_mut()
                .for_each(|x| *x = observer.place(*x, begin));
            p.velocity
                .iter_mut()
                .for_each(|v| *v = observer.turned(*v) + observer.fast);
        })?;
        let time = DoubleDouble::from_f64(cluster.model.time_step) * STEPS as f64;
        let pairs = there.into_iter().zip(here);
        worst.extend(pairs.map(|(x, seen)| apart(observer.place(x, time), seen)));
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

/// The cluster in the state of a world, with all velocities reversed; bonds keep the reference lengths
/// and angles of the initial cluster.
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
