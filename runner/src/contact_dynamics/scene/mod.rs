//! Scene files with `model = "contact-dynamics"`, read and checked completely.

mod bodies;
mod laws;
mod output;
mod setup;

pub use bodies::{Bodies, Body, Outline, Role, Wall};
pub use output::{Measure, Output};
pub use setup::{CellTable, Compaction, Glue, PackingTable, ShearTable, Sizes};

use crate::error::SceneError;
use crate::scene::table::{Range, Table};
use crate::scene::{Keys, MODELS, Overrides, SceneFile, SceneText, Schedule, domain, gravity};
use gouge_common::geometry::{Domain, Vec2};
use gouge_contact_dynamics::step::StepSettings;
use std::path::{Path, PathBuf};
use toml::de::DeTable;

type Result<T> = std::result::Result<T, SceneError>;

/// A scene, complete and consistent.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// Title.
    pub title: String,
    /// End time in s.
    pub end: f64,
    /// How a step goes.
    pub settings: StepSettings,
    /// The box.
    pub domain: Domain,
    /// Density in kg/m².
    pub density: f64,
    /// Acceleration in m/s² of all bodies.
    pub gravity: Vec2,
    /// Bodies and walls that the scene lists.
    pub bodies: Bodies,
    /// Protocol that makes a packing between two walls.
    pub packing: Option<PackingTable>,
    /// Two walls around the bodies that the scene lists.
    pub cell: Option<CellTable>,
    /// What drives the upper of two walls.
    pub shear: Option<ShearTable>,
    /// What a run writes and how often.
    pub output: Output,
    /// Whether the time between samples follows from the end.
    pub has_default_interval: bool,
    /// Name of the scene file.
    pub file: String,
    /// All files that were read: the scene and its CSV files.
    pub files: Vec<PathBuf>,
    /// SHA-256 of the file and the overrides.
    pub sha256: String,
    /// All keys with their values, to tell how scenes differ.
    pub keys: Keys,
}

const KEYS: [&str; 14] = [
    "title",
    "model",
    "time",
    "box",
    "material",
    "contact",
    "solver",
    "external",
    "particles",
    "particles_file",
    "walls",
    "cell",
    "setup",
    "shear",
];

/// The key that names a CSV file of bodies.
const BODIES_FILE: &str = "particles_file";

impl Scene {
    pub(crate) fn read(file: &SceneFile, overrides: &Overrides) -> Result<Self> {
        let mut scene = file.read(overrides, |root, table, folder| {
            root.optional_choice("model", &MODELS)?;
            let mut scene = Self::from_table(root, folder)?;
            scene.keys = keys(root, table, folder, &scene)?;
            Ok(scene)
        })?;
        scene.sha256 = file.sha256(overrides);
        if let Some(path) = file.path() {
            path.clone_into(&mut scene.files[0]);
        }
        Ok(scene)
    }

    fn from_table(root: &Table, folder: &Path) -> Result<Self> {
        root.allow(&[&KEYS[..], &["output"]].concat())?;
        let time = root.table("time")?;
        time.allow(&["step", "end", "scheme"])?;
        let (end, step) = time.duration_and_step("end")?;
        let material = root.table("material")?;
        material.allow(&["density"])?;
        let density = material.number("density", Range::Positive)?;
        let packing = setup::packing(root, density, step)?;
        let cell = setup::cell(root)?;
        let bodies = bodies::bodies(root, folder, density)?;
        let diameter = match &packing {
            Some(packing) => packing.sizes.range().mean(),
            None => bodies.mean_diameter(),
        };
        let mut scene = Self {
            title: root.optional_text("title")?.unwrap_or_default().to_owned(),
            end,
            settings: laws::settings(root, &time, step, diameter)?,
            domain: domain(root)?,
            density,
            gravity: gravity(root)?,
            bodies,
            packing,
            cell,
            shear: setup::shear(root)?,
            output: output::output(root, end)?,
            has_default_interval: crate::scene::has_default_interval(root)?,
            file: root.source().file.to_owned(),
            files: vec![PathBuf::from(root.source().file)],
            sha256: String::new(),
            keys: Keys::default(),
        };
        if let Some(name) = root.optional_text(BODIES_FILE)? {
            scene.files.push(folder.join(name));
        }
        scene.check(root)?;
        Ok(scene)
    }

