//! Grains with all that a step needs.

use crate::bonds::Bonds;
use crate::energy::Energies;
use crate::error::{LostNode, SetupError, StepError, TooFast, require};
use crate::forces::{Settings, Touching, Workspace};
use crate::grain::Grains;
use crate::guard::Guard;
use crate::limits::Limits;
use crate::state::{State, moved};
use gouge_common::geometry::Vec2;
use gouge_common::instructions::Instructions;
use gouge_common::pair::Pair;
use gouge_equations::rendered;

/// Where accelerations come from at the beginning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Beginning {
    /// From the forces.
    #[default]
    Forces,
    /// From the given state.
    Given,
}

/// Grains that move.
#[derive(Clone, Debug)]
pub struct World {
    grains: Grains,
    settings: Settings,
    state: State,
    workspace: Workspace,
    /// Stops nodes that are too fast, if it is wanted.
    guard: Option<Guard>,
}

/// Refuse settings outside their ranges, and states of other grains.
fn validate(grains: &Grains, settings: &Settings, state: &State) -> Result<(), SetupError> {
    let step = settings.time_step;
    require("time_step", step, "positive", step > 0.0)?;
    if let Some(contact) = &settings.contact {
        contact.validate(grains)?;
    }
    if let Some(walls) = &settings.walls {
        walls.validate(&state.walls)?;
    }
    let nodes = grains.nodes();
    let lengths = [
        ("places", state.places.len()),
        ("velocity", state.velocity.len()),
        ("acceleration", state.acceleration.len()),
        ("bonds", state.bonds.numbers().len()),
    ];
    match lengths.into_iter().find(|&(_, length)| length != nodes) {
        Some((column, length)) => Err(SetupError::StateLength {
            column,
            length,
            nodes,
        }),
        None => Ok(()),
    }
}

#[rendered]
impl World {
    /// Grains in a state of motion, as [`World::new`] makes them, with a time step and a contact radius that are safe, also
    /// for fast nodes.
    ///
    /// # Errors
    /// As for [`World::new`]; [`SetupError::TimeStep`] for a step above one of the [`Limits`],
    /// [`SetupError::ContactRadius`] for a radius below that of [`Contact::check_radius`], and [`SetupError::TooFast`] for
    /// nodes that [`World::guarded`] refuses.
    ///
    /// [`Contact::check_radius`]: crate::contacts::Contact::check_radius
    pub fn within_limits(
        grains: Grains,
        settings: Settings,
        state: State,
        beginning: Beginning,
    ) -> Result<Self, SetupError> {
        validate(&grains, &settings, &state)?;
        if let Some(contact) = &settings.contact {
            contact.check_radius(&grains)?;
        }
        Limits::of(&grains, &state.bonds, &settings).check(settings.time_step)?;
        Ok(Self::new(grains, settings, state, beginning)?.guarded()?)
    }

    /// Grains in a state of motion, whatever the time step and the contact radius are: results of others may have been
    /// computed with unstable ones.
    ///
    /// # Errors
    /// [`SetupError::Parameter`] for a setting outside its range, and [`SetupError::StateLength`] for a state of other
    /// grains.
    pub fn new(
        grains: Grains,
        settings: Settings,
        state: State,
        beginning: Beginning,
    ) -> Result<Self, SetupError> {
        validate(&grains, &settings, &state)?;
        let workspace = Workspace::new(&grains, &settings, &state);
        let mut world = Self {
            grains,
            settings,
            state,
            workspace,
            guard: None,
        };
        world.hold_clamped();
        if beginning == Beginning::Forces {
            let work = world.state.work;
            world.evaluate();
            world.state.work = work;
            for (node, acceleration) in world.state.acceleration.iter_mut().enumerate() {
                let density = world.grains.of(node).density;
                *acceleration = world.workspace.force[node] * (1.0 / density);
            }
            world.hold_clamped();
        }
        Ok(world)
    }

    /// The same world with instructions for its bonds other than the widest of the machine; the bits stay the same.
    pub fn with_instructions(mut self, instructions: Instructions) -> Self {
        self.workspace.use_instructions(instructions);
        self
    }

    /// The same world, which stops before a step in which nodes that can touch something move by more than half of the
    /// contact radius, relative to other nodes or to walls, along an axis: contacts could be missed.
    ///
    /// # Errors
    /// [`TooFast`] if the first step is such a step.
    pub fn guarded(mut self) -> Result<Self, Box<TooFast>> {
        self.guard = Guard::of(&self.grains, &self.settings);
        self.require_slow()?;
        Ok(self)
    }

    /// The motion for which [`World::guarded`] refuses the coming step; none if no contact could be missed in it. The world
    /// need not be guarded.
    pub fn too_fast(&self) -> Option<Box<TooFast>> {
        let guard = Guard::of(&self.grains, &self.settings)?;
        let checked = guard.check(&self.grains, &self.settings, &self.state);
        checked.err()
    }

    fn require_slow(&self) -> Result<(), Box<TooFast>> {
        match &self.guard {
            Some(guard) => guard.check(&self.grains, &self.settings, &self.state),
            None => Ok(()),
        }
    }

