//! Outputs at the end of a finished or failed run: the summary, the final particles and a picture.

use super::folder::{PARTICLES, SUMMARY, remove_restart, write_whole};
use super::friction::Friction;
use super::scene_run::SceneRun;
use super::{dem, page, picture, restart, stress_strain};
use crate::build::COMMIT;
use crate::error::Error;
use crate::scene::Scene;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::path::Path;

/// Status of a finished run.
const DONE: &str = "done";
/// Status of a finished run whose energy balance cannot be trusted.
pub const UNTRUSTED: &str = "untrusted";
/// Status of a run that was stopped by the user.
const INTERRUPTED: &str = "interrupted";
/// Beginning of the status of a run that an error of the model stopped.
const FAILED: &str = "failed: ";

/// `summary.json`: what a run says about itself when it ends.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Summary {
    /// `done`, `untrusted`, `interrupted`, or the error that stopped the run.
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
    /// Number of particles times steps of the scene proper, divided by its wall time in s.
    pub particle_steps_per_second: f64,
    /// Number of contacts and bonds, summed over the steps of the scene proper, divided by its wall time in s.
    pub link_steps_per_second: f64,
    /// Version of the program.
    pub version: String,
    /// The commit from which it was built, as [`crate::build::COMMIT`] says.
    #[serde(default)]
    pub commit: String,
    /// SHA-256 of the scene file and its overrides.
    pub scene_sha256: String,
    /// Terms of the energy balance in J; absent if the scene does not keep it.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub energy: Option<serde_json::Map<String, serde_json::Value>>,
    /// Columns of the series.
    pub series_columns: Vec<String>,
    /// The warnings of the run.
    #[serde(default)]
    pub warnings: Vec<String>,
    /// Whether the energy balance was watched.
    #[serde(default)]
    pub balance_watched: bool,
    /// The largest residual of the balance in any sample, in units of the energy exchanged; absent if the
    /// balance was not watched.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub balance_error: Option<f64>,
    /// Friction of a driven block; absent if nothing slides.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub friction: Option<Friction>,
    /// Means over the contact networks of the second half of a run of contact dynamics, if the scene measures them.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub network: Option<serde_json::Map<String, serde_json::Value>>,
    /// Mode, damage, cracks and limits of the step of a run of peridynamic grains.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub peridem: Option<serde_json::Map<String, serde_json::Value>>,
    /// Number of times the neighbour list was built; resuming a run builds it once more.
    #[serde(default)]
    pub neighbor_rebuilds: u64,
}

impl Summary {
    /// Status of a finished run.
    pub const DONE: &str = DONE;

    /// Status of a run that was interrupted, or that an error of the model stopped.
    pub fn failed(error: &Error) -> String {
        match error.is_interruption() {
            true => INTERRUPTED.to_owned(),
            false => format!("{FAILED}{error}"),
        }
    }

    /// The summary of the run in a folder.
    ///
    /// # Errors
    /// A file that cannot be read or is not a summary.
    pub fn read(folder: &Path) -> Result<Self, Error> {
        let path = folder.join(SUMMARY);
        let read =
            || -> std::io::Result<Self> { Ok(serde_json::from_slice(&std::fs::read(&path)?)?) };
        read().map_err(|error| Error::file("read", &path, error))
    }

    /// Whether the run finished.
    pub fn is_finished(&self) -> bool {
        [DONE, UNTRUSTED].contains(&self.status.as_str())
    }

    /// The most important means over the contact networks of the second half of a run, as names and texts.
    pub fn network_lines(&self) -> Vec<(&'static str, String)> {
        const SHOWN: [(&str, &str); 4] = [
            ("q/p", "stress_ratio"),
            ("solid fraction", "solid_fraction"),
            ("coordination", "coordination"),
            ("side-side share", "side_side"),
        ];
        let line = |(name, key): (&'static str, &str)| {
            let mean = self.network.as_ref()?.get(key)?.as_f64()?;
            Some((name, format!("{mean:.4}, mean over the second half")))
        };
        SHOWN.into_iter().filter_map(line).collect()
    }

    /// Mode, damage, cracks and step of a run of peridynamic grains, as names and texts.
    pub fn peridem_lines(&self) -> Vec<(&'static str, String)> {
        let Some(own) = &self.peridem else {
            return Vec::new();
        };
        let number = |key: &str| own.get(key).and_then(Value::as_f64).unwrap_or(f64::NAN);
        let mode = own.get("mode").and_then(Value::as_str).unwrap_or_default();
        let state = format!(
            "{} grains in {} pieces, bulk damage {:.4}",
            number("grains"),
            number("pieces"),
            number("bulk_damage")
        );
        let step = number("step_over_smallest_limit");
        let crack = |crack: &Value| {
            let number = |key: &str| crack.get(key)?.as_f64();
            let (angle, length) = (number("angle")?.to_degrees(), number("length")?);
            let text = format!("{length:.4e} m long, at {angle:.2} degrees from the x axis");
            Some(("crack", text))
        };
        let cracks = own.get("cracks").and_then(Value::as_array);
        let mut lines = vec![
            ("mode", mode.to_owned()),
            ("state", state),
            ("time step", format!("{step:.2} of the smallest limit")),
        ];
        lines.extend(cracks.into_iter().flatten().filter_map(crack));
        lines
    }

