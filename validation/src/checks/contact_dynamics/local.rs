//! The laws of Signorini and Coulomb at single points.

use crate::checks::random::Random;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Figure, Measurement, Origin, Outcome, Table, azema,
};
use crate::oracles::contact_dynamics::point::Point;
use gouge_common::geometry::Vec2;
use gouge_contact_dynamics::delassus::PointKinematics;
use gouge_contact_dynamics::local::{ExactRule, LocalProblem, LocalRule, LocalStatus, PaperRule};
use gouge_contact_dynamics::units::{InverseMass, Velocity};

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.local.residual",
            claim: "The impulse of a contact point satisfies the laws of Signorini and Coulomb to rounding; the rule printed in the source does not.",
            equations: azema("(A1)-(A3), (A19)-(A20), (A25)-(A26), E6, E7"),
            scene: "100 000 points between bodies of random masses, moments of inertia, arms and directions, with random velocities and friction up to 0.99 of the limit of uniqueness",
            oracle: "The laws as three complementarities, in double-double precision",
            norm: "Largest residual of the laws in m/s, in units of rounding of the velocity times the condition of the response",
            origin: Origin::Exact,
            reason: "An impulse takes at most ten rounded operations, each enlarged by the condition at most: half a unit each, and the same once more for the velocity that belongs to it",
            effort: Effort::Quick,
            measure: residual,
        },
        Check {
            id: "contact-dynamics.local.response",
            claim: "The response of a contact point to its own impulse is the change of its velocity.",
            equations: azema("(A10)-(A12), (A15), (A18), E2"),
            scene: "10 000 points between bodies of random masses, one of which may be driven in one direction, and moments of inertia",
            oracle: "The velocity of the points of two bodies after a unit impulse, from linear and angular momentum in the frame of space",
            norm: "Largest error of a response, in units of rounding of the sum of its terms",
            origin: Origin::Exact,
            reason: "Six terms of at most three products each, half a unit per operation, and as many in the oracle",
            effort: Effort::Quick,
            measure: response,
        },
        Check {
            id: "contact-dynamics.local.number-of-solutions",
            claim: "The status of a contact point says whether the laws have one solution, several or none, and the impulse is one of them.",
            equations: azema("(A1)-(A3), (A20), E16"),
            scene: "20 000 points with friction up to four times the limit of uniqueness, half of them separating",
            oracle: "All eight choices of zeros of the linear complementarity problem of the point, by Gauss elimination",
            norm: "Number of points whose status or impulse differs",
            origin: Origin::Exact,
            reason: "Points whose number of solutions changes within a relative margin of 1e-7 are left out",
            effort: Effort::Quick,
            measure: number_of_solutions,
        },
    ]
}

const PROBLEMS: usize = 100_000;
/// Units of rounding per condition.
const UNITS: f64 = 10.0;
/// A residual that is no rounding, relative to the velocity.
const VIOLATION: f64 = 1e-6;

