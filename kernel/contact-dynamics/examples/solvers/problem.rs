//! The problem of one step, taken out of a sheared packing.

use crate::packing::System;
use gouge_contact_dynamics::law::ContactLaw;
use gouge_contact_dynamics::local::Components;
use gouge_contact_dynamics::step::{Workspace, step};
use gouge_contact_dynamics::sweep::{ContactInput, Solver, StopCriterion, SweepSettings};
use gouge_contact_dynamics::units::{InverseMass, Velocity};

use crate::clock;
use rayon::ThreadPool;
use std::time::Instant;

/// Contact points with their first guesses, velocities before the step and without contacts, and the rest.
#[derive(Clone)]
pub struct Problem {
    points: Vec<ContactInput>,
    before: Vec<Velocity>,
    free: Vec<Velocity>,
    masses: Vec<InverseMass>,
    law: ContactLaw,
    time_step: f64,
    /// Horizontal place of each unit, if it has one.
    places: Vec<f64>,
    period: Option<f64>,
}

/// What some sweeps achieved.
pub struct Outcome {
    /// Processor time in s.
    pub time: f64,
    /// Largest residual of the laws.
    pub residual: f64,
    pub velocities: Vec<Velocity>,
}

impl Problem {
    /// Advance a system by a step, and return the problem that the step solved.
    pub fn of_step(system: &mut System, workspace: &mut Workspace) -> Self {
        system.drive();
        let configuration = &system.state.configuration;
        let before = configuration.velocity.clone();
        let mut free = configuration.clone();
        free.accelerate(&system.assembly, system.settings.time_step);
        let mut memory = system.state.memory.clone();
        step(
            &system.assembly,
            &system.settings,
            &mut system.state,
            workspace,
        );
        let mut guesses = Vec::new();
        let distance = system.settings.warm_start_distance;
        memory.guess(workspace.keys(), distance, &mut guesses);
        let mut points = workspace.points().to_vec();
        for (point, guess) in points.iter_mut().zip(guesses) {
            point.impulse = guess;
        }
        let mut places = vec![f64::NAN; before.len()];
        let positions = &system.state.configuration.position;
        for (&unit, position) in system.assembly.unit.iter().zip(positions) {
            // The first two units are the walls.
            if unit > 1 {
                places[unit as usize] = position.x;
            }
        }
        Self {
            places,
            period: system.assembly.domain.period(),
            points,
            before,
            free: free.velocity,
            masses: system.assembly.inverse_mass.clone(),
            law: system.settings.law,
            time_step: system.settings.time_step,
        }
    }

    /// Number of contact points.
    pub fn points(&self) -> usize {
        self.points.len()
    }

    /// The same problem without first guesses.
    pub fn cold(&self) -> Self {
        let mut problem = self.clone();
        for point in &mut problem.points {
            point.impulse = Components::default();
        }
        problem
    }

    /// The same problem with another coefficient of friction.
    pub fn with_friction(&self, friction: f64) -> Self {
        let mut problem = self.clone();
        problem.law.friction = friction;
        problem
    }

    /// A solver that knows the places of all units.
    fn solver(&self) -> Solver {
        let mut solver = Solver::new();
        solver.set_places(self.places.iter().copied(), self.period);
        solver
    }

    /// Time in s on the wall for a number of sweeps, in the calling thread or in a pool of several.
    pub fn wall_time(
        &self,
        settings: &SweepSettings,
        sweeps: usize,
        pool: Option<&ThreadPool>,
    ) -> f64 {
        let settings = never_ending(settings, sweeps);
        let mut solver = self.solver();
        let (law, before) = (&self.law, &self.before);
        let mut velocities = self.free.clone();
        // Once without sweeps, so that the buffers are there.
        solver.prepare(&self.points, law, self.time_step, before, &self.masses);
        solver.solve(&never_ending(&settings, 0), &self.masses, &mut velocities);
        velocities.clone_from(&self.free);
        solver.prepare(&self.points, law, self.time_step, before, &self.masses);
        solver.set_threads(pool.map_or(1, ThreadPool::current_num_threads));
        let mut run = || {
            let start = Instant::now();
            solver.solve(&settings, &self.masses, &mut velocities);
            start.elapsed().as_secs_f64()
        };
        match pool {
            Some(pool) => pool.install(run),
            None => run(),
        }
    }

    /// Sweep a number of times; the time is the smallest of a few repetitions.
    pub fn solve(&self, settings: &SweepSettings, sweeps: usize) -> Outcome {
        let settings = never_ending(settings, sweeps);
        let mut best = f64::INFINITY;
        let mut solver = self.solver();
        let mut velocities = Vec::new();
        for _ in 0..(1000 / sweeps).clamp(1, 9) {
            let (law, before) = (&self.law, &self.before);
            solver.prepare(&self.points, law, self.time_step, before, &self.masses);
            velocities.clone_from(&self.free);
            let (time, _) = clock::time(|| solver.solve(&settings, &self.masses, &mut velocities));
            best = best.min(time);
        }
        Outcome {
            time: best,
            residual: solver.residual(&velocities),
            velocities,
        }
    }

    /// Root mean square difference of two sets of velocities of the free bodies, in the norm of kinetic energy.
    pub fn distance(&self, a: &[Velocity], b: &[Velocity]) -> f64 {
        let (mut sum, mut mass) = (0.0, 0.0);
        for (inverse, (a, b)) in self.masses.iter().zip(a.iter().zip(b)) {
            let difference = Velocity {
                linear: a.linear - b.linear,
                angular: a.angular - b.angular,
            };
            sum += 2.0 * inverse.kinetic_energy(difference);
            mass += if inverse.x > 0.0 {
                1.0 / inverse.x
            } else {
                0.0
            };
        }
        (sum / mass).sqrt()
    }
}

/// Settings for a number of sweeps, whatever they change.
fn never_ending(settings: &SweepSettings, sweeps: usize) -> SweepSettings {
    SweepSettings {
        stop: StopCriterion::Increment {
            tolerance: 0.0,
            floor: 0.0,
        },
        max_sweeps: sweeps,
        ..*settings
    }
}
