//! The files that a run leaves: series, summary and final particles.

use super::checkpoint::write_whole;
use crate::error::Error;
use crate::scene::{Scene, role_name};
use gouge_dem::estimators::{Energy, fragments, friction_feedback, friction_load};
use gouge_dem::particles::Particles;
use gouge_dem::{Drive, World};
use serde::Serialize;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// Columns of the series of a scene.
pub fn columns(scene: &Scene) -> Vec<&'static str> {
    let mut columns = vec!["time"];
    if scene.output.energy {
        columns.extend(Energy::<f64>::NAMES);
    }
    if scene.driving.is_some() {
        columns.extend([
            "friction_load",
            "friction_feedback",
            "drive_force_x",
            "drive_force_y",
        ]);
    }
    if scene.bond.is_some() {
        columns.extend(["bonds", "fragments"]);
    }
    columns
}

/// One row of the series.
fn row(scene: &Scene, world: &World, drive: &Drive<f64>) -> String {
    let mut cells = vec![format!("{:?}", world.time())];
    if scene.output.energy {
        cells.extend(world.energy().values().map(|value| format!("{value:?}")));
    }
    if scene.driving.is_some() {
        let numbers = [
            friction_load(drive),
            friction_feedback(drive),
            drive.applied.x,
            drive.applied.y,
        ];
        cells.extend(numbers.map(|value| format!("{value:?}")));
    }
    if let Some(strong) = world.bonds() {
        cells.push(strong.len().to_string());
        cells.push(fragments(world.state()).number.to_string());
    }
    cells.join(",") + "\n"
}

/// The first energy of a world that is not finite, if its energies are written.
pub fn infinite_energy(scene: &Scene, world: &World) -> Option<&'static str> {
    let values = scene.output.energy.then(|| world.energy().values())?;
    let mut named = Energy::<f64>::NAMES.into_iter().zip(values);
    named
        .find(|(_, value)| !value.is_finite())
        .map(|(name, _)| name)
}

/// The file `series.csv` as it grows.
pub struct Series {
    path: PathBuf,
    file: File,
    bytes: u64,
}

impl Series {
    /// Begin a series, or go on after the first `bytes` of one.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn open(scene: &Scene, folder: &Path, bytes: Option<u64>) -> Result<Self, Error> {
        let path = folder.join("series.csv");
        let open = || -> std::io::Result<(File, u64)> {
            let Some(bytes) = bytes else {
                return Ok((File::create(&path)?, 0));
            };
            let mut file = File::options().write(true).open(&path)?;
            if file.metadata()?.len() < bytes {
                return Err(std::io::Error::other(
                    "it is shorter than when it was last written",
                ));
            }
            file.set_len(bytes)?;
            file.seek(SeekFrom::End(0))?;
            Ok((file, bytes))
        };
        let (file, bytes) = open().map_err(|error| Error::file("open", &path, error))?;
        let mut series = Self { path, file, bytes };
        if series.bytes == 0 {
            series.append(&(columns(scene).join(",") + "\n"))?;
        }
        Ok(series)
    }

    /// Bring what was appended to the disk.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn sync(&self) -> Result<(), Error> {
        let synced = self.file.sync_data();
        synced.map_err(|error| Error::file("write", &self.path, error))
    }

    /// Append a sample.
    ///
    /// # Errors
    /// Failures of the file system; what was there before is kept.
    pub fn sample(
        &mut self,
        scene: &Scene,
        world: &World,
        drive: &Drive<f64>,
    ) -> Result<(), Error> {
        self.append(&row(scene, world, drive))
    }

    fn append(&mut self, text: &str) -> Result<(), Error> {
        if let Err(error) = self.file.write_all(text.as_bytes()) {
            let _ = self.file.set_len(self.bytes);
            return Err(Error::file("write", &self.path, error));
        }
        self.bytes += text.len() as u64;
        Ok(())
    }

    /// Bytes written so far.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}

/// `particles.csv`: numbers printed so that reading them gives the same bits.
///
/// # Errors
/// Failures of the file system.
pub fn write_particles(folder: &Path, particles: &Particles) -> Result<(), Error> {
    let mut text = String::from("id,x,y,vx,vy,angle,angular_velocity,radius,role\n");
    for i in 0..particles.len() {
        let (x, v) = (particles.position[i], particles.velocity[i]);
        let (angle, omega) = (particles.angle[i], particles.angular_velocity[i]);
        let role = role_name(particles.role[i]);
        text += &format!(
            "{i},{:?},{:?},{:?},{:?},{angle:?},{omega:?},{:?},{role}\n",
            x.x, x.y, v.x, v.y, particles.radius[i]
        );
    }
    write_whole(&folder.join("particles.csv"), text.as_bytes())
}

/// `summary.json`.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// `done`, or what stopped the run.
    pub status: String,
    /// Steps of the scene proper.
    pub steps: u64,
    /// Time of the scene proper in s.
    pub time: f64,
    /// Number of particles.
    pub particles: usize,
    /// Bonds at t = 0.
    pub bonds_initial: usize,
    /// Bonds broken since.
    pub bonds_broken: usize,
    /// Wall time of the whole run in s, set-up included.
    pub wall_seconds: f64,
    /// Particles times steps of the scene proper over its wall time.
    pub particle_steps_per_second: f64,
    /// Links times steps of the scene proper over its wall time.
    pub link_steps_per_second: f64,
    /// Version of the program.
    pub version: &'static str,
    /// SHA-256 of the scene file.
    pub scene_sha256: String,
    /// Terms of the energy balance in J; absent where the scene books none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy: Option<serde_json::Map<String, serde_json::Value>>,
    /// Columns of the series.
    pub series_columns: Vec<&'static str>,
    /// How often the neighbour list was built since the run began or was resumed.
    pub neighbor_rebuilds: u64,
}

/// The energies of a world by name.
pub fn energies(world: &World) -> serde_json::Map<String, serde_json::Value> {
    let values = world.energy().values();
    Energy::<f64>::NAMES
        .iter()
        .zip(values)
        .map(|(name, value)| ((*name).to_owned(), serde_json::json!(value)))
        .collect()
}

/// Write `summary.json`.
///
/// # Errors
/// Failures of the file system.
pub fn write_summary(folder: &Path, summary: &Summary) -> Result<(), Error> {
    let path = folder.join("summary.json");
    let text = serde_json::to_string_pretty(summary)
        .map_err(|error| Error::file("write", &path, std::io::Error::other(error)))?;
    write_whole(&path, (text + "\n").as_bytes())
}

/// Bonds that can be drawn as lines between their grains: not those across the seam of a periodic box.
pub fn unbroken_lines(scene: &Scene, world: &World) -> impl Iterator<Item = (usize, usize)> {
    let position = &world.particles().position;
    let half = scene
        .domain
        .period()
        .map_or(f64::INFINITY, |width| 0.5 * width);
    let bonded = world.bonds().map_or(&[][..], |strong| strong.pairs());
    let pairs = bonded.iter().map(|pair| pair.indices());
    pairs.filter(move |&(i, j)| (position[i].x - position[j].x).abs() <= half)
}
