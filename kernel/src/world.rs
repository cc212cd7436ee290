//! The state of a scene and how it advances.

use crate::error::{ModelError, StepError};
use crate::estimators::{Energy, Ledger};
use crate::forces::{self, Forces, LinkState, StrongPass, Tally, WeakPass};
use crate::geometry::{
    ContactDistance, FocalArm, MeanArm, Metric, Open, PeriodicX, RadiusArm, Vec2,
};
use crate::integrators::{self, Integrator, Previous};
use crate::laws::{Frictionless, NoBending};
use crate::links::{BondStart, ContactStart, Neighbors, Pair, StrongLinks, WeakLinks};
use crate::model::{Ambient, ContactNormal, ContactTangential, Domain, External, Model, Reading};
use crate::particles::{Particles, Role};
use crate::scalar::Real;

/// Evaluate an expression with `$metric` bound to the metric of the model.
macro_rules! with_metric {
    ($model:expr, $metric:ident => $body:expr) => {
        match $model.period() {
            Some(length) => {
                let $metric = PeriodicX { length };
                $body
            }
            None => {
                let $metric = Open;
                $body
            }
        }
    };
}

/// Evaluate an expression with `$pass` bound to the pass over strong links that the model asks for.
macro_rules! with_strong_pass {
    ($model:expr, $bond:expr, $pass:ident => $body:expr) => {
        with_metric!($model, metric => {
            let (normal, wraps) = ($bond.normal, $model.reading == Reading::Thesis);
            let yielding = $bond.yielding.map(|yielding| yielding.law);
            match $bond.tangential {
                Some(beam) => {
                    let $pass = StrongPass { metric, normal, beam, yielding, wraps };
                    $body
                }
                None => {
                    let $pass = StrongPass { metric, normal, beam: NoBending, yielding, wraps };
                    $body
                }
            }
        })
    };
}

/// Evaluate an expression with `$pass` bound to the pass over weak links that the model asks for.
macro_rules! with_weak_pass {
    ($model:expr, $contact:expr, $pass:ident => $body:expr) => {
        with_metric!($model, metric => with_weak_pass!(@normal $model, $contact, metric, $pass => $body))
    };
    (@normal $model:expr, $contact:expr, $metric:ident, $pass:ident => $body:expr) => {
        match $contact.normal {
            ContactNormal::KelvinVoigt(normal) => {
                with_weak_pass!(@tangential $model, $contact, $metric, normal, $pass => $body)
            }
            ContactNormal::Bshp(normal) => {
                with_weak_pass!(@tangential $model, $contact, $metric, normal, $pass => $body)
            }
        }
    };
    (@tangential $model:expr, $contact:expr, $metric:ident, $normal:ident, $pass:ident => $body:expr) => {
        match $contact.tangential {
            None => with_weak_pass!(
                @pass $model, $metric, RadiusArm, $normal, Frictionless, $pass => $body
            ),
            Some(ContactTangential::HaffWerner(law)) => {
                with_weak_pass!(@arm $model, $contact, $metric, $normal, law, $pass => $body)
            }
            Some(ContactTangential::CundallStrack(law)) => {
                with_weak_pass!(@arm $model, $contact, $metric, $normal, law, $pass => $body)
            }
            Some(ContactTangential::CundallStrackTruncated(law)) => {
                with_weak_pass!(@arm $model, $contact, $metric, $normal, law, $pass => $body)
            }
        }
    };
    (@arm $model:expr, $contact:expr, $metric:ident, $normal:ident, $law:ident, $pass:ident => $body:expr) => {
        match $contact.distance {
            ContactDistance::Radius => {
                with_weak_pass!(@pass $model, $metric, RadiusArm, $normal, $law, $pass => $body)
            }
            ContactDistance::Focal => {
                with_weak_pass!(@pass $model, $metric, FocalArm, $normal, $law, $pass => $body)
            }
            ContactDistance::Mean => {
                with_weak_pass!(@pass $model, $metric, MeanArm, $normal, $law, $pass => $body)
            }
        }
    };
    (@pass $model:expr, $metric:ident, $arm:expr, $normal:ident, $law:expr, $pass:ident => $body:expr) => {{
        let $pass = WeakPass {
            metric: $metric,
            arm: $arm,
            normal: $normal,
            tangential: $law,
            reading: $model.reading,
        };
        $body
    }};
}

