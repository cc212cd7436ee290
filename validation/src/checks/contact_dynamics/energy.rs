//! The balance of energy.

use super::cells::{settings, sheared};
use super::system::{System, exact_steps, law, moving};
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, azema};
use crate::references::Packing;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::step::Scheme;
use gouge_contact_dynamics::sweep::StopCriterion;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.energy.balance",
            claim: "Kinetic energy changes by the work that is booked: of collisions, friction, the correction of overlaps, loads and the drive.",
            equations: azema("(A4)-(A9), (A29)-(A30)"),
            scene: "400 hexagons that are sheared for 60 steps, without and with restitution; sweeps end at 1e-2 of the mean impulse, so that they are far from converged",
            oracle: "The theorem of work and energy, which holds for any impulses",
            norm: "Difference of the change of kinetic energy and the sum of all work, in units of rounding of the work of the drive",
            origin: Origin::Exact,
            reason: "60 steps with 1000 points: sums of 6e4 terms have an error of sqrt(6e4) = 245 units if rounding is random; four times that",
            effort: Effort::Thorough,
            measure: balance,
        },
        Check {
            id: "contact-dynamics.energy.decrease",
            claim: "Without restitution, no step creates energy, and momentum is kept.",
            equations: azema("(A1)-(A3), (A6)-(A7), (A13)"),
            scene: "60 clouds of 16 discs and polygons in random motion, friction 0 to 1, 25 steps each",
            oracle: "The laws allow only dissipation; Newton's third law",
            norm: "Largest growth of the kinetic energy in a step, relative, and largest change of momentum, in units of that of one body",
            origin: Origin::Exact,
            reason: "Sweeps stop at a residual of 1e-12 m/s, which can do a work of 1e-12 of the energy per point at speeds of 1 m/s, and there are less than 100 points",
            effort: Effort::Thorough,
            measure: decrease,
        },
        Check {
            id: "contact-dynamics.energy.correction",
            claim: "The correction of overlaps removes its fraction per step, and the energy that it gives to the bodies is booked.",
            equations: azema("(A9), (A32)"),
            scene: "200 pairs of discs of random sizes that overlap at rest; one step",
            oracle: "The relative velocity that removes the fraction of the overlap, and the kinetic energy of the pair with it",
            norm: "Largest relative error of the velocity, the work and the kinetic energy",
            origin: Origin::Exact,
            reason: "Overlaps of at least 1e-3 m are differences of lengths of 2 m with a rounding error of 2e-16 m, and energies are squares of them",
            effort: Effort::Quick,
            measure: correction,
        },
    ]
}

