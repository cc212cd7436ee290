//! The outputs of a run: those that grow with every sample, and those at its end.

use super::super::{Means, Scene};
use super::contacts::table_of_points;
use super::directions;
use super::frame;
use super::samples::{self, columns};
use super::scene_run::SceneRun;
use super::statistics::Statistics;
use super::{page, picture};
use crate::error::Error;
use crate::run::folder::{
    CONTACTS, DIRECTIONS, DIRECTIONS_TABLE, NETWORK, PARTICLES, PICTURE, SERIES, write_whole,
};
use crate::run::page::Animation;
use crate::run::series::{Sample, Series};
use crate::run::trajectory::{FramePlan, Frames};
use crate::run::{Event, RunOptions, Summary, Warning};
use gouge_contact_dynamics::observables::Network;
use gouge_contact_dynamics::world::World;
use std::path::Path;

/// The outputs that grow with every sample.
pub struct Files {
    series: Series,
    network: Option<Series>,
    frames: Option<Frames>,
    animation: Option<Animation>,
    buffer: Network,
}

impl Files {
    /// Begin the outputs, or continue them after a number of samples and of bytes.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn open(
        scene: &Scene,
        folder: &Path,
        options: RunOptions,
        samples: u64,
        bytes: Option<[u64; 2]>,
    ) -> Result<Self, Error> {
        let [series, network] = [0, 1].map(|place| bytes.map(|bytes| bytes[place]));
        let plan = FramePlan {
            trajectory: scene.output.trajectory,
            has_links: false,
        };
        let schedule = scene.schedule();
        let times: Vec<f64> = (0..samples)
            .map(|sample| schedule.sample_time(sample))
            .collect();
        let frames = Frames::open(&plan, folder, &times)?;
        let animation = match &frames {
            Some(_) if !options.data_only => {
                Animation::open(folder, samples, scene.number_of_bodies())?
            }
            _ => None,
        };
        Ok(Self {
            series: Series::open(folder.join(SERIES), &columns(scene), series)?,
            network: open_network(scene, folder, network)?,
            frames,
            animation,
            buffer: Network::new(),
        })
    }

    /// Append a sample to all of them.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(
        &mut self,
        scene: &Scene,
        world: &World,
        number: u64,
        sample: &Sample,
    ) -> Result<(), Error> {
        self.series.write(sample)?;
        // Before the first step there is no network.
        if let Some(network) = self.network.as_mut().filter(|_| world.steps() > 0) {
            let statistics = Statistics::of(scene, world, &mut self.buffer);
            let times = [world.time()];
            let numbers = times.into_iter().chain(statistics.values());
            let cells: Vec<String> = numbers.map(|number| format!("{number:?}")).collect();
            network.append_row(&cells)?;
        }
        if let Some(frames) = &mut self.frames {
            frames.write(number, &frame::frame(scene, world), None)?;
        }
        if let Some(animation) = &mut self.animation {
            animation.write(&frame::grains(scene, world))?;
        }
        Ok(())
    }

    /// Make all rows and frames safe from a power failure, and return the bytes of the series and of the network.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn sync(&mut self) -> Result<[u64; 2], Error> {
        self.series.sync()?;
        if let Some(network) = &self.network {
            network.sync()?;
        }
        if let Some(frames) = &mut self.frames {
            frames.sync()?;
        }
        if let Some(animation) = &self.animation {
            animation.sync()?;
        }
        let network = self.network.as_ref().map_or(0, Series::bytes);
        Ok([self.series.bytes(), network])
    }
}

fn open_network(scene: &Scene, folder: &Path, bytes: Option<u64>) -> Result<Option<Series>, Error> {
    if !scene.measures_network() {
        return Ok(None);
    }
    let names = Statistics::names();
    let names: Vec<&str> = ["time"]
        .into_iter()
        .chain(names.iter().map(String::as_str))
        .collect();
    Series::open(folder.join(NETWORK), &names, bytes).map(Some)
}

impl SceneRun<'_> {
    /// Write the final outputs of a run whose phases ended in some way, and return its summary.
    ///
    /// # Errors
    /// What ended the run, or a failure of the file system.
    pub fn complete(mut self, ended: Result<(), Error>) -> Result<Summary, Error> {
        let status = match &ended {
            Ok(()) => self.judge(),
            Err(error) if error.is_interruption() => Summary::INTERRUPTED.to_owned(),
            Err(error) if error.is_of_state() => Summary::failed(error),
            Err(_) => return ended.map(|()| self.summary(String::new())),
        };
        if !Summary::is_failure(&status) {
            self.write_checkpoint()?;
        }
        self.observer.event(Event::Ended);
        let mut summary = self.summary(status);
        self.lock.check()?;
        let write = |name, text: String| write_whole(&self.folder.join(name), text.as_bytes());
        write(PARTICLES, frame::particles_csv(self.scene, &self.world))?;
        let means = means(self.scene, &self.folder, summary.time);
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
        if !self.options.data_only {
            page::write(&self.folder, self.scene, &self.world, directions, &summary)?;
        }
        summary.write(&self.folder)?;
        ended.map(|()| summary)
    }

    /// The status of a finished run, with warnings of what is doubtful.
    fn judge(&mut self) -> String {
        let all = self.all_steps();
        let share = |number: u64| number as f64 / all.steps.max(1) as f64;
        let steps = all.steps;
        if share(all.unconverged) > DOUBTFUL {
            let number = all.unconverged;
            self.warn(Warning::Unconverged { number, steps });
        }
        if share(all.large_overlaps) > DOUBTFUL {
            let number = all.large_overlaps;
            self.warn(Warning::LargeOverlaps { number, steps });
        }
        let error = samples::balance_error(&self.world, self.kinetic);
        if let Some(error) = error.filter(|&error| error > BALANCE) {
            self.warn(Warning::Imbalance(error));
            return crate::run::UNTRUSTED.to_owned();
        }
        match share(all.unconverged) > UNTRUSTED_SHARE {
            true => crate::run::UNTRUSTED.to_owned(),
            false => Summary::DONE.to_owned(),
        }
    }

    fn summary(&self, status: String) -> Summary {
        let (scene, world) = (self.scene, &self.world);
        let [wall_seconds, main] = self.seconds();
        let is_main = self.is_main();
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
            warnings: self.warnings.lines().map(str::to_owned).collect(),
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
