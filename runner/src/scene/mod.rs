//! Scene files, read and checked completely.

mod arrays;
pub mod builtin;
mod check;
mod file;
mod history;
mod external;
mod keys;
mod laws;
mod output;
mod overrides;
mod scene_text;
mod particles;
pub(crate) mod rows;
mod schedule;
mod setup;
mod shape;
mod strength;
pub(crate) mod table;
mod text;

pub(crate) use external::gravity;
pub use file::{MODELS, SceneFile};
pub use history::{History, initial_angles};
pub use keys::Keys;
pub use laws::DrivingTable;
pub(crate) use output::has_default_interval;
pub use output::{Measure, Output, Trajectory};
pub use overrides::Overrides;
pub use particles::{Material, Place, Placed, role_name};
pub use scene_text::SceneText;
pub use schedule::{Schedule, steps_for};
pub use setup::{Amount, Bonding, FaultTable, LatticeTable, PhaseTable, Roles, Setup};
pub use shape::{Rectangle, Shape};
pub use strength::BondStrength;
pub use text::hex;

use crate::error::{Error, SceneError};
use gouge_common::geometry::Domain;
use gouge_common::geometry::Vec2;
use gouge_common::scalar::Real;
use gouge_dem::bonds::BondStart;
use gouge_dem::contacts::ContactStart;
use gouge_dem::integrators::Integrator;
use gouge_dem::laws::characteristic_length;
use gouge_dem::model::{Ambient, BondLaws, ContactLaws, External, Model, Reading};
use gouge_dem::particles::{Particle, Particles};
use gouge_dem::{ModelError, Number, Start, World};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use table::{Range, Table};
use toml::de::DeTable;

type Result<T> = std::result::Result<T, SceneError>;

/// A scene, complete and consistent.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Title.
    pub title: String,
    /// Form of the equations that the errata correct.
    pub reading: Reading,
    /// Integration method.
    pub integrator: Integrator,
    /// Time step in s.
    pub step: f64,
    /// End time in s.
    pub end: f64,
    /// The box.
    pub domain: Domain,
    /// Density and moment of inertia.
    pub material: Material,
    /// Laws of contacts (weak links).
    pub contact: Option<ContactLaws>,
    /// Laws of bonds (strong links).
    pub bond: Option<BondLaws>,
    /// Drag.
    pub ambient: Option<Ambient>,
    /// External potential.
    pub external: Option<External>,
    /// Driving.
    pub driving: Option<DrivingTable>,
    /// Particles that the scene lists.
    pub particles: Vec<Particle>,
    /// Bonds that the scene lists.
    pub bonds: Placed<BondStart>,
    /// Contacts that began before t = 0.
    pub contacts: Placed<ContactStart>,
    /// What files tell of the past of particles, bonds and contacts besides.
    pub history: History,
    /// Protocol that generates more particles.
    pub setup: Option<Setup>,
    /// Another run whose final state replaces particles, bonds, contacts and set-up.
    pub start: Option<StartFile>,
    /// What a run writes and how often.
    pub output: Output,
    /// Whether the time between samples follows from the end time, because the scene does not give it.
    pub has_default_interval: bool,
    /// Name of the scene file.
    pub file: String,
    /// All files that were read: the scene and its CSV files.
    pub files: Vec<PathBuf>,
    /// SHA-256 of the file and the overrides.
    pub sha256: String,
    /// All keys with their values, to tell how scenes differ.
    pub keys: Keys,
    /// The keys with their overrides, without those that make particles, bonds and contacts.
    pub laws: toml::Table,
}

/// The checkpoint of another run, from whose final state a run begins.
#[derive(Clone, Debug, PartialEq)]
pub struct StartFile {
    /// The file.
    pub path: PathBuf,
    /// SHA-256 of its content.
    pub sha256: String,
    /// The error that refuses it, except for the reason.
    pub refusal: SceneError,
}

const KEYS: [&str; 20] = [
    "title",
    "model",
    "reading",
    "time",
    "box",
    "material",
    "contact",
    "bond",
    "ambient",
    "external",
    "driving",
    "start",
    "particles",
    "particles_file",
    "bonds",
    "bonds_file",
    "contacts",
    "contacts_file",
    "setup",
    "output",
];

/// Names of the integrators for ordinary scenes.
pub const INTEGRATORS: [(&str, Integrator); 5] = [
    ("euler", Integrator::Euler),
    ("symplectic-euler", Integrator::SymplecticEuler),
    ("taylor", Integrator::Taylor),
    ("velocity-verlet", Integrator::VelocityVerlet),
    ("beeman", Integrator::Beeman),
];

/// Name of the integrator that exists only for comparisons with other programs.
const HALF_STEP: (&str, Integrator) = (
    "velocity-verlet-half-step",
    Integrator::VelocityVerletHalfStep,
);

/// Name of an integrator.
pub fn integrator_name(integrator: Integrator) -> &'static str {
    let named = |one: &&(&str, Integrator)| one.1 == integrator;
    INTEGRATORS.iter().find(named).unwrap_or(&HALF_STEP).0
}

