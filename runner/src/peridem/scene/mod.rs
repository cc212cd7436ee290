//! Scene files with `model = "peridem"`, read and checked completely.

mod contact;
mod grains;
mod materials;
mod output;
mod outline;
mod refusals;
mod size;

pub use contact::{ContactTable, WallTable};
pub use grains::{Form, GrainTable, Mesh, MeshKind};
pub use materials::{BondTable, Constants, MaterialTable};
pub use output::{CrackTable, MOST_CRACKS, Output};
pub use refusals::Refusals;

use crate::error::SceneError;
use crate::scene::table::Table;
use crate::scene::{Keys, MODELS, Overrides, SceneFile, SceneText, Schedule, gravity};
use gouge_common::geometry::Vec2;
use gouge_peridem::mode::Mode;
use std::path::{Path, PathBuf};
use toml::de::DeTable;

type Result<T> = std::result::Result<T, SceneError>;

/// A scene, complete and consistent.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Title.
    pub title: String,
    /// Reading of the source, from which defaults follow.
    pub mode: Mode,
    /// Time step in s.
    pub step: f64,
    /// End time in s.
    pub end: f64,
    /// Whether the time step may be above the limits.
    pub is_step_forced: bool,
    /// The materials, by name.
    pub materials: Vec<MaterialTable>,
    /// The bonds of all grains.
    pub bonds: BondTable,
    /// Contact between nodes, if nodes touch.
    pub contact: Option<ContactTable>,
    /// Straight walls.
    pub walls: Option<WallTable>,
    /// Acceleration in m/s² of all nodes.
    pub gravity: Vec2,
    /// The grains.
    pub grains: Vec<GrainTable>,
    /// Cracks whose directions and lengths are measured.
    pub cracks: Vec<CrackTable>,
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
    /// Errors for what is known only once the grains have nodes.
    pub refusals: Refusals,
}

const KEYS: [&str; 13] = [
    "title",
    "model",
    "mode",
    "time",
    "materials",
    "bonds",
    "mesh",
    "contact",
    "walls",
    "external",
    "grains",
    "cracks",
    "output",
];

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
        root.allow(&KEYS)?;
        let mode = root
            .optional_choice("mode", &Mode::ALL)?
            .unwrap_or_default();
        let time = root.table("time")?;
        time.allow(&["step", "end", "forced"])?;
        let (end, step) = time.duration_and_step("end")?;
        let materials = materials::materials(root)?;
        let bonds = materials::bonds(root, mode)?;
        let contact = contact::contact(root, mode)?;
        let tables = root.tables("grains")?;
        let surroundings = grains::Surroundings {
            root,
            folder,
            materials: &materials,
            horizon: bonds.horizon,
        };
        let grains = grains::grains(&tables, &surroundings)?;
        let grain_files = grains.iter().flat_map(GrainTable::files);
        let scene = Self {
            title: root.optional_text("title")?.unwrap_or_default().to_owned(),
            mode,
            step,
            end,
            is_step_forced: time.optional_truth("forced")?.unwrap_or(false),
            walls: contact::walls(root, mode, contact.as_ref())?,
            gravity: gravity(root)?,
            cracks: output::cracks(root, grains.len())?,
            output: output::output(root, end)?,
            has_default_interval: crate::scene::has_default_interval(root)?,
            file: root.source().file.to_owned(),
            files: [PathBuf::from(root.source().file)]
                .into_iter()
                .chain(grain_files.cloned())
                .collect(),
            sha256: String::new(),
            keys: Keys::default(),
            refusals: Refusals::of(root, &time, contact.as_ref(), &tables)?,
            materials,
            bonds,
            contact,
            grains,
        };
        scene.check(root, &tables)?;
        Ok(scene)
    }

    /// Whether the parts of the scene fit together.
    fn check(&self, root: &Table, tables: &[Table]) -> Result<()> {
        for (grain, table) in self.grains.iter().zip(tables) {
            let material = &self.materials[grain.material];
            let breaks = grain.is_breakable && self.bonds.breaking.is_some();
            if breaks && material.fracture_energy.is_none() {
                let accepted = format!(
                    "can break, but materials.{}.fracture_energy is missing; give it, or breakable = false, or \
                     bonds.breaking = \"none\"",
                    material.name
                );
                return Err(table.own_error(&accepted));
            }
            let constants = material.constants(&self.bonds);
            constants.map_err(|error| materials::refused(root, material, &error))?;
        }
        if let Some(contact) = &self.contact {
            contact::check_stiffness(root, contact, self)?;
        }
        size::check_bonds(root, self)
    }

    /// When a run takes samples.
    pub fn schedule(&self) -> Schedule {
        Schedule {
            step: self.step,
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
            refusals: Refusals::default(),
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

/// The keys of a scene; files stand for their content, and what depends on other keys by default is written out.
fn keys(root: &Table, table: &DeTable, folder: &Path, scene: &Scene) -> Result<Keys> {
    let mut keys = Keys::of(&root.source(), table);
    keys.set("output.interval", &format!("{:?}", scene.output.interval));
    for (grain, table) in root.tables("grains")?.iter().enumerate() {
        for key in grains::FILES {
            if let Some(name) = table.optional_text(key)? {
                let content = std::fs::read(folder.join(name)).unwrap_or_default();
                keys.set_file(&format!("grains[{grain}].{key}"), name, &content);
            }
        }
    }
    Ok(keys)
}
