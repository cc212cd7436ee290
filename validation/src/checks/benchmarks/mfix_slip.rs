//! MFiX DEM04 and DEM05: a sphere slides until it rolls, and hits a plane obliquely.

use super::literature;
use super::plane::{FLATNESS, Flight, OnPlane, fixed, linear, material};
use super::sweep::step_errors;
use crate::checks::scenes::{advance, head, particle, world_in};
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Measurement, Origin, Outcome, Plot, Table,
};
use crate::oracles::impact::{Normal, Tangential};
use crate::scalars::DoubleDouble;
use gouge_kernel::World;
use gouge_kernel::scalar::Real;
use std::f64::consts::PI;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.mfix.04",
            claim: "DEM04: a sphere that slides with u_0 rolls after 2 u_0 / (7 mu g), a way of (12/49) u_0^2 / (mu g) later, with 5/7 of its speed; the viscous law only until it has slowed down to mu m g / gamma.",
            equations: "(6)-(7), (10), (35)-(36), (41)-(42)",
            scene: "A sphere of 1 mm and 10000 kg/m^3 at 0.1 m/s rests on a plane, k = 1e4 N/m; mu = 0.2, 0.5 and 1; Haff-Werner, Cundall-Strack as printed and truncated, steps of 5 us",
            oracle: "Uniform retardation, from the state after one step: the spring, which is there at once, needs 10 ns to reach the limit, and no step resolves that",
            norm: "Relative error of time, way, velocity and surface speed at which the slip, interpolated within its step, ends",
            origin: Origin::Exact,
            reason: "Under constant forces velocity Verlet is exact; the height at rest, a double, leaves 1e-11 of the weight, interpolation over a few steps some 1e-12 of the speed, and the plane, a sphere 1e12 times as large, bends by as much",
            effort: Effort::Quick,
            measure: sliding,
        },
        Check {
            id: "benchmarks.mfix.04-rolling",
            claim: "DEM04: once it rolls the sphere keeps the angular momentum about its contact, and does not slip faster than each law of friction allows.",
            equations: "(6)-(7), (41)-(42)",
            scene: "The same, for another 2 ms",
            oracle: "v - (2/5) r w = u_0; slip below mu m g / gamma (viscous), below the chatter (7/2) mu g dt of the printed law, below the swing mu m g sqrt(7 / (2 m k)) of a spring released at its limit",
            norm: "Error of the invariant over the speed, in units of 1e-11; slip over its bound, less one",
            origin: Origin::Exact,
            reason: "Rounding; the printed law changes the sign of its force at rest, so that one step more than stops it; the spring swings with a step of 0.22 of its time scale, with which velocity Verlet exceeds the amplitude by (w dt)^2 / 8, and is released within a step, which adds w dt / 2",
            effort: Effort::Quick,
            measure: rolling,
        },
        Check {
            id: "benchmarks.mfix.05-stick",
            claim: "DEM05: while a linear contact sticks, the contact point comes back with cos(pi sqrt((7/2) k_t / k_n)) of its speed.",
            equations: "(35)-(36), (42)",
            scene: "A sphere of aluminium oxide on a plane at 45 degrees, Kelvin-Voigt without damping, truncated Cundall-Strack with mu = 1e15; k_t / k_n = 2/7, 0.8605, 1 and 10; steps with which the contact ends on a step",
            oracle: "Two springs: half a period of one, sqrt((7/2) k_t / k_n) times as much of the other",
            norm: "Error of the ratio, extrapolated to no step from 64 to 1024 steps",
            origin: Origin::Convergent,
            reason: "With half a period a whole number of steps, of w dt = 2 sin(pi / 2 n), the error is a series in n^-2; extrapolation through five of them leaves a product of (18.6 / n)^2 / 24 of the larger ones, below 1e-9, and the contact is kept closed by ending it 1e-13 early",
            effort: Effort::Quick,
            measure: sticking,
        },
        Check {
            id: "benchmarks.mfix.05",
            claim: "DEM05: the whole curves of oblique impact with linear springs, and 1 - 0.184 cot(theta) where the contact slides.",
            equations: "(35)-(36), (42)",
            scene: "A sphere of 5 mm and 4000 kg/m^3 at 3.9 m/s, 5 to 65 degrees, k_n = 1.72e7, k_t = 1.48e7 N/m, mu = 0.092, e = 1; 1500 steps a collision",
            oracle: "Integration to high order between located events; above 35 degrees the closed form",
            norm: "Error of normal and tangential velocity and surface speed, in units of the normal speed; the worst for its tolerance",
            origin: Origin::Convergent,
            reason: "As in test 4 of Chung and Ooi; where the contact slides the closed form to 1e-8, because without damping half a sine of steps loses no speed but in the step in which it ends, (pi / n)^3 / 6 of it",
            effort: Effort::Quick,
            measure: oblique,
        },
    ]
}

