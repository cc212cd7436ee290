//! Checkpoints, from which `--resume` continues: written completely or not at all, and checked before use.
//!
//! Between the ends that all checkpoints have (`sealed.rs`) are the progress of the run, the keys of the scene, and the
//! state as the tag of its model and named columns.

use super::balance::Balance;
use super::bytes::{Reader, put_record, put_text, put_words};
use super::displacements::Displacements;
use super::fingerprint::{Fingerprint, Kinship};
use super::folder::write_whole;
use super::friction::DriveSample;
use super::phases::{PhaseKind, phase_model, phases};
use super::sealed;
use crate::contact_dynamics;
use crate::error::Error;
use crate::machine::with_chosen_execution;
use crate::peridem;
use crate::scene::{Keys, Scene};
use gouge_common::geometry::Vec2;
use gouge_common::record::Record;
use gouge_dem::World;
use std::path::Path;

/// Why a state is refused that is whole, but not one of the scene.
pub(crate) const UNFIT: &str = "its state does not fit the scene";
/// Number of words of the progress of the run.
const HEAD: usize = 7;

/// Progress and state of a run at one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Position of the phase.
    pub phase: u64,
    /// Samples written.
    pub samples: u64,
    /// Bytes of the series written.
    pub series_bytes: u64,
    /// Bytes of the file of broken bonds written.
    pub breaks_bytes: u64,
    /// Bonds at the beginning of the scene proper.
    pub bonds_initial: u64,
    /// Wall time so far in s, of the whole run and of the scene proper.
    pub seconds: [f64; 2],
    /// Sum of the number of contacts and bonds over all steps of the scene proper so far.
    pub link_steps: f64,
    /// Number of times the neighbour list was built so far.
    pub rebuilds: u64,
    /// What the samples so far say about the energy balance.
    pub balance: Balance,
    /// What the samples so far say about the drive.
    pub drive_samples: Vec<DriveSample>,
    /// Displacements since t = 0, if the scene measures strains.
    pub displacements: Option<Displacements>,
    /// The warnings so far, one per line.
    pub warnings: String,
    /// The keys of the scene.
    pub keys: Keys,
    /// The state.
    pub state: Record,
}

impl Checkpoint {
    /// Write to a temporary file, then rename it to the given path.
    ///
    /// # Errors
    /// Failures of the file system; the earlier checkpoint then still exists.
    pub fn write(&self, path: &Path, fingerprint: &Fingerprint) -> Result<(), Error> {
        let mut bytes = sealed::begin(fingerprint);
        let head = [
            self.phase,
            self.samples,
            self.series_bytes,
            self.bonds_initial,
            self.seconds[0].to_bits(),
            self.seconds[1].to_bits(),
            self.link_steps.to_bits(),
        ];
        put_words(&mut bytes, &head);
        put_words(&mut bytes, &[self.rebuilds, self.breaks_bytes]);
        self.balance.put(&mut bytes);
        put_words(&mut bytes, &[self.drive_samples.len() as u64]);
        for sample in &self.drive_samples {
            put_words(&mut bytes, &sample.numbers().map(f64::to_bits));
        }
        Displacements::put(self.displacements.as_ref(), &mut bytes);
        put_text(&mut bytes, &self.keys.to_text());
        put_text(&mut bytes, &self.warnings);
        put_record(&mut bytes, &self.state);
        write_whole(path, &sealed::seal(bytes))
    }

    /// Read a checkpoint from a file, and whether it belongs to a scene.
    ///
    /// # Errors
    /// A file that cannot be read or is damaged.
    pub fn read(path: &Path, scene: &Scene) -> Result<(Self, Kinship), Error> {
        let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        Self::parse(&bytes, scene).map_err(|reason| refusal(path, reason))
    }

