//! A scene under construction.

use super::grain::{Bond, Grain};
use super::keys;
use super::laws::{Law, friction};
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::Controller;
use gouge_dem::{ModelError, Number, World};
use gouge_runner::error::{Error, SceneError};
use gouge_runner::machine::with_chosen_execution;
use gouge_runner::scene::{DrivingTable, Scene, builtin, integrator_name};
use std::path::Path;
use toml::{Table, Value};

/// A scene under construction.
///
/// A step that cannot be made, such as replacing a key that is not there, is kept as a mistake; the text, the
/// scene and the world are refused because of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    table: Table,
    mistake: Option<String>,
}

/// Why a draft is no scene.
#[derive(Clone, Debug, thiserror::Error)]
pub enum Mistake {
    /// A step of the construction that could not be made.
    #[error("the draft of a scene: {0}")]
    Draft(String),
    /// The scene has a mistake.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The kernel refuses the state.
    #[error(transparent)]
    Model(#[from] ModelError),
}

impl From<Mistake> for Error {
    fn from(mistake: Mistake) -> Self {
        match mistake {
            Mistake::Draft(_) => Self::Argument(mistake.to_string()),
            Mistake::Scene(error) => error.into(),
            Mistake::Model(error) => error.into(),
        }
    }
}

/// An integrator, or its name in scenes.
pub struct Method(String);

impl From<Integrator> for Method {
    fn from(integrator: Integrator) -> Self {
        Self(integrator_name(integrator).to_owned())
    }
}

impl From<&str> for Method {
    fn from(name: &str) -> Self {
        Self(name.to_owned())
    }
}

impl Draft {
    /// Nothing: a part to be added to other drafts.
    pub fn empty() -> Self {
        Self::default()
    }

    /// An open box without grains: a method, a time step in s, density 2700 kg/m^3, an end that nothing reaches.
    pub fn open_box(method: impl Into<Method>, step: f64) -> Self {
        Self::empty()
            .with("time.step", step)
            .with("time.end", 1e12 * step)
            .with("time.integrator", method.into().0)
            .with("material.density", 2700.0)
    }

    /// The scene of a text.
    pub fn parse(text: &str) -> Self {
        match text.parse::<Table>() {
            Ok(table) => Self {
                table,
                mistake: None,
            },
            Err(error) => Self::empty().mistaken(error.to_string()),
        }
    }

    /// A built-in scene.
    pub fn builtin(name: &str) -> Self {
        match builtin::text(name) {
            Some(text) => Self::parse(text),
            None => Self::empty().mistaken(format!("there is no built-in scene {name}")),
        }
    }

    /// Whether there is a dotted key of tables.
    pub fn has(&self, key: &str) -> bool {
        keys::has(&self.table, key)
    }

    /// Set a dotted key, such as `box.width` or `particles.0.radius`, whether it is there or not.
    pub fn with(mut self, key: &str, value: impl Into<Value>) -> Self {
        match keys::set(&mut self.table, key, value.into()) {
            true => self,
            false => self.mistaken(format!("{key} cannot be set")),
        }
    }

    /// Add a table that gives no key, which leaves all of them to their defaults.
    pub fn with_table(self, key: &str) -> Self {
        self.with(key, Table::new())
    }

    /// Replace the value of a dotted key; a mistake if it is not there.
    pub fn replacing(mut self, key: &str, value: impl Into<Value>) -> Self {
        match keys::replace(&mut self.table, key, value.into()) {
            true => self,
            false => self.mistaken(format!("there is no {key} to replace")),
        }
    }

    /// Remove a dotted key; a mistake if it is not there.
    pub fn without(mut self, key: &str) -> Self {
        match keys::remove(&mut self.table, key) {
            true => self,
            false => self.mistaken(format!("there is no {key} to remove")),
        }
    }

    /// Add all that another draft says, its grains and bonds after those of this one; a mistake if both give
    /// the same key.
    pub fn and(mut self, other: &Self) -> Self {
        if let Some(mistake) = &other.mistake {
            self = self.mistaken(mistake.clone());
        }
        match keys::join(&mut self.table, &other.table) {
            Ok(()) => self,
            Err(key) => self.mistaken(format!("{key} is given twice")),
        }
    }

    /// With the first mistake kept.
    fn mistaken(mut self, mistake: String) -> Self {
        self.mistake.get_or_insert(mistake);
        self
    }

    /// Choose `reading`: `corrected` or `thesis`.
    pub fn reading(self, reading: &str) -> Self {
        self.with("reading", reading)
    }

    /// End at a time in s.
    pub fn ending_at(self, time: f64) -> Self {
        self.with("time.end", time)
    }

    /// Choose a law of contacts or bonds.
    pub fn law<L: Law>(self, law: L) -> Self {
        self.with(L::KEY, law.table())
    }

