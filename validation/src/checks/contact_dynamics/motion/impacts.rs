//! Collisions with a floor.

use super::super::system::{System, exact_steps, law, moving};
use crate::checks::random::Random;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, azema,
};
use crate::oracles::contact_dynamics::bodies::{disc_after_impact, gyration, landing};
use gouge_contact_dynamics::law::GapRule;
use gouge_contact_dynamics::step::Scheme;
use std::f64::consts::{FRAC_PI_2, PI};

pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "contact-dynamics.motion.oblique",
            claim: "A disc that hits a floor obliquely sticks up to a sliding velocity of 3 mu (1 + e) times its speed, slides beyond it, and rebounds with e.",
            equations: azema("(A1)-(A5), (A18), (A25)-(A26)"),
            scene: "Discs with friction 0.1, 0.3 and 0.6, restitution 0, 0.5 and 1, 41 angles and three spins; one step from contact",
            oracle: "Angular momentum about the point of contact, and the Coulomb limit of the whole impulse",
            norm: "Largest error of a velocity component, in units of the speed towards the floor",
            origin: Origin::Exact,
            reason: "One step at one point; sweeps stop at 1e-14 m/s, and velocities of up to 6 m/s have a rounding error of 1e-15 m/s",
            effort: Effort::Quick,
            measure: oblique,
        },
        Check {
            id: "contact-dynamics.motion.corner",
            claim: "A polygon that falls on a corner turns about it if friction suffices, and rebounds from it with e if there is none.",
            equations: azema("(A6)-(A7), (A10)-(A15), E6, E7"),
            scene: "500 polygons of 3 to 12 sides in random attitude and motion that hit a floor with one corner, friction 1 or 0",
            oracle: "Conservation of angular momentum about the corner, and the laws at the corner",
            norm: "Largest error of the angular momentum or of the corner's velocity, in units of the size of their terms",
            origin: Origin::Exact,
            reason: "One step at one point; sweeps stop at 1e-14 m/s, a thirtieth of rounding times the number of terms",
            effort: Effort::Quick,
            measure: corner,
        },
        Check {
            id: "contact-dynamics.motion.landing",
            claim: "A polygon that rolls over its corners keeps the angular velocity of a rimless wheel at each landing; a triangle comes to rest.",
            equations: azema("(1), (A1)-(A3), (A27)"),
            scene: "Polygons of 3 to 30 sides that turn about a corner and land flat, friction 1, one step",
            oracle: "Conservation of angular momentum about the corner on which it lands",
            norm: "Largest error of the angular velocity after landing, in units of that before",
            origin: Origin::Exact,
            reason: "Sweeps over two points stop at 1e-14 m/s; the arm is at least 0.1 m",
            effort: Effort::Quick,
            measure: landings,
        },
    ]
}

/// A system whose contacts are found where bodies are at the beginning of a very short step.
fn instant(friction: f64, restitution: f64) -> System {
    let mut settings = exact_steps(1e-9, law(friction, restitution, GapRule::Closed));
    settings.scheme = Scheme::Beginning;
    System::new(settings)
}

fn oblique() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for (friction, restitution) in [(0.1, 0.0), (0.3, 0.5), (0.6, 1.0), (0.3, 0.0)] {
        let mut marks = Vec::new();
        for k in 0..=40 {
            let along = 0.1 * f64::from(k);
            for spin in [0.0, -1.5, 2.0] {
                let mut system = instant(friction, restitution);
                let velocity = moving(along, -1.0, 2.0 * spin);
                system.body(0, 0.5, [0.0, 0.5], 0.0, velocity)?;
                system.floor()?;
                system.step();
                let v = system.velocity(0);
                let expected = disc_after_impact(along, 1.0, spin, restitution, friction);
                all.push(Measurement::absolute(expected[0], v.linear.x, 1e-13));
                all.push(Measurement::absolute(expected[1], 0.5 * v.angular, 1e-13));
                all.push(Measurement::absolute(restitution, v.linear.y, 1e-13));
                if spin == 0.0 && k % 2 == 0 {
                    marks.push([along, v.linear.x + 0.5 * v.angular]);
                }
            }
        }
        let name = format!("friction {friction}, e = {restitution}");
        let expected = |along: f64| {
            let after = disc_after_impact(along, 1.0, 0.0, restitution, friction);
            [along, after[0] + after[1]]
        };
        let theory = (0..=200).map(|k| expected(0.02 * f64::from(k)));
        curves.push(Curve::line(&format!("{name}, theory"), theory));
        curves.push(Curve::marks(&name, marks));
    }
    let figure = Figure::new(
        "Sliding velocity of a disc after an oblique impact: none up to 3 mu (1 + e) times the normal speed",
        Axis::linear("sliding velocity before", "normal speeds"),
        Axis::linear("sliding velocity after", "normal speeds"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure)]))
}

