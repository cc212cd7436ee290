//! Frames of a trajectory, for ParaView (VTK) and OVITO (extended XYZ).

mod dump;
mod extxyz;
mod list;
mod vtk;

use super::folder::write_soon;
use super::page::ANIMATION;
use super::table::Table;
use crate::error::Error;
use crate::scene::Trajectory;
use gouge_common::geometry::{Domain, Vec2};
use std::ffi::OsStr;
use std::fs::File;
use std::path::{Path, PathBuf};

/// Folder of the frames, inside the output folder.
pub const FOLDER: &str = "trajectory";

/// Beginning and ending of the names of frames.
const KINDS: [(&str, &str); 4] = [
    ("frame", "vtk"),
    ("frame", "xyz"),
    ("links", "vtk"),
    ("links", "dump"),
];

/// The content of a frame, for any model.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Time in s.
    pub time: f64,
    /// What a reader should know besides; empty if there is nothing.
    pub note: String,
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
    /// Polygons: the radii of their circumscribed circles, and their corners, both in m. Discs have many corners.
    Polygons(Vec<f64>, Vec<Vec<Vec2>>),
    /// Nodes of meshes: the radii in m of discs with their areas, and triangles of nodes.
    Nodes(Vec<f64>, Vec<[u32; 3]>),
}

impl Frame {
    /// The radii of discs or of circumscribed circles.
    fn radii(&self) -> &[f64] {
        let (Shapes::Discs(radii) | Shapes::Polygons(radii, _) | Shapes::Nodes(radii, _)) =
            &self.shapes;
        radii
    }
}

/// All contacts and bonds at the time of a frame.
#[derive(Clone, Debug, PartialEq)]
pub struct LinkFrame {
    /// Time in s.
    pub time: f64,
    /// Number of steps.
    pub steps: u64,
    /// Whether the box is periodic in x.
    pub is_periodic: bool,
    /// Lower left and upper right corner of all that is shown, in m.
    pub bounds: [Vec2; 2],
    /// The centre of i, and that of j or of its nearest image, in m.
    pub segments: Vec<[Vec2; 2]>,
    /// Their data, in the same order.
    pub links: Table,
}

/// What frames a run writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FramePlan {
    /// Format of the frames.
    pub trajectory: Trajectory,
    /// Whether each is accompanied by one of the contacts and bonds.
    pub has_links: bool,
}

/// The frames of a run.
#[derive(Debug)]
pub struct Frames {
    plan: FramePlan,
    folder: PathBuf,
    /// Files that are not safe from a power failure yet.
    unsafe_files: Vec<PathBuf>,
}

impl Frames {
    /// The frames of a run that has written samples at the given times in s; none if there is no trajectory.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn open(plan: &FramePlan, folder: &Path, times: &[f64]) -> Result<Option<Self>, Error> {
        if plan.trajectory == Trajectory::None {
            return Ok(None);
        }
        let folder = folder.join(FOLDER);
        std::fs::create_dir_all(&folder).map_err(|error| Error::file("create", &folder, error))?;
        for list in lists(plan) {
            list::write(list, &folder, times)?;
        }
        Ok(Some(Self {
            plan: *plan,
            folder,
            unsafe_files: Vec::new(),
        }))
    }

    /// Write the frame of a sample, and that of its links if the plan has them.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(
        &mut self,
        sample: u64,
        frame: &Frame,
        links: Option<&LinkFrame>,
    ) -> Result<(), Error> {
        let is_vtk = self.plan.trajectory == Trajectory::Vtk;
        let (ending, text) = match is_vtk {
            true => ("vtk", vtk::text(frame)?),
            false => ("xyz", extxyz::text(frame)),
        };
        self.put(&format!("frame_{sample:06}.{ending}"), &text)?;
        if let Some(links) = links {
            let (ending, text) = match is_vtk {
                true => ("vtk", vtk::links(links)?),
                false => ("dump", dump::text(links)),
            };
            self.put(&format!("links_{sample:06}.{ending}"), &text)?;
        }
        for list in lists(&self.plan) {
            list::append(list, &self.folder, (sample, frame.time))?;
        }
        Ok(())
    }

    fn put(&mut self, name: &str, text: &str) -> Result<(), Error> {
        let path = self.folder.join(name);
        write_soon(&path, text.as_bytes())?;
        self.unsafe_files.push(path);
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

/// The lists of frames that a run needs.
fn lists(plan: &FramePlan) -> impl Iterator<Item = list::List> + use<> {
    let is_vtk = plan.trajectory == Trajectory::Vtk;
    let grains = is_vtk.then_some(list::GRAINS);
    let links = (is_vtk && plan.has_links).then_some(list::LINKS);
    grains.into_iter().chain(links)
}

/// Whether a file in the folder of the frames has a name that a run gives.
pub fn is_frame(name: &OsStr) -> bool {
    let Some(name) = name.to_str() else {
        return false;
    };
    let parts = name.split_once('_').zip(name.rsplit_once('.'));
    let is_numbered = parts.is_some_and(|((kind, number), (_, ending))| {
        let number = number
            .strip_suffix(ending)
            .and_then(|rest| rest.strip_suffix('.'));
        let is_number =
            |text: &str| text.len() >= 6 && text.bytes().all(|byte| byte.is_ascii_digit());
        number.is_some_and(is_number) && KINDS.contains(&(kind, ending))
    });
    is_numbered || [list::GRAINS.0, list::LINKS.0, ANIMATION].contains(&name)
}
