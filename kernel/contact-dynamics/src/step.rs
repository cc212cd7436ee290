//! A time step.

use crate::assembly::{Assembly, Configuration};
use crate::delassus::PointKinematics;
use crate::detection::{DetectionSettings, Placed, Touch, detect};
use crate::error::{SetupError, require};
use crate::law::ContactLaw;
use crate::local::Components;
use crate::sweep::{ContactInput, Solver, SweepOrder, SweepReport, SweepSettings};
use crate::units::{InverseMass, Velocity};
use crate::warm_start::{Memory, PointKey};
use gouge_common::geometry::{Metric, Vec2, WithMetric};
use gouge_common::neighbors::{Neighbors, SearchSpheres};
use gouge_common::pair::Pair;
use gouge_equations::rendered;

/// In which configuration contacts are detected.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scheme {
    /// In the middle of the step, azema (A28)-(A32). A predicted gap is zero at the next detection; half of the way to
    /// it is left at the end of the step.
    #[default]
    Midpoint,
    /// At the beginning of the step.
    Beginning,
}

/// All choices of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepSettings {
    /// Time step in s.
    pub time_step: f64,
    /// Where contacts are detected.
    pub scheme: Scheme,
    /// Lengths of detection.
    pub detection: DetectionSettings,
    /// Friction, restitution, gaps.
    pub law: ContactLaw,
    /// How impulses are found.
    pub sweeps: SweepSettings,
    /// Largest distance in m between a point and its predecessor in the previous step, if their features differ.
    pub warm_start_distance: f64,
}

impl StepSettings {
    /// Check all numbers.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a time step that is not positive, a negative length of detection or of warm
    /// starts, or a law or sweeps outside their ranges.
    pub fn validate(&self) -> Result<(), SetupError> {
        self.law.validate()?;
        self.sweeps.validate()?;
        require(
            "time step",
            self.time_step,
            "positive",
            self.time_step > 0.0,
        )?;
        let lengths = [
            ("alert distance", self.detection.alert_distance),
            ("merge distance", self.detection.merge_distance),
            ("tie distance", self.detection.tie_distance),
            ("warm start distance", self.warm_start_distance),
        ];
        for (name, length) in lengths {
            require(name, length, "not negative", length >= 0.0)?;
        }
        Ok(())
    }
}

impl StepSettings {
    /// The lengths of detection that the law needs. Where only closed points count, points nearer than the tie distance
    /// are closed, so that rounding does not open them.
    pub fn effective_detection(&self) -> DetectionSettings {
        let lengths = self.detection;
        let alert_distance = match self.law.takes_closed_points_only() {
            true => lengths.alert_distance.min(lengths.tie_distance),
            false => lengths.alert_distance,
        };
        DetectionSettings {
            alert_distance,
            ..lengths
        }
    }
}

/// What changes from step to step.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct State {
    /// Positions and velocities.
    pub configuration: Configuration,
    /// Impulses of the latest step.
    pub memory: Memory,
}

/// Buffers of a step; nothing in them is worth saving.
#[derive(Clone, Debug)]
pub struct Workspace {
    neighbors: Neighbors<f64>,
    reaches: Vec<f64>,
    pairs: Vec<Pair>,
    axes: Vec<Vec2>,
    touches: Vec<Touch>,
    keys: Vec<PointKey>,
    points: Vec<ContactInput>,
    guesses: Vec<Components>,
    before: Vec<Velocity>,
    /// The body of each unit that is a single body.
    single: Vec<Option<u32>>,
    solver: Solver,
}

/// What a step did.
#[rendered]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepReport {
    /// The sweeps.
    pub sweeps: SweepReport,
    /// Number of contact points.
    pub points: usize,
    /// Largest overlap in m.
    pub largest_overlap: f64,
    /// Work in J that the correction of overlaps did: $-\frac12 \sum P_n w$ with the correcting velocity w of each
    /// point, which is not positive.
    pub work_of_correction: f64,
}

