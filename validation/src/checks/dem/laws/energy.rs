//! Stored energy and dissipation.

use super::cluster::{Cluster, Rubbing, SI};
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Failure, Measurement, Origin, Outcome, thesis};
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, BeamLaw, Bshp, CundallStrack, CundallStrackTruncated, EulerBernoulli,
    ExternalLaw, Gravity, HaffWerner, HarmonicWell, KelvinVoigt, NormalLaw, TangentialLaw,
    TangentialMotion,
};
use gouge_dem::particles::Particles;
use gouge_dem::{Start, World};
use gouge_scalars::Dual;

pub(super) fn checks() -> Vec<Check> {
    let check = |id, claim, equations| Check {
        id,
        claim,
        equations,
        scene: "Each law alone, in 100 000 random states over many decades",
        oracle: "The derivative of the stored energy, by dual numbers",
        norm: "Largest relative difference in units of rounding",
        origin: Origin::Exact,
        reason: "Up to four roundings on each side",
        effort: Effort::Quick,
        measure: gradients,
    };
    vec![
        check(
            "laws.gradient",
            "Every conservative force is minus the derivative of the energy that its law stores.",
            thesis("(8)-(10), (35)-(45), (67), (75)-(77)"),
        ),
        Check {
            scene: "Eight grains, six of them bonded, with contacts whose friction springs stick, under gravity, displaced from the state in which the bonds began",
            oracle: "The derivative of the energy of the whole world with respect to each coordinate, by dual numbers",
            norm: "Largest error of a force or torque, in units of rounding of the largest spring force",
            reason: "About ten roundings per bond or contact, of which a grain has at most six",
            measure: world_gradient,
            ..check(
                "laws.world-gradient",
                "Forces and torques in a bonded cluster with sticking contacts are minus the gradient of its energy, including the derivatives with respect to the angles.",
                thesis("(6), (7), (45), (75)-(77), E10, E17"),
            )
        },
        Check {
            oracle: "Zero",
            norm: "Number of cases in which the heat is negative beyond the rounding of force times rate, or in which a contact attracts",
            reason: "Dissipated power is never negative, so no such case is allowed",
            measure: passivity,
            ..check(
                "laws.passivity",
                "Contact laws, except the printed Cundall-Strack law, and bond laws never return heat; normal forces of contacts never attract.",
                thesis("(35)-(45), (78)"),
            )
        },
        Check {
            scene: "One contact: sliding under a normal force of 300 N, loading to 1000 N, return to the start, unloading",
            oracle: "k z^2 / 2 - (k z0^2 / 2 + F (z - z0)), with F the friction limit under the lower load and z0 = F / k, from thesis E15",
            norm: "Relative error of the work and the heat of the printed law; counted as a failure if the truncated law does not lose energy",
            reason: "The force is piecewise linear and its kinks lie on nodes, so the trapezoidal rule is exact up to the rounding of 4000 sums. The expected heat also contains half a step at the friction limit, because the printed force jumps there",
            measure: printed_cycle,
            ..check(
                "laws.printed-cycle",
                "The printed Cundall-Strack law creates energy in a closed cycle. The amount follows from its two branches and is booked as negative heat. The truncated law loses energy in the same cycle.",
                thesis("(42), E15, E56"),
            )
        },
    ]
}

const STATES: usize = 100_000;

/// Compares a force with minus a slope, in units of rounding.
fn against(force: f64, slope: f64) -> Measurement {
    Measurement::scaled(
        -slope,
        force,
        f64::EPSILON * slope.abs() + f64::MIN_POSITIVE,
        8.0,
    )
}

fn gradients() -> Outcome {
    let mut random = Random::new(31);
    let mut worst = Vec::with_capacity(8 * STATES);
    for _ in 0..STATES {
        let (k, xi) = (random.magnitude(1e-3, 1e12), random.magnitude(1e-12, 1e-2));
        let radii = [random.magnitude(1e-4, 1e-1), random.magnitude(1e-4, 1e-1)];
        worst.extend(normal(k, xi, radii, random.between(-0.9, 0.49)));
        worst.extend(tangential(k, random.signed(1e-12, 1e-2)));
        worst.extend(external(
            random.magnitude(1e-3, 1e6),
            random.magnitude(1e-9, 1.0),
            random.signed(1e-6, 1e3),
        ));
    }
    Ok(Measurement::worst(worst).into())
}