    /// Read a checkpoint from the bytes of a file, and whether it belongs to a scene.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(bytes: &[u8], scene: &Scene) -> Result<(Self, Kinship), &'static str> {
        let (fingerprint, mut rest) = sealed::open(bytes)?;
        let head = rest.words(HEAD as u64).unwrap_or_default();
        let [
            phase,
            samples,
            series_bytes,
            bonds_initial,
            whole,
            main,
            link_steps,
        ] = head[..]
        else {
            return Err("it is damaged: its beginning is missing");
        };
        let rest = Rest::read(rest).ok_or_else(|| unfit(bytes))?;
        let kinship = Kinship::of(scene, fingerprint, &rest.keys);
        let saved = Self {
            phase,
            samples,
            series_bytes,
            bonds_initial,
            seconds: [whole, main].map(f64::from_bits),
            link_steps: f64::from_bits(link_steps),
            rebuilds: rest.rebuilds,
            breaks_bytes: rest.breaks_bytes,
            balance: rest.balance,
            drive_samples: rest.drive_samples,
            displacements: rest.displacements,
            warnings: rest.warnings,
            keys: rest.keys,
            state: rest.state,
        };
        Ok((saved, kinship))
    }

    /// The world in the stored state.
    ///
    /// # Errors
    /// Columns that are not a state of the scene in a phase of this kind.
    pub fn world(&self, path: &Path, scene: &Scene, kind: PhaseKind) -> Result<World, Error> {
        let world = world_of_record(scene, kind, &self.state);
        world.ok_or_else(|| refusal(path, UNFIT))
    }

    /// The displacements to the positions of the stored state, if there are any.
    ///
    /// # Errors
    /// Displacements of another number of particles.
    pub fn displacements(
        &self,
        path: &Path,
        positions: &[Vec2],
    ) -> Result<Option<Displacements>, Error> {
        let Some(stored) = self.displacements.clone() else {
            return Ok(None);
        };
        let continued = stored.continued(positions);
        continued.map(Some).ok_or_else(|| refusal(path, UNFIT))
    }
}

/// What follows the head.
struct Rest {
    rebuilds: u64,
    breaks_bytes: u64,
    balance: Balance,
    drive_samples: Vec<DriveSample>,
    displacements: Option<Displacements>,
    keys: Keys,
    warnings: String,
    state: Record,
}

impl Rest {
    fn read(mut rest: Reader) -> Option<Self> {
        Some(Self {
            rebuilds: rest.word()?,
            breaks_bytes: rest.word()?,
            balance: Balance::read(&mut rest)?,
            drive_samples: drive_samples(&mut rest)?,
            displacements: Displacements::read(&mut rest)?,
            keys: Keys::of_text(&rest.text()?),
            warnings: rest.text()?,
            state: rest.record().filter(|_| rest.0.is_empty())?,
        })
    }
}

fn drive_samples(rest: &mut Reader) -> Option<Vec<DriveSample>> {
    let number = rest.word()?;
    let words = rest.words(number.checked_mul(5)?)?;
    let (samples, _) = words.as_chunks();
    let sample = |words: &[u64; 5]| DriveSample::of_numbers(words.map(f64::from_bits));
    Some(samples.iter().map(sample).collect())
}

/// Why a whole checkpoint is refused whose content is not one of the model of the scene.
pub(crate) fn unfit(bytes: &[u8]) -> &'static str {
    let is_read = |is_saved: fn(Reader) -> bool| {
        let opened = sealed::open(bytes);
        opened.is_ok_and(|(_, content)| is_saved(content))
    };
    match () {
        () if is_read(is_saved) => "it is of a scene with model = \"dem\"",
        () if is_read(contact_dynamics::is_saved) => {
            "it is of a scene with model = \"contact-dynamics\""
        }
        () if is_read(peridem::is_saved) => "it is of a scene with model = \"peridem\"",
        () => UNFIT,
    }
}

/// Whether the content of a checkpoint is one of this model.
fn is_saved(mut content: Reader) -> bool {
    content.words(HEAD as u64).is_some() && Rest::read(content).is_some()
}

pub(crate) fn refusal(path: &Path, reason: &str) -> Error {
    Error::Checkpoint {
        path: path.to_owned(),
        reason: reason.to_owned(),
    }
}

/// The world in the bytes of a checkpoint of a scene.
///
/// # Errors
/// What is wrong with the bytes, or why they do not belong to the scene.
pub fn world_of_checkpoint(bytes: &[u8], scene: &Scene) -> Result<World, String> {
    let (saved, kinship) = Checkpoint::parse(bytes, scene)?;
    if let Kinship::Other(reason) = kinship {
        return Err(reason);
    }
    let phases = phases(scene);
    let phase = (saved.phase as usize).min(phases.len() - 1);
    world_of_record(scene, phases[phase].kind, &saved.state).ok_or_else(|| UNFIT.to_owned())
}

/// The world of a scene in a recorded state of a phase of this kind; none if the record is not such a state.
pub fn world_of_record(scene: &Scene, kind: PhaseKind, record: &Record) -> Option<World> {
    // The area of driving depends on the radii, which are known only from the state.
    let bare = World::from_record(phase_model(scene, kind, &[0.0]), record)?;
    let model = phase_model(scene, kind, &bare.particles().radius);
    World::from_record(model, record).map(with_chosen_execution)
}