impl Scene {
    /// Read a scene file, or a built-in scene by its name. If a file has the name of a built-in scene, it is read.
    ///
    /// # Errors
    /// An unreadable file, or any mistake in it.
    pub fn load(name: impl AsRef<Path>) -> std::result::Result<Self, Error> {
        Self::load_with(name, &Overrides::default())
    }

    /// Like [`Scene::load`], with some keys overridden.
    ///
    /// # Errors
    /// As [`Scene::load`]; a mistake in an override names the override.
    pub fn load_with(
        name: impl AsRef<Path>,
        overrides: &Overrides,
    ) -> std::result::Result<Self, Error> {
        Ok(Self::read(&SceneFile::load(name)?, overrides)?)
    }

    /// Read a scene from the bytes of a file; its CSV files are read from `folder`.
    ///
    /// # Errors
    /// Any mistake in it.
    pub fn parse(file: &str, bytes: &[u8], folder: &Path) -> Result<Self> {
        Self::parse_with(file, bytes, folder, &Overrides::default())
    }

    /// Like [`Scene::parse`], with some keys overridden before anything is checked.
    ///
    /// # Errors
    /// As [`Scene::parse`]; a mistake in an override names the override.
    pub fn parse_with(
        file: &str,
        bytes: &[u8],
        folder: &Path,
        overrides: &Overrides,
    ) -> Result<Self> {
        Self::read(&SceneFile::new(file, bytes, folder), overrides)
    }

    pub(crate) fn read(file: &SceneFile, overrides: &Overrides) -> Result<Self> {
        let mut scene = file.read(overrides, |root, table, folder| {
            let mut scene = Self::from_table(root, folder)?;
            scene.keys = keys(root, table, folder, &scene)?;
            scene.laws = laws_of(table);
            scene.check(root)?;
            Ok(scene)
        })?;
        scene.sha256 = file.sha256(overrides);
        if let Some(path) = file.path() {
            path.clone_into(&mut scene.files[0]);
        }
        Ok(scene)
    }

    fn from_table(root: &Table, folder: &Path) -> Result<Self> {
        // The model determines which keys exist, so it is checked first.
        root.optional_choice("model", &[("dem", ())])?;
        root.allow(&KEYS)?;
        let readings = [
            ("corrected", Reading::Corrected),
            ("thesis", Reading::Thesis),
        ];
        let reading = root
            .optional_choice("reading", &readings)?
            .unwrap_or(Reading::Corrected);
        let domain = domain(root)?;
        let time = root.table("time")?;
        time.allow(&["step", "end", "integrator"])?;
        let (end, step) = time.duration_and_step("end")?;
        let material = particles::material(root, reading)?;
        let mut history = History::default();
        let mut scene = Self {
            title: root.optional_text("title")?.unwrap_or_default().to_owned(),
            reading,
            integrator: time.choice("integrator", &[&INTEGRATORS[..], &[HALF_STEP]].concat())?,
            step,
            end,
            contact: laws::contact(root, reading)?,
            bond: laws::bond(root)?,
            ambient: laws::ambient(root, reading)?,
            external: laws::external(root, &domain)?,
            driving: laws::driving(root)?,
            particles: particles::particles(root, folder, material, &mut history)?,
            bonds: particles::bonds(root, folder, &mut history)?,
            contacts: particles::contacts(root, folder, &mut history)?,
            history,
            setup: setup::setup(root, &domain, reading, material, folder)?,
            start: particles::start(root, folder)?,
            output: output::output(root, end)?,
            domain,
            material,
            has_default_interval: output::has_default_interval(root)?,
            file: root.source().file.to_owned(),
            files: files(root, folder)?,
            sha256: String::new(),
            keys: Keys::default(),
            laws: toml::Table::new(),
        };
        if let Some(start) = &scene.start {
            scene.files.push(start.path.clone());
            (scene.particles, scene.setup) = (Vec::new(), None);
            (scene.bonds, scene.contacts) = (Vec::new(), Vec::new());
            scene.history = History::default();
        }
        Ok(scene)
    }

    /// The model of the scene proper, for particles of the given radii.
    pub fn model(&self, radii: &[f64]) -> Model {
        let width = self.domain.width.unwrap_or(0.0);
        Model {
            reading: self.reading,
            integrator: self.integrator,
            time_step: self.step,
            domain: self.domain,
            contact: self.contact,
            bond: self.bond,
            ambient: self.ambient,
            external: self.external,
            driving: self
                .driving
                .map(|table| table.law(width, characteristic_length(radii))),
            ledger: self.output.energy,
        }
    }

    /// The world at t = 0 of a scene without set-up. It uses one thread and the widest instructions unless the caller
    /// chooses others (`machine::with_chosen_execution`).
    ///
    /// # Errors
    /// A state that the kernel rejects.
    pub fn initial_world(&self) -> std::result::Result<World, ModelError> {
        let world = self.initial_world_in()?;
        let History {
            rests, memories, ..
        } = &self.history;
        match rests.is_empty() && memories.is_none() {
            true => Ok(world),
            false => Ok(world.with_history(rests, memories.clone())),
        }
    }

