//! Follows the thesis author's program step by step, by way of an independent model of its equations.
//!
//! Both sides do the same operations but for the order of sums and the way to an angle, so they may
//! differ by rounding alone; see [`rounding`] for how much that is.

use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
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
use gouge_validation::oracles::original::{
    Driver, Duty, Ends, Grain, Original, Rubbing, Rules, Spring,
};
use rand::RngExt;
use rand_pcg::Pcg32;
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

/// The same scene for both sides.
struct Twins {
    world: World,
    oracle: Original,
}

impl Twins {
    fn new(oracle: Original, ledger: bool) -> Self {
        // Every second pair the other way round: the order of its ends must not matter.
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

    /// Bonds of the kernel begin at t = 0 in the state that it finds.
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

/// Position, velocity, angle and angular velocity of any particle, and total driving force: largest
/// differences, magnitudes or tolerances, in SI units.
#[derive(Clone, Copy, Debug, Default)]
struct Deviation([f64; 5]);

impl Deviation {
    fn widen(&mut self, other: [f64; 5]) {
        for (widest, new) in self.0.iter_mut().zip(other) {
            // Undefined numbers must not pass for small ones.
            *widest = if new.is_nan() {
                f64::INFINITY
            } else {
                widest.max(new)
            };
        }
    }
}

/// What happened while both sides ran.
struct Replay {
    twins: Twins,
    worst: Deviation,
    largest: Deviation,
    /// Steps in which bonds broke.
    breaks: Vec<u64>,
    /// Pairs that broke and touched in the same step.
    broken_into_contact: usize,
    /// Steps in which there was some contact.
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

/// The same bonds hold and, where the kernel remembers contacts, the same pairs touch.
fn compare_links(Twins { world, oracle }: &Twins) {
    let pairs = world.bonds().map_or(&[][..], |strong| strong.pairs());
    let bonded = in_order(pairs.iter().copied());
    let expected: Vec<Ends> = oracle.bonds.keys().copied().collect();
    assert_eq!(bonded, expected, "bonds after {} steps", world.steps());
    if matches!(oracle.rules.rubbing, Rubbing::CundallStrack { .. }) {
        let moves = |i: usize| oracle.grains[i].duty != Duty::Fixed;
        let weak = world.contacts().expect("there are contacts");
        let touching = in_order(weak.remembered().map(|(pair, _)| pair));
        let expected = oracle
            .contacts
            .keys()
            .copied()
            .filter(|&(i, j)| moves(i) || moves(j));
        let expected: Vec<Ends> = expected.collect();
        assert_eq!(touching, expected, "contacts after {} steps", world.steps());
    }
}

/// Pairs in the order of their first particles.
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

/// Growth of errors in a motion that is stable.
const STABLE: f64 = 1.0;
/// Growth of errors in the block: with an explicit step a sticking Cundall-Strack contact is damped by
/// -k dt, so that an error multiplies by e in about 4 us, and the block moves for 10 us: e^2.5. The
/// model parts from itself by more if positions are nudged by a last place in every step.
const BLOCK_GROWTH: f64 = 12.0;
/// Links on a particle, about the most there are.
const LINKS: f64 = 8.0;

/// What rounding may do to a replay.
///
/// A position X is known to eps X and an angle A to eps A, so that a link with stiffness k and damping
/// g exerts a force known to eps (k (X + r A) + g V), V the speed of surfaces. Over a step this moves a
/// velocity by that times dt / m. Such errors of all links and successive steps are taken to add like a
/// random walk, to the root of the number of steps, and to be magnified by the motion until the end (`growth`).
/// The error of a position is that of the velocity times the time, and the rounding of its own sum,
/// which repeats itself in free flight and so adds to the number of steps. The driving force is a sum
/// of equal terms, the same on both sides unless a sign differs.
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
    // m r^2 / J is 5/3.
    let spin = 5.0 / 3.0 * velocity / small + walk * omega;
    let (sum, time) = (f64::EPSILON * steps, steps * rules.dt);
    let [position, angle] = [sum * x + velocity * time, sum * phi + spin * time];
    Deviation([position, velocity, angle, spin, f64::EPSILON * drive])
}

/// Print how far both sides differ, and check that it is rounding.
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

/// Two unequal grains with a gap between them at an angle, on a line through `x`, with velocities along the line of
/// centres and across, and spins.
fn approaching(x: f64, gap: f64, [closing, across]: [f64; 2], spins: [f64; 2]) -> Vec<Grain> {
    let (normal, [r, s]) = ([0.4_f64.cos(), 0.4_f64.sin()], [1.1e-3, 0.85e-3]);
    let reach = r + s + gap;
    let along = |a: f64, b: f64| [a * normal[0] - b * normal[1], a * normal[1] + b * normal[0]];
    let mut first = grain([x, 5e-3], r);
    let offset = along(reach, 0.0);
    let mut second = grain([(x + offset[0]).rem_euclid(BOX), 5e-3 + offset[1]], s);
    first.v = along(0.5 * closing, 0.5 * across);
    second.v = along(-0.5 * closing, -0.5 * across);
    (first.omega, second.omega) = (spins[0], spins[1]);
    // An angle of long ago, to be subtracted again.
    (first.phi, second.phi) = (7.5, -11.0);
    vec![first, second]
}

#[test]
fn collisions_follow_the_original_program() {
    // The last come from so far that they are no neighbours at first.
    let motions = [
        ("head on", 2e-8, [2.0, 0.0], [0.0; 2]),
        ("oblique, sticking", 2e-8, [2.0, 0.2], [150.0, -60.0]),
        ("oblique, sliding", 2e-8, [1.5, -3.0], [4e3, 2.5e3]),
        ("from afar", 1.2e-3, [200.0, 1.0], [4e3, 0.0]),
    ];
    for rubbing in EACH_RUBBING {
        for (place, x) in [("inside", 10e-3), ("at the seam", BOX - 0.4e-3)] {
            for (motion, gap, velocity, spins) in motions {
                let grains = approaching(x, gap, velocity, spins);
                let rules = Rules {
                    rubbing,
                    period: Some(BOX),
                    ..RULES
                };
                let run = replay(Twins::new(Original::new(rules, grains), false), 1000);
                assert!((20..900).contains(&run.touching), "they meet and part");
                let turns = (run.twins.oracle.grains[0].omega - spins[0]).abs() > 1e-6;
                assert!(
                    turns == (rubbing != Rubbing::Zero && motion != "head on"),
                    "{motion}"
                );
                check(&format!("{rubbing:?}, {place}, {motion}"), &run, STABLE);
            }
        }
    }
}

/// A ring of soft unequal grains, squeezed by the period and held at one height, that turn like gears.
fn gears(rubbing: Rubbing) -> Original {
    let radii = [1e-3, 0.7e-3, 1.1e-3, 0.8e-3];
    let soft = Spring {
        k: 1e4,
        gamma: 0.02,
    };
    let (mut x, mut grains) = (0.0, Vec::new());
    for (r, turn) in radii.into_iter().zip([1.0, -1.0, 1.01, -0.98]) {
        let mut gear = grain([x + r, 1e-3 * r], r);
        gear.omega = 20.0 * turn / r;
        x += 2.0 * r;
        grains.push(gear);
    }
    let well = Some([1e4, 0.0]);
    let period = Some(0.97 * x);
    grains.iter_mut().for_each(|gear| gear.x[0] *= 0.97);
    Original::new(
        Rules {
            dt: 2e-7,
            period,
            touch: soft,
            rubbing,
            well,
            ..RULES
        },
        grains,
    )
}

#[test]
fn rolling_contacts_follow_the_original_program() {
    let soft = [
        Rubbing::HaffWerner {
            mu: 0.7,
            gamma: 0.05,
        },
        Rubbing::CundallStrack { mu: 0.7, k: 1e4 },
    ];
    for rubbing in soft {
        let steps = 5_000;
        let run = replay(Twins::new(gears(rubbing), true), steps);
        assert_eq!(run.touching, steps, "they never part");
        for gear in &run.twins.oracle.grains {
            assert!(
                gear.phi.abs() > 2.0 * TAU,
                "each turns more than twice: {}",
                gear.phi
            );
        }
        check(&format!("gears, {rubbing:?}"), &run, STABLE);
    }
}

#[test]
fn contacts_begun_earlier_follow_the_original_program() {
    // Both ends turned since then by an angle, or by that and whole turns; the last at rest, where a
    // sliding contact has no direction of its own.
    let cases = [
        ("sticks", [1.0, 0.5], [30.0, -20.0], [1e-4, -3e-4]),
        ("slid", [1.0, 0.5], [3e3, -1e3], [0.1, 0.2]),
        ("at rest", [0.0; 2], [0.0; 2], [0.1, -0.02]),
    ];
    for rubbing in EACH_RUBBING {
        for (name, velocity, spins, turned) in cases {
            let grains = approaching(BOX - 0.4e-3, -1e-4, velocity, spins);
            let rules = Rules {
                rubbing,
                period: Some(BOX),
                ..RULES
            };
            let mut oracle = Original::new(rules, grains);
            oracle.bond((0, 1), 1.0);
            let psi = oracle.bonds.remove(&(0, 1)).expect("just bonded").psi;
            let psi = [psi[0] - turned[0] - TAU, psi[1] - turned[1] + 2.0 * TAU];
            oracle.contacts.insert((0, 1), psi);
            let run = replay(Twins::new(oracle, false), 1000);
            check(
                &format!("contact begun earlier, {name}, {rubbing:?}"),
                &run,
                STABLE,
            );
        }
    }
}

/// Three grains, two of them bonded to the third and rubbing against each other, that whirl as a whole.
#[test]
fn whirling_contacts_follow_the_original_program() {
    let soft = [
        Rubbing::HaffWerner {
            mu: 0.7,
            gamma: 1.0,
        },
        Rubbing::CundallStrack { mu: 0.7, k: 1e6 },
    ];
    for rubbing in soft {
        let spin = 1e5;
        let mut grains = vec![
            grain([-0.8e-3, 0.0], 1e-3),
            grain([0.8e-3, 0.1e-3], 0.85e-3),
            grain([0.0, 1.6e-3], 0.9e-3),
        ];
        for grain in &mut grains {
            grain.v = [-spin * (grain.x[1] - 0.5e-3), spin * grain.x[0]];
            grain.omega = spin;
        }
        grains[0].omega *= 0.99;
        let mut oracle = Original::new(Rules { rubbing, ..RULES }, grains);
        oracle.bond((0, 2), 1.0);
        oracle.bond((1, 2), 1.0);
        let run = replay(Twins::new(oracle, true), 20_000);
        assert_eq!(run.touching, 20_000, "they never part");
        assert!(
            run.twins.oracle.grains[0].phi > 2.5 * TAU,
            "it turns more than twice"
        );
        check(&format!("whirl, {rubbing:?}"), &run, STABLE);
    }
}

/// A bonded pair of unequal grains with the given velocity of the second along and across, and spins.
fn bonded(rules: Rules, distance: f64, velocity: [f64; 2], spins: [f64; 2]) -> Original {
    let normal = [0.3_f64.cos(), -0.3_f64.sin()];
    let mut grains = vec![grain([4e-3, 6e-3], 1.15e-3), grain([0.0; 2], 0.9e-3)];
    grains[1].x = [4e-3 + distance * normal[0], 6e-3 + distance * normal[1]];
    let [a, b] = velocity;
    grains[1].v = [a * normal[0] - b * normal[1], a * normal[1] + b * normal[0]];
    (grains[0].omega, grains[1].omega) = (spins[0], spins[1]);
    (grains[0].phi, grains[1].phi) = (-2.0, 40.0);
    let mut oracle = Original::new(rules, grains);
    oracle.bond((0, 1), 1.0);
    oracle
}

#[test]
fn bonds_follow_the_original_program() {
    // Spins of the last two: each end turns round many times, so that angles wrap at different moments.
    let motions = [
        ("stretched", [30.0, 0.0], [0.0; 2]),
        ("bent", [0.0; 2], [2e4, -2e4]),
        ("sheared", [0.0, 30.0], [0.0; 2]),
        ("all at once", [20.0, -10.0], [3e4, -1e4]),
        ("whirling", [0.0, 220.0], [1e5, 1e5]),
    ];
    for distance in [2.3e-3, 1.9e-3] {
        for (motion, velocity, spins) in motions {
            let steps = if motion == "whirling" { 40_000 } else { 3_000 };
            let now = replay(
                Twins::bonded_now(bonded(RULES, distance, velocity, spins)),
                steps,
            );
            check(&format!("bond, {motion}, {distance:?}"), &now, STABLE);
            let mut earlier = bonded(RULES, distance, velocity, spins);
            for bond in earlier.bonds.values_mut() {
                bond.length *= 0.998;
                bond.psi = [bond.psi[0] + 5e-3, bond.psi[1] - 8e-3];
            }
            let earlier = replay(Twins::new(earlier, false), steps);
            check(
                &format!("bond begun earlier, {motion}, {distance:?}"),
                &earlier,
                STABLE,
            );
            assert_eq!(earlier.touching, 0, "bonded pairs make no contact");
        }
    }
}

#[test]
fn bonds_turned_inside_out_follow_the_original_program() {
    // A bond so limp that its ends turn round and round against it.
    let bend = Spring {
        k: 1e2,
        gamma: 1e-3,
    };
    let spins = [3e5, -2e5];
    let run = replay(
        Twins::new(
            bonded(Rules { bend, ..RULES }, 2.1e-3, [0.0, 10.0], spins),
            true,
        ),
        20_000,
    );
    let turns = run
        .twins
        .oracle
        .grains
        .iter()
        .map(|grain| grain.omega.abs())
        .collect::<Vec<_>>();
    assert!(turns.iter().all(|&omega| omega > 1e5), "{turns:?}");
    check("bond turned inside out", &run, STABLE);
}

#[test]
fn breaking_bonds_follow_the_original_program() {
    let weak_damping = Spring { k: 1e7, gamma: 1.0 };
    let cases = [
        ("tension", 2.05e-3, [150.0, 0.0], [0.0; 2], false),
        (
            "tension while touching",
            1.95e-3,
            [120.0, 5.0],
            [3e4, -1e4],
            true,
        ),
        ("compression", 2.05e-3, [-150.0, 2.0], [2e4, 5e4], true),
        ("shear", 2.2e-3, [0.0, 200.0], [0.0; 2], false),
        ("bending", 2.0e-3, [0.0, 0.0], [2e5, 1.5e5], true),
    ];
    for rubbing in EACH_RUBBING {
        for (name, distance, velocity, spins, touches) in cases {
            let (stretch, bend) = (weak_damping, weak_damping);
            let rules = Rules {
                rubbing,
                stretch,
                bend,
                strength: Some(STRENGTH),
                ..RULES
            };
            let run = replay(
                Twins::new(bonded(rules, distance, velocity, spins), true),
                1000,
            );
            assert_eq!(run.breaks.len(), 1, "{name}");
            assert!(run.breaks[0] > 2, "{name}: not at once");
            assert_eq!(run.broken_into_contact == 1, touches, "{name}");
            check(
                &format!("{name} {rubbing:?}, broken at {:?}", run.breaks),
                &run,
                STABLE,
            );
        }
    }
}

/// Height of the block's lattice in m: as many hexagonal rows as columns.
const HEIGHT: f64 = BOX * 0.866;

/// A small block of granite, cut by a jagged fault, pressed and sheared.
fn block(rubbing: Rubbing, viscosity: Option<f64>, seed: u64) -> Original {
    const ROWS: usize = 13;
    let mut random = Pcg32::new(seed, 1);
    let mut uniform = |low: f64, high: f64| low + (high - low) * random.random::<f64>();
    let mut grains = Vec::new();
    for place in 0..ROWS * ROWS {
        let (column, row) = ((place % ROWS) as f64, (place / ROWS) as f64);
        let column = column + if row % 2.0 == 0.0 { 0.25 } else { 0.75 };
        let lattice = [
            BOX * column / ROWS as f64,
            HEIGHT * (row + 0.5) / ROWS as f64,
        ];
        let x = lattice.map(|x| x + uniform(-1e-4, 1e-4));
        let mut new = grain(x, uniform(0.82843e-3, 1.17157e-3));
        new.duty = match x[1] {
            y if y < 4e-3 => Duty::Fixed,
            y if y > HEIGHT - 4e-3 => Duty::Driven,
            _ => Duty::Free,
        };
        new.phi = uniform(-9.0, 9.0);
        if new.duty != Duty::Fixed {
            new.v = [uniform(-60.0, 60.0), uniform(-60.0, 60.0)];
            new.omega = uniform(-2e4, 2e4);
        }
        grains.push(new);
    }
    let driver = Some(Driver {
        speed: 2.0,
        load: 28e6 * BOX * 2e-3,
        rate: 1e8,
    });
    let (period, strength) = (Some(BOX), Some(STRENGTH));
    let mut block = Original::new(
        Rules {
            rubbing,
            viscosity,
            period,
            strength,
            driver,
            ..RULES
        },
        grains,
    );
    block.drive = [200.0, -1300.0];
    bond_halves(&mut block, || uniform(0.9, 1.1));
    block
}

fn bond_halves(block: &mut Original, mut factor: impl FnMut() -> f64) {
    let above = |[x, y]: [f64; 2]| y > 0.5 * HEIGHT + 1e-3 * (2.0 * TAU * x / BOX).sin();
    let number = block.grains.len();
    for (i, j) in (0..number).flat_map(|i| (i + 1..number).map(move |j| (i, j))) {
        let (a, b) = (block.grains[i], block.grains[j]);
        let apart = block.apart((i, j));
        let is_near = apart[0].hypot(apart[1]) <= 1.2247 * (a.r + b.r);
        if is_near && above(a.x) == above(b.x) {
            block.bond((i, j), factor());
        }
    }
}

#[test]
fn a_sheared_block_follows_the_original_program() {
    for rubbing in EACH_RUBBING {
        for viscosity in [None, Some(1.0)] {
            let twins = Twins::new(block(rubbing, viscosity, 7), viscosity.is_some());
            let bonds = twins.oracle.bonds.len();
            let run = replay(twins, 1000);
            let left = run.twins.oracle.bonds.len();
            let name = format!("block, {rubbing:?}, viscosity {viscosity:?}");
            assert!(
                left < bonds && left > bonds / 2,
                "{name}: {left} of {bonds} bonds left"
            );
            println!(
                "{bonds} bonds at first, {} broke into contacts",
                run.broken_into_contact
            );
            check(&name, &run, BLOCK_GROWTH);
        }
    }
}
