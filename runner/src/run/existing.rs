//! What an output folder already holds, and what a new run does about it: it never replaces results unasked.

use super::checkpoint::Checkpoint;
use super::context::RunContext;
use super::fingerprint::{Fingerprint, Kinship};
use super::folder::{
    CHECKPOINT, PARTICLES, PICTURE, SERIES, SUMMARY, outputs, refuse_replacing_inputs,
};
use super::lock::Lock;
use super::outcome::Summary;
use super::{Event, NamedPhase, Observer, RunOptions};
use crate::error::Error;
use crate::scene::{Keys, Scene, SceneText};
use std::path::Path;

/// How a run begins.
#[derive(Debug)]
enum Beginning<C> {
    /// From the scene.
    Fresh,
    /// From a checkpoint of the same scene, possibly with an earlier end.
    Checkpoint(Box<C>),
    /// Not at all: the run is already complete, and this is its summary.
    Complete(Box<Summary>),
}

/// A checkpoint of the scenes of a model.
pub trait Saved<S>: Sized {
    /// Files that every finished run has.
    const RESULTS: &'static [&'static str] = &[SERIES, PARTICLES, PICTURE];

    /// Read a checkpoint from a file, and whether it belongs to a scene.
    ///
    /// # Errors
    /// A file that cannot be read or is damaged.
    fn read(path: &Path, scene: &S) -> Result<(Self, Kinship), Error>;

    /// The keys of its scene.
    fn keys(&self) -> &Keys;
}

impl Saved<Scene> for Checkpoint {
    fn read(path: &Path, scene: &Scene) -> Result<(Self, Kinship), Error> {
        Self::read(path, scene)
    }

    fn keys(&self) -> &Keys {
        &self.keys
    }
}

/// The scene with the interval between samples of the run in a folder, if the scene gives none and that run is one of
/// the same scene, possibly with an earlier end. So the end can be moved although the interval follows from it.
fn with_interval_of_earlier_run<S: SceneText + Clone, C: Saved<S>>(
    scene: &S,
    folder: &Path,
    options: RunOptions,
) -> Option<S> {
    let path = folder.join(CHECKPOINT);
    if options.overwrite || !path.exists() {
        return None;
    }
    let mut adapted = scene.clone();
    let (interval, keys) = adapted.default_interval()?;
    let (saved, _) = C::read(&path, scene).ok()?;
    *interval = saved.keys().number("output.interval")?;
    keys.set("output.interval", &format!("{interval:?}"));
    let (_, kinship) = C::read(&path, &adapted).ok()?;
    (!matches!(kinship, Kinship::Other(_))).then_some(adapted)
}

/// Lock a folder, decide how a run of a scene begins there, and let it go on: from a checkpoint if one is given.
///
/// # Errors
/// A folder that cannot be written or that another run is using, as [`beginning`], and as the run.
pub fn run_in_folder<S: SceneText + Clone, C: Saved<S>>(
    scene: &S,
    folder: &Path,
    options: RunOptions,
    observer: &mut dyn Observer,
    phases: Vec<NamedPhase>,
    go_on: impl for<'a> FnOnce(&'a S, RunContext<'a>, Option<C>) -> Result<Summary, Error>,
) -> Result<Summary, Error> {
    std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
    let lock = Lock::take(folder)?;
    refuse_replacing_inputs(scene, folder)?;
    let adapted = with_interval_of_earlier_run::<_, C>(scene, folder, options);
    let scene = adapted.as_ref().unwrap_or(scene);
    let saved = match beginning(scene, folder, options)? {
        Beginning::Complete(summary) => {
            observer.event(Event::AlreadyDone { folder });
            return Ok(*summary);
        }
        Beginning::Checkpoint(saved) => Some(*saved),
        Beginning::Fresh => None,
    };
    if saved.is_none() && options.resume {
        observer.event(Event::NothingToResume { folder });
    }
    let fingerprint = Fingerprint::of(scene);
    let context = RunContext::new((folder, &lock), options, observer, phases, fingerprint);
    go_on(scene, context, saved)
}

/// How a run of a scene begins in a folder.
///
/// # Errors
/// Outputs that the run would replace, nothing to resume from, or a failure of the file system.
fn beginning<S, C: Saved<S>>(
    scene: &S,
    folder: &Path,
    options: RunOptions,
) -> Result<Beginning<C>, Error> {
    let found = outputs(folder)?;
    if options.overwrite {
        return Ok(Beginning::Fresh);
    }
    let Some(first) = found.first() else {
        return Ok(Beginning::Fresh);
    };
    if found == [folder.join(SUMMARY)] && Summary::read(folder).is_ok_and(|one| one.is_stillborn())
    {
        return Ok(Beginning::Fresh);
    }
    let path = folder.join(CHECKPOINT);
    if !path.exists() {
        let trouble = match options.resume {
            true => "there is no checkpoint to resume from",
            false => "no checkpoint tells what made it",
        };
        let what = format!("{}, and {trouble}", first.display());
        return Err(refusal(folder, &what, ""));
    }
    let read = C::read(&path, scene);
    let (saved, kinship) = read.map_err(|error| match error {
        Error::Checkpoint { reason, .. } if !options.resume => {
            refusal(folder, &format!("a checkpoint, but {reason}"), "")
        }
        error => error,
    })?;
    let finished = Summary::read(folder).ok().filter(Summary::is_finished);
    match (kinship, finished) {
        (Kinship::Same, Some(summary)) => complete(folder, C::RESULTS, summary),
        (Kinship::Same | Kinship::Shorter(_), _) if options.resume => {
            Ok(Beginning::Checkpoint(Box::new(saved)))
        }
        (Kinship::Same, _) => Err(refusal(
            folder,
            "an unfinished run of this scene",
            "continue it with --resume, ",
        )),
        (Kinship::Shorter(end), _) => Err(refusal(
            folder,
            &format!("a run of this scene until {end:?} s"),
            "extend it with --resume, ",
        )),
        (Kinship::Other(reason), _) if options.resume => Err(Error::Checkpoint { path, reason }),
        (Kinship::Other(reason), _) => {
            let what = format!("another run, because {reason}");
            Err(refusal(folder, &what, ""))
        }
    }
}

fn refusal(folder: &Path, what: &str, advice: &str) -> Error {
    Error::Argument(format!(
        "{} holds {what}: {advice}choose another folder, or replace it with --overwrite",
        folder.display()
    ))
}

/// A finished run needs nothing, unless a part of its results was removed.
fn complete<C>(folder: &Path, results: &[&str], summary: Summary) -> Result<Beginning<C>, Error> {
    let missing = results.iter().find(|name| !folder.join(name).exists());
    match missing {
        None => Ok(Beginning::Complete(Box::new(summary))),
        Some(name) => Err(refusal(
            folder,
            &format!("the finished run of this scene, but without {name}"),
            "",
        )),
    }
}
