//! MFiX DEM01 and DEM02: a sphere bounces under gravity.

use super::plane::linear;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};
use crate::oracles::bounce::{Release, Spring, apex};
use crate::oracles::impact::damping_ratio;
use crate::scenes::{Draft, Grain};
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use std::f64::consts::PI;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.mfix.01-02-contact",
            claim: "DEM01 and DEM02: a dropped sphere rebounds to the height, and at the time, of a damped spring with gravity that acts until its force vanishes.",
            equations: thesis("(8)-(10), (35)-(36)"),
            scene: SCENE,
            oracle: "Closed form of the damped oscillator with gravity, ended where k xi + gamma xi' = 0",
            norm: "Relative error of the height above contact, and of the time from contact to the highest point",
            origin: Origin::Convergent,
            reason: "The force has one kink, at its end, where the error of the trapezoidal rule is an eighth of the jump of its rate times dt^2, and the phase lags by a fraction (w dt)^2 / 24: relative to the speed less than (pi / n)^2 / 4 with n steps per half period, and twice that in the height. Programs that let the contact attract until the overlap vanishes, such as MFiX, have other values: the table shows both",
            effort: Effort::Quick,
            measure: contact,
        },
        Check {
            id: "benchmarks.mfix.02-limit",
            claim: "DEM02: the difference between the rebound height and that of hard spheres is proportional to one over the square root of the stiffness.",
            equations: thesis("(8)-(10), (35)-(36)"),
            scene: "The same scene, k = 5e6 and 5e8 N/m, e = 0.9, 0.7 and 0.5",
            oracle: "The hard-sphere height e^2 h and the exponent -1/2",
            norm: "Error of the observed exponent",
            origin: Origin::Convergent,
            reason: "The difference is a series in q = g / (w v), which is 5.2e-3 and 5.2e-4; a second term of at most twice the first times q changes the exponent by 2 (q_1 - q_2) / ln 100 = 2.0e-3",
            effort: Effort::Quick,
            measure: limit,
        },
        Check {
            id: "benchmarks.mfix.02-bounces",
            claim: "DEM02: six successive bounces reach the heights given by contacts and flights in closed form.",
            equations: thesis("(8)-(10), (35)-(36)"),
            scene: "A sphere dropped from 0.5 m, k = 5e4 N/m with e = 0.9 and 5e5 N/m with e = 0.7, 1000 steps per half period",
            oracle: "Flights and damped oscillators with gravity, alternating",
            norm: "Relative error of the height above contact of each bounce, over its tolerance",
            origin: Origin::Convergent,
            reason: "A damped contact begins with a jump of the force, gamma v, somewhere within a step: gamma dt / (2 m) of the speed per contact, plus the kinks as for a single contact. The errors of all previous contacts add up and are doubled in the height",
            effort: Effort::Thorough,
            measure: bounces,
        },
    ]
}

const SCENE: &str = "A sphere of radius 0.1 m and 2600 kg/m^3 dropped from 0.5 m on a fixed one, from the moment of contact; stiffness 1e4 to 5e6 N/m, damping for e = 1 to 0.5 without gravity; Kelvin-Voigt, 16000 steps per half period";
const RADIUS: f64 = 0.1;
const DENSITY: f64 = 2600.0;
const GRAVITY: f64 = 9.81;
const DROP: f64 = 0.4;

fn mass() -> f64 {
    4.0 / 3.0 * PI * DENSITY * RADIUS.powi(3)
}

/// The spring of the given stiffness and damping ratio.
fn spring(stiffness: f64, ratio: f64) -> Spring {
    Spring {
        stiffness: stiffness / mass(),
        damping: 2.0 * ratio * (stiffness / mass()).sqrt(),
        gravity: GRAVITY,
    }
}

/// Half a period without damping in s.
fn half_period(spring: &Spring) -> f64 {
    PI / spring.stiffness.sqrt()
}

fn scene(spring: &Spring, height: f64, speed: f64, step: f64) -> Result<World, Failure> {
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .grain(
            Grain::at([0.0, height], RADIUS)
                .moving([0.0, -speed])
                .of_density(DENSITY),
        )
        .grain(Grain::at([0.0; 2], RADIUS).fixed())
        .and(&linear(spring.stiffness * mass(), spring.damping * mass()))
        .gravity(GRAVITY);
    Ok(draft.world()?)
}

