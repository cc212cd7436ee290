//! Comparison of a run with data of another program.

mod dump;
mod quantities;
mod read;
mod table;

pub use read::{Data, Frame, Kind, When, read};

use crate::error::Error;
use crate::run::{Event, Observer, Phase, begin_phase, named, phases};
use crate::scene::Scene;
use gouge_dem::World;
use quantities::Quantities;
use std::fmt::Write;

/// Number of steps between reports of progress.
const CHUNK: u64 = 256;
/// Largest distance of a time from a multiple of the time step, in units of the step, that is taken for rounding.
const ROUNDING: f64 = 1e-3;

/// How data are compared.
#[derive(Clone, Debug)]
pub struct Options {
    /// Time step of the other program in s, if its data count steps; absent: the step of the scene.
    pub step: Option<f64>,
    /// Largest difference that is accepted, in units of the range of the column.
    pub tolerance: f64,
    /// Tolerances of single columns, which replace the common one.
    pub tolerances: Vec<(String, f64)>,
    /// Differences in SI units that are accepted whatever the range of a column.
    pub absolute: Vec<(String, f64)>,
    /// The columns that are compared; all that both sides have if empty.
    pub columns: Vec<String>,
}

/// The largest difference of a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The column.
    pub name: String,
    /// Its unit.
    pub unit: &'static str,
    /// The largest absolute difference.
    pub largest: f64,
    /// Difference of the largest and the smallest value of the other program, or the largest magnitude if all are
    /// equal.
    pub range: f64,
    /// Time of the largest difference in s.
    pub time: f64,
    /// The particle with the largest difference; none if the column describes the whole run.
    pub particle: Option<usize>,
    /// The largest difference that is accepted, in units of the range.
    pub tolerance: f64,
    /// The largest difference that is accepted whatever the range, in SI units.
    pub absolute: f64,
}

impl Difference {
    /// The largest difference in units of the range.
    pub fn relative(&self) -> f64 {
        match self.largest {
            0.0 => 0.0,
            largest => largest / self.range,
        }
    }

    /// Whether the difference is accepted.
    pub fn is_within(&self) -> bool {
        self.relative() <= self.tolerance || self.largest <= self.absolute
    }
}

/// Result of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The compared columns.
    pub differences: Vec<Difference>,
    /// Columns of the data that were not compared.
    pub ignored: Vec<String>,
    /// Number of times that were compared.
    pub times: usize,
    /// Fewest and most particles that were compared at a time, and their number in the scene; none if the data
    /// describe the whole run.
    pub particles: Option<[usize; 3]>,
}

/// Run a scene and compare it with data at all of their times.
///
/// # Errors
/// Times at which the run has no state, particles or columns that only one side has, or a run that fails.
pub fn compare(
    scene: &Scene,
    data: &Data,
    options: &Options,
    observer: &mut dyn Observer,
) -> Result<Comparison, Error> {
    let phases = phases(scene);
    let mut world = set_up(scene, &phases, observer)?;
    let quantities = Quantities::of(data, &options.columns, scene, &world)?;
    let mut differences = quantities.differences(data, options)?;
    let main = phases.len() - 1;
    observer.event(Event::PhaseBegan {
        phases: &named(&phases),
        index: main,
    });
    for frame in &data.frames {
        let step = step_of(scene, data, frame, options)?;
        advance(&mut world, step, &phases, main, observer)?;
        let ours = quantities.values(scene, &world)?;
        for (place, difference) in differences.iter_mut().enumerate() {
            let theirs = &frame.columns[quantities.column(place)];
            look(
                difference,
                frame,
                &ours[place],
                theirs,
                (scene, world.time()),
                data.first_id,
            )
            .map_err(|reason| refusal(data, &reason))?;
        }
    }
    observer.event(Event::Ended);
    Ok(Comparison {
        differences,
        ignored: quantities.ignored(data),
        times: data.frames.len(),
        particles: particles(data, world.particles().len()),
    })
}

fn particles(data: &Data, all: usize) -> Option<[usize; 3]> {
    let numbers = data
        .frames
        .iter()
        .filter_map(|frame| Some(frame.ids.as_ref()?.len()));
    let (fewest, most) = (numbers.clone().min()?, numbers.max()?);
    Some([fewest, most, all])
}

