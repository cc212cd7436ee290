//! Compares the kernel step by step with an independent model of the equations in the thesis author's program.
//!
//! Both sides do the same operations except for the order of sums and the computation of angles, so they differ only by
//! rounding; [`rounding`] estimates by how much.

mod block;
mod bonds;
mod contacts;

use gouge_common::geometry::{Domain, Vec2};
use gouge_common::pair::Pair;
use gouge_dem::bonds::BondStart;
use gouge_dem::contacts::ContactStart;
use gouge_dem::geometry::ContactDistance;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::{
    AdjustedKelvinVoigt, Controller, CreepingDrag, CundallStrack, Driving, EulerBernoulli,
    HaffWerner, HarmonicWell, KelvinVoigt, ZhangEckert,
};
use gouge_dem::model::{
    Ambient, BondLaws, ContactLaws, ContactNormal, ContactTangential, External, Model, Reading,
    Yielding,
};
use gouge_dem::particles::{Particle, Role};
use gouge_dem::{Start, World};
use gouge_validation::oracles::original::{Duty, Ends, Grain, Original, Rubbing, Rules, Spring};
use std::f64::consts::{PI, TAU};

const HAFF_WERNER: Rubbing = Rubbing::HaffWerner {
    mu: 0.7,
    gamma: 1e2,
};
const CUNDALL_STRACK: Rubbing = Rubbing::CundallStrack { mu: 0.7, k: 1e8 };
const EACH_RUBBING: [Rubbing; 3] = [Rubbing::Zero, HAFF_WERNER, CUNDALL_STRACK];
const STRENGTH: [f64; 2] = [280e6, 168e6];
const BOX: f64 = 25e-3;

/// The parameters of the author's runs.
const RULES: Rules = Rules {
    dt: 1e-8,
    period: None,
    touch: Spring {
        k: 1e7,
        gamma: 10.0,
    },
    rubbing: Rubbing::Zero,
    stretch: Spring {
        k: 1e7,
        gamma: 10.0,
    },
    bend: Spring {
        k: 1e7,
        gamma: 10.0,
    },
    strength: None,
    viscosity: None,
    well: None,
    driver: None,
};

/// A grain of granite at rest.
fn grain(x: [f64; 2], r: f64) -> Grain {
    Grain {
        x,
        v: [0.0; 2],
        phi: 0.0,
        omega: 0.0,
        r,
        density: 2700.0,
        duty: Duty::Free,
    }
}

/// The same scene in the kernel and in the model of the author's program.
struct Twins {
    world: World,
    oracle: Original,
}

impl Twins {
    fn new(oracle: Original, ledger: bool) -> Self {
        // Every second pair is reversed: the order of its ends must not matter.
        let bonds = oracle.bonds.iter().map(|(&(i, j), bond)| {
            let ([a, b], turned) = (bond.psi, (i + j) % 2 == 1);
            BondStart {
                between: if turned { [j, i] } else { [i, j] },
                strength_factor: bond.factor,
                initial_distance: Some(bond.length),
                initial_angles: Some(if turned { [b, a] } else { [a, b] }),
            }
        });
        Self::starting(bonds.collect(), oracle, ledger)
    }

    /// Both sides, with bonds that begin at t = 0 in the current state.
    fn bonded_now(oracle: Original) -> Self {
        let bonds = oracle.bonds.iter().map(|(&(i, j), bond)| BondStart {
            between: [j, i],
            strength_factor: bond.factor,
            initial_distance: None,
            initial_angles: None,
        });
        Self::starting(bonds.collect(), oracle, true)
    }