    /// Whether the user stopped the run.
    pub fn is_interrupted(&self) -> bool {
        self.status == INTERRUPTED
    }

    /// Whether an error of the model stopped the run.
    pub fn is_failed(&self) -> bool {
        self.status.starts_with(FAILED)
    }

    /// Whether the run finished without anything to show because its first state could not be made.
    pub fn is_stillborn(&self) -> bool {
        self.is_failed() && self.particles == 0
    }

    /// The summary of a run of which nothing is known but the hash of its scene, whether the balance is watched, and its
    /// status.
    pub fn empty(scene_sha256: &str, balance_watched: bool, status: String) -> Self {
        Self {
            status,
            steps: 0,
            time: 0.0,
            particles: 0,
            bonds_initial: 0,
            bonds_broken: 0,
            wall_seconds: 0.0,
            particle_steps_per_second: 0.0,
            link_steps_per_second: 0.0,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            commit: COMMIT.to_owned(),
            scene_sha256: scene_sha256.to_owned(),
            energy: None,
            series_columns: Vec::new(),
            warnings: Vec::new(),
            balance_watched,
            balance_error: None,
            friction: None,
            network: None,
            peridem: None,
            neighbor_rebuilds: 0,
        }
    }

    /// What ended a run early, if its outputs can be written all the same.
    ///
    /// # Errors
    /// What ended it, if not.
    pub fn early_end(ended: Result<(), Error>) -> Result<Option<Error>, Error> {
        match ended {
            Ok(()) => Ok(None),
            Err(error) if error.is_interruption() || error.is_of_state() => Ok(Some(error)),
            Err(error) => Err(error),
        }
    }

    /// Write that a run could not begin.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write_stillborn(scene: &Scene, folder: &Path, error: &Error) -> Result<(), Error> {
        let status = Self::failed(error);
        Self::empty(&scene.sha256, scene.output.energy, status).write(folder)
    }

    /// Write the summary into a folder.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(&self, folder: &Path) -> Result<(), Error> {
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
    pub fn complete(mut self) -> Result<Summary, Error> {
        let failure = Summary::early_end(self.run_phases())?;
        let neighbor_rebuilds = self.rebuilds();
        match &failure {
            Some(error) if error.is_of_state() => {
                self.world = self.world.with_state(self.last_good.clone());
            }
            _ => self.write_checkpoint()?,
        }
        let status = match &failure {
            None => self.judge(),
            Some(error) => Summary::failed(error),
        };
        self.context.report_end();
        let summary = Summary {
            neighbor_rebuilds,
            ..self.summary(status)
        };
        self.write_outcome(&summary)?;
        failure.map_or(Ok(summary), Err)
    }

    /// The status of a finished run, with a warning if its balance cannot be trusted.
    fn judge(&mut self) -> String {
        if self.balance.conclude() {
            self.warn_of_balance(self.balance.scale(), "the energy exchanged");
        }
        match self.balance.is_off {
            true => UNTRUSTED.to_owned(),
            false => DONE.to_owned(),
        }
    }

    fn write_outcome(&self, summary: &Summary) -> Result<(), Error> {
        let (scene, world, folder) = (self.scene, &self.world, &self.context.folder);
        self.context.lock.check()?;
        let particles = dem::particles(scene, world.particles());
        write_whole(&folder.join(PARTICLES), particles.to_csv().as_bytes())?;
        picture::write(folder, scene, world, self.balance.is_off)?;
        if self.context.is_main() {
            restart::write_bonds(folder, world)?;
            match summary.is_failed() {
                // What led to the failure is in its last state, too.
                true => remove_restart(folder)?,
                false if self.context.options.data_only => {}
                false => restart::write_restart(folder, scene, world)?,
            }
        }
        if !self.context.options.data_only {
            stress_strain::write(folder)?;
            page::write(folder, scene, world, summary)?;
        }
        summary.write(folder)
    }

    fn summary(&self, status: String) -> Summary {
        let (scene, world) = (self.scene, &self.world);
        let [wall_seconds, main] = self.context.seconds();
        let (steps, time) = if self.context.is_main() {
            (world.steps(), world.time())
        } else {
            (0, 0.0)
        };
        let number = world.particles().len();
        let rate = |amount: f64| if main > 0.0 { amount / main } else { 0.0 };
        let bonds = dem::number_of_bonds(world);
        let columns = dem::series_columns(scene);
        Summary {
            steps,
            time,
            particles: number,
            bonds_initial: self.bonds_initial,
            bonds_broken: self.bonds_initial.saturating_sub(bonds),
            wall_seconds,
            particle_steps_per_second: rate(number as f64 * steps as f64),
            link_steps_per_second: rate(self.link_steps),
            energy: scene.output.energy.then(|| dem::energies(world)),
            series_columns: columns.into_iter().map(str::to_owned).collect(),
            warnings: self.context.warnings.lines().map(str::to_owned).collect(),
            balance_watched: scene.output.energy,
            balance_error: scene.output.energy.then(|| self.balance.ratio()),
            friction: Friction::of(&self.drive_samples, mean(&world.particles().radius)),
            ..Summary::empty(&scene.sha256, scene.output.energy, status)
        }
    }
}

fn mean(numbers: &[f64]) -> f64 {
    numbers.iter().sum::<f64>() / numbers.len() as f64
}
