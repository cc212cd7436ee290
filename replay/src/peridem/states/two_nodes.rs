//! Motion of two nodes along their line, by steps of the kernel extrapolated to steps of no length.

use super::Found;
use super::constants::{object, weight};
use crate::error::Fault;
use crate::fields::Fields;
use crate::peridem::refusals::{CONTACT, of_parameter};
use core::f64::consts::TAU;
use gouge_common::geometry::Vec2;
use gouge_peridem::bond_law::{BreakOrder, BreakingRule};
use gouge_peridem::bonds::Bonds;
use gouge_peridem::contact_law::{ContactLaw, ContactReading};
use gouge_peridem::contacts::Contact;
use gouge_peridem::forces::Settings;
use gouge_peridem::grain::{Grain, Grains};
use gouge_peridem::material::{BondConstants, Weight};
use gouge_peridem::state::State;
use gouge_peridem::world::{Beginning, World};

/// Steps per inverse frequency in the coarsest run.
const COARSEST: f64 = 64.0;
/// Most runs; each has half the step of the one before.
const RUNS: u32 = 9;
/// Relative change from one run to the next at which a moment counts as found.
const CONVERGED: f64 = 1e-13;
/// Number of steps through which a polynomial is laid.
const POINTS: usize = 6;
/// Longest motion, in inverse frequencies. Nodes that take longer to separate do so at the speed of rounding.
const LONGEST: f64 = 30.0;
/// Horizon in m of a bond that gives none although its weight depends on it.
const HORIZON: f64 = 0.0005;
/// Ratio of the speeds of separation and approach below which it is rounding.
const NOISE: f64 = 1e-12;
/// Ratio of the speed to the least one that breaks, in the case that breaks.
const BREAKING_RATIO: f64 = 1.3;

/// Two nodes on the x axis.
#[derive(Clone)]
struct Two {
    /// Distance in m at the beginning.
    distance: f64,
    area: [f64; 2],
    density: f64,
    /// Speed in m/s at which the nodes move apart at the beginning.
    opening_speed: f64,
    link: Link,
}

/// What acts between them.
#[derive(Clone)]
enum Link {
    Bond(BondConstants, Option<BreakingRule>),
    Contact(ContactLaw, f64),
}

/// How far apart two nodes have moved, in m, and how fast, in m/s, after each step.
struct Motion {
    step: f64,
    opening: Vec<f64>,
    speed: Vec<f64>,
}

/// A moment of a motion: time in s, opening in m, speed in m/s.
type Moment = [f64; 3];

impl Two {
    fn reduced_mass(&self) -> f64 {
        let [x, y] = self.area.map(|area| area * self.density);
        x * y / (x + y)
    }

    /// Frequency in 1/s without damping.
    fn frequency(&self) -> f64 {
        let [x, y] = self.area;
        let stiffness = match &self.link {
            Link::Bond(constants, _) => {
                let weight = constants.weight.at(self.distance, constants.horizon);
                constants.stiffness * weight / self.distance
            }
            Link::Contact(law, stiffness) => law.between_grains(*stiffness).stiffness,
        };
        (stiffness * x * y / self.reduced_mass()).sqrt()
    }

    /// The nodes as one bonded grain, or as two grains.
    fn world(&self, step: f64) -> Result<World, Fault> {
        let places = [Vec2::zero(), Vec2::new(self.distance, 0.0)];
        let (constants, breaking) = match self.link {
            Link::Bond(constants, breaking) => (constants, breaking),
            Link::Contact(..) => (NO_BONDS, None),
        };
        let grain = |nodes: &[usize]| Grain {
            position: nodes.iter().map(|&node| places[node]).collect(),
            area: nodes.iter().map(|&node| self.area[node]).collect(),
            density: self.density,
            constants,
            breaking,
            touches_itself: false,
            contact_stiffness: constants.stiffness,
            material: 0,
            clamped: Vec::new(),
            load: Vec::new(),
        };
        let (grains, pairs) = match self.link {
            Link::Bond(..) => (vec![grain(&[0, 1])], vec![vec![[0, 1]]]),
            Link::Contact(..) => (vec![grain(&[0]), grain(&[1])], Vec::new()),
        };
        let grains = Grains::new(&grains)?;
        let bonds = Bonds::from_pairs(&grains, &pairs)?;
        let mut state = State::at_rest(&grains, bonds);
        let [x, y] = self.area.map(|area| area / (self.area[0] + self.area[1]));
        state.velocity = [-y, x]
            .map(|share| Vec2::new(share * self.opening_speed, 0.0))
            .to_vec();
        let contact = match self.link {
            Link::Bond(..) => None,
            Link::Contact(law, stiffness) => Some(Contact {
                law,
                stiffness: vec![vec![stiffness]],
                shares_sticking: false,
            }),
        };
        let settings = Settings {
            time_step: step,
            gravity: Vec2::zero(),
            break_order: BreakOrder::BreakFirst,
            contact,
            walls: None,
        };
        Ok(World::new(grains, settings, state, Beginning::Forces)?)
    }