fn balance() -> Outcome {
    let packing = Packing::read("hexagons").map_err(Failure::Oracle)?;
    let mut all = Vec::new();
    let mut table = Table::new(
        "Work in the first 60 steps, in units of that of the drive",
        &[
            "restitution",
            "collisions",
            "friction",
            "correction",
            "load",
            "change of kinetic energy",
            "residual",
        ],
    );
    for restitution in [Components::default(), Components { n: 0.6, t: 0.3 }] {
        let mut settings = settings(&packing, packing.strain_per_step, 1e-2);
        settings.law.restitution = restitution;
        let mut world = sheared(&packing, settings)?.with_work(true);
        let beginning = world.kinetic_energy();
        for _ in 0..60 {
            world.step()?;
        }
        let work = world.work().copied().unwrap_or_default();
        let change = world.kinetic_energy() - beginning;
        let unit = f64::EPSILON * work.drive;
        all.push(Measurement::scaled(work.total(), change, unit, 1000.0));
        let signs = [
            work.drive > 0.0,
            work.friction < 0.0,
            work.correction >= 0.0,
        ];
        all.push(Measurement::count(signs.iter().filter(|&&is| !is).count()));
        let terms = [
            work.collision,
            work.friction,
            work.correction,
            work.load,
            change,
            change - work.total(),
        ];
        let cells = terms.map(|term| format!("{:.3e}", term / work.drive));
        let name = format!("{}, {}", restitution.n, restitution.t);
        table.push([name].into_iter().chain(cells));
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

/// Bodies of many shapes that fly towards their centre.
fn cloud(random: &mut Random) -> Result<System, Failure> {
    let friction = random.choice(&[0.0, 0.1, 0.4, 1.0]);
    let mut settings = exact_steps(0.01, law(friction, 0.0, GapRule::Closed));
    settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-12 };
    let mut system = System::new(settings);
    let shapes = random.choice(&[[0, 0], [3, 3], [4, 0], [6, 9], [5, 30]]);
    for place in 0..16 {
        let at = [place % 4, place / 4].map(|k| 1.02 * (f64::from(k) - 1.5));
        let velocity = moving(
            -0.5 * at[0] + random.between(-0.5, 0.5),
            -0.5 * at[1] + random.between(-0.5, 0.5),
            random.between(-2.0, 2.0),
        );
        let radius = random.between(0.4, 0.5);
        let angle = random.between(-3.0, 3.0);
        system.body(random.choice(&shapes), radius, at, angle, velocity)?;
    }
    Ok(system)
}

fn momentum(system: &System) -> [f64; 2] {
    let masses = system.assembly.inverse_mass.iter();
    let units = masses.zip(&system.state.configuration.velocity);
    units.fold([0.0; 2], |sum, (mass, v)| {
        [sum[0] + v.linear.x / mass.x, sum[1] + v.linear.y / mass.y]
    })
}

fn decrease() -> Outcome {
    let mut random = Random::new(231);
    let (mut all, mut met) = (Vec::new(), 0);
    for _ in 0..60 {
        let mut system = cloud(&mut random)?;
        let start = momentum(&system);
        let mut energy = system.energy();
        for _ in 0..25 {
            met += system.step().points;
            let growth = (system.energy() / energy - 1.0).max(0.0);
            all.push(Measurement::absolute(0.0, growth, 1e-10));
            energy = system.energy();
        }
        let end = momentum(&system);
        for k in 0..2 {
            all.push(Measurement::absolute(start[k], end[k], 1e-10));
        }
    }
    if met < 1000 {
        return Err(Failure::Oracle(format!("only {met} contact points")));
    }
    Ok(Measurement::worst(all).into())
}

fn correction() -> Outcome {
    let mut random = Random::new(232);
    let mut all = Vec::new();
    for _ in 0..200 {
        let [fraction, step] = [random.between(0.01, 1.0), random.magnitude(1e-3, 1.0)];
        let [one, other] = [random.between(0.3, 1.0), random.between(0.3, 1.0)];
        let (allowed, excess) = (random.between(0.0, 1e-2), random.magnitude(1e-3, 1e-1));
        let gap = GapRule::Stabilized {
            fraction,
            allowed_overlap: allowed,
        };
        let mut settings = exact_steps(step, law(0.0, 0.0, gap));
        settings.scheme = Scheme::Beginning;
        let mut system = System::new(settings);
        let rest = moving(0.0, 0.0, 0.0);
        system.body(0, one, [0.0; 2], 0.0, rest)?;
        system.body(0, other, [one + other - allowed - excess, 0.0], 0.0, rest)?;
        let report = system.step();
        let apart = system.velocity(1).linear.x - system.velocity(0).linear.x;
        let expected = fraction * excess / step;
        all.push(Measurement::relative(expected, apart, 1e-11));
        let masses = [one, other].map(|radius| std::f64::consts::PI * radius * radius);
        let reduced = masses[0] * masses[1] / (masses[0] + masses[1]);
        let energy = 0.5 * reduced * expected * expected;
        all.push(Measurement::relative(energy, system.energy(), 1e-11));
        all.push(Measurement::relative(
            energy,
            report.work_of_correction,
            1e-11,
        ));
    }
    Ok(Measurement::worst(all).into())
}