fn corner() -> Outcome {
    let mut random = Random::new(221);
    let mut all = Vec::new();
    for case in 0..500 {
        let sides = 3 + random.below(10);
        // The lowest corner is off the vertical by at most 0.4 of the angle at which the next one is as low.
        let lean = random.between(-0.4, 0.4) * PI / sides as f64;
        let arm = [lean.sin(), -lean.cos()];
        let before = [
            random.between(-1.0, 1.0),
            random.between(-3.0, -1.0),
            random.between(-1.0, 1.0),
        ];
        let is_rough = case % 2 == 0;
        let (friction, restitution) = if is_rough { (1.0, 0.0) } else { (0.0, 0.6) };
        let mut system = instant(friction, restitution);
        let velocity = moving(before[0], before[1], before[2]);
        system.body(sides, 1.0, [0.0, -arm[1]], lean - FRAC_PI_2, velocity)?;
        system.floor()?;
        system.step();
        let v = system.velocity(0);
        let after = [v.linear.x, v.linear.y, v.angular];
        let speed = |v: [f64; 3]| [v[0] - v[2] * arm[1], v[1] + v[2] * arm[0]];
        let momentum = |v: [f64; 3]| gyration(sides) * v[2] - arm[0] * v[1] + arm[1] * v[0];
        all.push(Measurement::absolute(
            momentum(before),
            momentum(after),
            1e-13,
        ));
        if speed(before)[1] >= 0.0 {
            continue;
        }
        let [along, up] = speed(after);
        all.push(Measurement::absolute(
            -restitution * speed(before)[1],
            up,
            1e-13,
        ));
        // Friction 1 holds the corner only if the impulse that stops it is within 45 degrees.
        let impulse = [after[0] - before[0], after[1] - before[1]];
        if is_rough && impulse[0].abs() < 0.99 * impulse[1] {
            all.push(Measurement::absolute(0.0, along, 1e-13));
        }
        if !is_rough {
            all.push(Measurement::absolute(0.0, impulse[0], 1e-13));
        }
    }
    Ok(Measurement::worst(all).into())
}

/// Angular velocity after a polygon that turned about a corner at -1 rad/s landed on the next one.
fn landed(sides: usize) -> Result<f64, Failure> {
    let half = PI / sides as f64;
    let mut system = instant(1.0, 0.0);
    // It turns clockwise about the left corner of its lower side, so that its centre goes right and down.
    let velocity = moving(half.cos(), -half.sin(), -1.0);
    system.body(sides, 1.0, [0.0, half.cos()], half - FRAC_PI_2, velocity)?;
    system.floor()?;
    system.step();
    Ok(-system.velocity(0).angular)
}

fn landings() -> Outcome {
    let (mut all, mut marks) = (Vec::new(), Vec::new());
    for sides in 3..=30 {
        let ratio = landed(sides)?;
        all.push(Measurement::absolute(landing(sides), ratio, 1e-12));
        marks.push([sides as f64, ratio]);
    }
    let theory = (3..=30).map(|sides| [sides as f64, landing(sides)]);
    let figure = Figure::new(
        "Angular velocity after landing on the next corner, over that before",
        Axis::linear("number of sides", ""),
        Axis::linear("ratio", ""),
        vec![
            Curve::line("rimless wheel", theory),
            Curve::marks("polygons", marks),
        ],
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(figure)]))
}
