//! Order through events: the effect of a kink or a jump of the force.

use super::slope;
use crate::checks::dem::scenes::advance;
use crate::checks::{
    Axis, Check, Curve, Effort, Exhibit, Failure, Figure, Measurement, Origin, Outcome, Table,
    thesis,
};
use crate::oracles::events::{Return, bounced, rubbed, slipped};
use crate::scenes::events::held;
use crate::scenes::{Draft, Grain};
use gouge_dem::laws::KelvinVoigt;
use gouge_runner::scene::INTEGRATORS;
use rayon::prelude::*;
use std::f64::consts::PI;

/// The checks of this file.
pub fn checks() -> Vec<Check> {
    let reason = "If an event falls at a random moment of a step, the velocity error is the jump of the force times a fraction of the step (order one), or the kink times a fraction of its square (order two). Over 32 phases and five halvings, the root mean square leaves a scatter of the fitted slope below 0.1";
    vec![
        Check {
            id: "order.events",
            claim: "Every integrator keeps its order if the force only has a kink: undamped contacts begin and end, damped contacts end, friction springs begin and cease to slip, viscous friction falls below its limit. If the force jumps (a damped contact begins, a printed Cundall-Strack contact reverses), methods of order two fall to order one. Symplectic Euler gains an order in an undamped bounce, because no force acts at the start and at the end.",
            equations: thesis("(36), (41), (42), (55)-(58)"),
            scene: "Head-on pairs, and a grain spinning between two fixed ones, through six kinds of events at 32 phases of the step, 40 to 1280 steps",
            oracle: "Closed forms that include the event; orders predicted from the smoothness of the force",
            norm: "Largest distance from the predicted order of the order fitted to the root-mean-square error over all phases",
            origin: Origin::Convergent,
            reason,
            effort: Effort::Thorough,
            measure: all_phases,
        },
        Check {
            id: "order.restart",
            claim: "If the run starts at the moment of touch, with the damping force already acting, every integrator has its full order for a damped contact.",
            equations: thesis("(36), (55)-(58)"),
            scene: "The head-on pair with damping, starting from an overlap of 1e-12 of the unit of length",
            oracle: "Closed form of the damped oscillator",
            norm: "Largest distance of the order observed between 1280 and 2560 steps from the theoretical order",
            origin: Origin::Convergent,
            reason: "The next term of the error is smaller by about the time step, 1e-3 of the time scale, with a factor of a few units",
            effort: Effort::Quick,
            measure: restarted,
        },
    ]
}

/// The event during the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Event {
    /// A contact without damping begins and ends.
    Bounce,
    /// A damped contact begins.
    Meeting,
    /// A damped contact ends.
    Leaving,
    /// A truncated Cundall-Strack contact slips and sticks again.
    Slipping,
    /// A printed Cundall-Strack contact slips and reverses.
    Reversing,
    /// Haff-Werner friction falls below its limit.
    Easing,
}

const EVENTS: [Event; 6] = [
    Event::Bounce,
    Event::Meeting,
    Event::Leaving,
    Event::Slipping,
    Event::Reversing,
    Event::Easing,
];

const RADIUS: f64 = 1e-3;
const STIFFNESS: f64 = 1e7;
/// Damping ratio of the damped contacts.
const ZETA: f64 = 0.3;
/// Speed of a pair in m/s; the overlap stays below a thousandth of the radius.
const SPEED: f64 = 1.0;

fn mass() -> f64 {
    4.0 / 3.0 * PI * 2700.0 * RADIUS.powi(3)
}

/// Distance of the fixed neighbours from the grain that spins between them, centre to centre, in m.
const GAP: f64 = 1.999 * RADIUS;
const FRICTION: f64 = 0.5;

/// Angular frequency of a pair in contact in 1/s.
fn pair_rate() -> f64 {
    (2.0 * STIFFNESS / mass()).sqrt()
}

/// Rate in 1/s of a grain that spins between two others, held by springs or by dashpots whose damping
/// is that stiffness times one microsecond.
fn spin_rate(event: Event) -> f64 {
    match event {
        Event::Easing => 5.0 * STIFFNESS * 1e-6 / mass(),
        _ => (5.0 * STIFFNESS / mass()).sqrt(),
    }
}

