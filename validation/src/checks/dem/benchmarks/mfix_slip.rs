//! MFiX DEM04: a sphere slides until it rolls.

use super::plane::{FLATNESS, linear};
use crate::checks::dem::scenes::advance;
use crate::checks::extrapolation::to_no_step;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};
use crate::scenes::{Draft, Grain};
use gouge_common::scalar::Real;
use gouge_dem::World;
use gouge_dem::integrators::Integrator;
use gouge_scalars::DoubleDouble;
use std::f64::consts::PI;

/// The checks.
pub fn checks() -> Vec<Check> {
    vec![
        Check {
            id: "benchmarks.mfix.04",
            claim: "DEM04: a sphere that slides with initial speed u_0 starts to roll after the time 2 u_0 / (7 mu g) and the distance (12/49) u_0^2 / (mu g), with 5/7 of its speed. With the viscous law the sliding phase ends when the slip has fallen to mu m g / gamma.",
            equations: thesis("(6)-(7), (10), (35)-(36), (41)-(42)"),
            scene: "A sphere of 1 mm diameter and 10000 kg/m^3 at 0.1 m/s on a plane, k = 1e4 N/m; mu = 0.2, 0.5 and 1; Haff-Werner, printed and truncated Cundall-Strack, time steps of 5 us",
            oracle: "Uniform deceleration from the state after one step. The spring needs 10 ns to reach its limit, which no time step resolves",
            norm: "Relative error of time, distance, velocity and surface speed at the end of sliding, interpolated within the step",
            origin: Origin::Exact,
            reason: "Under constant forces velocity Verlet is exact. The resting height, a double, contributes 1e-11 of the weight, the interpolation over a few steps about 1e-12 of the speed, and the curvature of the plane, a sphere 1e12 times as large, as much",
            effort: Effort::Quick,
            measure: sliding,
        },
        Check {
            id: "benchmarks.mfix.04-rolling",
            claim: "DEM04: once it rolls, the sphere conserves its angular momentum about the contact point, and its slip stays within the bound of each friction law.",
            equations: thesis("(6)-(7), (41)-(42)"),
            scene: "The same scene, for another 2 ms",
            oracle: "v - (2/5) r w = u_0. Bounds of the slip: mu m g / gamma for the viscous law, (7/2) mu g dt for the chatter of the printed law, and mu m g sqrt(7 / (2 m k)) for the oscillation of a truncated spring released at its limit",
            norm: "Relative error of the invariant, in units of 1e-11; slip over its bound, minus one",
            origin: Origin::Exact,
            reason: "Rounding. The printed law reverses its force at rest, so that one step more than stops the slip. The spring oscillates with a time step of 0.22 of its time scale, for which velocity Verlet exceeds the amplitude by (w dt)^2 / 8, and its release within a step adds w dt / 2",
            effort: Effort::Quick,
            measure: rolling,
        },
        Check {
            id: "benchmarks.mfix.04-viscous",
            claim: "DEM04 below the Coulomb limit: viscous friction turns sliding into rolling exponentially, at the rate (7/2) gamma / m.",
            equations: thesis("(6)-(7), (34), (41)"),
            scene: "The same sphere with mu = 1e4 and Haff-Werner, 0.2 ms; 40 to 320 steps, extrapolated",
            oracle: "Closed form: slip u_0 exp(-7 gamma t / (2 m)), velocity (5 u_0 + 2 slip) / 7",
            norm: "Largest error of velocity and surface speed in units of u_0, every 0.05 ms",
            origin: Origin::Convergent,
            reason: "The error is a series in dt starting at dt^2. Extrapolation from four time steps leaves 1.04e-3 of its term in dt^5, which with rate dt = 0.1 for the coarsest is 1.04e-8 times a coefficient below a tenth, as for the decay of an exponential",
            effort: Effort::Quick,
            measure: viscous,
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

/// Friction law of DEM04.
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
    /// Damping in kg/s or stiffness in kg/s^2.
    fn constant(self) -> f64 {
        match self {
            Self::Viscous => DAMPING,
            _ => STIFFNESS,
        }
    }
    /// Slip in m/s at which uniform sliding ends.
    fn least_slip(self, friction: f64) -> f64 {
        match self {
            Self::Viscous => friction * mass() * GRAVITY / DAMPING,
            _ => 0.0,
        }
    }
    /// Bound of the slip in m/s afterwards.
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

fn resting(law: Law, friction: f64, step: f64) -> Result<World<DoubleDouble>, Failure> {
    let height = RADIUS - mass() * GRAVITY / STIFFNESS;
    let draft = Draft::open_box(Integrator::VelocityVerlet, step)
        .grain(
            Grain::at([0.0, height], RADIUS)
                .moving([SPEED, 0.0])
                .of_density(1e4),
        )
        .grain(Grain::at([0.0, -FLATNESS * RADIUS], FLATNESS * RADIUS).fixed())
        .and(&linear(STIFFNESS, 0.0))
        .friction(law.name(), friction, law.constant())
        .gravity(GRAVITY);
    Ok(draft.world_in()?)
}

/// A moment of sliding: time, position, velocity, surface speed.
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
    /// The moment at which uniform sliding has slowed to the given slip.
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
    /// Linear extrapolation from two moments to the given slip; the position is a parabola.
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

/// The state after one step and the end of sliding, from the kernel.
fn slid(law: Law, friction: f64) -> Result<(Sliding, Sliding), Failure> {
    let mut world = resting(law, friction, STEP)?;
    world.step()?;
    let first = Sliding::of(&world);
    let least = law.least_slip(friction);
    // The printed law can stop the slip just above zero, so the search ends with the last step of
    // sliding.
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
        "From sliding to rolling: time, distance and velocity",
        &[
            "friction",
            "law",
            "end of sliding (s)",
            "kernel",
            "distance (m)",
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
            let mut world = resting(law, friction, STEP)?;
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
    let plot = Figure::new(
        "For every friction coefficient the sphere finally rolls at five sevenths of its speed",
        Axis::linear("time", "ms"),
        Axis::linear("velocity", "m/s"),
        curves,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Figure(plot)]))
}

/// Interval of comparison in the viscous decay, in s.
const EVERY: f64 = 5e-5;

fn viscous() -> Outcome {
    let run = |steps: u64| {
        let mut world = resting(Law::Viscous, 1e4, EVERY / steps as f64)?;
        let row = |_| {
            advance(&mut world, steps)?;
            let now = Sliding::of(&world);
            Ok([now.velocity, now.surface])
        };
        (0..4).map(row).collect::<Result<Vec<_>, Failure>>()
    };
    let levels = [10, 20, 40, 80].into_iter().map(run);
    let measured = to_no_step(levels.collect::<Result<Vec<_>, Failure>>()?, &[2, 3, 4]);
    let rate = 3.5 * DAMPING / mass();
    let compared = measured.iter().enumerate().flat_map(|(n, measured)| {
        let slip = SPEED * (-rate * EVERY * (n + 1) as f64).exp();
        let velocity = (5.0 * SPEED + 2.0 * slip) / 7.0;
        let expected = [velocity, slip - velocity];
        [0, 1].map(|at| Measurement::scaled(expected[at], measured[at], SPEED, 1e-9))
    });
    Ok(Measurement::worst(compared).into())
}