const RADIUS: f64 = 5e-4;
const SPEED: f64 = 0.1;
const GRAVITY: f64 = 9.81;
const STIFFNESS: f64 = 1e4;
const STEP: f64 = 5e-6;
const DAMPING: f64 = 0.03;

fn mass() -> f64 {
    4.0 / 3.0 * PI * 1e4 * RADIUS.powi(3)
}

/// Law of friction of DEM04.
#[derive(Clone, Copy, PartialEq)]
enum Law {
    Viscous,
    Printed,
    Truncated,
}

impl Law {
    const ALL: [Self; 3] = [Self::Viscous, Self::Printed, Self::Truncated];

    fn name(self) -> &'static str {
        match self {
            Self::Viscous => "haff-werner",
            Self::Printed => "cundall-strack",
            Self::Truncated => "cundall-strack-truncated",
        }
    }
    fn text(self, friction: f64) -> String {
        let constant = match self {
            Self::Viscous => format!("damping = {DAMPING:e}"),
            _ => format!("stiffness = {STIFFNESS:e}"),
        };
        let name = self.name();
        format!("[contact.tangential]\nlaw = \"{name}\"\nfriction = {friction:e}\n{constant}\n")
    }
    /// Slip in m/s at which uniform sliding ends.
    fn least_slip(self, friction: f64) -> f64 {
        match self {
            Self::Viscous => friction * mass() * GRAVITY / DAMPING,
            _ => 0.0,
        }
    }
    /// Largest slip in m/s afterwards.
    fn most_slip(self, friction: f64) -> f64 {
        match self {
            Self::Viscous => self.least_slip(friction),
            Self::Printed => 3.5 * friction * GRAVITY * STEP,
            Self::Truncated => {
                let frequency = (3.5 * STIFFNESS / mass()).sqrt();
                let phase = frequency * STEP;
                let swing = frequency * friction * mass() * GRAVITY / STIFFNESS;
                swing * (1.0 + 0.5 * phase + phase * phase / 8.0)
            }
        }
    }
}

fn resting(law: Law, friction: f64) -> Result<World<DoubleDouble>, Failure> {
    let height = RADIUS - mass() * GRAVITY / STIFFNESS;
    let text = head("velocity-verlet", STEP)
        + &particle([0.0, height], [SPEED, 0.0], 0.0, RADIUS)
        + "density = 1e4\n"
        + &fixed([0.0, -FLATNESS * RADIUS], FLATNESS * RADIUS)
        + &linear(STIFFNESS, 0.0)
        + &law.text(friction)
        + &format!("[external]\nlaw = \"gravity\"\nacceleration = {GRAVITY:e}\n");
    world_in(&text)
}

/// A moment of sliding: time, place, velocity, surface speed.
#[derive(Clone, Copy, Default)]
struct Sliding {
    time: f64,
    place: f64,
    velocity: f64,
    surface: f64,
}

impl Sliding {
    fn of(world: &World<DoubleDouble>) -> Self {
        let p = world.particles();
        Self {
            time: world.time(),
            place: p.position[0].x.to_f64(),
            velocity: p.velocity[0].x.to_f64(),
            surface: p.angular_velocity[0].to_f64() * RADIUS,
        }
    }
    fn slip(&self) -> f64 {
        self.velocity + self.surface
    }
    /// The moment at which uniform sliding has slowed down to a slip.
    fn until(&self, slip: f64, friction: f64) -> Self {
        let retardation = friction * GRAVITY;
        let wait = (self.slip() - slip) / (3.5 * retardation);
        Self {
            time: self.time + wait,
            place: self.place + (self.velocity - 0.5 * retardation * wait) * wait,
            velocity: self.velocity - retardation * wait,
            surface: self.surface - 2.5 * retardation * wait,
        }
    }
    /// The moment at which the straight lines through two moments reach a slip; a parabola for the place.
    fn extrapolated(&self, later: &Self, slip: f64) -> Self {
        let s = (self.slip() - slip) / (self.slip() - later.slip());
        let line = |a: f64, b: f64| a + (b - a) * s;
        let step = later.time - self.time;
        let velocity = line(self.velocity, later.velocity);
        Self {
            time: line(self.time, later.time),
            place: self.place + 0.5 * (self.velocity + velocity) * s * step,
            velocity,
            surface: line(self.surface, later.surface),
        }
    }
}