    /// Like [`Scene::initial_world`], in another number type, and with bonds and contacts as the usual columns of their
    /// files describe them.
    ///
    /// # Errors
    /// A state that the kernel rejects.
    pub fn initial_world_in<S: Number>(&self) -> std::result::Result<World<S>, ModelError> {
        let mut particles: Particles<S> = self.particles.iter().copied().collect();
        for (i, inertia) in self.history.inertia.iter().enumerate() {
            let [mass, moment] = inertia.map(S::from_f64);
            (particles.mass[i], particles.moment_of_inertia[i]) = (mass, moment);
        }
        wrap(&self.domain, &mut particles);
        let radii: Vec<f64> = self.particles.iter().map(|one| one.radius).collect();
        let model = self.model(&radii);
        let start = Start {
            bonds: self.bonds.iter().map(|(bond, _)| *bond).collect(),
            contacts: match &self.history.memories {
                None => self.contacts.iter().map(|(contact, _)| *contact).collect(),
                Some(_) => Vec::new(),
            },
            drive_force: self.initial_force(),
        };
        World::new(model, particles, &start)
    }

    /// Total driving force at t = 0 in N.
    pub fn initial_force(&self) -> Vec2 {
        self.driving.map_or(Vec2::zero(), |driving| {
            Vec2::new(driving.initial_force[0], driving.initial_force[1])
        })
    }

    /// When a run takes samples.
    pub fn schedule(&self) -> Schedule {
        Schedule {
            step: self.step,
            end: self.end,
            interval: self.output.interval,
        }
    }

    /// Number of steps until the end time.
    pub fn steps(&self) -> u64 {
        self.schedule().steps()
    }

    /// Step of a sample, counted from zero; the last step is always sampled.
    pub fn sample_step(&self, sample: u64) -> u64 {
        self.schedule().sample_step(sample)
    }

    /// Step of a sample if the scene had no end.
    pub fn regular_sample_step(&self, sample: u64) -> u64 {
        self.schedule().regular_sample_step(sample)
    }
}

/// Map the positions of all particles into the periodic box.
pub fn wrap<S: Real>(domain: &Domain, particles: &mut Particles<S>) {
    use gouge_common::geometry::{Metric, PeriodicX};
    if let Some(length) = domain.period() {
        particles
            .position
            .iter_mut()
            .for_each(|x| *x = PeriodicX { length }.wrap(*x));
    }
}

pub(crate) fn domain(root: &Table) -> Result<Domain> {
    let Some(table) = root.optional_table("box")? else {
        return Ok(Domain {
            width: None,
            height: None,
            periodic: false,
        });
    };
    table.allow(&["width", "height", "boundary"])?;
    let width = table.optional_number("width", Range::Positive)?;
    let boundaries = [("open", false), ("periodic-x", true)];
    let periodic = table
        .optional_choice("boundary", &boundaries)?
        .unwrap_or(false);
    if periodic && width.is_none() {
        return Err(table.error(
            "width",
            "missing; required if boundary is periodic-x; must be a width in m",
        ));
    }
    Ok(Domain {
        width,
        height: table.optional_number("height", Range::Positive)?,
        periodic,
    })
}

/// Keys that name a file of the scene.
const FILES: [&str; 3] = ["particles_file", "bonds_file", "contacts_file"];

/// The keys of a scene; files stand for their content, and what depends on other keys by default is written out.
fn keys(root: &Table, table: &DeTable, folder: &Path, scene: &Scene) -> Result<Keys> {
    let mut keys = Keys::of(&root.source(), table);
    keys.set("output.interval", &format!("{:?}", scene.output.interval));
    if let Some(start) = &scene.start {
        keys.set(
            "start",
            &format!("the state with the hash {}", &start.sha256[..12]),
        );
    }
    if let Some((name, path)) = strength::file(root, folder)? {
        let content = std::fs::read(path).unwrap_or_default();
        keys.set_file("setup.bonding.strength.file", &name, &content);
    }
    for key in FILES {
        if let Some(name) = root.optional_text(key)? {
            let content = std::fs::read(folder.join(name)).unwrap_or_default();
            keys.set_file(key, name, &content);
        }
    }
    Ok(keys)
}

/// Keys that make particles, bonds and contacts.
const STATE: [&str; 8] = [
    "start",
    "setup",
    "particles",
    "particles_file",
    "bonds",
    "bonds_file",
    "contacts",
    "contacts_file",
];

/// The keys that do not make particles, bonds and contacts.
fn laws_of(table: &DeTable) -> toml::Table {
    let is_law = |key: &str| !STATE.contains(&key);
    let kept = table.iter().filter(|(key, _)| is_law(key.get_ref()));
    let kept: DeTable = kept
        .map(|(key, value)| (key.clone(), value.clone()))
        .collect();
    let reader = toml::Deserializer::from(toml::Spanned::new(0..0, kept));
    toml::Table::deserialize(reader).unwrap_or_default()
}

fn files(root: &Table, folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = vec![PathBuf::from(root.source().file)];
    for key in FILES {
        files.extend(root.optional_text(key)?.map(|name| folder.join(name)));
    }
    files.extend(strength::file(root, folder)?.map(|(_, path)| path));
    Ok(files)
}