    /// Choose friction by the name of the law, the coefficient, and its damping in kg/s or stiffness in kg/s^2.
    pub fn friction(self, law: &str, coefficient: f64, constant: f64) -> Self {
        let entries = friction(law, coefficient, constant).into_iter();
        let table: Table = entries
            .map(|(key, value)| (key.to_owned(), value))
            .collect();
        self.with("contact.tangential", table)
    }

    /// Gravity with an acceleration in m/s^2, downwards.
    pub fn gravity(self, acceleration: f64) -> Self {
        self.with("external.law", "gravity")
            .with("external.acceleration", acceleration)
    }

    /// A harmonic well with a stiffness in kg/s^2, centred at half the height of the box.
    pub fn harmonic_well(self, stiffness: f64) -> Self {
        self.with("external.law", "harmonic-well")
            .with("external.stiffness", stiffness)
    }

    /// Drag of creeping flow with a viscosity in Pa s.
    pub fn creeping_drag(self, viscosity: f64) -> Self {
        self.with("ambient.law", "creeping")
            .with("ambient.viscosity", viscosity)
    }

    /// The drag correlation with a viscosity in Pa s and a density of the medium in kg/m^3.
    pub fn correlation_drag(self, viscosity: f64, density: f64) -> Self {
        self.with("ambient.law", "correlation")
            .with("ambient.viscosity", viscosity)
            .with("ambient.density", density)
    }

    /// A driving force on the driven grains.
    pub fn driving(self, driving: DrivingTable) -> Self {
        if let Controller::Steady { velocity } = driving.controller {
            return self
                .with("driving.controller", "steady")
                .with("driving.velocity", vec![velocity.x, velocity.y]);
        }
        let draft = self
            .with("driving.speed", driving.speed)
            .with("driving.pressure", driving.pressure)
            .with("driving.initial_force", driving.initial_force.to_vec());
        let draft = match driving.controller {
            Controller::Exact | Controller::Steady { .. } => {
                draft.with("driving.controller", "exact")
            }
            Controller::RateLimited { force_rate } => draft
                .with("driving.controller", "rate-limited")
                .with("driving.force_rate", force_rate),
        };
        match driving.area {
            Some(area) => draft.with("driving.area", area),
            None => draft,
        }
    }

    /// Add a table to the array of tables with a dotted key, such as a phase to `setup.settle`.
    pub fn adding(mut self, array: &str, item: &Self) -> Self {
        if let Some(mistake) = &item.mistake {
            self = self.mistaken(mistake.clone());
        }
        self.push(array, item.table.clone().into())
    }

    fn push(mut self, array: &str, item: Value) -> Self {
        match keys::push(&mut self.table, array, item) {
            true => self,
            false => self.mistaken(format!("{array} is no array")),
        }
    }

    /// Add a grain.
    pub fn grain(self, grain: Grain) -> Self {
        self.push("particles", grain.table())
    }

    /// Add grains.
    pub fn grains(self, grains: impl IntoIterator<Item = Grain>) -> Self {
        grains.into_iter().fold(self, Self::grain)
    }

    /// Bond two grains, counted from 0, that are unstrained now.
    pub fn bonded(self, i: usize, j: usize) -> Self {
        self.bond(Bond::between(i, j))
    }

    /// Add a bond.
    pub fn bond(self, bond: Bond) -> Self {
        self.push("bonds", bond.table())
    }

    /// Two grains that touched before, with the angles in rad at which their contact began.
    pub fn touching_since(self, i: usize, j: usize, initial_angles: [f64; 2]) -> Self {
        self.push(
            "contacts",
            Bond::between(i, j).since(initial_angles).table(),
        )
    }

    /// The text of the scene.
    ///
    /// # Errors
    /// Mistakes in the draft.
    pub fn text(&self) -> Result<String, Mistake> {
        match &self.mistake {
            Some(mistake) => Err(Mistake::Draft(mistake.clone())),
            None => toml::to_string(&self.table).map_err(|e| Mistake::Draft(e.to_string())),
        }
    }

    /// The scene; files beside it are sought in the present folder.
    ///
    /// # Errors
    /// Mistakes in the draft or the scene.
    pub fn scene(&self) -> Result<Scene, Mistake> {
        let text = self.text()?;
        Ok(Scene::parse("scene.toml", text.as_bytes(), Path::new("."))?)
    }

    /// The world at t = 0 of a scene without set-up.
    ///
    /// # Errors
    /// Mistakes in the draft or the scene, states that the kernel refuses.
    pub fn world(&self) -> Result<World, Mistake> {
        self.world_in()
    }

    /// The same in another number type.
    ///
    /// # Errors
    /// As [`Draft::world`].
    pub fn world_in<S: Number>(&self) -> Result<World<S>, Mistake> {
        Ok(self
            .scene()?
            .initial_world_in()
            .map(with_chosen_execution)?)
    }
}