/// Total driving force and what it meets.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drive<S> {
    /// Total driving force in N, for the next step.
    pub force: Vec2<S>,
    /// Total driving force in N in the step that led to the present state.
    pub applied: Vec2<S>,
    /// Sum of all other forces on the driven particles in N, at the latest evaluation.
    pub reaction: Vec2<S>,
}

/// The initial state of a scene.
#[derive(Clone, Debug, Default)]
pub struct Start {
    /// Bonds.
    pub bonds: Vec<BondStart>,
    /// Memory of contacts that began earlier.
    pub contacts: Vec<ContactStart>,
    /// Total driving force in N.
    pub drive_force: Vec2,
}

/// Everything that changes with time, and exactly the arrays that the model asks for.
#[derive(Clone, Debug)]
pub struct World<S: Real = f64> {
    pub(crate) model: Model,
    pub(crate) particles: Particles<S>,
    pub(crate) inverse_mass: Vec<S>,
    pub(crate) inverse_inertia: Vec<S>,
    pub(crate) forces: Forces<S>,
    pub(crate) strong: Option<StrongLinks<S>>,
    pub(crate) weak: Option<WeakLinks<S>>,
    pub(crate) driven: Vec<u32>,
    pub(crate) drive: Drive<S>,
    pub(crate) previous: Option<Previous<S>>,
    pub(crate) ledger: Option<Ledger<S>>,
    pub(crate) tally: Tally<S>,
    pub(crate) steps: u64,
    pub(crate) is_evaluated: bool,
}

impl<S: Real> World<S> {
    /// The world of a model, with its particles and links at t = 0.
    ///
    /// # Errors
    /// Links that cannot be, a periodic box narrower than two cells, driving without driven particles.
    pub fn new(model: Model, particles: Particles<S>, start: &Start) -> Result<Self, ModelError> {
        check_width(&model, &particles)?;
        let driven: Vec<u32> = match model.driving {
            Some(_) => particles
                .with_role(Role::Driven)
                .map(|i| i as u32)
                .collect(),
            None => Vec::new(),
        };
        if model.driving.is_some() && driven.is_empty() {
            return Err(ModelError::NothingDriven);
        }
        let inverse = |column: &[S], particles: &Particles<S>| {
            let one = S::from_f64(1.0);
            let of = |(i, &x): (usize, &S)| {
                if particles.is_fixed(i) {
                    S::zero()
                } else {
                    one / x
                }
            };
            column.iter().enumerate().map(of).collect::<Vec<S>>()
        };
        let mut world = Self {
            inverse_mass: inverse(&particles.mass, &particles),
            inverse_inertia: inverse(&particles.moment_of_inertia, &particles),
            forces: Forces::new(particles.len()),
            strong: None,
            weak: None,
            driven,
            drive: Drive {
                force: start.drive_force.cast(),
                ..Drive::default()
            },
            previous: model
                .integrator
                .needs_previous()
                .then(|| Previous::new(model.integrator, particles.len())),
            ledger: None,
            tally: Tally::default(),
            steps: 0,
            is_evaluated: false,
            model,
            particles,
        };
        world.drive.applied = world.drive.force;
        world.make_links(start)?;
        if model.ledger {
            world.ledger = Some(Ledger::starting_from(&world.state_energy()));
        }
        Ok(world)
    }

    fn make_links(&mut self, start: &Start) -> Result<(), ModelError> {
        let Self {
            model, particles, ..
        } = self;
        if let Some(bond) = model.bond {
            let edges = bond
                .yielding
                .is_none_or(|yielding| yielding.unbreakable_edges);
            let period = model.period();
            self.strong = Some(with_metric!(model, metric => {
                StrongLinks::new(metric, particles, &start.bonds, edges, period)
            })?);
        }
        if let Some(contact) = model.contact {
            let Domain { width, height, .. } = model.domain;
            let neighbors = Neighbors::new(particles, [width, height], model.period());
            let mut weak = WeakLinks::new(neighbors, particles.len(), contact.remembers());
            with_metric!(model, metric => {
                weak.rebuild(metric, particles, self.strong.as_ref());
                weak.remember(metric, particles, &start.contacts)
            })?;
            self.weak = Some(weak);
        }
        Ok(())
    }