fn set_up(scene: &Scene, phases: &[Phase], observer: &mut dyn Observer) -> Result<World, Error> {
    let mut world = begin_phase(scene, phases, 0, None)?;
    for index in 0..phases.len() - 1 {
        observer.event(Event::PhaseBegan {
            phases: &named(phases),
            index,
        });
        advance(&mut world, phases[index].steps, phases, index, observer)?;
        world = begin_phase(scene, phases, index + 1, Some(world))?;
    }
    Ok(world)
}

fn advance(
    world: &mut World,
    last: u64,
    phases: &[Phase],
    phase: usize,
    observer: &mut dyn Observer,
) -> Result<(), Error> {
    while world.steps() < last {
        let until = last.min(world.steps() + CHUNK);
        crate::run::advance(world, until - world.steps(), &phases[phase].name)?;
        let steps = world.steps();
        observer.event(Event::Progress { phase, steps });
    }
    Ok(())
}

/// The step of a scene at the time of a frame.
fn step_of(scene: &Scene, data: &Data, frame: &Frame, options: &Options) -> Result<u64, Error> {
    let time = match frame.when {
        When::End => scene.steps() as f64 * scene.step,
        When::Time(time) => time,
        When::Step(step) => step as f64 * options.step.unwrap_or(scene.step),
    };
    let (exact, last) = (time / scene.step, scene.steps());
    let nearest = exact.round();
    if !(nearest >= 0.0 && nearest <= last as f64) {
        let end = last as f64 * scene.step;
        let reason = format!("time {time:?} s: must be from 0 to the end of the run, {end:?} s");
        return Err(refusal(data, &reason));
    }
    if (exact - nearest).abs() > ROUNDING {
        let reason = format!(
            "time {time:?} s: must be a multiple of time.step = {:?}; --set time.step=... changes that",
            scene.step
        );
        return Err(refusal(data, &reason));
    }
    Ok(nearest as u64)
}

/// Keep the largest difference of a frame.
fn look(
    difference: &mut Difference,
    frame: &Frame,
    ours: &[f64],
    theirs: &[f64],
    (scene, time): (&Scene, f64),
    first_id: usize,
) -> Result<(), String> {
    for (row, &their) in theirs.iter().enumerate() {
        let particle = frame.ids.as_ref().map(|ids| ids[row]);
        let place = particle.unwrap_or(0);
        let &our = ours.get(place).ok_or_else(|| {
            let (first, last) = (first_id, (first_id + ours.len()).saturating_sub(1));
            format!(
                "id {}: must be from {first} to {last}, as the scene has {} particles",
                place + first_id,
                ours.len()
            )
        })?;
        let mut distance = (our - their).abs();
        if let Some(width) = scene.domain.period().filter(|_| difference.name == "x") {
            let rest = distance.rem_euclid(width);
            distance = rest.min(width - rest);
        }
        let both_undefined = our.is_nan() && their.is_nan();
        let distance = match distance.is_nan() {
            true if both_undefined => 0.0,
            true => f64::INFINITY,
            false => distance,
        };
        if distance > difference.largest {
            (difference.largest, difference.time) = (distance, time);
            difference.particle = particle;
        }
    }
    Ok(())
}

fn refusal(data: &Data, reason: &str) -> Error {
    Error::Argument(format!("{}: {reason}", data.file))
}

impl Comparison {
    /// Whether all differences are accepted.
    pub fn is_within(&self) -> bool {
        self.differences.iter().all(Difference::is_within)
    }

    /// The comparison as text: one line per column.
    pub fn text(&self) -> String {
        let mut text = format!(
            "{:18}{:>22}{:>14}{:>12}{:>16}{:>10}\n",
            "column", "largest difference", "of its range", "tolerance", "at time / s", "particle"
        );
        for one in &self.differences {
            let particle = one.particle.map_or_else(String::new, |i| i.to_string());
            let _ = writeln!(
                text,
                "{:18}{:>22}{:>14.2e}{:>12.1e}{:>16.6e}{:>10}  {}",
                one.name,
                format!("{:.3e} {}", one.largest, one.unit),
                one.relative(),
                one.tolerance,
                one.time,
                particle,
                if one.is_within() { "within" } else { "OUTSIDE" },
            );
        }
        let _ = writeln!(text, "times compared: {}", self.times);
        match self.particles {
            Some([fewest, most, all]) if fewest == most => {
                let _ = writeln!(text, "particles compared: {most} of {all}");
            }
            Some([fewest, most, all]) => {
                let _ = writeln!(text, "particles compared: {fewest} to {most} of {all}");
            }
            None => {}
        }
        if !self.ignored.is_empty() {
            let _ = writeln!(text, "not compared: {}", self.ignored.join(", "));
        }
        text
    }
}