    /// Move until an event, which is seen in a step with the opening and the speed before and after it.
    fn run(
        &self,
        step: f64,
        ends: &impl Fn([f64; 2], [f64; 2]) -> bool,
    ) -> Result<Option<Motion>, Fault> {
        let mut world = self.world(step)?;
        let mut motion = Motion {
            step,
            opening: vec![0.0],
            speed: vec![self.opening_speed],
        };
        let most = (LONGEST / (self.frequency() * step)) as usize;
        for _ in 0..most {
            world.step()?;
            let state = world.state();
            let [from, to] =
                [0, 1].map(|node| (state.places[node].displacement.x, state.velocity[node].x));
            motion.opening.push(to.0 - from.0);
            motion.speed.push(to.1 - from.1);
            let last = |values: &[f64]| [values[values.len() - 2], values[values.len() - 1]];
            if motion.opening.len() > POINTS && ends(last(&motion.opening), last(&motion.speed)) {
                return Ok(Some(motion));
            }
        }
        Ok(None)
    }

    /// A moment, extrapolated from runs with ever shorter steps; nothing if it never comes.
    ///
    /// The errors of a run are a power series in its step, because the steps of the motion up to the moment are linear.
    fn moment(
        &self,
        ends: impl Fn([f64; 2], [f64; 2]) -> bool,
        find: impl Fn(&Motion) -> Moment,
    ) -> Result<Option<Moment>, Fault> {
        let mut row: Vec<Moment> = Vec::new();
        let mut best = ([0.0; 3], f64::INFINITY);
        for run in 0..RUNS {
            let step = 1.0 / (self.frequency() * COARSEST * f64::from(1 << run));
            let Some(motion) = self.run(step, &ends)? else {
                return Ok(None);
            };
            let before = row.last().copied();
            let value = extrapolate(&mut row, find(&motion));
            let change = before.map_or(f64::INFINITY, |before| largest_change(&before, &value));
            if change <= best.1 {
                best = (value, change);
            }
            if change <= CONVERGED {
                break;
            }
        }
        Ok(Some(best.0))
    }

    /// The first moment after which the nodes are farther apart than an opening.
    fn opens_beyond(&self, level: f64) -> Result<Option<Moment>, Fault> {
        let ends = |[before, after]: [f64; 2], _: [f64; 2]| before <= level && after > level;
        self.moment(ends, |motion| motion.crossing(level))
    }

    /// The first moment at which the nodes turn round.
    fn turns(&self) -> Result<Option<Moment>, Fault> {
        let ends = |_: [f64; 2], [before, after]: [f64; 2]| before * after <= 0.0;
        self.moment(ends, Motion::turning)
    }
}

/// Add the result of a run to the last row of the scheme of Richardson, and return the extrapolated moment.
fn extrapolate(row: &mut Vec<Moment>, result: Moment) -> Moment {
    let mut value = result;
    let mut power = 1.0;
    for before in row.iter_mut() {
        power *= 2.0;
        let better = [0, 1, 2].map(|k| value[k] + (value[k] - before[k]) / (power - 1.0));
        *before = core::mem::replace(&mut value, better);
    }
    row.push(value);
    value
}

/// Largest relative change of the numbers of a moment.
fn largest_change(before: &Moment, after: &Moment) -> f64 {
    let changes = before.iter().zip(after);
    let relative =
        changes.map(|(before, after)| (after - before).abs() / after.abs().max(f64::MIN_POSITIVE));
    relative.fold(0.0, f64::max)
}

/// Constants of nodes that have no bonds.
const NO_BONDS: BondConstants = BondConstants {
    weight: Weight::Constant,
    horizon: 1.0,
    stiffness: 1.0,
    critical_stretch: 1.0,
};

/// A polynomial through values at 0, 1, 2, ..., by the method of Neville.
fn interpolated(values: &[f64], at: f64) -> f64 {
    let mut row = values.to_vec();
    for order in 1..row.len() {
        for k in 0..row.len() - order {
            let from = k as f64;
            row[k] += (at - from) / order as f64 * (row[k + 1] - row[k]);
        }
    }
    row[0]
}

/// Zero of a polynomial through values at 0, 1, 2, ... in the interval that begins at a place.
fn zero(values: &[f64], place: usize) -> f64 {
    let (mut low, mut high) = (place as f64, place as f64 + 1.0);
    let is_negative = interpolated(values, low) < 0.0;
    loop {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            return middle;
        }
        if (interpolated(values, middle) < 0.0) == is_negative {
            low = middle;
        } else {
            high = middle;
        }
    }
}

