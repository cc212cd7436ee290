//! The outputs that grow with every sample.

use super::super::Scene;
use super::frame;
use super::mesh::Cells;
use super::samples::columns;
use crate::error::Error;
use crate::run::RunOptions;
use crate::run::folder::{BREAKS, SERIES};
use crate::run::page::Animation;
use crate::run::series::{Sample, Series};
use crate::run::trajectory::{FramePlan, Frames};
use gouge_peridem::world::World;
use std::path::Path;

/// Columns of the file of broken bonds: nodes are counted from the first of the grain.
const BREAK_COLUMNS: [&str; 5] = ["step", "time", "grain", "i", "j"];

/// The outputs that grow.
pub struct Files {
    series: Series,
    breaks: Series,
    frames: Option<Frames>,
    animation: Option<Animation>,
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
        world: &World,
        (samples, bytes): (u64, Option<[u64; 2]>),
    ) -> Result<Self, Error> {
        let [series, breaks] = [0, 1].map(|place| bytes.map(|bytes| bytes[place]));
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
                Animation::open(folder, samples, world.grains().nodes())?
            }
            _ => None,
        };
        Ok(Self {
            series: Series::open(folder.join(SERIES), &columns(scene), series)?,
            breaks: Series::open(folder.join(BREAKS), &BREAK_COLUMNS, breaks)?,
            frames,
            animation,
        })
    }

    /// Append a sample to all of them.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(
        &mut self,
        scene: &Scene,
        (world, cells): (&World, &[Cells]),
        number: u64,
        sample: &Sample,
    ) -> Result<(), Error> {
        self.series.write(sample)?;
        if let Some(frames) = &mut self.frames {
            frames.write(number, &frame::frame(scene, world, cells), None)?;
        }
        if let Some(animation) = &mut self.animation {
            animation.write(&frame::nodes(world))?;
        }
        Ok(())
    }

    /// Append the bonds that broke in a step.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write_breaks(&mut self, rows: &[Vec<String>]) -> Result<(), Error> {
        self.breaks.append_rows(rows)
    }

    /// Make all rows and frames safe from a power failure, and return the bytes of the series and of the broken bonds.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn sync(&mut self) -> Result<[u64; 2], Error> {
        self.series.sync()?;
        self.breaks.sync()?;
        if let Some(frames) = &mut self.frames {
            frames.sync()?;
        }
        if let Some(animation) = &self.animation {
            animation.sync()?;
        }
        Ok([self.series.bytes(), self.breaks.bytes()])
    }
}
