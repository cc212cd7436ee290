//! Samples of the scene proper: rows of the series and frames of the trajectory.

use super::scene_run::SceneRun;
use super::series::Sample;
use super::{Warning, dem};
use crate::error::Error;
use crate::scene::{Measure, Scene};
use gouge_dem::estimators::Energy;
use gouge_dem::{StepError, World};
use std::borrow::Cow;

impl SceneRun<'_> {
    /// Write a sample of the current state.
    pub(super) fn write_sample(&mut self) -> Result<(), Error> {
        let refreshed = self.world.refresh_neighbors();
        let checked = refreshed.and_then(|()| match self.world.check() {
            // Nothing has moved yet: the initial state is written, and the first step will fail.
            Err(StepError::TooFast { .. }) if self.world.steps() == 0 => Ok(()),
            checked => checked,
        });
        checked.map_err(|source| self.step_error(source))?;
        let evaluated =
            evaluated(self.scene, &self.world).map_err(|source| self.step_error(source))?;
        let energy = self.scene.output.energy.then(|| self.world.energy());
        let displacements = self.displacements.as_ref();
        let sample = dem::sample(
            self.scene,
            &self.world,
            &evaluated,
            energy.as_ref(),
            displacements,
        );
        let drive = *evaluated.drive();
        if let Some(name) = dem::infinite_energy(&sample) {
            return Err(Error::Energy {
                phase: self.context.present_phase().name.clone(),
                name,
                time: self.world.time(),
            });
        }
        if self.scene.regular_sample_step(self.context.samples) > self.world.steps() {
            self.before_early_sample = Some(self.progress());
        }
        self.judge_step();
        if let Some(energy) = &energy {
            self.watch_balance(energy);
        }
        if self.scene.driving.is_some() {
            let drive = dem::drive_sample(&self.world, &drive);
            self.drive_samples.extend(drive);
        }
        self.last_good.clone_from(self.world.state());
        self.context.lock.check()?;
        self.append(&sample)?;
        let since = self.context.samples.checked_sub(1);
        let since = since.map_or(0, |before| self.scene.sample_step(before));
        let links = dem::number_of_bonds(&self.world) + self.world.number_of_contacts();
        self.link_steps += links as f64 * (self.world.steps() - since) as f64;
        self.context.count_sample(self.world.time());
        Ok(())
    }

    /// Append a sample of the current state to all outputs that grow.
    fn append(&mut self, sample: &Sample) -> Result<(), Error> {
        self.write_breaks()?;
        let (scene, world) = (self.scene, &self.world);
        let Some(files) = &mut self.files else {
            return Ok(());
        };
        let frame = || {
            let links = scene.output.links;
            let links = links.then(|| dem::link_frame(scene, world));
            (dem::frame(scene, world), links)
        };
        files.write(self.context.samples, sample, frame, || dem::grains(world))
    }

    /// Warn that the energy balance cannot be trusted, because its residual is too large beside some energy in J.
    pub(super) fn warn_of_balance(&mut self, scale: f64, what: &'static str) {
        self.context.warn(Warning::Balance {
            time: self.world.time(),
            residual: self.balance.residual,
            scale,
            what,
        });
    }

    /// Warn at the first sample whose energy balance cannot be trusted.
    fn watch_balance(&mut self, energy: &Energy) {
        if self.balance.watch(&self.world, energy) {
            self.warn_of_balance(self.balance.largest, "its largest term");
        }
    }
}

/// A sample of a world in the scene proper, without strains, which depend on the past.
///
/// # Errors
/// Forces that cannot be evaluated.
pub fn sample_of(scene: &Scene, world: &World) -> Result<Sample, Error> {
    let evaluated = evaluated(scene, world).map_err(|source| Error::Step {
        phase: "run".to_owned(),
        source,
    })?;
    let energy = scene.output.energy.then(|| world.energy());
    Ok(dem::sample(scene, world, &evaluated, energy.as_ref(), None))
}

/// The world with the forces in its present state, if a sample needs them. If they are not evaluated yet, they are
/// evaluated in a copy: the evaluation may break bonds, which belongs to the next step and not to this sample.
fn evaluated<'a>(scene: &Scene, world: &'a World) -> Result<Cow<'a, World>, StepError> {
    let measure = &scene.output.measure;
    let needs_forces = scene.driving.is_some() || measure.contains(&Measure::UnbalancedForce);
    if !needs_forces || !world.is_pending() {
        return Ok(Cow::Borrowed(world));
    }
    let mut ahead = world.clone();
    ahead.evaluate_if_pending()?;
    Ok(Cow::Owned(ahead))
}