    /// The model.
    pub fn model(&self) -> &Model {
        &self.model
    }
    /// The particles.
    pub fn particles(&self) -> &Particles<S> {
        &self.particles
    }
    /// Strong links, if the model has them.
    pub fn strong_links(&self) -> Option<&StrongLinks<S>> {
        self.strong.as_ref()
    }
    /// Weak links, if the model has them.
    pub fn weak_links(&self) -> Option<&WeakLinks<S>> {
        self.weak.as_ref()
    }
    /// The driving force.
    pub fn drive(&self) -> &Drive<S> {
        &self.drive
    }
    /// Forces and torques of the latest evaluation.
    pub fn forces(&self) -> &Forces<S> {
        &self.forces
    }
    /// Number of pairs that overlap without being bonded.
    pub fn contacts(&self) -> usize {
        let Some(weak) = &self.weak else { return 0 };
        let p = &self.particles;
        let overlaps = |pair: &&Pair| {
            let (i, j) = pair.indices();
            let d = with_metric!(self.model, metric => metric.displacement(p.position[i], p.position[j]));
            let reach = p.radius[i] + p.radius[j];
            d.norm_squared() < reach * reach
        };
        weak.pairs.iter().filter(overlaps).count()
    }
    /// How often the neighbour list was built.
    pub fn rebuilds(&self) -> u64 {
        self.weak
            .as_ref()
            .map_or(0, |weak| weak.neighbors().rebuilds())
    }
    /// Completed steps.
    pub fn steps(&self) -> u64 {
        self.steps
    }
    /// Time since the initial state in s.
    pub fn time(&self) -> f64 {
        self.steps as f64 * self.model.time_step
    }