impl Motion {
    /// Moment at which the opening reaches a level in the last step. Forces may have changed at the end of this step, which
    /// the opening does not feel yet; the speed does, and is extrapolated.
    fn crossing(&self, level: f64) -> Moment {
        let first = self.opening.len() - POINTS;
        let above: Vec<_> = self.opening[first..]
            .iter()
            .map(|opening| opening - level)
            .collect();
        let at = zero(&above, POINTS - 2);
        let speed = interpolated(&self.speed[first - 1..first - 1 + POINTS], at + 1.0);
        [self.step * (first as f64 + at), level, speed]
    }

    /// Moment at which the speed vanishes in the last step.
    fn turning(&self) -> Moment {
        let first = self.speed.len() - POINTS;
        let at = zero(&self.speed[first..], POINTS - 2);
        let opening = interpolated(&self.opening[first..], at);
        [self.step * (first as f64 + at), opening, 0.0]
    }
}

/// Areas in m^2 of both nodes.
fn areas(case: &Fields) -> Result<[f64; 2], Fault> {
    match case.usables_of("V", 2)?.as_slice() {
        &[x, y] => Ok([x, y]),
        _ => Err(case.refuse_key("V", "2 positive numbers")),
    }
}

/// Two nodes that collide.
pub(super) fn collision(case: &Fields, reading: ContactReading) -> Result<Found, Fault> {
    let law = ContactLaw {
        radius: case.usable("R_c")?,
        damping_ratio: case.number("r_d")?,
        friction: 0.0,
        reading,
    };
    let validated = law.validate();
    validated.map_err(|error| of_parameter(case, &CONTACT, error))?;
    let speed = case.positive("relative_speed")?;
    let two = Two {
        distance: law.radius,
        area: areas(case)?,
        density: case.usable("rho")?,
        opening_speed: -speed,
        link: Link::Contact(law, case.usable("K_n")?),
    };
    let mut found = object([("omega", two.frequency().into())]);
    let Some([time, opening, _]) = two.turns()?.filter(|[_, opening, _]| -opening < law.radius)
    else {
        return Err(case.refuse_key(
            "relative_speed",
            "small enough that the nodes do not pass through each other",
        ));
    };
    found.extend(object([
        ("deepest", (-opening).into()),
        ("time_of_deepest", time.into()),
    ]));
    // Nodes that are damped too much approach the contact radius, which only rounding lets them reach.
    let is_separation = |[_, _, separation]: &Moment| *separation > NOISE * speed;
    let exit = two.opens_beyond(0.0)?.filter(is_separation);
    if let Some([time, _, _]) = exit {
        found.insert("contact_duration_until_d_is_R_c".to_owned(), time.into());
    }
    let restitution = exit.map_or(0.0, |[_, _, separation]| separation / speed);
    let lost = 0.5 * two.reduced_mass() * speed * speed * (1.0 - restitution * restitution);
    found.extend(object([
        ("restitution", restitution.into()),
        ("energy_dissipated", lost.into()),
    ]));
    Ok(found)
}

/// Two bonded nodes that are torn apart.
pub(super) fn bond(case: &Fields) -> Result<Found, Fault> {
    let length = case.positive("length")?;
    let weight = weight(case)?;
    let usual = match weight {
        Weight::Constant => 2.0 * length,
        Weight::Conic | Weight::Parabolic => HORIZON,
    };
    let constants = BondConstants {
        weight,
        horizon: match case.optional("eps") {
            Some(horizon) => horizon.as_usable()?,
            None => usual,
        },
        stiffness: case.usable("c")?,
        critical_stretch: case.usable("s0")?,
    };
    if length >= constants.horizon {
        let accepted = format!("below the horizon, {} m", constants.horizon);
        return Err(case.refuse_key("length", accepted));
    }
    let mut two = Two {
        distance: length,
        area: areas(case)?,
        density: case.usable("rho")?,
        opening_speed: 0.0,
        link: Link::Bond(constants, None),
    };
    // The bond is linear in the opening: the largest one is proportional to the speed.
    let critical = constants.critical_stretch * length;
    let trial = critical * two.frequency();
    two.opening_speed = trial;
    let never = || case.refuse_key("s0", "a stretch that the bond reaches");
    let [quarter, largest, _] = two.turns()?.ok_or_else(never)?;
    let (period, least) = (4.0 * quarter, trial * critical / largest);
    let broken = |speed: f64| -> Result<Found, Fault> {
        let mut two = two.clone();
        two.opening_speed = speed;
        two.link = Link::Bond(constants, Some(BreakingRule::TensionOnly));
        let [time, _, after] = two.opens_beyond(critical)?.ok_or_else(never)?;
        Ok(object([
            ("opening_speed", speed.into()),
            ("speed_after_break", after.into()),
            (
                "energy_lost",
                (0.5 * two.reduced_mass() * (speed * speed - after * after)).into(),
            ),
            ("time_of_break", time.into()),
        ]))
    };
    Ok(object([
        ("omega", (TAU / period).into()),
        ("period", period.into()),
        ("opening_speed_that_just_breaks", least.into()),
        ("at_1_3_times", broken(BREAKING_RATIO * least)?.into()),
    ]))
}
