//! The outputs at the end of a run.

use super::super::{Means, Scene};
use super::contacts::table_of_points;
use super::samples::{self, columns};
use super::scene_run::SceneRun;
use super::{directions, frame, page, picture};
use crate::error::Error;
use crate::run::folder::{CONTACTS, DIRECTIONS, DIRECTIONS_TABLE, PARTICLES, PICTURE, write_whole};
use crate::run::{Summary, UNTRUSTED, Warning};
use std::path::Path;

impl SceneRun<'_> {
    /// Run all remaining phases, including the current one, write the final outputs, and return the summary.
    ///
    /// # Errors
    /// What ended the run, or a failure of the file system.
    pub fn complete(mut self) -> Result<Summary, Error> {
        let failure = Summary::early_end(self.run_phases())?;
        if failure.as_ref().is_none_or(Error::is_interruption) {
            self.write_checkpoint()?;
        }
        let status = match &failure {
            None => self.judge(),
            Some(error) => Summary::failed(error),
        };
        self.context.report_end();
        let mut summary = self.summary(status);
        self.context.lock.check()?;
        let write =
            |name, text: String| write_whole(&self.context.folder.join(name), text.as_bytes());
        write(PARTICLES, frame::particles_csv(self.scene, &self.world))?;
        let means = means(self.scene, &self.context.folder, summary.time);
        let directions = means
            .as_ref()
            .map(|means| directions::draw(means).to_string());
        if let (Some(means), Some(picture)) = (&means, &directions) {
            write(DIRECTIONS_TABLE, directions::table(means).to_csv())?;
            write(DIRECTIONS, picture.clone())?;
        }
        summary.network = means.as_ref().map(named);
        write(CONTACTS, table_of_points(self.scene, &self.world).to_csv())?;
        write(PICTURE, picture::draw(self.scene, &self.world).to_string())?;
        if !self.context.options.data_only {
            page::write(
                &self.context.folder,
                self.scene,
                &self.world,
                directions,
                &summary,
            )?;
        }
        summary.write(&self.context.folder)?;
        failure.map_or(Ok(summary), Err)
    }

    /// The status of a finished run, with warnings of what is doubtful.
    fn judge(&mut self) -> String {
        let all = self.all_steps();
        let share = |number: u64| number as f64 / all.steps.max(1) as f64;
        let steps = all.steps;
        if share(all.unconverged) > DOUBTFUL {
            let number = all.unconverged;
            self.context.warn(Warning::Unconverged { number, steps });
        }
        if share(all.large_overlaps) > DOUBTFUL {
            let number = all.large_overlaps;
            self.context.warn(Warning::LargeOverlaps { number, steps });
        }
        let error = samples::balance_error(&self.world, self.kinetic);
        if let Some(error) = error.filter(|&error| error > BALANCE) {
            self.context.warn(Warning::Imbalance(error));
            return UNTRUSTED.to_owned();
        }
        match share(all.unconverged) > UNTRUSTED_SHARE {
            true => UNTRUSTED.to_owned(),
            false => Summary::DONE.to_owned(),
        }
    }

    fn summary(&self, status: String) -> Summary {
        let (scene, world) = (self.scene, &self.world);
        let [wall_seconds, main] = self.context.seconds();
        let is_main = self.context.is_main();
        let steps = if is_main { world.steps() } else { 0 };
        let rate = |amount: f64| if main > 0.0 { amount / main } else { 0.0 };
        let number = world.assembly().shape.len();
        let energies = samples::energies(world, self.kinetic).filter(|_| is_main);
        let energies = energies.map(|terms| {
            let terms = terms.into_iter();
            terms
                .map(|(name, energy)| (name.to_owned(), energy.into()))
                .collect()
        });
        let columns = columns(scene).into_iter().map(str::to_owned);
        Summary {
            steps,
            time: steps as f64 * scene.settings.time_step,
            particles: number,
            wall_seconds,
            particle_steps_per_second: rate(number as f64 * steps as f64),
            link_steps_per_second: rate(self.point_steps),
            energy: energies,
            series_columns: columns.collect(),
            warnings: self.context.warnings.lines().map(str::to_owned).collect(),
            balance_error: samples::balance_error(world, self.kinetic).filter(|_| is_main),
            ..Summary::empty(&scene.sha256, scene.output.energy, status)
        }
    }
}

/// Means over the second half of a run until a time in s.
fn means(scene: &Scene, folder: &Path, until: f64) -> Option<Means> {
    let is_measured = scene.measures_network();
    is_measured.then(|| Means::between(folder, 0.5 * until, until))?
}

fn named(means: &Means) -> serde_json::Map<String, serde_json::Value> {
    let all = means.all().into_iter();
    all.map(|(name, mean)| (name, mean.into())).collect()
}

/// Share of steps with large overlaps or without convergence that needs a warning.
const DOUBTFUL: f64 = 0.01;
/// Share of steps without convergence beyond which a run is not trusted.
const UNTRUSTED_SHARE: f64 = 0.5;
/// Largest residual of the balance that rounding explains, in parts of what was exchanged.
const BALANCE: f64 = 1e-9;