    /// Advance by one time step.
    ///
    /// # Errors
    /// A state that is no longer finite, or a particle that moved more than a cell. The state is then
    /// that of the failure, not of the last good step.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.evaluate_if_pending()?;
        let before = self.tally;
        let step = self.model.time_step;
        match self.model.integrator {
            Integrator::Euler => integrators::euler(self, step),
            Integrator::SymplecticEuler => integrators::symplectic_euler(self, step),
            Integrator::Taylor => integrators::taylor(self, step),
            Integrator::VelocityVerlet => integrators::velocity_verlet(self, step)?,
            Integrator::Beeman => integrators::beeman(self, step)?,
        }
        self.steps += 1;
        self.is_evaluated = !self.model.integrator.evaluates_first();
        if let Some(ledger) = &mut self.ledger {
            let after = if self.is_evaluated {
                self.tally
            } else {
                before
            };
            ledger.advance(&before, &after, step);
        }
        Ok(())
    }

    /// Bring forces and links up to date with the positions, as the next step would.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    pub fn evaluate_if_pending(&mut self) -> Result<(), StepError> {
        if self.is_evaluated {
            return Ok(());
        }
        self.evaluate(self.model.integrator.evaluates_first())?;
        self.is_evaluated = true;
        Ok(())
    }

    /// Forces at the present positions and velocities; bonds break, contacts begin and end.
    pub(crate) fn evaluate(&mut self, advances_drive: bool) -> Result<(), StepError> {
        self.watch()?;
        self.forces.clear();
        self.tally = Tally::default();
        self.add_strong_links();
        self.add_weak_links();
        if let Some(strong) = &mut self.strong
            && !strong.broken.is_empty()
        {
            strong.remove_broken();
        }
        self.add_fields();
        self.add_driving(advances_drive);
        if let Some(ledger) = &mut self.ledger {
            ledger.book(&self.tally);
        }
        Ok(())
    }

    /// Keep the neighbour list valid, and stop if the state has become senseless.
    fn watch(&mut self) -> Result<(), StepError> {
        let Self {
            model,
            particles,
            weak: Some(weak),
            ..
        } = self
        else {
            return self.check();
        };
        if with_metric!(model, metric => weak.neighbors().are_stale(metric, particles)) {
            self.check()?;
            let Self {
                model,
                particles,
                weak,
                strong,
                ..
            } = self;
            if let Some(weak) = weak {
                with_metric!(model, metric => weak.rebuild(metric, particles, strong.as_ref()));
            }
        }
        Ok(())
    }

    /// Check that the state is finite and that no particle moves more than a cell a step.
    ///
    /// # Errors
    /// The first particle that violates either.
    pub fn check(&self) -> Result<(), StepError> {
        integrators::check(self)
    }

    fn add_strong_links(&mut self) {
        let Self {
            model,
            particles,
            forces,
            strong,
            tally,
            ..
        } = self;
        let (Some(strong), Some(bond)) = (strong, model.bond) else {
            return;
        };
        with_strong_pass!(model, bond, pass => match (bond.yielding.is_some(), model.ledger) {
            (false, false) => forces::strong_links::<_, _, _, false, false>(pass, particles, strong, forces, tally),
            (false, true) => forces::strong_links::<_, _, _, false, true>(pass, particles, strong, forces, tally),
            (true, false) => forces::strong_links::<_, _, _, true, false>(pass, particles, strong, forces, tally),
            (true, true) => forces::strong_links::<_, _, _, true, true>(pass, particles, strong, forces, tally),
        });
    }

    fn add_weak_links(&mut self) {
        let Self {
            model,
            particles,
            forces,
            strong,
            weak,
            tally,
            ..
        } = self;
        let (Some(weak), Some(contact)) = (weak, model.contact) else {
            return;
        };
        let strong = strong.as_ref();
        if let Some(strong) = strong
            && !strong.broken.is_empty()
        {
            weak.admit_broken(strong);
        }
        let is_broken = |pair: Pair| strong.is_some_and(|strong| strong.breaks_now(pair));
        with_weak_pass!(model, contact, pass => if model.ledger {
            forces::weak_links::<_, _, _, _, _, true>(pass, particles, weak, is_broken, forces, tally);
        } else {
            forces::weak_links::<_, _, _, _, _, false>(pass, particles, weak, is_broken, forces, tally);
        });
    }

    fn add_fields(&mut self) {
        let Self {
            model,
            particles,
            forces,
            tally,
            ..
        } = self;
        match (model.ambient, model.ledger) {
            (None, _) => {}
            (Some(Ambient::Creeping(law)), false) => {
                forces::ambient::<_, _, false>(law, particles, forces, tally)
            }
            (Some(Ambient::Creeping(law)), true) => {
                forces::ambient::<_, _, true>(law, particles, forces, tally)
            }
            (Some(Ambient::Correlation(law)), false) => {
                forces::ambient::<_, _, false>(law, particles, forces, tally)
            }
            (Some(Ambient::Correlation(law)), true) => {
                forces::ambient::<_, _, true>(law, particles, forces, tally)
            }
        }
        match model.external {
            None => {}
            Some(External::Gravity(law)) => forces::external(law, particles, forces),
            Some(External::HarmonicWell(law)) => forces::external(law, particles, forces),
        }
    }

    fn add_driving(&mut self, advances: bool) {
        let Self {
            model,
            particles,
            forces,
            tally,
            driven,
            drive,
            ..
        } = self;
        let Some(law) = model.driving else { return };
        let measured = forces::measure(particles, driven, forces);
        drive.reaction = measured.reaction;
        let before = drive.force;
        if advances {
            drive.force = law.next_force(before, &measured, model.time_step);
        }
        drive.applied = if model.integrator.evaluates_first() {
            before
        } else {
            drive.force
        };
        if model.ledger {
            forces::driving::<_, true>(drive.force, particles, driven, forces, tally);
        } else {
            forces::driving::<_, false>(drive.force, particles, driven, forces, tally);
        }
    }

    /// Find all pairs that may touch anew.
    pub(crate) fn find_neighbors(&mut self) {
        let Self {
            model,
            particles,
            weak,
            strong,
            ..
        } = self;
        if let Some(weak) = weak {
            with_metric!(model, metric => weak.rebuild(metric, particles, strong.as_ref()));
        }
    }

    /// Represent every position in the box.
    pub(crate) fn wrap(&mut self) {
        if let Some(length) = self.model.period() {
            let metric = PeriodicX { length };
            self.particles
                .position
                .iter_mut()
                .for_each(|x| *x = metric.wrap(*x));
        }
    }

    /// Acceleration of particle `i` in m/s^2 and its angular acceleration in rad/s^2, thesis eq. (51).
    #[inline(always)]
    pub(crate) fn acceleration(&self, i: usize) -> (Vec2<S>, S) {
        (
            self.forces.force[i] * self.inverse_mass[i],
            self.forces.torque[i] * self.inverse_inertia[i],
        )
    }

    /// Every pair that interacts in the present state, in order, strong links after weak ones.
    pub fn links(&self) -> Vec<LinkState> {
        let Self {
            model, particles, ..
        } = self;
        let mut states = Vec::new();
        if let (Some(weak), Some(contact)) = (&self.weak, model.contact) {
            with_weak_pass!(model, contact, pass => {
                states.extend(forces::links_at::weak(pass, particles, weak));
            });
        }
        if let (Some(strong), Some(bond)) = (&self.strong, model.bond) {
            with_strong_pass!(model, bond, pass => {
                states.extend(forces::links_at::strong(pass, particles, &strong.links));
            });
        }
        states
    }

    /// The energies that are functions of the state, in J.
    pub(crate) fn state_energy(&self) -> Energy<S> {
        let Self {
            model, particles, ..
        } = self;
        let mut energy = Energy::of_particles(model, particles);
        if let (Some(weak), Some(contact)) = (&self.weak, model.contact) {
            energy.contact += with_weak_pass!(model, contact, pass => {
                forces::stored_in_weak_links(pass, particles, weak)
            });
        }
        if let (Some(strong), Some(bond)) = (&self.strong, model.bond) {
            energy.contact += with_strong_pass!(model, bond, pass => {
                forces::stored_in_strong_links(pass, particles, &strong.links)
            });
        }
        energy
    }

    /// Every term of the energy balance (72) in J; those of the ledger are zero without one.
    pub fn energy(&self) -> Energy<S> {
        let energy = self.state_energy();
        match &self.ledger {
            Some(ledger) => ledger.balance(energy),
            None => energy,
        }
    }
}

