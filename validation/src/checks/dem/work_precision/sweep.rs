//! Runs of a case with one integrator in one number type: their errors and times.

use super::case::{Case, Origin, Truth};
use crate::checks::Failure;
use gouge_dem::integrators::Integrator;
use gouge_dem::{Number, StepError, World};
use gouge_runner::scene::INTEGRATORS;
use gouge_scalars::{DoubleDouble, Single};
use std::ops::Range;
use std::time::Instant;

/// Number type of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// 24 bits.
    Single,
    /// 53 bits.
    Double,
    /// 106 bits.
    DoubleDouble,
}

impl Precision {
    /// Name in tables and texts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Single => "f32",
            Self::Double => "f64",
            Self::DoubleDouble => "double-double",
        }
    }
    /// Half the distance from one to the next larger number.
    pub fn roundoff(self) -> f64 {
        match self {
            Self::Single => 0.5 * f64::from(f32::EPSILON),
            Self::Double => 0.5 * f64::EPSILON,
            Self::DoubleDouble => f64::EPSILON * f64::EPSILON,
        }
    }
}

/// Median and quartiles in s.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// Median.
    pub median: f64,
    /// Lower and upper quartile.
    pub quartiles: [f64; 2],
}

impl Spread {
    fn of(mut times: Vec<f64>) -> Self {
        times.sort_by(f64::total_cmp);
        // The number of repetitions is 4 n + 1, so that median and quartiles are among them.
        let at = |quarter: usize| times[quarter * (times.len() - 1) / 4];
        Self {
            median: at(2),
            quartiles: [at(1), at(3)],
        }
    }
}

/// One run: its time step, its error, and its time if it was measured.
#[derive(Clone, Copy, Debug)]
pub struct Rung {
    /// Step in s.
    pub step: f64,
    /// Number of steps.
    pub steps: u64,
    /// Error in units of the largest displacement; infinite if the run stopped.
    pub error: f64,
    /// Wall time of stepping.
    pub time: Option<Spread>,
}

/// Runs with one integrator in one number type, each with half the time step of the previous one.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Name of the integrator.
    pub integrator: &'static str,
    /// Number type.
    pub precision: Precision,
    /// The runs.
    pub rungs: Vec<Rung>,
}

/// Whether times are measured, for all runs of a case, or only errors, for a few of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clock {
    /// Errors only.
    Ignored,
    /// Repeat every run for timing, one at a time.
    Watched,
}

/// A case that is ready to run.
pub struct Bench<'a> {
    /// The case.
    pub case: &'a Case,
    /// Its initial state.
    pub origin: Origin,
    /// Its reference solution.
    pub truth: Truth,
    /// Whether times are measured.
    pub clock: Clock,
}

impl<'a> Bench<'a> {
    /// Makes the initial state of a case and its reference solution.
    pub fn new(case: &'a Case, clock: Clock) -> Result<Self, Failure> {
        let origin = (case.origin)()?;
        let finest = match clock {
            Clock::Ignored => case.brief.end - 1,
            Clock::Watched => case.rungs - 1,
        };
        let truth = (case.truth)(case, &origin, finest)?;
        Ok(Self {
            case,
            origin,
            truth,
            clock,
        })
    }

    /// Runs one integrator over some rungs.
    pub fn sweep(
        &self,
        method: usize,
        precision: Precision,
        rungs: Range<u32>,
    ) -> Result<Sweep, Failure> {
        let (integrator, kind) = INTEGRATORS[method];
        let run = |rung| match precision {
            Precision::Single => self.run::<Single>(kind, rung),
            Precision::Double => self.run::<f64>(kind, rung),
            Precision::DoubleDouble => self.run::<DoubleDouble>(kind, rung),
        };
        Ok(Sweep {
            integrator,
            precision,
            rungs: rungs.map(run).collect::<Result<_, _>>()?,
        })
    }

    fn run<S: Number>(&self, integrator: Integrator, rung: u32) -> Result<Rung, Failure> {
        let (step, steps) = self.case.rung(rung);
        let start = self.origin.world::<S>(integrator, step)?;
        let mut world = start.clone();
        let first = stepping(&mut world, steps);
        let error = match first {
            Ok(_) => self.origin.error(world.particles(), &self.truth),
            Err(_) => f64::INFINITY,
        };
        let time = match (first, self.clock) {
            (Ok(seconds), Clock::Watched) => Some(repeated(&start, steps, seconds)?),
            _ => None,
        };
        Ok(Rung {
            step,
            steps,
            error,
            time,
        })
    }
}

/// Runs shorter than this many seconds are repeated more often.
const SHORT: f64 = 5e-3;

/// Times of repeated runs; the first run, which is not included, was the warm-up.
fn repeated<S: Number>(start: &World<S>, steps: u64, first: f64) -> Result<Spread, Failure> {
    let repetitions = if first < SHORT { 21 } else { 5 };
    let times = (0..repetitions)
        .map(|_| stepping(&mut start.clone(), steps))
        .collect::<Result<_, StepError>>()?;
    Ok(Spread::of(times))
}

/// Advances a world by the given number of steps; returns the time in s.
fn stepping<S: Number>(world: &mut World<S>, steps: u64) -> Result<f64, StepError> {
    let began = Instant::now();
    for _ in 0..steps {
        world.step()?;
    }
    let seconds = began.elapsed().as_secs_f64();
    world.check()?;
    Ok(seconds)
}