    /// Advance by one step of velocity Verlet, section 6.1 of peridem.
    ///
    /// $$ \vec u \leftarrow \vec u + \Delta t \, \vec v + \tfrac12 \Delta t^2 \vec a, \qquad \vec v \leftarrow \vec v + \tfrac12 \Delta t (\vec a + \vec a') $$
    ///
    /// The new acceleration $\vec a'$ is found from the new displacements and the old velocities, which makes damping and
    /// friction explicit and of first order.
    ///
    /// # Errors
    /// [`StepError`] if the state is no longer finite, a node is behind a wall, or a node is too fast for a guarded world,
    /// which then has not moved.
    pub fn step(&mut self) -> Result<(), StepError> {
        let time = self.time();
        (self.require_slow()).map_err(|motion| StepError::TooFast { motion, time })?;
        let step = self.settings.time_step;
        let state = &mut self.state;
        let motions = state.velocity.iter().zip(&state.acceleration);
        for (place, (&velocity, &acceleration)) in state.places.iter_mut().zip(motions) {
            place.displacement += moved(velocity, acceleration, step);
        }
        self.state.steps += 1;
        if let Some(walls) = &self.settings.walls {
            walls.advance(&mut self.state.walls, step);
        }
        self.evaluate();
        let mut sum = Vec2::zero();
        for row in &self.grains.rows {
            let inverse = 1.0 / row.density;
            for node in row.nodes.clone() {
                let acceleration = self.workspace.force[node] * inverse;
                let old = core::mem::replace(&mut self.state.acceleration[node], acceleration);
                self.state.velocity[node] += (old + acceleration) * (0.5 * step);
                sum += self.state.velocity[node];
            }
        }
        self.hold_clamped();
        if !sum.is_finite() {
            return self.find_fault();
        }
        match self.workspace.has_lost {
            true => self.require_inside(),
            false => Ok(()),
        }
    }

    fn evaluate(&mut self) {
        self.workspace
            .evaluate(&self.grains, &self.settings, &mut self.state);
    }

    fn hold_clamped(&mut self) {
        for &node in &self.grains.clamped {
            self.state.velocity[node as usize] = Vec2::zero();
            self.state.acceleration[node as usize] = Vec2::zero();
        }
    }

    #[cold]
    fn find_fault(&self) -> Result<(), StepError> {
        let is_wrong = |velocity: &Vec2| !velocity.is_finite();
        let Some(node) = self.state.velocity.iter().position(is_wrong) else {
            return Ok(());
        };
        let grain = self.grains.grain_of[node] as usize;
        Err(StepError::NotFinite {
            grain,
            node: node - self.grains.rows[grain].nodes.start,
            time: self.time(),
            steps: self.state.steps,
        })
    }

    #[cold]
    fn require_inside(&self) -> Result<(), StepError> {
        match self.lost_node() {
            None => Ok(()),
            Some(lost) => Err(StepError::BehindWall {
                lost,
                time: self.time(),
            }),
        }
    }

    /// The first node that is so far behind a wall that it no longer pushes it back. The authors' readings of walls let such
    /// nodes go.
    pub fn lost_node(&self) -> Option<LostNode> {
        let (node, wall, depth) = self.settings.walls.as_ref()?.first_behind(&self.state)?;
        let grain = self.grains.grain_of[node] as usize;
        Some(LostNode {
            grain,
            node: node - self.grains.rows[grain].nodes.start,
            wall,
            depth,
        })
    }

    /// The same grains in another state, with the forces on the walls in N per metre of depth.
    pub(crate) fn with_state(mut self, state: State, reactions: [Vec2; 4]) -> Self {
        let instructions = self.workspace.instructions();
        self.workspace = Workspace::new(&self.grains, &self.settings, &state);
        self.workspace.use_instructions(instructions);
        self.workspace.reactions = reactions;
        self.state = state;
        self
    }

    /// Forces in N per metre of depth of the grains on the left, right, top and bottom wall.
    pub fn reactions(&self) -> [Vec2; 4] {
        self.workspace.reactions
    }

    /// All contacts between nodes.
    pub fn contacts(&self) -> Vec<Touching> {
        self.workspace
            .contacts(&self.grains, &self.settings, &self.state)
    }

    /// What a run does not change.
    pub fn grains(&self) -> &Grains {
        &self.grains
    }

    /// What acts besides bonds, and how.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The state.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Bonds that have not broken.
    pub fn bonds(&self) -> &Bonds {
        &self.state.bonds
    }

    /// Bonds that broke in the latest step, by later node and then by earlier one.
    pub fn broken(&self) -> &[Pair] {
        &self.workspace.broken
    }

    /// Time in s: the number of steps times the time step.
    pub fn time(&self) -> f64 {
        self.state.steps as f64 * self.settings.time_step
    }

    /// Energies of the state.
    pub fn energies(&self) -> Energies {
        let mut energies = Energies::of(&self.grains, &self.state, self.settings.gravity);
        energies.contacts =
            self.workspace
                .contact_energy(&self.grains, &self.settings, &self.state);
        energies
    }
}