impl World {
    /// Go on from the present state at t = 0 with another model and, if given, other roles.
    ///
    /// Bonds, contacts that remember and the driving force are kept; the ledger begins anew.
    ///
    /// # Errors
    /// As [`World::new`].
    pub fn continue_with(
        mut self,
        model: Model,
        roles: Option<Vec<Role>>,
    ) -> Result<Self, ModelError> {
        if let Some(roles) = roles {
            self.particles.assign(roles);
        }
        let links = self.strong.map_or_else(Vec::new, |strong| strong.links);
        let contacts = self.weak.map_or_else(Vec::new, |weak| {
            weak.remembered()
                .map(|(pair, memory)| (pair, *memory))
                .collect()
        });
        let start = Start {
            drive_force: self.drive.force,
            ..Start::default()
        };
        let mut world = Self::new(model, self.particles, &start)?;
        world.adopt_links(links, contacts);
        world.strengthen_edges();
        if model.ledger {
            world.ledger = Some(Ledger::starting_from(&world.state_energy()));
        }
        Ok(world)
    }

    /// The particles alone.
    pub fn into_particles(self) -> Particles {
        self.particles
    }

    /// Make the bonds of driven and fixed particles unbreakable, if the model wants them so.
    fn strengthen_edges(&mut self) {
        let edges = self.model.bond.and_then(|bond| bond.yielding);
        let (Some(strong), true) = (&mut self.strong, edges.is_some_and(|y| y.unbreakable_edges))
        else {
            return;
        };
        for link in &mut strong.links {
            let (i, j) = link.pair.indices();
            if self.particles.role[i] != Role::Free || self.particles.role[j] != Role::Free {
                link.strength_factor = f64::INFINITY;
            }
        }
    }
}

/// A periodic box holds at least two cells across, so that a pair never meets twice.
fn check_width<S: Real>(model: &Model, particles: &Particles<S>) -> Result<(), ModelError> {
    let cell = 2.0 * particles.largest_radius();
    match model.period() {
        Some(width) if width < 2.0 * cell => Err(ModelError::NarrowBox { width, cell }),
        _ => Ok(()),
    }
}