/// Stretch of a spring at the friction limit in m; for dashpots, this times their rate is the speed at
/// the limit.
fn stretch(event: Event) -> f64 {
    let limit = FRICTION * STIFFNESS * (2.0 * RADIUS - GAP);
    match event {
        Event::Easing => limit / (STIFFNESS * 1e-6 * spin_rate(event)),
        _ => limit / STIFFNESS,
    }
}

impl Event {
    fn name(self) -> &'static str {
        match self {
            Self::Bounce => "contact without damping, beginning and end",
            Self::Meeting => "damped contact, beginning",
            Self::Leaving => "damped contact, end",
            Self::Slipping => "truncated Cundall-Strack, slip and stick",
            Self::Reversing => "printed Cundall-Strack, reversal",
            Self::Easing => "Haff-Werner, limit to viscous",
        }
    }

    /// Whether the force jumps; otherwise it has a kink.
    fn jumps(self) -> bool {
        matches!(self, Self::Meeting | Self::Reversing)
    }

    /// Expected order of an integrator, given by its position in the list.
    ///
    /// While forces do not depend on velocities, symplectic Euler is velocity Verlet shifted by half a
    /// kick. Both agree if no force acts at the start and at the end, as before and after a bounce.
    fn order(self, integrator: usize) -> f64 {
        match self {
            Self::Bounce if integrator == 1 => 2.0,
            event if event.jumps() => 1.0,
            _ => SMOOTH[integrator],
        }
    }

    /// Time between start and end, in units of the inverse rate.
    fn duration(self) -> f64 {
        match self {
            Self::Bounce | Self::Slipping | Self::Reversing => 4.0,
            Self::Meeting => 1.5,
            Self::Leaving | Self::Easing => 3.0,
        }
    }

    /// Runs the event from a start that depends on the phase. Returns position and velocity at the end,
    /// from the kernel and in closed form, in units of the motion.
    fn run(self, integrator: &str, steps: u64, phase: f64) -> Result<[[f64; 2]; 2], Failure> {
        match self {
            Self::Bounce => self.pair(integrator, steps, -0.3 - 0.3 * phase, 0.0),
            Self::Meeting => self.pair(integrator, steps, -0.3 - 0.3 * phase, ZETA),
            Self::Leaving => self.pair(integrator, steps, 0.2 + 0.3 * phase, ZETA),
            Self::Slipping | Self::Reversing => self.spin(integrator, steps, 1.6 + 0.3 * phase),
            Self::Easing => self.spin(integrator, steps, 2.0 + 0.3 * phase),
        }
    }

    /// A head-on pair that starts the given time before or after touch, in units of the inverse rate.
    fn pair(
        self,
        integrator: &str,
        steps: u64,
        start: f64,
        zeta: f64,
    ) -> Result<[[f64; 2]; 2], Failure> {
        let w = pair_rate();
        let [x, v] = if start < 0.0 {
            [start, 1.0]
        } else {
            bounced(start, zeta)
        };
        let unit = SPEED / w;
        let (half, speed) = (RADIUS - 0.5 * x * unit, 0.5 * v * SPEED);
        let damping = zeta * mass() * w;
        let draft = Draft::open_box(integrator, self.duration() / (w * steps as f64))
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping,
            })
            .with("output.energy", false)
            .grain(Grain::at([-half, 0.0], RADIUS).moving([speed, 0.0]))
            .grain(Grain::at([half, 0.0], RADIUS).moving([-speed, 0.0]));
        let mut world = draft.world()?;
        advance(&mut world, steps)?;
        let p = world.particles();
        let overlap = 2.0 * RADIUS - (p.position[1].x - p.position[0].x);
        let closing = p.velocity[0].x - p.velocity[1].x;
        let end = start + self.duration();
        Ok([[overlap / unit, closing / SPEED], bounced(end, zeta)])
    }

    /// A grain between two fixed ones that starts with the given speed, in units of the speed at the
    /// limit.
    fn spin(self, integrator: &str, steps: u64, speed: f64) -> Result<[[f64; 2]; 2], Failure> {
        let (w, unit) = (spin_rate(self), stretch(self));
        let (law, constant) = match self {
            Self::Easing => ("haff-werner", STIFFNESS * 1e-6),
            Self::Reversing => ("cundall-strack", STIFFNESS),
            _ => ("cundall-strack-truncated", STIFFNESS),
        };
        let step = self.duration() / (w * steps as f64);
        let draft = held(integrator, step, GAP, speed * unit * w / RADIUS)
            .law(KelvinVoigt {
                stiffness: STIFFNESS,
                damping: 0.0,
            })
            .friction(law, FRICTION, constant)
            .with("output.energy", false);
        let mut world = draft.world()?;
        advance(&mut world, steps)?;
        let p = world.particles();
        let found = [
            p.angle[0] * RADIUS / unit,
            p.angular_velocity[0] * RADIUS / (unit * w),
        ];
        let expected = match self {
            Self::Easing => rubbed(self.duration(), speed),
            Self::Reversing => slipped(self.duration(), speed, Return::Stays),
            _ => slipped(self.duration(), speed, Return::Springs),
        };
        Ok([found, expected])
    }

    fn error(self, integrator: &str, steps: u64, phase: f64) -> Result<f64, Failure> {
        let [found, expected] = self.run(integrator, steps, phase)?;
        Ok((found[0] - expected[0]).hypot(found[1] - expected[1]))
    }
}