    /// Whether the parts of the scene fit together.
    fn check(&self, root: &Table) -> Result<()> {
        let has_walls = self.packing.is_some() || self.cell.is_some();
        if has_walls && self.domain.period().is_none() {
            let accepted =
                "a packing between walls needs box.width and box.boundary = \"periodic-x\"";
            return Err(root.error("box", accepted));
        }
        if self.shear.is_some() && !has_walls {
            return Err(root.error("shear", "needs the walls of [setup] or of [cell]"));
        }
        if self.packing.is_some() && (self.cell.is_some() || !self.bodies.is_empty()) {
            let accepted =
                "cannot be combined with [cell], [[particles]], particles_file or [[walls]]";
            return Err(root.error("setup", accepted));
        }
        if has_walls && !self.bodies.walls.is_empty() {
            return Err(root.error("walls", "cannot be combined with the walls of [cell]"));
        }
        if self.packing.is_none() && self.bodies.bodies.is_empty() {
            return Err(root.error(
                "particles",
                "missing; a scene needs [[particles]], particles_file or [setup]",
            ));
        }
        if has_walls && self.gravity != Vec2::zero() {
            let accepted = "gravity cannot be combined with the walls of [setup] or of [cell]";
            return Err(root.error("external", accepted));
        }
        if !has_walls && !self.output.measure.is_empty() {
            let output = root.table("output")?;
            let accepted =
                "needs the walls of [setup] or of [cell], between which stress is measured";
            return Err(output.error("measure", accepted));
        }
        self.check_width(root)?;
        self.bodies.check_roles(root, self.cell.is_some())?;
        self.check_law(root)
    }

    /// A body must not touch two images of another one, and a deposit needs some width.
    fn check_width(&self, root: &Table) -> Result<()> {
        let Some(width) = self.domain.period() else {
            return Ok(());
        };
        let (diameters, largest) = match &self.packing {
            Some(packing) => (4.0, packing.sizes.range().maximum),
            None => {
                let radii = self.bodies.bodies.iter().map(Body::radius);
                (2.0, 2.0 * radii.fold(0.0, f64::max))
            }
        };
        if width < diameters * largest {
            let accepted = format!(
                "must be at least {diameters:?} times the largest diameter, {:?} m",
                diameters * largest
            );
            return Err(root.table("box")?.error("width", &accepted));
        }
        Ok(())
    }

    fn check_law(&self, root: &Table) -> Result<()> {
        let checked = self.settings.validate();
        checked.map_err(|error| root.error("contact", &error.to_string()))
    }

    /// Number of bodies.
    pub fn number_of_bodies(&self) -> usize {
        match &self.packing {
            Some(packing) => packing.bodies,
            None => self.bodies.bodies.len(),
        }
    }

    /// Whether the network of contacts is measured at every sample.
    pub fn measures_network(&self) -> bool {
        self.output.measure.contains(&Measure::Network)
    }

    /// Number of steps until the end time.
    pub fn steps(&self) -> u64 {
        self.schedule().steps()
    }

    /// When a run takes samples.
    pub fn schedule(&self) -> Schedule {
        Schedule {
            step: self.settings.time_step,
            end: self.end,
            interval: self.output.interval,
        }
    }
}

impl SceneText for Scene {
    fn files(&self) -> &[PathBuf] {
        &self.files
    }
    fn keys(&self) -> &Keys {
        &self.keys
    }
    fn end(&self) -> f64 {
        self.end
    }
    fn content_until(&self, end: f64) -> String {
        let anonymous = Self {
            end,
            title: String::new(),
            file: String::new(),
            files: Vec::new(),
            sha256: String::new(),
            keys: Keys::default(),
            has_default_interval: false,
            ..self.clone()
        };
        format!("{anonymous:?}")
    }
    fn default_interval(&mut self) -> Option<(&mut f64, &mut Keys)> {
        let own = (&mut self.output.interval, &mut self.keys);
        self.has_default_interval.then_some(own)
    }
}

/// The keys of a scene; a file stands for its content, and what depends on other keys by default is written out.
fn keys(root: &Table, table: &DeTable, folder: &Path, scene: &Scene) -> Result<Keys> {
    let mut keys = Keys::of(&root.source(), table);
    keys.set("output.interval", &format!("{:?}", scene.output.interval));
    if let Some(name) = root.optional_text(BODIES_FILE)? {
        let content = std::fs::read(folder.join(name)).unwrap_or_default();
        keys.set_file(BODIES_FILE, name, &content);
    }
    Ok(keys)
}