    fn starting(bonds: Vec<BondStart>, oracle: Original, ledger: bool) -> Self {
        let [x, y] = oracle.drive;
        let contacts = oracle
            .contacts
            .iter()
            .map(|(&(i, j), &[a, b])| ContactStart {
                between: [j, i],
                initial_angles: [b, a],
            });
        let contacts = contacts.collect();
        let start = Start {
            bonds,
            contacts,
            drive_force: Vec2::new(x, y),
        };
        let particles = oracle.grains.iter().map(particle).collect();
        let world = World::new(model(&oracle, ledger), particles, &start).expect("a sound scene");
        Self { world, oracle }
    }
}

fn particle(grain: &Grain) -> Particle {
    Particle {
        position: Vec2::new(grain.x[0], grain.x[1]),
        velocity: Vec2::new(grain.v[0], grain.v[1]),
        angle: grain.phi,
        angular_velocity: grain.omega,
        radius: grain.r,
        density: grain.density,
        inertia_factor: Reading::Thesis.inertia_factor(),
        role: match grain.duty {
            Duty::Free => Role::Free,
            Duty::Driven => Role::Driven,
            Duty::Fixed => Role::Fixed,
        },
    }
}

fn model(oracle: &Original, ledger: bool) -> Model {
    let rules = &oracle.rules;
    Model {
        reading: Reading::Thesis,
        integrator: Integrator::Euler,
        time_step: rules.dt,
        domain: Domain {
            width: rules.period,
            height: None,
            periodic: rules.period.is_some(),
        },
        contact: Some(contact(rules)),
        bond: (!oracle.bonds.is_empty()).then(|| bond(rules)),
        ambient: rules
            .viscosity
            .map(|viscosity| Ambient::Creeping(CreepingDrag { viscosity })),
        external: rules
            .well
            .map(|[stiffness, centre]| External::HarmonicWell(HarmonicWell { stiffness, centre })),
        driving: rules.driver.map(|driver| Driving {
            controller: Controller::RateLimited {
                force_rate: driver.rate,
            },
            speed: driver.speed,
            pressure: driver.load,
            area: 1.0,
        }),
        ledger,
    }
}

fn contact(rules: &Rules) -> ContactLaws {
    let tangential = match rules.rubbing {
        Rubbing::Zero => None,
        Rubbing::HaffWerner { mu, gamma } => Some(ContactTangential::HaffWerner(HaffWerner {
            friction: mu,
            damping: gamma,
        })),
        Rubbing::CundallStrack { mu, k } => {
            let (friction, stiffness, grips_at_rest) = (mu, k, true);
            let law = CundallStrack {
                friction,
                stiffness,
                grips_at_rest,
            };
            Some(ContactTangential::CundallStrack(law))
        }
    };
    let Spring {
        k: stiffness,
        gamma: damping,
    } = rules.touch;
    let normal = ContactNormal::KelvinVoigt(KelvinVoigt { stiffness, damping });
    ContactLaws {
        distance: ContactDistance::Radius,
        normal,
        tangential,
    }
}

fn bond(rules: &Rules) -> BondLaws {
    let Rules { stretch, bend, .. } = rules;
    let yielding = |[normal_strength, tangential_strength]: [f64; 2]| Yielding {
        law: ZhangEckert {
            normal_strength,
            tangential_strength,
        },
        tensile_strength: None,
        unbreakable_edges: true,
    };
    BondLaws {
        normal: AdjustedKelvinVoigt {
            stiffness: stretch.k,
            damping: stretch.gamma,
        },
        tangential: Some(EulerBernoulli {
            stiffness: bend.k,
            damping: bend.gamma,
        }),
        yielding: rules.strength.map(yielding),
    }
}

/// Largest differences, magnitudes or tolerances of position, velocity, angle and angular velocity of any particle
/// and of the total driving force, in SI units.
#[derive(Clone, Copy, Debug, Default)]
struct Deviation([f64; 5]);

impl Deviation {
    fn widen(&mut self, other: [f64; 5]) {
        for (widest, new) in self.0.iter_mut().zip(other) {
            // NaN must not count as a small number.
            *widest = if new.is_nan() {
                f64::INFINITY
            } else {
                widest.max(new)
            };
        }
    }
}