/// Phases that fill the interval from zero to one evenly for any number of them: multiples of the
/// golden ratio.
fn phases() -> Vec<f64> {
    let golden = 0.5 * (5.0_f64.sqrt() - 1.0);
    (1..=32).map(|n| (golden * f64::from(n)).fract()).collect()
}

/// Time step in units of the inverse rate, and root-mean-square error over all phases.
fn curve(event: Event, integrator: &str) -> Result<Vec<[f64; 2]>, Failure> {
    let phases = phases();
    let mean = |steps: u64| {
        let squares = phases
            .iter()
            .map(|&phase| Ok(event.error(integrator, steps, phase)?.powi(2)))
            .collect::<Result<Vec<f64>, Failure>>()?;
        let mean = squares.iter().sum::<f64>() / squares.len() as f64;
        Ok([event.duration() / steps as f64, mean.sqrt()])
    };
    [40, 80, 160, 320, 640, 1280]
        .into_iter()
        .map(mean)
        .collect()
}

/// Order of the method on smooth motion.
const SMOOTH: [f64; 5] = [1.0, 1.0, 1.0, 2.0, 2.0];

fn all_phases() -> Outcome {
    let cases: Vec<(Event, usize)> = EVENTS
        .iter()
        .flat_map(|&event| (0..INTEGRATORS.len()).map(move |n| (event, n)))
        .collect();
    let curves = cases
        .par_iter()
        .map(|&(event, n)| curve(event, INTEGRATORS[n].0))
        .collect::<Result<Vec<_>, Failure>>()?;
    let mut table = Table::new(
        "Orders through events: predicted from the smoothness of the force, and observed",
        &["event", "force", "integrator", "predicted", "observed"],
    );
    let (mut all, mut verlet) = (Vec::new(), Vec::new());
    for (&(event, n), points) in cases.iter().zip(curves) {
        let predicted = event.order(n);
        let found = slope(&points);
        all.push(Measurement::absolute(predicted, found, 0.1));
        let force = if event.jumps() { "jumps" } else { "has a kink" };
        table.push([
            event.name().to_owned(),
            force.to_owned(),
            INTEGRATORS[n].0.to_owned(),
            format!("{predicted}"),
            format!("{found:.3}"),
        ]);
        if n == 3 {
            verlet.push(Curve::marked_line(event.name(), points));
        }
    }
    let plot = Figure::new(
        "A jump of the force reduces the order of velocity Verlet from two to one",
        Axis::logarithmic("time step in units of the inverse rate", ""),
        Axis::logarithmic("root-mean-square error at the end over all phases", ""),
        verlet,
    );
    Ok(Measurement::worst(all).showing([Exhibit::Table(table), Exhibit::Figure(plot)]))
}

fn restarted() -> Outcome {
    let mut all = Vec::new();
    for ((name, _), order) in INTEGRATORS.iter().zip(SMOOTH) {
        let error = |steps: u64| {
            let [found, expected] = Event::Meeting.pair(name, steps, 1e-12, ZETA)?;
            Ok::<f64, Failure>((found[0] - expected[0]).hypot(found[1] - expected[1]))
        };
        let found = (error(1280)? / error(2560)?).log2();
        all.push(Measurement::absolute(order, found, 0.01));
    }
    Ok(Measurement::worst(all).into())
}
