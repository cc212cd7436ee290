//! The outputs that grow while a run goes on.

use super::context::RunContext;
use super::folder::SERIES;
use super::page::{Animation, Grain};
use super::series::{Sample, Series};
use super::trajectory::{Frame, FramePlan, Frames, LinkFrame};
use crate::error::Error;
use crate::scene::Schedule;

/// Which outputs grow.
pub struct GrowthPlan<'a> {
    /// Columns of the series.
    pub columns: &'a [&'a str],
    /// File and columns of a second table.
    pub table: Option<(&'a str, &'a [&'a str])>,
    /// Frames of the trajectory.
    pub frames: FramePlan,
    /// When samples are due.
    pub schedule: Schedule,
    /// Number of bodies that the motion on the page shows.
    pub bodies: usize,
}

/// The outputs that grow.
pub struct GrowingFiles {
    series: Series,
    /// A second table, if the run has one.
    pub table: Option<Series>,
    frames: Option<Frames>,
    animation: Option<Animation>,
}

impl GrowingFiles {
    /// Begin the outputs, or continue them after the samples of a run and a number of bytes of the series and of the table.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn open(
        context: &RunContext,
        plan: &GrowthPlan,
        bytes: Option<[u64; 2]>,
    ) -> Result<Self, Error> {
        let (folder, samples) = (&context.folder, context.samples);
        let [series, table] = [0, 1].map(|place| bytes.map(|bytes| bytes[place]));
        let times: Vec<f64> = (0..samples)
            .map(|sample| plan.schedule.sample_time(sample))
            .collect();
        let open_table = |(name, columns)| Series::open(folder.join(name), columns, table);
        let series = Series::open(folder.join(SERIES), plan.columns, series)?;
        let table = plan.table.map(open_table).transpose()?;
        let frames = Frames::open(&plan.frames, folder, &times)?;
        let animation = match &frames {
            Some(_) if !context.options.data_only => Animation::open(folder, samples, plan.bodies)?,
            _ => None,
        };
        Ok(Self {
            series,
            table,
            frames,
            animation,
        })
    }

    /// Append a sample to the series, the trajectory and the motion on the page.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(
        &mut self,
        number: u64,
        sample: &Sample,
        frame: impl FnOnce() -> (Frame, Option<LinkFrame>),
        motion: impl FnOnce() -> Vec<Grain>,
    ) -> Result<(), Error> {
        self.series.write(sample)?;
        if let Some(frames) = &mut self.frames {
            let (frame, links) = frame();
            frames.write(number, &frame, links.as_ref())?;
        }
        if let Some(animation) = &mut self.animation {
            animation.write(&motion())?;
        }
        Ok(())
    }

    /// Make all rows and frames safe from a power failure, and return the bytes of the series and of the table.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn sync(&mut self) -> Result<[u64; 2], Error> {
        self.series.sync()?;
        if let Some(table) = &self.table {
            table.sync()?;
        }
        if let Some(frames) = &mut self.frames {
            frames.sync()?;
        }
        if let Some(animation) = &self.animation {
            animation.sync()?;
        }
        let table = self.table.as_ref().map_or(0, Series::bytes);
        Ok([self.series.bytes(), table])
    }
}