/// Speed of impact in m/s.
fn impact_speed() -> f64 {
    (2.0 * GRAVITY * DROP).sqrt()
}

/// Height above contact and time of the highest point after one contact, from the kernel: both are
/// constants of the flight.
fn thrown(spring: &Spring, steps: u64) -> Result<[f64; 2], Failure> {
    let touching = (2.0 * RADIUS).next_down();
    let step = half_period(spring) / steps as f64;
    let mut world = scene(spring, touching, impact_speed(), step)?;
    for _ in 0..4 * steps {
        world.step()?;
        let p = world.particles();
        let (y, v) = (p.position[0].y - 2.0 * RADIUS, p.velocity[0].y);
        if y > 0.0 {
            return Ok([y + v * v / (2.0 * GRAVITY), world.time() + v / GRAVITY]);
        }
    }
    Err(Failure::Oracle("the sphere does not come back".to_owned()))
}

fn contact() -> Outcome {
    const STEPS: u64 = 16000;
    let cases = [
        (1e4, [1.0, 0.9, 0.6]),
        (5e4, [0.9, 0.7, 0.5]),
        (1e5, [0.9, 0.7, 0.6]),
        (5e5, [1.0, 0.9, 0.5]),
        (5e6, [1.0, 0.9, 0.5]),
    ];
    let mut table = Table::new(
        "First rebound: height of the centre and contact time, with MFiX's convention for comparison",
        &[
            "stiffness (N/m)",
            "restitution",
            "height (m)",
            "kernel",
            "contact (s)",
            "height, MFiX (m)",
            "contact, MFiX (s)",
            "speed, MFiX (m/s)",
            "hard spheres (m)",
        ],
    );
    let mut all = Vec::new();
    let bound = (PI / STEPS as f64).powi(2) / 4.0;
    for (stiffness, restitutions) in cases {
        for e in restitutions {
            let spring = spring(stiffness, damping_ratio(e));
            let end = spring.release(impact_speed());
            let height = apex(&end, GRAVITY);
            let [measured, time] = thrown(&spring, STEPS)?;
            all.push(Measurement::relative(height, measured, 2.0 * bound));
            all.push(Measurement::relative(
                end.time + end.speed / GRAVITY,
                time,
                2.0 * bound,
            ));
            let theirs = attracting(stiffness, e);
            table.push([
                format!("{stiffness:e}"),
                format!("{e}"),
                format!("{:.10}", RADIUS + height),
                format!("{:.10}", RADIUS + measured),
                format!("{:.10}", end.time),
                format!("{:.9}", RADIUS + apex(&theirs, GRAVITY)),
                format!("{:.9}", theirs.time),
                format!("{:.8}", theirs.speed),
                format!("{:.3}", RADIUS + e * e * DROP),
            ]);
        }
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

/// The end of a contact that attracts until its overlap vanishes, with the damping ratio that gives the
/// restitution without gravity, -ln e / sqrt(pi^2 + ln^2 e).
fn attracting(stiffness: f64, e: f64) -> Release {
    let log = -e.ln();
    spring(stiffness, log / PI.hypot(log)).separation(impact_speed())
}

fn limit() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    for e in [0.9, 0.7, 0.5] {
        let ratio = damping_ratio(e);
        let hard = e * e * DROP;
        let gap = |stiffness: f64| {
            hard - apex(&spring(stiffness, ratio).release(impact_speed()), GRAVITY)
        };
        let stiffnesses = [5e4, 5e5, 5e6, 5e7, 5e8];
        let gaps = stiffnesses
            .iter()
            .map(|&k| Ok([k, hard - thrown(&spring(k, ratio), 16000)?[0]]))
            .collect::<Result<Vec<_>, Failure>>()?;
        let exponent = (gaps[4][1] / gaps[2][1]).log10() / 2.0;
        all.push(Measurement::absolute(-0.5, exponent, 2.0e-3));
        let line = stiffnesses.iter().map(|&k| [k, gap(k)]);
        curves.push(Curve::line(&format!("closed form, e = {e}"), line));
        curves.push(Curve::marks(&format!("kernel, e = {e}"), gaps));
    }
    let plot = Figure::new(
        "Soft spheres approach hard ones with the inverse square root of the stiffness",
        Axis::logarithmic("stiffness", "N/m"),
        Axis::logarithmic("height below that of hard spheres", "m"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

/// Number of bounces compared.
const BOUNCES: usize = 6;

fn bounces() -> Outcome {
    let (mut all, mut curves) = (Vec::new(), Vec::new());
    let mut table = Table::new(
        "Heights of six bounces",
        &[
            "restitution",
            "bounce",
            "expected (m)",
            "kernel (m)",
            "hard spheres (m)",
        ],
    );
    for (stiffness, e) in [(5e4, 0.9), (5e5, 0.7)] {
        let spring = spring(stiffness, damping_ratio(e));
        let step = half_period(&spring) / 1000.0;
        let (heights, line) = expected_bounces(&spring);
        let (measured, marks) = measured_bounces(&spring, step)?;
        let once = 0.5 * spring.damping * step + 0.25 * spring.stiffness * step * step;
        for n in 0..BOUNCES {
            let so_far = (n + 1) as f64;
            all.push(Measurement::relative(
                heights[n],
                measured[n],
                2.0 * so_far * once,
            ));
            table.push([
                format!("{e}"),
                format!("{}", n + 1),
                format!("{:.9}", RADIUS + heights[n]),
                format!("{:.9}", RADIUS + measured[n]),
                format!("{:.9}", RADIUS + DROP * e.powi(2 * n as i32 + 2)),
            ]);
        }
        curves.push(Curve::line(&format!("oracle, e = {e}"), line));
        curves.push(Curve::marks(&format!("kernel, e = {e}"), marks));
    }
    let plot = Figure::new(
        "A dropped sphere bounces as predicted from its spring and gravity",
        Axis::linear("time", "s"),
        Axis::linear("height of the centre", "m"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Table(table), Exhibit::Figure(plot)]))
}

/// Heights above contact, and the path of the centre.
fn expected_bounces(spring: &Spring) -> (Vec<f64>, Vec<[f64; 2]>) {
    let mut speed = impact_speed();
    let fall = speed / GRAVITY;
    let mut path: Vec<[f64; 2]> = (0..8)
        .map(|n| fall * f64::from(n) / 8.0)
        .map(|t| [t, RADIUS + DROP - 0.5 * GRAVITY * t * t])
        .collect();
    let mut time = fall;
    let mut heights = Vec::new();
    for _ in 0..BOUNCES {
        let end = spring.release(speed);
        path.extend((0..10).map(|n| end.time * f64::from(n) / 10.0).map(|t| {
            let [overlap, _] = spring.state(speed, t);
            [time + t, RADIUS - overlap]
        }));
        time += end.time;
        let height = apex(&end, GRAVITY);
        heights.push(height);
        // From the end of contact up, and down to touch.
        speed = (2.0 * GRAVITY * height).sqrt();
        let flight = (end.speed + speed) / GRAVITY;
        path.extend((0..16).map(|n| flight * f64::from(n) / 16.0).map(|t| {
            let y = end.speed * t - 0.5 * GRAVITY * t * t - end.overlap;
            [time + t, RADIUS + y]
        }));
        time += flight;
    }
    (heights, path)
}

fn measured_bounces(spring: &Spring, step: f64) -> Result<(Vec<f64>, Vec<[f64; 2]>), Failure> {
    let mut world = scene(spring, 2.0 * RADIUS + DROP, 0.0, step)?;
    let (mut heights, mut path) = (Vec::new(), Vec::new());
    let mut touches = false;
    while heights.len() < BOUNCES {
        world.step()?;
        let p = world.particles();
        let (y, v) = (p.position[0].y - 2.0 * RADIUS, p.velocity[0].y);
        if touches && y > 0.0 {
            heights.push(y + v * v / (2.0 * GRAVITY));
        }
        touches = y < 0.0;
        if world.steps() % 1000 == 0 {
            path.push([world.time(), RADIUS + y]);
        }
        if world.time() > LONGEST {
            return Err(Failure::Oracle("the sphere stops bouncing".to_owned()));
        }
    }
    Ok((heights, path))
}

/// Time in s within which six bounces must be over.
const LONGEST: f64 = 10.0;
