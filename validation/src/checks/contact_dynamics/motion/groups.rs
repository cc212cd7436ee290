//! Several bodies at once.

use super::super::system::{System, exact_steps, law, moving};
use crate::checks::random::Random;
use crate::checks::{Check, Effort, Exhibit, Measurement, Origin, Outcome, Table, azema};
use crate::oracles::contact_dynamics::bodies::pyramid;
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::step::Scheme;

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.motion.cradle",
            claim: "When a disc hits a row of touching discs without loss, all others leave together with 2/n of its velocity.",
            equations: azema("(A4)-(A5), (A13), (A27)"),
            scene: "Rows of 2 to 12 equal discs without friction, restitution 1, one step",
            oracle: "One simultaneous law: the hit point reverses its velocity, no other point opens, and momentum is kept",
            norm: "Largest error of a velocity, in units of the first one",
            origin: Origin::Exact,
            reason: "Sweeps stop at 1e-14 m/s; in a row of n points a residual is enlarged by the sum of the responses, at most n^2/2 = 60",
            effort: Effort::Quick,
            measure: cradle,
        },
        Check {
            id: "contact-dynamics.motion.pyramid",
            claim: "A disc on two others that stand apart presses on them as statics says, as long as friction holds them; with less friction they roll apart.",
            equations: azema("(A1)-(A3), (A15)-(A18), (A23)-(A24), E5"),
            scene: "Three equal discs, the upper one at 0.55 to 1 rad from the vertical above the lower ones, friction 5 % above and below the limit",
            oracle: "Balance of forces and moments",
            norm: "Largest error of a force in units of the weight; a velocity that must not vanish counts as infinite if it does",
            origin: Origin::Exact,
            reason: "Sweeps stop at 1e-14 m/s, which is a force of 1e-12 weights at a step of 1 ms and g = 10 m/s^2; five points, enlarged by at most 1e2",
            effort: Effort::Quick,
            measure: three_discs,
        },
        Check {
            id: "contact-dynamics.motion.gap",
            claim: "A body that would pass a gap within a step is slowed so that it closes the gap exactly.",
            equations: azema("(A1)-(A2), (A28), C2, C3"),
            scene: "200 discs that fly at a floor, with gaps of a tenth to nine tenths of the way of a step",
            oracle: "The gap divided by the step; half of it is left at the end of the step, nothing at the next detection",
            norm: "Largest error of the velocity, in units of the first one, or of a length, in units of the gap",
            origin: Origin::Exact,
            reason: "A position of up to 2 m has a rounding error of 2e-16 m, and gaps are at least 1e-4 m",
            effort: Effort::Quick,
            measure: gap,
        },
    ]
}

fn cradle() -> Outcome {
    let mut all = Vec::new();
    for n in 2..=12 {
        let mut settings = exact_steps(1e-3, law(0.0, 1.0, GapRule::Closed));
        settings.scheme = Scheme::Beginning;
        let mut system = System::new(settings);
        for k in 0..n {
            let speed = if k == 0 { 1.0 } else { 0.0 };
            system.body(0, 0.5, [k as f64, 0.0], 0.0, moving(speed, 0.0, 0.0))?;
        }
        system.step();
        for k in 0..n {
            let twice = 2.0 / n as f64;
            let expected = if k == 0 { twice - 1.0 } else { twice };
            let found = system.velocity(k).linear.x;
            all.push(Measurement::absolute(expected, found, 1e-12));
        }
    }
    Ok(Measurement::worst(all).into())
}

const GRAVITY: f64 = 10.0;

/// Two discs on a floor and one on top, whose lines of centres are at an angle in rad from the vertical.
fn heap(angle: f64, friction: f64) -> Result<System, crate::checks::Failure> {
    let settings = exact_steps(1e-3, law(friction, 0.0, GapRule::Predicted));
    let mut system = System::new(settings);
    let rest = moving(0.0, 0.0, 0.0);
    let (sin, cos) = angle.sin_cos();
    for at in [[-sin, 0.5], [sin, 0.5], [0.0, 0.5 + cos]] {
        system.body(0, 0.5, at, 0.0, rest)?;
    }
    system.floor()?;
    system.gravity([0.0, -GRAVITY]);
    Ok(system)
}

fn three_discs() -> Outcome {
    let weight = GRAVITY * std::f64::consts::PI / 4.0;
    let mut all = Vec::new();
    let mut table = Table::new(
        "Forces of three discs in units of the weight of one",
        &[
            "angle (rad)",
            "between discs",
            "statics",
            "friction",
            "statics",
        ],
    );
    for angle in [0.55, 0.6, 0.7, 0.85, 1.0_f64] {
        let limit = (0.5 * angle).tan();
        let mut system = heap(angle, 1.05 * limit)?;
        system.steps(3);
        let expected = pyramid(angle);
        let found = system.forces();
        if found.len() != 4 {
            all.push(Measurement::absolute(4.0, found.len() as f64, 0.0));
            continue;
        }
        // Pairs of discs come first, then the two points on the floor.
        for (place, force) in found.iter().enumerate() {
            let [n, t] = match place {
                0 | 1 => [expected[0], expected[1]],
                _ => [expected[2], expected[3]],
            };
            all.push(Measurement::absolute(n, force.n / weight, 1e-10));
            all.push(Measurement::absolute(t, force.t.abs() / weight, 1e-10));
        }
        table.push([
            format!("{angle}"),
            format!("{:.12}", found[0].n / weight),
            format!("{:.12}", expected[0]),
            format!("{:.12}", found[0].t.abs() / weight),
            format!("{:.12}", expected[1]),
        ]);
        let mut loose = heap(angle, 0.95 * limit)?;
        loose.steps(3);
        let apart = loose.velocity(1).linear.x;
        let moves = if apart > 1e-6 { 0.0 } else { f64::INFINITY };
        all.push(Measurement::absolute(0.0, moves, 1e-10));
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn gap() -> Outcome {
    let mut random = Random::new(222);
    let mut all = Vec::new();
    for _ in 0..200 {
        let speed = random.magnitude(1e-3, 1e-2);
        let gap = speed * random.between(0.1, 0.9);
        let settings = exact_steps(1.0, law(0.0, 0.0, GapRule::Predicted));
        let mut system = System::new(settings);
        // The middle of the step is where the gap is measured.
        let height = 0.5 + gap + 0.5 * speed;
        let fall = moving(0.0, -speed, 0.0);
        system.body(0, 0.5, [0.0, height], 0.0, fall)?;
        system.floor()?;
        system.step();
        let v = system.velocity(0).linear.y;
        all.push(Measurement::scaled(-gap, v, speed, 1e-11));
        let left = system.position(0)[1] - 0.5;
        all.push(Measurement::scaled(0.5 * gap, left, gap, 1e-11));
        system.step();
        let height = system.position(0)[1] - 0.5;
        all.push(Measurement::scaled(0.0, height, gap, 1e-11));
    }
    Ok(Measurement::worst(all).into())
}
