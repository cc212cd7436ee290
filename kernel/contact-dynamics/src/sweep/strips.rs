//! Sweeps by vertical strips, which threads can share.
//!
//! A point of a strip touches only units of its strip and of the next one. First all even strips are visited, at the
//! same time if there are threads, then all odd ones, then the points that belong to no strip, such as those of a wall
//! that moves. Backward sweeps reverse all of it. No result depends on which thread did what, and sums are combined in
//! the order of strips.

use super::Row;
use super::changes::Changes;
use super::division::Division;
use super::iteration::{Iteration, SweepReport, Sweeping};
use super::momentum::{Momentum, Sequence};
use super::places::Places;
use super::residual::{larger, natural_map};
use super::team::{Team, lock};
use super::unit::SharedUnit;
use super::visit::Visit;
use crate::units::{InverseMass, Velocity};
use std::sync::{Mutex, PoisonError};

/// With fewer points, threads cost more than they gain.
const POINTS_FOR_THREADS: usize = 1000;

/// Points and units, sorted by strips.
#[derive(Debug, Default)]
pub(super) struct Strips {
    division: Division,
    units: Vec<SharedUnit>,
    /// Strip by strip, and all other points. A thread locks a part while it works on it.
    parts: Vec<Mutex<Part>>,
}

/// A copy has no points: these are buffers of a step.
impl Clone for Strips {
    fn clone(&self) -> Self {
        Self::default()
    }
}

/// The points of a strip, or those of none.
#[derive(Clone, Debug, Default)]
struct Part {
    rows: Vec<Row>,
    /// The point of each row.
    points: Vec<u32>,
    momentum: Momentum,
    changes: Changes,
    /// Residual, or product of changes.
    number: f64,
}

impl Part {
    fn clear(&mut self, room: usize) {
        self.rows.clear();
        self.rows.reserve(room);
        self.points.clear();
        self.points.reserve(room);
        self.momentum.clear(room);
    }
}

/// What threads do at the same time.
#[derive(Clone, Copy, Debug)]
enum Job {
    /// Visit the points of every other strip, from a first one to a last one.
    Visit(Visit, [usize; 2]),
    BeginMomentum,
    /// Find the products of changes.
    Product,
    /// Extrapolate by a part of the last change.
    Move(f64),
    /// Find the residuals with a friction.
    Residual(f64),
}

impl Strips {
    /// Take the points and units of a step. `false` if there are too few strips.
    pub fn gather(
        &mut self,
        rows: &[Row],
        places: &Places,
        velocities: &[Velocity],
        inverse_masses: &[InverseMass],
    ) -> bool {
        if !self.division.divide(rows, inverse_masses, places) {
            return false;
        }
        let division = &self.division;
        self.parts
            .resize_with(division.number() + 1, Mutex::default);
        // Twice the mean, because the points of a strip are not always as many.
        let room = 2 * rows.len() / division.number();
        for part in &mut self.parts {
            unlocked(part).clear(room);
        }
        for (point, row) in rows.iter().enumerate() {
            let mut row = *row;
            let units = row.kinematics.units;
            let strip = division.strip_of(units);
            row.kinematics.units = units.map(|unit| division.place_of(unit as usize, strip));
            let part = unlocked(&mut self.parts[strip.unwrap_or(division.number())]);
            part.rows.push(row);
            part.points.push(point as u32);
        }
        self.units.clear();
        let join =
            |&unit: &u32| SharedUnit::new(velocities[unit as usize], inverse_masses[unit as usize]);
        self.units.extend(division.units().iter().map(join));
        true
    }

    /// Sweep until the stop criterion is met.
    pub fn solve(&self, iteration: Iteration<'_>, threads: usize) -> SweepReport {
        let team = Team::new(Job::BeginMomentum);
        let points = self.parts.iter().map(|part| lock(part).rows.len());
        let is_alone = threads < 2 || points.sum::<usize>() < POINTS_FOR_THREADS;
        let mut leader = Leader {
            strips: self,
            team: &team,
            sequence: Sequence::default(),
            is_alone,
        };
        if is_alone {
            return iteration.run(&mut leader);
        }
        let helpers = threads.min(self.division.number() / 2) - 1;
        rayon::scope(|scope| {
            for _ in 0..helpers {
                scope.spawn(|_| team.help(|job, task| self.work(job, task)));
            }
            let report = iteration.run(&mut leader);
            team.dismiss();
            report
        })
    }