/// The result of running both sides.
struct Replay {
    twins: Twins,
    worst: Deviation,
    largest: Deviation,
    /// The steps in which bonds broke.
    breaks: Vec<u64>,
    /// Number of pairs whose bond broke and that touched in the same step.
    broken_into_contact: usize,
    /// Number of steps with at least one contact.
    touching: u64,
}

/// Run both sides and compare them after every step.
fn replay(twins: Twins, steps: u64) -> Replay {
    let (worst, largest) = (Deviation::default(), Deviation::default());
    let mut run = Replay {
        twins,
        worst,
        largest,
        breaks: vec![],
        broken_into_contact: 0,
        touching: 0,
    };
    for step in 0..steps {
        let before: Vec<Ends> = run.twins.oracle.bonds.keys().copied().collect();
        run.twins.world.step().expect("a finite state");
        run.twins.oracle.step();
        compare_links(&run.twins);
        let Original {
            bonds, contacts, ..
        } = &run.twins.oracle;
        if bonds.len() < before.len() {
            run.breaks.push(step);
            let touches = |ends: &&Ends| !bonds.contains_key(ends) && contacts.contains_key(ends);
            run.broken_into_contact += before.iter().filter(touches).count();
        }
        run.touching += u64::from(!contacts.is_empty());
        compare_states(&mut run);
    }
    run
}

/// Check that both sides have the same bonds and, if the kernel stores contacts, the same contacts.
fn compare_links(Twins { world, oracle }: &Twins) {
    let pairs = world.bonds().map_or(&[][..], |bonds| bonds.pairs());
    let bonded = in_order(pairs.iter().copied());
    let expected: Vec<Ends> = oracle.bonds.keys().copied().collect();
    assert_eq!(bonded, expected, "bonds after {} steps", world.steps());
    if matches!(oracle.rules.rubbing, Rubbing::CundallStrack { .. }) {
        let moves = |i: usize| oracle.grains[i].duty != Duty::Fixed;
        let contacts = world.contacts().expect("there are contacts");
        let touching = in_order(contacts.remembered().map(|(pair, _)| pair));
        let expected = oracle
            .contacts
            .keys()
            .copied()
            .filter(|&(i, j)| moves(i) || moves(j));
        let expected: Vec<Ends> = expected.collect();
        assert_eq!(touching, expected, "contacts after {} steps", world.steps());
    }
}

/// Pairs sorted by their first particles.
fn in_order(pairs: impl Iterator<Item = Pair>) -> Vec<Ends> {
    let mut all: Vec<Ends> = pairs.map(Pair::indices).collect();
    all.sort_unstable();
    all
}

fn compare_states(run: &mut Replay) {
    let Twins { world, oracle } = &run.twins;
    let p = world.particles();
    let force = world.drive().force;
    let drive = [force.x - oracle.drive[0], force.y - oracle.drive[1]];
    let drive = drive[0].hypot(drive[1]);
    for (i, grain) in oracle.grains.iter().enumerate() {
        let mut x = p.position[i].x - grain.x[0];
        if let Some(l) = oracle.rules.period {
            assert!((0.0..=l).contains(&p.position[i].x), "in the box");
            x -= l * (x / l).round();
        }
        let y = p.position[i].y - grain.x[1];
        let v = [p.velocity[i].x - grain.v[0], p.velocity[i].y - grain.v[1]];
        let (phi, omega) = (p.angle[i] - grain.phi, p.angular_velocity[i] - grain.omega);
        let differences = [x.hypot(y), v[0].hypot(v[1]), phi.abs(), omega.abs(), drive];
        run.worst.widen(differences);
        let [x, v] = [grain.x, grain.v].map(|a| a[0].hypot(a[1]));
        let drive = oracle.drive[0].hypot(oracle.drive[1]);
        run.largest
            .widen([x, v, grain.phi.abs(), grain.omega.abs(), drive]);
    }
}

