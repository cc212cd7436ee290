//! Frames of a trajectory, for ParaView (VTK) and OVITO (extended XYZ).

mod extxyz;
mod vtk;

use super::dem;
use super::folder::write_whole;
use super::table::Table;
use crate::error::Error;
use crate::scene::{Scene, Trajectory};
use gouge_common::geometry::{Domain, Vec2};
use gouge_dem::World;
use std::path::Path;

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

/// Write the frame of a sample, if the scene has a trajectory.
///
/// # Errors
/// Failures of the file system.
pub fn write_frame(scene: &Scene, folder: &Path, sample: u64, world: &World) -> Result<(), Error> {
    let frame = || dem::frame(scene, world);
    let (ending, text) = match scene.output.trajectory {
        Trajectory::None => return Ok(()),
        Trajectory::Vtk => ("vtk", vtk::text(&frame())?),
        Trajectory::Extxyz => ("xyz", extxyz::text(&frame())),
    };
    let frames = folder.join("trajectory");
    std::fs::create_dir_all(&frames).map_err(|error| Error::file("create", &frames, error))?;
    write_whole(
        &frames.join(format!("frame_{sample:06}.{ending}")),
        text.as_bytes(),
    )?;
    if scene.output.trajectory == Trajectory::Vtk {
        write_list(scene, &frames, sample)?;
    }
    Ok(())
}

/// Remove the frames of an earlier run, and nothing else.
///
/// # Errors
/// Failures of the file system.
pub fn remove_frames(folder: &Path) -> Result<(), Error> {
    let frames = folder.join("trajectory");
    let Ok(entries) = std::fs::read_dir(&frames) else {
        return Ok(());
    };
    for entry in entries.flatten() {
        let (path, name) = (entry.path(), entry.file_name());
        let name = name.to_string_lossy();
        if name.starts_with("frame_") || name.starts_with("run.vtk") {
            std::fs::remove_file(&path).map_err(|error| Error::file("replace", &path, error))?;
        }
    }
    // Fails, as intended, if the folder still contains other files.
    let _ = std::fs::remove_dir(&frames);
    Ok(())
}

/// Write the list of frames and their times, which ParaView opens as one animation.
fn write_list(scene: &Scene, frames: &Path, last: u64) -> Result<(), Error> {
    let entry = |sample: u64| {
        let time = (sample as f64 * scene.output.interval).min(scene.end);
        format!("    {{ \"name\": \"frame_{sample:06}.vtk\", \"time\": {time:?} }}")
    };
    let files: Vec<String> = (0..=last).map(entry).collect();
    let text = format!(
        "{{\n  \"file-series-version\": \"1.0\",\n  \"files\": [\n{}\n  ]\n}}\n",
        files.join(",\n")
    );
    write_whole(&frames.join("run.vtk.series"), text.as_bytes())
}