/// The state after one step, and the end of sliding, by the kernel.
fn slid(law: Law, friction: f64) -> Result<(Sliding, Sliding), Failure> {
    let mut world = resting(law, friction)?;
    world.step()?;
    let first = Sliding::of(&world);
    let least = law.least_slip(friction);
    // The printed law can stop the slip just above zero: the last step of sliding ends the search.
    let nearly = least + 1.001 * 3.5 * friction * GRAVITY * STEP;
    let mut last = [first; 3];
    for _ in 0..10_000 {
        world.step()?;
        let now = Sliding::of(&world);
        if now.slip() <= nearly {
            return Ok((first, last[0].extrapolated(&last[1], least)));
        }
        last = [last[1], last[2], now];
    }
    Err(Failure::Oracle("the sphere does not roll".to_owned()))
}

const FRICTIONS: [f64; 3] = [0.2, 0.5, 1.0];

fn sliding() -> Outcome {
    let mut table = Table::new(
        "From sliding to rolling: when, where, how fast",
        &[
            "friction",
            "law",
            "end of sliding (s)",
            "kernel",
            "way (m)",
            "kernel",
            "velocity (m/s)",
            "kernel",
            "rigid: 2 u / (7 mu g) (s)",
        ],
    );
    let mut all = Vec::new();
    for friction in FRICTIONS {
        for law in Law::ALL {
            let (first, measured) = slid(law, friction)?;
            let expected = first.until(law.least_slip(friction), friction);
            let pairs = [
                (expected.time, measured.time),
                (expected.place, measured.place),
                (expected.velocity, measured.velocity),
                (expected.surface, measured.surface),
            ];
            all.extend(pairs.map(|(a, b)| Measurement::relative(a, b, 1e-10)));
            table.push([
                format!("{friction}"),
                law.name().to_owned(),
                format!("{:.13e}", expected.time),
                format!("{:.13e}", measured.time),
                format!("{:.13e}", expected.place),
                format!("{:.13e}", measured.place),
                format!("{:.13}", expected.velocity),
                format!("{:.13}", measured.velocity),
                format!("{:.9e}", 2.0 * SPEED / (7.0 * friction * GRAVITY)),
            ]);
        }
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn rolling() -> Outcome {
    let mut all = Vec::new();
    let mut curves = Vec::new();
    for friction in FRICTIONS {
        for law in Law::ALL {
            let mut world = resting(law, friction)?;
            let rolls = 2.0 * SPEED / (7.0 * friction * GRAVITY);
            let until = (rolls / STEP) as u64 + 1;
            let mut marks = Vec::new();
            for n in 0..until + 400 {
                world.step()?;
                let now = Sliding::of(&world);
                if n % (until / 30) == 0 {
                    marks.push([1e3 * now.time, now.velocity]);
                }
                if n > until + 1 {
                    let bound = law.most_slip(friction);
                    let excess = (now.slip().abs() / bound - 1.0).max(0.0);
                    all.push(Measurement::absolute(0.0, excess, 1e-6));
                }
            }
            let now = Sliding::of(&world);
            let invariant = now.velocity - 0.4 * now.surface;
            all.push(Measurement::relative(SPEED, invariant, 1e-11));
            if law == Law::Truncated {
                let rigid = [
                    [0.0, SPEED],
                    [1e3 * rolls, 5.0 / 7.0 * SPEED],
                    [1e3 * rolls + 2.0, 5.0 / 7.0 * SPEED],
                ];
                curves.push(Curve::line(
                    &format!("rigid sphere, mu = {friction}"),
                    rigid,
                ));
                curves.push(Curve::marks(&format!("kernel, mu = {friction}"), marks));
            }
        }
    }
    let plot = Plot {
        title: "Whatever the friction, the sphere rolls with five sevenths of its speed".to_owned(),
        x: Axis::linear("time (ms)"),
        y: Axis::linear("velocity (m/s)"),
        curves,
    };
    Ok(Measurement::worst(all).showing([Exhibit::Plot(plot)]))
}

const NORMAL: f64 = 1.72e7;
const TANGENTIAL: f64 = 1.48e7;

fn contact(ratio: f64, friction: f64) -> OnPlane {
    OnPlane {
        material: material("aluminium oxide", [3.8e11, 0.23], 4000.0),
        radius: 0.0025,
        normal: Normal::Linear([NORMAL, 0.0]),
        tangential: Tangential::Spring([friction, ratio * NORMAL]),
    }
}

/// Slip after half a period over slip before, with so many steps.
fn stuck(ratio: f64, steps: u64) -> Result<f64, Failure> {
    let contact = contact(ratio, 1e15);
    let before = Flight {
        along: 2.0,
        normal: 2.0,
        spin: 0.0,
    };
    let phase = 2.0 * (0.5 * PI / steps as f64).sin();
    let step = phase * (contact.mass() / NORMAL).sqrt() * (1.0 - 1e-13);
    let mut world = world_in::<DoubleDouble>(&contact.scene_with_step(before, step))?;
    advance(&mut world, steps)?;
    let p = world.particles();
    let slip = p.velocity[0].x.to_f64() + contact.radius * p.angular_velocity[0].to_f64();
    Ok(slip / before.along)
}

fn sticking() -> Outcome {
    let mut table = Table::new(
        "Slip after a collision without sliding, over slip before",
        &["k_t / k_n", "expected", "kernel, extrapolated"],
    );
    let mut all = Vec::new();
    for ratio in [2.0 / 7.0, TANGENTIAL / NORMAL, 1.0, 10.0] {
        let mut levels = [64, 128, 256, 512, 1024]
            .iter()
            .map(|&steps| stuck(ratio, steps))
            .collect::<Result<Vec<_>, Failure>>()?;
        for order in 1..5 {
            let weight = 1.0 / (f64::from(1 << (2 * order)) - 1.0);
            levels = levels
                .windows(2)
                .map(|pair| pair[1] + (pair[1] - pair[0]) * weight)
                .collect();
        }
        let expected = (PI * (3.5 * ratio).sqrt()).cos();
        all.push(Measurement::absolute(expected, levels[0], 1e-9));
        table.push([
            format!("{ratio:.6}"),
            format!("{expected:.12}"),
            format!("{:.12}", levels[0]),
        ]);
    }
    Ok(Measurement::worst(all).showing([Exhibit::Table(table)]))
}

fn oblique() -> Outcome {
    const STEPS: u64 = 1500;
    let contact = contact(TANGENTIAL / NORMAL, 0.092);
    let (mut all, mut line, mut marks) = (Vec::new(), Vec::new(), Vec::new());
    let mut table = Table::new(
        "Tangential restitution of DEM05",
        &["angle (deg)", "expected", "kernel", "1 - 0.184 cot(theta)"],
    );
    for n in 1..=13 {
        let degrees = 5.0 * f64::from(n);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let before = Flight {
            along: 3.9 * sin,
            normal: 3.9 * cos,
            spin: 0.0,
        };
        let (a, b) = (contact.expected(before)?, contact.measured(before, STEPS)?);
        let step = contact.duration(before.normal) / STEPS as f64;
        let [normal, along] = step_errors(&contact.impact(), before.normal, before.along, step);
        let turning = before.normal / contact.radius;
        all.push(Measurement::scaled(
            a.normal,
            b.normal,
            before.normal,
            normal,
        ));
        all.push(Measurement::scaled(a.along, b.along, before.normal, along));
        all.push(Measurement::scaled(a.spin, b.spin, turning, 2.5 * along));
        let slides = 1.0 - 0.184 / degrees.to_radians().tan();
        let restitution = b.along / before.along;
        if degrees > 35.0 {
            all.push(Measurement::absolute(slides, restitution, 1e-8));
        }
        line.push([degrees, a.along / before.along]);
        marks.push([degrees, restitution]);
        table.push([
            format!("{degrees:.0}"),
            format!("{:.10}", a.along / before.along),
            format!("{restitution:.10}"),
            format!("{slides:.10}"),
        ]);
    }
    let measured = literature::OBLIQUE_MEASURED;
    let plot = Plot {
        title: "Linear springs miss the dip that the experiment has below the angle of sliding"
            .to_owned(),
        x: Axis::linear("angle of impact (deg)"),
        y: Axis::linear("tangential restitution"),
        curves: vec![
            Curve::line("oracle", line),
            Curve::marks("kernel", marks),
            Curve::marks(
                "literature: experiment of Kharaz et al., digitised",
                measured,
            ),
        ],
    };
    Ok(Measurement::worst(all).showing([Exhibit::Table(table), Exhibit::Plot(plot)]))
}
