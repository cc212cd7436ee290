//! Samples of the scene proper: rows of the series and frames of the trajectory.

use super::scene_run::SceneRun;
use super::{Event, Warning, dem};
use crate::error::Error;
use gouge_dem::estimators::Energy;
use gouge_dem::{Drive, StepError};

impl SceneRun<'_> {
    /// Write a sample of the current state.
    pub(super) fn sample(&mut self) -> Result<(), Error> {
        let refreshed = self.world.refresh_neighbors();
        let checked = refreshed.and_then(|()| match self.world.check() {
            // Nothing has moved yet: the initial state is written, and the first step will fail.
            Err(StepError::TooFast { .. }) if self.world.steps() == 0 => Ok(()),
            checked => checked,
        });
        checked.map_err(|source| self.step_error(source))?;
        let drive = self.present_drive()?;
        let energy = self.scene.output.energy.then(|| self.world.energy());
        let sample = dem::sample(self.scene, &self.world, &drive, energy.as_ref());
        if let Some(name) = dem::infinite_energy(&sample) {
            return Err(Error::Energy {
                phase: self.phases[self.phase].name.clone(),
                name,
                time: self.world.time(),
            });
        }
        if self.scene.regular_sample_step(self.samples) > self.world.steps() {
            self.before_early_sample = Some((self.balance, self.warnings.clone()));
        }
        self.judge_step();
        if let Some(energy) = &energy {
            self.watch_balance(energy);
        }
        self.last_good.clone_from(self.world.state());
        if let Some(series) = &mut self.series {
            series.write(&sample)?;
        }
        if let Some(frames) = &mut self.frames {
            frames.write(self.scene, self.samples, &self.world)?;
        }
        self.observer.event(Event::SampleWritten {
            sample: self.samples,
            time: self.world.time(),
        });
        let steps = self.scene.sample_step(self.samples + 1);
        let links = dem::number_of_bonds(&self.world) + self.world.number_of_contacts();
        self.link_steps += links as f64 * steps.saturating_sub(self.world.steps()) as f64;
        self.samples += 1;
        Ok(())
    }

    /// Warn at the first sample whose energy balance cannot be trusted.
    fn watch_balance(&mut self, energy: &Energy) {
        if self.balance.watch(energy) {
            self.warn(Warning::Balance {
                time: self.world.time(),
                residual: energy.residual,
                largest: self.balance.largest,
            });
        }
    }

    /// The driving force and the reaction force in the current state. If forces are not evaluated yet, they are
    /// evaluated in a copy: the evaluation may break bonds, which belongs to the next step and not to this sample.
    fn present_drive(&self) -> Result<Drive<f64>, Error> {
        if self.scene.driving.is_none() || !self.world.is_pending() {
            return Ok(*self.world.drive());
        }
        let mut ahead = self.world.clone();
        ahead
            .evaluate_if_pending()
            .map_err(|source| self.step_error(source))?;
        Ok(*ahead.drive())
    }
}