fn normal(k: f64, xi: f64, radii: [f64; 2], nu: f64) -> [Measurement; 3] {
    let (x, dual) = (Dual::variable(xi), radii.map(Dual::from_f64));
    let kv = KelvinVoigt {
        stiffness: k,
        damping: 3.0,
    };
    let bshp = Bshp {
        youngs_modulus: k,
        poissons_ratio: nu,
        dissipative_constant: 1e-4,
    };
    let akv = AdjustedKelvinVoigt {
        stiffness: k,
        damping: 3.0,
    };
    [
        against(kv.force(radii, xi, 0.0), kv.stored_energy(dual, x).slope()),
        against(
            bshp.force(radii, xi, 0.0),
            bshp.stored_energy(dual, x).slope(),
        ),
        against(akv.force(xi, 0.0), akv.stored_energy(x).slope()),
    ]
}

fn tangential(k: f64, zeta: f64) -> [Measurement; 3] {
    let (x, load) = (Dual::variable(zeta), 2.0 * k * zeta.abs());
    let slide = TangentialMotion {
        displacement: zeta,
        velocity: 1.0,
    };
    let eb = EulerBernoulli {
        stiffness: k,
        damping: 3.0,
    };
    let printed = CundallStrack {
        friction: 1.0,
        stiffness: k,
        grips_at_rest: false,
    };
    let cut = CundallStrackTruncated {
        friction: 1.0,
        stiffness: k,
    };
    let normal = Dual::from_f64(-load);
    [
        against(eb.force(zeta, 0.0), eb.stored_energy(x).slope()),
        against(
            printed.friction(slide, -load, &mut 0.0).force,
            printed.stored_energy(x, normal, Dual::default()).slope(),
        ),
        against(
            cut.friction(slide, -load, &mut 0.0).force,
            cut.stored_energy(x, normal, Dual::default()).slope(),
        ),
    ]
}

fn external(strength: f64, mass: f64, y: f64) -> [Measurement; 2] {
    let at = Vec2::new(Dual::from_f64(0.3), Dual::variable(y));
    let (gravity, well) = (
        Gravity {
            acceleration: strength,
        },
        HarmonicWell {
            stiffness: strength,
            centre: 0.0,
        },
    );
    let dual = Dual::from_f64(mass);
    [
        against(
            gravity.force(mass, Vec2::new(0.3, y)).y,
            gravity.potential(dual, at).slope(),
        ),
        against(
            well.force(mass, Vec2::new(0.3, y)).y,
            well.potential(dual, at).slope(),
        ),
    ]
}

/// The cluster, with bonds that began at lengths and angles differing by up to 2 % and 0.02 rad from
/// the present ones.
fn moved() -> Cluster {
    let mut cluster = Cluster::new(Rubbing::Spring, false, SI);
    cluster.model.external = Some(gouge_dem::model::External::Gravity(Gravity {
        acceleration: 1e4,
    }));
    let mut random = Random::new(32);
    for bond in &mut cluster.bonds {
        let [i, j] = bond.between.map(|end| cluster.grains[end]);
        bond.initial_distance = Some((j.position - i.position).norm() * random.between(0.98, 1.02));
        let way = j.position - i.position;
        let lambda = way.y.atan2(way.x);
        let bent = |random: &mut Random| random.between(-0.02, 0.02);
        bond.initial_angles = Some([
            bent(&mut random) - lambda,
            bent(&mut random) - lambda - std::f64::consts::PI,
        ]);
    }
    cluster
        .grains
        .iter_mut()
        .for_each(|grain| grain.velocity = Vec2::zero());
    cluster
        .grains
        .iter_mut()
        .for_each(|grain| grain.angular_velocity = 0.0);
    cluster
}

fn world_gradient() -> Outcome {
    let cluster = moved();
    let mut world: World = cluster.world()?;
    world.evaluate_if_pending()?;
    let forces = world.forces();
    let mut worst = Vec::new();
    for i in 0..cluster.grains.len() {
        let radius = cluster.grains[i].radius;
        let given = [
            forces.force[i].x,
            forces.force[i].y,
            forces.torque[i] / radius,
        ];
        for (axis, given) in given.into_iter().enumerate() {
            let slope = slope(&cluster, i, axis)? / if axis == 2 { radius } else { 1.0 };
            // Springs are strained by up to 2 % of their length.
            let scale = f64::EPSILON * 2e7 * 2e-3;
            worst.push(Measurement::scaled(-slope, given, scale, 64.0));
        }
    }
    Ok(Measurement::worst(worst).into())
}

/// Derivative of the energy of the cluster with respect to one coordinate of a grain: x, y or the
/// angle.
fn slope(cluster: &Cluster, i: usize, axis: usize) -> Result<f64, Failure> {
    let mut particles: Particles<Dual> = cluster.grains.iter().copied().collect();
    let one = Dual::new(0.0, 1.0);
    match axis {
        0 => particles.position[i].x += one,
        1 => particles.position[i].y += one,
        _ => particles.angle[i] += one,
    }
    // Without stated initial values, a bond would take its reference from the perturbed state.
    let start = Start {
        bonds: cluster.bonds.clone(),
        ..Start::default()
    };
    Ok(World::new(cluster.model, particles, &start)?
        .energy()
        .mechanical()
        .slope())
}