fn draw(random: &mut Random, largest_friction: f64) -> LocalProblem {
    let bodies = [(); 2].map(|()| {
        let inverse = random.magnitude(1e-2, 1e2);
        let arm = [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        (inverse, inverse * random.between(1.0, 8.0), arm)
    });
    let sum = |term: fn(f64, f64, [f64; 2]) -> f64| -> f64 {
        bodies.iter().map(|&(m, i, arm)| term(m, i, arm)).sum()
    };
    let w_nn = sum(|m, i, arm| m + i * arm[1] * arm[1]);
    let w_nt = sum(|_, i, arm| -i * arm[0] * arm[1]);
    let limit = largest_friction * w_nn / w_nt.abs();
    LocalProblem {
        w_nn,
        w_tt: sum(|m, i, arm| m + i * arm[0] * arm[0]),
        w_nt,
        a_n: random.signed(1e-3, 1e1),
        a_t: random.signed(1e-3, 1e1),
        friction: random.between(0.0, 1.5).min(limit),
    }
}

fn seen(problem: &LocalProblem) -> Point {
    Point {
        response: [problem.w_nn, problem.w_tt, problem.w_nt],
        approach: [problem.a_n, problem.a_t],
        friction: problem.friction,
    }
}

fn residual() -> Outcome {
    let mut random = Random::new(201);
    let mut worst = Vec::with_capacity(PROBLEMS);
    let mut shares = [[0.0; 2]; BINS];
    for _ in 0..PROBLEMS {
        let problem = draw(&mut random, 0.99);
        let point = seen(&problem);
        let [exact, printed] = [ExactRule.solve(&problem), PaperRule.solve(&problem)]
            .map(|solution| point.residual([solution.impulse.n, solution.impulse.t]));
        let unit = f64::EPSILON * point.condition() * point.speed();
        worst.push(Measurement::scaled(0.0, exact, unit, UNITS));
        let is_loaded = problem.a_n > 0.0;
        let ratio = problem.w_nt.abs() / problem.w_nn;
        let bin = (ratio * 10.0) as usize;
        if let Some(share) = shares.get_mut(bin).filter(|_| is_loaded) {
            share[0] += 1.0;
            share[1] += f64::from(u8::from(printed > VIOLATION * point.speed()));
        }
    }
    Ok(Measurement::worst(worst).showing(exhibits(&shares)))
}

/// Number of intervals of W_nt/W_nn.
const BINS: usize = 16;

fn exhibits(shares: &[[f64; 2]; BINS]) -> [Exhibit; 2] {
    let centre = |bin: usize| (bin as f64 + 0.5) / 10.0;
    let full = shares
        .iter()
        .enumerate()
        .filter(|(_, share)| share[0] > 100.0);
    let points: Vec<[f64; 2]> = full
        .clone()
        .map(|(bin, share)| [centre(bin), share[1] / share[0]])
        .collect();
    let intervals: Vec<[f64; 2]> = full
        .map(|(_, share)| {
            let p = share[1] / share[0];
            let error = 2.0 * (p * (1.0 - p) / share[0]).sqrt();
            [p - error, p + error]
        })
        .collect();
    let figure = Figure::new(
        "How often the printed rule violates the laws at approaching points",
        Axis::linear("absolute W_nt/W_nn", ""),
        Axis::linear("share of points", ""),
        vec![Curve::marks("printed rule, two standard errors", points).with_intervals(intervals)],
    );
    let [all, wrong] = shares.iter().fold([0.0; 2], |sum, share| {
        [sum[0] + share[0], sum[1] + share[1]]
    });
    let mut table = Table::new(
        "Approaching points at which a rule violates the laws by more than 1e-6 of the velocity",
        &["rule", "points", "violations"],
    );
    table.push(["exact".to_owned(), format!("{all}"), "0".to_owned()]);
    table.push(["printed".to_owned(), format!("{all}"), format!("{wrong}")]);
    [Exhibit::Figure(figure), Exhibit::Table(table)]
}

fn response() -> Outcome {
    let mut random = Random::new(202);
    let mut all = Vec::new();
    for _ in 0..10_000 {
        let masses = [(); 2].map(|()| {
            let x = random.magnitude(1e-3, 1e3);
            let y = if random.below(4) == 0 { 0.0 } else { x };
            InverseMass {
                x,
                y,
                rotation: random.magnitude(1e-3, 1e3),
            }
        });
        let angle = random.between(-4.0, 4.0);
        let normal = [angle.cos(), angle.sin()];
        let arms = [(); 2].map(|()| [random.between(-1.0, 1.0), random.between(-1.0, 1.0)]);
        let vector = |v: [f64; 2]| Vec2::new(v[0], v[1]);
        let point = PointKinematics::new([0, 1], vector(normal), arms.map(vector));
        let found = point.delassus(&masses);
        let tangent = [-normal[1], normal[0]];
        let seen = |impulse: [f64; 2], along: [f64; 2]| {
            let moved = [0, 1].map(|k| moved(masses[k], arms[k], impulse, along));
            let size: f64 = moved.iter().map(|(_, size)| size).sum();
            (moved[0].0 + moved[1].0, size)
        };
        let responses = [
            (found.nn, seen(normal, normal)),
            (found.tt, seen(tangent, tangent)),
            (found.nt, seen(tangent, normal)),
            (found.nt, seen(normal, tangent)),
        ];
        let measured = responses.map(|(found, (expected, size))| {
            Measurement::scaled(expected, found, f64::EPSILON * size, 18.0)
        });
        all.extend(measured);
        all.push(carried(&point, &masses, arms, normal));
    }
    Ok(Measurement::worst(all).into())
}

/// Velocity along a direction, and the size of its terms, that an impulse gives to the point of a body at an arm.
fn moved(mass: InverseMass, arm: [f64; 2], impulse: [f64; 2], along: [f64; 2]) -> (f64, f64) {
    let spin = mass.rotation * (arm[0] * impulse[1] - arm[1] * impulse[0]);
    let terms = [
        mass.x * impulse[0] * along[0],
        mass.y * impulse[1] * along[1],
        -spin * arm[1] * along[0],
        spin * arm[0] * along[1],
    ];
    let arms = arm[0].hypot(arm[1]);
    let size = mass.x + mass.y + mass.rotation * arms * arms;
    (terms.iter().sum(), size)
}

/// The impulse that a solver applies moves the point by the same response.
fn carried(
    point: &PointKinematics,
    masses: &[InverseMass; 2],
    arms: [[f64; 2]; 2],
    normal: [f64; 2],
) -> Measurement {
    let mut velocities = [Velocity::default(); 2];
    let impulse = gouge_contact_dynamics::local::Components { n: 1.0, t: 0.0 };
    point.apply(impulse, masses, &mut velocities);
    let found = point.relative_velocity(&velocities).n;
    let both = [0, 1].map(|k| moved(masses[k], arms[k], normal, normal));
    let (expected, size) = (both[0].0 + both[1].0, both[0].1 + both[1].1);
    Measurement::scaled(expected, found, f64::EPSILON * size, 18.0)
}

fn number_of_solutions() -> Outcome {
    let mut random = Random::new(203);
    let (mut wrong, mut counts) = (0, [0; 4]);
    for _ in 0..20_000 {
        let drawn = draw(&mut random, f64::INFINITY);
        let friction = random.between(0.0, 4.0) * drawn.w_nn / drawn.w_nt.abs();
        let problem = LocalProblem { friction, ..drawn };
        let [wide, narrow] = [1e-7, -1e-7].map(|margin| seen(&problem).solutions_within(margin));
        if wide.len() != narrow.len() {
            continue;
        }
        let solution = ExactRule.solve(&problem);
        let is_right = match solution.status {
            LocalStatus::NoSolution => wide.is_empty(),
            LocalStatus::SeveralSolutions => wide.len() > 1,
            _ => wide.len() == 1,
        };
        let is_one = |other: &[f64; 2]| {
            let p = solution.impulse;
            let distance = (p.n - other[0]).abs() + (p.t - other[1]).abs();
            distance <= 1e-6 * (other[0].abs() + other[1].abs())
        };
        wrong += usize::from(!is_right || !wide.iter().any(is_one));
        counts[wide.len().min(3)] += 1;
    }
    let mut table = Table::new(
        "Points by the number of impulses that satisfy the laws",
        &["impulses", "points"],
    );
    for (number, count) in counts.iter().enumerate() {
        table.push([format!("{number}"), format!("{count}")]);
    }
    Ok(Measurement::count(wrong).showing([Exhibit::Table(table)]))
}