impl Workspace {
    /// Buffers for an assembly.
    pub fn new(assembly: &Assembly, state: &State, settings: &StepSettings) -> Self {
        let half = 0.5 * settings.effective_detection().alert_distance;
        let shapes = assembly.shape.iter().zip(&assembly.scale);
        let reach =
            |(&shape, &scale)| assembly.shapes.outline(shape).measures.circumradius * scale + half;
        let reaches: Vec<f64> = shapes.map(reach).collect();
        let spheres = SearchSpheres {
            positions: &state.configuration.position,
            radii: &reaches,
        };
        Self {
            neighbors: Neighbors::new(spheres, &assembly.domain),
            reaches,
            pairs: Vec::new(),
            axes: Vec::new(),
            touches: Vec::new(),
            keys: Vec::new(),
            points: Vec::new(),
            guesses: Vec::new(),
            before: Vec::new(),
            single: assembly.single_bodies(),
            solver: Solver::new(),
        }
    }

    /// Divide sweeps by strips among the threads of the pool in use if there is more than one; the bits of the results
    /// do not depend on it.
    pub fn set_threads(&mut self, threads: usize) {
        self.solver.set_threads(threads);
    }

    /// Contact points of the latest step with their impulses.
    pub fn solver(&self) -> &Solver {
        &self.solver
    }

    /// Identities of the contact points of the latest step.
    pub fn keys(&self) -> &[PointKey] {
        &self.keys
    }

    /// Velocities of the units before the latest step.
    pub fn velocities_before(&self) -> &[Velocity] {
        &self.before
    }

    /// Contact points of the latest step as they were detected.
    pub fn points(&self) -> &[ContactInput] {
        &self.points
    }
}

/// Advance a state by one time step, azema (A28)-(A32).
///
/// Bodies move for half a step with their old velocities; contacts are detected there; impulses change the velocities;
/// bodies move for the other half with their new velocities. Nothing is allocated once the buffers are large enough.
pub fn step(
    assembly: &Assembly,
    settings: &StepSettings,
    state: &mut State,
    workspace: &mut Workspace,
) -> StepReport {
    let time_step = settings.time_step;
    let first = match settings.scheme {
        Scheme::Midpoint => 0.5 * time_step,
        Scheme::Beginning => 0.0,
    };
    state.configuration.advance(assembly, first);
    assembly.domain.with_metric(Detect {
        assembly,
        settings,
        configuration: &mut state.configuration,
        workspace,
    });
    let sweeps = workspace.exchange_impulses(assembly, settings, state);
    state.configuration.advance(assembly, time_step - first);
    workspace.report(settings, sweeps)
}

impl Workspace {
    fn exchange_impulses(
        &mut self,
        assembly: &Assembly,
        settings: &StepSettings,
        state: &mut State,
    ) -> SweepReport {
        let memory = &mut state.memory;
        memory.guess(&self.keys, settings.warm_start_distance, &mut self.guesses);
        for (point, guess) in self.points.iter_mut().zip(&self.guesses) {
            point.impulse = *guess;
        }
        let masses = &assembly.inverse_mass;
        self.before.clone_from(&state.configuration.velocity);
        let before = &self.before;
        let solver = &mut self.solver;
        if settings.sweeps.order == SweepOrder::Strips {
            let position = &state.configuration.position;
            let place =
                |body: &Option<u32>| body.map_or(f64::NAN, |body| position[body as usize].x);
            solver.set_places(self.single.iter().map(place), assembly.domain.period());
        }
        solver.prepare(
            &self.points,
            &settings.law,
            settings.time_step,
            before,
            masses,
        );
        state.configuration.accelerate(assembly, settings.time_step);
        let velocities = &mut state.configuration.velocity;
        let report = solver.solve(&settings.sweeps, masses, velocities);
        memory.clear();
        for (key, row) in self.keys.iter().zip(solver.rows()) {
            memory.push(*key, row.impulse());
        }
        report
    }

    fn report(&self, settings: &StepSettings, sweeps: SweepReport) -> StepReport {
        let mut report = StepReport {
            sweeps,
            points: self.points.len(),
            ..StepReport::default()
        };
        for (point, row) in self.points.iter().zip(self.solver.rows()) {
            let gap = settings.law.gap.velocity(point.gap, settings.time_step);
            report.largest_overlap = report.largest_overlap.max(-point.gap);
            report.work_of_correction -= 0.5 * row.impulse().n * gap.correcting;
        }
        report
    }
}

/// Detection of all contact points, for one metric.
struct Detect<'a> {
    assembly: &'a Assembly,
    settings: &'a StepSettings,
    configuration: &'a mut Configuration,
    workspace: &'a mut Workspace,
}