/// Growth of errors in a stable motion.
const STABLE: f64 = 1.0;
/// Growth of errors in the block. With an explicit step a sticking Cundall-Strack contact has the negative damping
/// -k dt, so an error grows by a factor e in about 4 us, and the block moves for 10 us: e^2.5. The model deviates from
/// itself by more than that if positions are changed by one ulp in every step.
const BLOCK_GROWTH: f64 = 12.0;
/// Contacts and bonds of a particle; about the largest number that occurs.
const LINKS: f64 = 8.0;

/// Estimate of the differences that rounding causes in a replay.
///
/// A position X has the error eps X and an angle A the error eps A. So the force of a contact or bond with stiffness k
/// and damping g has the error eps (k (X + r A) + g V), where V is the relative surface velocity. In one step this
/// changes a velocity by the force error times dt / m. Errors of all contacts, bonds and steps are assumed to add
/// like a random walk, with the square root of the number of steps, and to be amplified by the motion until the end
/// (`growth`). The error of a position is the velocity error times the time, plus the rounding error of the
/// position's own sum. The latter repeats in free flight and so grows linearly with the number of steps. The driving
/// force is a sum of equal terms, which is the same on both sides unless a sign differs.
fn rounding(run: &Replay, growth: f64) -> Deviation {
    let Original { rules, grains, .. } = &run.twins.oracle;
    let steps = run.twins.world.steps() as f64;
    let [x, v, phi, omega, drive] = run.largest.0;
    let rub = match rules.rubbing {
        Rubbing::CundallStrack { k, .. } => Spring { k, gamma: 0.0 },
        Rubbing::HaffWerner { gamma, .. } => Spring { k: 0.0, gamma },
        Rubbing::Zero => Spring { k: 0.0, gamma: 0.0 },
    };
    let springs = [rules.touch, rules.stretch, rules.bend, rub];
    let k = springs.iter().map(|s| s.k).fold(0.0, f64::max);
    let gamma = springs.iter().map(|s| s.gamma).fold(0.0, f64::max);
    let small = grains
        .iter()
        .map(|grain| grain.r)
        .fold(f64::INFINITY, f64::min);
    let large = grains.iter().map(|grain| grain.r).fold(0.0, f64::max);
    let mass = 4.0 / 3.0 * PI * grains[0].density * small.powi(3);
    let force = LINKS * (k * (x + large * phi.max(TAU)) + gamma * (v + large * omega));
    let walk = growth * f64::EPSILON * steps.sqrt();
    let velocity = walk * (force * rules.dt / mass + v);
    // m r^2 / J = 5/3 in the author's program.
    let spin = 5.0 / 3.0 * velocity / small + walk * omega;
    let (sum, time) = (f64::EPSILON * steps, steps * rules.dt);
    let [position, angle] = [sum * x + velocity * time, sum * phi + spin * time];
    Deviation([position, velocity, angle, spin, f64::EPSILON * drive])
}

/// Print the differences of both sides and check that they are within rounding.
fn check(name: &str, run: &Replay, growth: f64) {
    let tolerance = rounding(run, growth);
    let pairs = run.worst.0.into_iter().zip(tolerance.0);
    let share = |(w, t)| if w == 0.0 { 0.0 } else { w / t };
    let shares: Vec<f64> = pairs.map(share).collect();
    let [x, v, phi, omega, drive] = run.worst.0;
    println!(
        "{name}: {} steps, {} bonds left; differ by {x:.1e} m, {v:.1e} m/s, {phi:.1e} rad, \
         {omega:.1e} rad/s, {drive:.1e} N; shares of the tolerance {shares:.3?}",
        run.twins.world.steps(),
        run.twins.oracle.bonds.len(),
    );
    assert!(
        shares.iter().all(|&share| share <= 1.0),
        "{name}: {:?} {tolerance:?}",
        run.worst
    );
}
