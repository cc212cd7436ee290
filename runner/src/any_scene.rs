//! A scene of any model, for commands that serve all of them.

use crate::error::Error;
use crate::run::{
    Observer, RunOptions, Summary, Table, links_of, phases, run_setup, series_columns,
};
use crate::scene::{Keys, Overrides, Scene, SceneFile, SceneText};
use crate::{commands, contact_dynamics, peridem, run};
use std::path::{Path, PathBuf};

/// A scene of any model.
#[derive(Clone, Debug)]
pub enum AnyScene {
    /// `model = "dem"`.
    Dem(Box<Scene>),
    /// `model = "contact-dynamics"`.
    ContactDynamics(Box<contact_dynamics::Scene>),
    /// `model = "peridem"`.
    Peridem(Box<peridem::Scene>),
}

impl AnyScene {
    /// Read a scene file, or a built-in scene by its name, with some keys overridden.
    ///
    /// # Errors
    /// An unreadable file, or any mistake in it.
    pub fn load_with(name: impl AsRef<Path>, overrides: &Overrides) -> Result<Self, Error> {
        Self::read(&SceneFile::load(name)?, overrides)
    }

    /// Read a scene from the bytes of a file; its CSV files are read from `folder`.
    ///
    /// # Errors
    /// Any mistake in it.
    pub fn parse_with(
        file: &str,
        bytes: &[u8],
        folder: &Path,
        overrides: &Overrides,
    ) -> Result<Self, Error> {
        Self::read(&SceneFile::new(file, bytes, folder), overrides)
    }

    fn read(file: &SceneFile, overrides: &Overrides) -> Result<Self, Error> {
        Ok(match file.model(overrides)? {
            "contact-dynamics" => {
                let scene = contact_dynamics::Scene::read(file, overrides)?;
                Self::ContactDynamics(Box::new(scene))
            }
            "peridem" => Self::Peridem(Box::new(peridem::Scene::read(file, overrides)?)),
            _ => Self::Dem(Box::new(Scene::read(file, overrides)?)),
        })
    }

    /// The scene, if it is one of the thesis's model.
    ///
    /// # Errors
    /// A scene of another model, which `what` cannot use.
    pub fn dem(self, what: &str) -> Result<Scene, Error> {
        let (file, model) = match self {
            Self::Dem(scene) => return Ok(*scene),
            Self::ContactDynamics(scene) => (scene.file, "contact-dynamics"),
            Self::Peridem(scene) => (scene.file, "peridem"),
        };
        Err(Error::Argument(format!(
            "{file}: model = \"{model}\": {what} needs a scene with model = \"dem\""
        )))
    }

    /// The scene, if it is one of the thesis's model.
    pub fn as_dem(&self) -> Option<&Scene> {
        match self {
            Self::Dem(scene) => Some(scene),
            Self::ContactDynamics(_) | Self::Peridem(_) => None,
        }
    }

    /// The scene, if it is one of the thesis's model.
    pub fn into_dem(self) -> Option<Scene> {
        match self {
            Self::Dem(scene) => Some(*scene),
            Self::ContactDynamics(_) | Self::Peridem(_) => None,
        }
    }

    /// Run the scene, write its outputs into a folder, report what happens to an observer, and return the summary.
    ///
    /// # Errors
    /// As [`run::run`].
    pub fn run(
        &self,
        folder: &Path,
        options: RunOptions,
        observer: &mut dyn Observer,
    ) -> Result<Summary, Error> {
        match self {
            Self::Dem(scene) => run::run(scene, folder, options, observer),
            Self::ContactDynamics(scene) => contact_dynamics::run(scene, folder, options, observer),
            Self::Peridem(scene) => peridem::run(scene, folder, options, observer),
        }
    }

    /// Every pair that interacts at t = 0; of contact dynamics, the contact points of the first step; of peridynamic
    /// grains, all bonds and contacts of nodes.
    ///
    /// # Errors
    /// Scenes that the kernel refuses.
    pub fn links(&self) -> Result<Table, Error> {
        match self {
            Self::Dem(scene) => Ok(links_of(&run_setup(scene)?)),
            Self::ContactDynamics(scene) => contact_dynamics::contacts(scene),
            Self::Peridem(scene) => peridem::links(scene),
        }
    }

    /// The time-step bounds of the scene, as JSON.
    ///
    /// # Errors
    /// Scenes that the kernel refuses.
    pub fn stability(&self) -> Result<String, Error> {
        match self {
            Self::Dem(scene) => commands::stability(scene),
            Self::ContactDynamics(scene) => contact_dynamics::stability(scene),
            Self::Peridem(scene) => peridem::stability(scene),
        }
    }

    fn text(&self) -> &dyn SceneText {
        match self {
            Self::Dem(scene) => &**scene,
            Self::ContactDynamics(scene) => &**scene,
            Self::Peridem(scene) => &**scene,
        }
    }

    /// All files that were read.
    pub fn files(&self) -> &[PathBuf] {
        self.text().files()
    }

    /// All keys with their values.
    pub fn keys(&self) -> &Keys {
        self.text().keys()
    }

    /// End time in s.
    pub fn end(&self) -> f64 {
        self.text().end()
    }

    /// SHA-256 of the file and the overrides.
    pub fn sha256(&self) -> &str {
        match self {
            Self::Dem(scene) => &scene.sha256,
            Self::ContactDynamics(scene) => &scene.sha256,
            Self::Peridem(scene) => &scene.sha256,
        }
    }

    /// Number of steps of a run, those of its set-up included; of a compaction, the largest number.
    pub fn steps(&self) -> u64 {
        match self {
            Self::Dem(scene) => phases(scene).iter().map(|phase| phase.steps).sum(),
            Self::ContactDynamics(scene) => scene.steps(),
            Self::Peridem(scene) => scene.schedule().steps(),
        }
    }

    /// Number of samples of a run.
    pub fn samples(&self) -> f64 {
        match self {
            Self::Dem(scene) => scene.end / scene.output.interval,
            Self::ContactDynamics(scene) => scene.end / scene.output.interval,
            Self::Peridem(scene) => scene.end / scene.output.interval,
        }
    }

    /// Whether runs measure contact networks.
    pub fn measures_network(&self) -> bool {
        match self {
            Self::Dem(_) | Self::Peridem(_) => false,
            Self::ContactDynamics(scene) => scene.measures_network(),
        }
    }

    /// Columns of the series of a run.
    pub fn series_columns(&self) -> Vec<&'static str> {
        match self {
            Self::Dem(scene) => series_columns(scene),
            Self::ContactDynamics(scene) => contact_dynamics::series_columns(scene),
            Self::Peridem(scene) => peridem::series_columns(scene),
        }
    }
}
