//! Outputs at the end of a finished or failed run: the summary, the final particles and a picture.

use super::folder::{PARTICLES, SUMMARY, write_whole};
use super::scene_run::SceneRun;
use super::{Event, dem, picture};
use crate::error::Error;
use serde::Serialize;
use std::path::Path;

/// Status of a finished run.
pub const DONE: &str = "done";

/// `summary.json`.
#[derive(Clone, Debug, Serialize)]
struct Summary {
    /// `done`, `interrupted`, or the error that stopped the run.
    status: String,
    /// Steps of the scene proper.
    steps: u64,
    /// Time of the scene proper in s.
    time: f64,
    /// Number of particles.
    particles: usize,
    /// Bonds at t = 0.
    bonds_initial: usize,
    /// Bonds broken since.
    bonds_broken: usize,
    /// Wall time of the whole run in s, set-up included.
    wall_seconds: f64,
    /// Number of particles times steps of the scene proper, divided by its wall time in s.
    particle_steps_per_second: f64,
    /// Number of contacts and bonds, summed over the steps of the scene proper, divided by its wall time in s.
    link_steps_per_second: f64,
    /// Version of the program.
    version: &'static str,
    /// SHA-256 of the scene file.
    scene_sha256: String,
    /// Terms of the energy balance in J; absent if the scene does not keep it.
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<serde_json::Map<String, serde_json::Value>>,
    /// Columns of the series.
    series_columns: Vec<&'static str>,
    /// The warnings of the run.
    warnings: Vec<String>,
    /// Whether the energy balance was watched.
    balance_watched: bool,
    /// Number of times the neighbour list was built; resuming a run builds it once more.
    neighbor_rebuilds: u64,
}

impl Summary {
    fn write(&self, folder: &Path) -> Result<(), Error> {
        let path = folder.join(SUMMARY);
        let text = serde_json::to_string_pretty(self)
            .map_err(|error| Error::file("write", &path, std::io::Error::other(error)))?;
        write_whole(&path, (text + "\n").as_bytes())
    }
}

impl SceneRun<'_> {
    /// Run all remaining phases, including the current one, and write the final outputs. A run whose state became
    /// invalid writes its last valid state.
    ///
    /// # Errors
    /// A failure of the file system, or a state that becomes invalid.
    pub fn complete(mut self) -> Result<(), Error> {
        let outcome = self.run_phases();
        match &outcome {
            Ok(()) | Err(Error::Interrupted(_)) => self.write_checkpoint()?,
            Err(error) if !error.is_of_state() => return outcome,
            Err(_) => {}
        }
        self.observer.event(Event::Ended);
        let (seconds, rebuilds) = (self.seconds(), self.rebuilds());
        let status = match &outcome {
            Ok(()) => DONE.to_owned(),
            Err(Error::Interrupted(_)) => "interrupted".to_owned(),
            Err(error) => {
                self.world = self.world.with_state(self.last_good.clone());
                format!("failed: {error}")
            }
        };
        self.write_outcome(status, seconds, rebuilds)?;
        outcome
    }

    fn write_outcome(
        &self,
        status: String,
        [wall_seconds, main]: [f64; 2],
        neighbor_rebuilds: u64,
    ) -> Result<(), Error> {
        let (scene, world, folder) = (self.scene, &self.world, &self.folder);
        let particles = dem::particles(scene, world.particles());
        write_whole(&folder.join(PARTICLES), particles.to_csv().as_bytes())?;
        picture::write(folder, scene, world, self.balance.is_off)?;
        let (steps, time) = if self.is_main() {
            (world.steps(), world.time())
        } else {
            (0, 0.0)
        };
        let number = world.particles().len();
        let rate = |amount: f64| if main > 0.0 { amount / main } else { 0.0 };
        let summary = Summary {
            status,
            steps,
            time,
            particles: number,
            bonds_initial: self.bonds_initial,
            bonds_broken: self
                .bonds_initial
                .saturating_sub(dem::number_of_bonds(world)),
            wall_seconds,
            particle_steps_per_second: rate(number as f64 * steps as f64),
            link_steps_per_second: rate(self.link_steps),
            version: env!("CARGO_PKG_VERSION"),
            scene_sha256: scene.sha256.clone(),
            energy: scene.output.energy.then(|| dem::energies(world)),
            series_columns: dem::series_columns(scene, world),
            warnings: self.warnings.lines().map(str::to_owned).collect(),
            balance_watched: scene.output.energy,
            neighbor_rebuilds,
        };
        summary.write(folder)
    }
}