impl WithMetric for Detect<'_> {
    type Output = ();
    fn call<M: Metric>(self, metric: M) {
        let Self {
            assembly,
            settings,
            configuration,
            workspace,
        } = self;
        metric.wrap_all(&mut configuration.position);
        workspace.update_pairs(metric, assembly, configuration);
        workspace.axes.clear();
        let axis = |angle: &f64| Vec2::new(libm::cos(*angle), libm::sin(*angle));
        workspace.axes.extend(configuration.angle.iter().map(axis));
        workspace.keys.clear();
        workspace.points.clear();
        workspace.detect_pairs(metric, assembly, settings, configuration);
        workspace.detect_walls(assembly, settings, configuration);
    }
}

impl Workspace {
    fn update_pairs<M: Metric>(
        &mut self,
        metric: M,
        assembly: &Assembly,
        configuration: &Configuration,
    ) {
        if !self.neighbors.is_stale(metric, &configuration.position) {
            return;
        }
        let spheres = SearchSpheres {
            positions: &configuration.position,
            radii: &self.reaches,
        };
        let may_interact = |i: usize, j: usize| {
            let [one, other] = [assembly.unit[i], assembly.unit[j]];
            one != other && can_move(assembly, one, other)
        };
        let pairs = &mut self.pairs;
        self.neighbors.rebuild(metric, spheres, may_interact, pairs);
    }

    fn detect_pairs<M: Metric>(
        &mut self,
        metric: M,
        assembly: &Assembly,
        settings: &StepSettings,
        configuration: &Configuration,
    ) {
        let positions = &configuration.position;
        let lengths = settings.effective_detection();
        for &pair in &self.pairs {
            let (i, j) = pair.indices();
            let d = metric.displacement(positions[i], positions[j]);
            let reach = self.reaches[i] + self.reaches[j];
            if d.norm_squared() > reach * reach {
                continue;
            }
            let [first, second] = [i, j].map(|body| placed(assembly, &self.axes, body));
            self.touches.clear();
            detect(&first, &second, d, &lengths, &mut self.touches);
            let units = [assembly.unit[i], assembly.unit[j]];
            for touch in &self.touches {
                self.keys.push(key(pair, touch, 0));
                self.points.push(input(units, touch, &settings.law));
            }
        }
    }

    fn detect_walls(
        &mut self,
        assembly: &Assembly,
        settings: &StepSettings,
        configuration: &Configuration,
    ) {
        let bodies = assembly.unit.len();
        let lengths = settings.effective_detection();
        for (index, (wall, &wall_unit)) in configuration
            .wall
            .iter()
            .zip(&assembly.wall_unit)
            .enumerate()
        {
            for body in 0..bodies {
                let unit = assembly.unit[body];
                let d = configuration.position[body] - wall.position;
                let is_far = wall.normal.dot(d) > self.reaches[body] + lengths.alert_distance;
                if is_far || unit == wall_unit || !can_move(assembly, unit, wall_unit) {
                    continue;
                }
                self.touches.clear();
                let shape = placed(assembly, &self.axes, body);
                wall.detect(&shape, d, &lengths, &mut self.touches);
                for touch in &self.touches {
                    self.keys
                        .push(key(Pair::new(body, bodies + index), touch, 1));
                    self.points
                        .push(input([wall_unit, unit], touch, &settings.law));
                }
            }
        }
    }
}

fn can_move(assembly: &Assembly, one: u32, other: u32) -> bool {
    [one, other]
        .into_iter()
        .any(|unit| assembly.inverse_mass[unit as usize] != InverseMass::IMPOSED)
}

fn placed<'a>(assembly: &'a Assembly, axes: &[Vec2], body: usize) -> Placed<'a> {
    Placed {
        outline: assembly.shapes.outline(assembly.shape[body]),
        scale: assembly.scale[body],
        axis: axes[body],
    }
}

/// The identity of a point; its place is relative to the body at one end of the touch.
fn key(pair: Pair, touch: &Touch, end: usize) -> PointKey {
    PointKey {
        pair,
        feature: touch.feature,
        place: touch.arms[end],
    }
}

/// A point as the sweeps see it. Where only closed points count, all that were detected are closed.
fn input(units: [u32; 2], touch: &Touch, law: &ContactLaw) -> ContactInput {
    ContactInput {
        kinematics: PointKinematics::new(units, touch.normal, touch.arms),
        gap: match law.takes_closed_points_only() {
            true => touch.gap.min(0.0),
            false => touch.gap,
        },
        impulse: Components::default(),
    }
}
