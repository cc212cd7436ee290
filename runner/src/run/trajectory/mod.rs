//! Frames of a trajectory, for ParaView (VTK) and OVITO (extended XYZ).

mod extxyz;
mod list;
mod vtk;

use super::dem;
use super::folder::write_soon;
use super::table::Table;
use crate::error::Error;
use crate::scene::{Scene, Trajectory};
use gouge_common::geometry::{Domain, Vec2};
use gouge_dem::World;
use std::ffi::OsStr;
use std::fs::File;
use std::path::{Path, PathBuf};

/// Folder of the frames, inside the output folder.
pub const FOLDER: &str = "trajectory";

/// The content of a frame, for any model.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Time in s.
    pub time: f64,
    /// The box.
    pub domain: Domain,
    /// Positions of the particles in m.
    pub positions: Vec<Vec2>,
    /// Shapes of the particles.
    pub shapes: Shapes,
    /// Columns of vectors.
    pub vectors: Vec<(&'static str, Vec<Vec2>)>,
    /// Columns of numbers, labels and categories.
    pub scalars: Table,
    /// Pairs of particles between which a line is drawn.
    pub lines: Vec<(usize, usize)>,
}

/// Shapes of all particles.
#[derive(Clone, Debug, PartialEq)]
pub enum Shapes {
    /// Discs of the given radii in m.
    Discs(Vec<f64>),
}

impl Frame {
    /// The radii of discs.
    fn radii(&self) -> &[f64] {
        let Shapes::Discs(radii) = &self.shapes;
        radii
    }
}

/// The frames of a run.
#[derive(Debug)]
pub struct Frames {
    folder: PathBuf,
    /// Files that are not safe from a power failure yet.
    unsafe_files: Vec<PathBuf>,
}

impl Frames {
    /// The frames of a run that has written a number of samples; none if the scene has no trajectory.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn open(scene: &Scene, folder: &Path, samples: u64) -> Result<Option<Self>, Error> {
        if scene.output.trajectory == Trajectory::None {
            return Ok(None);
        }
        let folder = folder.join(FOLDER);
        std::fs::create_dir_all(&folder).map_err(|error| Error::file("create", &folder, error))?;
        if scene.output.trajectory == Trajectory::Vtk {
            list::write(scene, &folder, samples)?;
        }
        Ok(Some(Self {
            folder,
            unsafe_files: Vec::new(),
        }))
    }

    /// Write the frame of a sample.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(&mut self, scene: &Scene, sample: u64, world: &World) -> Result<(), Error> {
        let frame = dem::frame(scene, world);
        let (ending, text) = match scene.output.trajectory {
            Trajectory::Extxyz => ("xyz", extxyz::text(&frame)),
            Trajectory::None | Trajectory::Vtk => ("vtk", vtk::text(&frame)?),
        };
        let path = self.folder.join(format!("frame_{sample:06}.{ending}"));
        write_soon(&path, text.as_bytes())?;
        self.unsafe_files.push(path);
        if scene.output.trajectory == Trajectory::Vtk {
            list::append(scene, &self.folder, sample)?;
        }
        Ok(())
    }

    /// Make all frames safe from a power failure.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn sync(&mut self) -> Result<(), Error> {
        for path in self.unsafe_files.drain(..) {
            let synced = File::open(&path).and_then(|file| file.sync_all());
            synced.map_err(|error| Error::file("write", &path, error))?;
        }
        Ok(())
    }
}

/// Whether a file in the folder of the frames has a name that a run gives.
pub fn is_frame(name: &OsStr) -> bool {
    let Some(name) = name.to_str() else {
        return false;
    };
    let number = name
        .strip_suffix(".vtk")
        .or_else(|| name.strip_suffix(".xyz"))
        .and_then(|name| name.strip_prefix("frame_"));
    let is_number = |text: &str| text.len() >= 6 && text.bytes().all(|byte| byte.is_ascii_digit());
    name == list::NAME || number.is_some_and(is_number)
}