    /// Number of strips of the latest step.
    pub fn number(&self) -> usize {
        self.parts.len().saturating_sub(1)
    }

    /// Write impulses and velocities back.
    pub fn scatter(&mut self, rows: &mut [Row], velocities: &mut [Velocity]) {
        for part in &mut self.parts {
            let part = unlocked(part);
            for (sorted, &point) in part.rows.iter().zip(&part.points) {
                let row = &mut rows[point as usize];
                (row.impulse, row.status) = (sorted.impulse, sorted.status);
            }
        }
        for (velocity, &slot) in velocities.iter_mut().zip(self.division.slots()) {
            *velocity = self.units[slot as usize].velocity();
        }
    }

    /// Do a task of a job.
    fn work(&self, job: Job, task: usize) {
        let index = match job {
            Job::Visit(_, [first, last]) if first > last => first - 2 * task,
            Job::Visit(_, [first, _]) => first + 2 * task,
            _ => task,
        };
        let mut part = lock(&self.parts[index]);
        let Part {
            rows,
            momentum,
            changes,
            number,
            ..
        } = &mut *part;
        let units = &self.units[self.division.units_of(index)];
        match job {
            Job::Visit(visit, _) => *changes = visit.run(rows, &self.units[..]),
            Job::BeginMomentum => momentum.begin(rows, units.iter().map(SharedUnit::velocity)),
            Job::Product => *number = momentum.product(rows),
            Job::Move(by) => {
                momentum.move_rows(by, rows);
                for (index, unit) in units.iter().enumerate() {
                    unit.set_velocity(momentum.moved(by, index, unit.velocity()));
                }
            }
            Job::Residual(friction) => {
                let residual = |row: &Row| {
                    let pair = row.kinematics.units;
                    let velocities = pair.map(|unit| self.units[unit as usize].velocity());
                    natural_map(row, friction, velocities)
                };
                *number = rows.iter().map(residual).fold(0.0, larger);
            }
        }
    }
}

fn unlocked(part: &mut Mutex<Part>) -> &mut Part {
    part.get_mut().unwrap_or_else(PoisonError::into_inner)
}

/// The thread that decides.
struct Leader<'a> {
    strips: &'a Strips,
    team: &'a Team<Job>,
    sequence: Sequence,
    /// Whether there are no helpers.
    is_alone: bool,
}

impl Leader<'_> {
    fn lead(&self, job: Job, tasks: usize) {
        let work = |job, task| self.strips.work(job, task);
        self.team.lead(job, tasks, work);
    }

    /// Have a job done for all parts.
    fn lead_all(&self, job: Job) {
        self.lead(job, self.strips.parts.len());
    }

    /// The numbers of all parts.
    fn numbers(&self) -> impl Iterator<Item = f64> {
        self.strips.parts.iter().map(|part| lock(part).number)
    }
}

impl Sweeping for Leader<'_> {
    fn begin_momentum(&mut self) {
        self.sequence = Sequence::default();
        self.lead_all(Job::BeginMomentum);
    }

    fn extrapolate(&mut self, largest: f64) {
        self.lead_all(Job::Product);
        let product = self.numbers().sum();
        let by = self.sequence.next(largest, product);
        self.lead_all(Job::Move(by));
    }

    fn sweep(&mut self, visit: Visit) -> Changes {
        let number = self.strips.division.number();
        // One thread finds the latest strips in its cache; of several, each keeps to its strips.
        let is_reversed = visit.is_backward && self.is_alone;
        let half = |first| {
            let last = first + number - 2;
            let ends = match is_reversed {
                false => [first, last],
                true => [last, first],
            };
            self.lead(Job::Visit(visit, ends), number / 2);
        };
        let others = || self.strips.work(Job::Visit(visit, [number; 2]), 0);
        match visit.is_backward {
            false => {
                half(0);
                half(1);
                others();
            }
            true => {
                others();
                half(1);
                half(0);
            }
        }
        let mut changes = Changes::default();
        for part in &self.strips.parts {
            changes.join(&lock(part).changes);
        }
        changes
    }

    fn residual(&mut self, friction: f64) -> f64 {
        self.lead_all(Job::Residual(friction));
        self.numbers().fold(0.0, larger)
    }
}