/// Heat rates of both laws of a bond.
fn beam_heat_rates(stiffness: f64, damping: f64, rate: f64) -> [f64; 2] {
    let bending = EulerBernoulli { stiffness, damping };
    let stretching = AdjustedKelvinVoigt { stiffness, damping };
    [bending.heat_rate(rate), stretching.heat_rate(rate)]
}

fn passivity() -> Outcome {
    let mut random = Random::new(33);
    let mut negative = 0;
    for _ in 0..STATES {
        let (k, c) = (random.magnitude(1.0, 1e9), random.magnitude(1e-3, 1e4));
        let (xi, rate) = (random.signed(1e-9, 1e-3), random.signed(1e-6, 1e3));
        let radii = [random.magnitude(1e-4, 1e-2), random.magnitude(1e-4, 1e-2)];
        let kv = KelvinVoigt {
            stiffness: k,
            damping: c,
        };
        let bshp = Bshp {
            youngs_modulus: 1e3 * k,
            poissons_ratio: 0.2,
            dissipative_constant: 1e-6 * c,
        };
        let normal = [
            (kv.force(radii, xi, rate), kv.elastic_force(radii, xi)),
            (bshp.force(radii, xi, rate), bshp.elastic_force(radii, xi)),
        ];
        let lost = |(total, elastic): (f64, f64)| {
            (elastic - total) * rate < -4.0 * f64::EPSILON * (elastic * rate).abs()
        };
        negative += normal.into_iter().filter(|&pair| lost(pair)).count();
        negative +=
            usize::from(kv.force(radii, xi, rate) > 0.0 || bshp.force(radii, xi, rate) > 0.0);
        let beams = beam_heat_rates(k, c, rate);
        let slide = TangentialMotion {
            displacement: xi,
            velocity: rate,
        };
        let load = random.magnitude(1e-3, 1e3);
        let viscous = HaffWerner {
            friction: 0.7,
            damping: c,
        }
        .friction(slide, -load, &mut 0.0);
        let mut slip = random.signed(1e-9, 1e-3);
        let cut = CundallStrackTruncated {
            friction: 0.7,
            stiffness: k,
        }
        .friction(slide, -load, &mut slip);
        let heats = [
            beams[0],
            beams[1],
            viscous.heat_rate,
            viscous.heat,
            cut.heat,
            cut.heat_rate,
        ];
        negative += heats.into_iter().filter(|&heat| heat < 0.0).count();
    }
    Ok(Measurement::count(negative).into())
}

/// Work done and heat booked by a law in a closed cycle: sliding under the first load and returning
/// under the second.
fn cycle(law: impl TangentialLaw, slid: f64, loads: [f64; 2]) -> [f64; 2] {
    let steps = 1000;
    let (mut memory, mut work, mut heat) = (0.0, 0.0, 0.0);
    let legs = [(1.0, loads[0]), (-1.0, loads[1])];
    for (direction, load) in legs {
        let at = |step: usize| {
            let part = slid * step as f64 / steps as f64;
            TangentialMotion {
                displacement: if direction > 0.0 { part } else { slid - part },
                velocity: direction,
            }
        };
        let mut before = law.friction(at(0), -load, &mut memory);
        heat += before.heat;
        for step in 1..=steps {
            let now = law.friction(at(step), -load, &mut memory);
            let way = slid / steps as f64;
            work += 0.5 * (before.force + now.force) * direction * way;
            heat += now.heat + 0.5 * (before.heat_rate + now.heat_rate) * way;
            before = now;
        }
    }
    [work, heat]
}

fn printed_cycle() -> Outcome {
    let (mu, k, loads) = (0.5, 1e6, [300.0, 1000.0]);
    // Sliding begins at a node, and the return stays below the friction limit of the higher load.
    let (low, slid) = (mu * loads[0], 4e-4);
    let start = low / k;
    let created = 0.5 * k * slid * slid - (0.5 * k * start * start + low * (slid - start));
    let [work, heat] = cycle(
        CundallStrack {
            friction: mu,
            stiffness: k,
            grips_at_rest: false,
        },
        slid,
        loads,
    );
    let [cut_work, _] = cycle(
        CundallStrackTruncated {
            friction: mu,
            stiffness: k,
        },
        slid,
        loads,
    );
    // The printed force jumps by the friction limit within one step, and the trapezoidal rule counts
    // half of that step.
    let jump = 0.5 * low * slid / 1000.0;
    Ok(Measurement::worst([
        Measurement::relative(created, work, 1e-12),
        Measurement::relative(jump - created, heat, 1e-12),
        Measurement::absolute(1.0, f64::from(u8::from(cut_work < 0.0)), 0.0),
    ])
    .into())
}
