//! Extreme inputs.

use super::system::{System, exact_steps, law, moving};
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Table, azema};
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::sweep::StopCriterion;

pub fn checks() -> Vec<Check> {
    vec![Check {
        id: "contact-dynamics.stability.extremes",
        claim: "Extreme masses, sizes, frictions, overlaps and steps leave a finite state that obeys the inequalities of the laws, and creates no energy where none is put in.",
        equations: azema("(A1)-(A3), (A25)-(A26), E16"),
        scene: "100 heaps of eight discs and polygons with mass ratios up to 1e6, size ratios up to 1e3, friction 0, 0.4 or 10, overlaps up to concentric bodies, steps of 1e-6 to 1 s, 20 steps of at most 200 sweeps each",
        oracle: "Signs and bounds: normal impulses are not negative, tangential ones within the Coulomb limit, in steps whose sweeps converged to a unique solution, energy grows at most by the impulses times the velocities that the correction of overlaps demands",
        norm: "Number of states that are not finite, of points outside the bounds, and of steps that create energy",
        origin: Origin::Exact,
        reason: "None is tolerated; the limits themselves hold up to four units of rounding, and the energy up to the work of what sweeps leave: a residual of 1e-10 m/s times the sum of all impulses",
        effort: Effort::Quick,
        measure: extremes,
    }]
}

/// What was counted.
#[derive(Default)]
struct Counts {
    steps: usize,
    points: usize,
    not_unique: usize,
    infinite: usize,
    outside: usize,
    judged: usize,
    created: usize,
}

fn heap(random: &mut Random) -> Result<System, Failure> {
    let friction = random.choice(&[0.0, 0.4, 10.0]);
    let gap = random.choice(&[
        GapRule::Closed,
        GapRule::Predicted,
        GapRule::Stabilized {
            fraction: 0.2,
            allowed_overlap: 1e-3,
        },
    ]);
    let mut settings = exact_steps(random.magnitude(1e-6, 1.0), law(friction, 0.0, gap));
    settings.sweeps.max_sweeps = 200;
    settings.sweeps.stop = StopCriterion::NaturalMap { velocity: 1e-10 };
    let mut system = System::new(settings);
    let deep = random.choice(&[1.0, 0.5, 0.0]);
    for _ in 0..8 {
        let sides = random.choice(&[0, 3, 4, 7, 60]);
        let radius = random.magnitude(1e-3, 1.0);
        // A mass between 1e-3 and 1e3 kg, whatever the size.
        let density = random.magnitude(1e-3, 1e3) / (radius * radius);
        let at = [random.between(-2.0, 2.0), random.between(0.0, 2.0)].map(|x| deep * x);
        let velocity = moving(
            random.signed(1e-3, 1.0),
            random.signed(1e-3, 1.0),
            random.signed(1e-3, 1.0),
        );
        let angle = random.between(-4.0, 4.0);
        system.dense_body((sides, density), radius, at, angle, velocity)?;
    }
    system.floor()?;
    Ok(system)
}

fn follow(system: &mut System, counts: &mut Counts) {
    let mut energy = system.energy();
    for _ in 0..20 {
        let report = system.step();
        counts.steps += 1;
        counts.points += report.points;
        counts.not_unique += report.sweeps.not_unique;
        let velocities = &system.state.configuration.velocity;
        let is_finite = |v: &gouge_contact_dynamics::units::Velocity| {
            (v.linear.x + v.linear.y + v.angular).is_finite()
        };
        counts.infinite += velocities.iter().filter(|v| !is_finite(v)).count();
        let Some(workspace) = system.workspace() else {
            continue;
        };
        let rows = workspace.solver().rows();
        let limit = system.settings.law.friction * (1.0 + 4.0 * f64::EPSILON);
        let is_outside = |p: Components| !(p.n >= 0.0 && p.t.abs() <= limit * p.n);
        counts.outside += rows.iter().filter(|row| is_outside(row.impulse())).count();
        if report.sweeps.has_converged && report.sweeps.not_unique == 0 {
            let sum: f64 = rows.iter().map(|row| row.impulse().n).sum();
            let left = 1e-10 * sum * (1.0 + limit);
            // The correction does at most the work of the impulse times the velocity that it demands.
            let correction = 2.0 * report.work_of_correction;
            let allowed = energy * (1.0 + 1e-12) + correction + left;
            counts.judged += 1;
            counts.created += usize::from(system.energy() > allowed);
        }
        energy = system.energy();
    }
}

fn extremes() -> Outcome {
    let mut random = Random::new(241);
    let mut counts = Counts::default();
    for _ in 0..100 {
        follow(&mut heap(&mut random)?, &mut counts);
    }
    let mut table = Table::new("What happened in the extreme heaps", &["event", "number"]);
    for (name, number) in [
        ("steps", counts.steps),
        ("contact points", counts.points),
        ("points with no or several solutions", counts.not_unique),
        ("velocities that are not finite", counts.infinite),
        ("impulses outside their limits", counts.outside),
        ("steps that converged to a unique solution", counts.judged),
        ("of these, steps that create energy", counts.created),
    ] {
        table.push([name.to_owned(), format!("{number}")]);
    }
    if counts.points < 1000 {
        return Err(Failure::Oracle("too few points".to_owned()));
    }
    let wrong = counts.infinite + counts.outside + counts.created;
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}
