//! Checkpoints of runs of contact dynamics.

use super::super::Scene;
use super::since::{Since, WORDS};
use crate::error::Error;
use crate::run::bytes::{Reader, put_record, put_text, put_words};
use crate::run::checkpoint::{refusal, unfit};
use crate::run::existing::Saved;
use crate::run::fingerprint::{Fingerprint, Kinship};
use crate::run::folder::write_whole;
use crate::run::sealed;
use crate::scene::Keys;
use gouge_common::record::Record;
use std::path::Path;

/// Progress and state of a run at one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Position of the phase.
    pub phase: u64,
    /// Samples written.
    pub samples: u64,
    /// Bytes of the series and of the sums over the network written.
    pub bytes: [u64; 2],
    /// Wall time so far in s, of the whole run and of the scene proper.
    pub seconds: [f64; 2],
    /// Number of contact points, summed over the steps of the scene proper.
    pub point_steps: f64,
    /// Kinetic energy in J at t = 0, and shear strain since then.
    pub beginning: [f64; 2],
    /// What the steps since the latest regular sample did, and those before it.
    pub since: [Since; 2],
    /// The warnings so far, one per line.
    pub warnings: String,
    /// The keys of the scene.
    pub keys: Keys,
    /// The cell that was compacted, once the scene proper has begun; it tells what is glued to the walls.
    pub compacted: Option<Record>,
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
        put_words(&mut bytes, &[self.phase, self.samples]);
        put_words(&mut bytes, &self.bytes);
        let [run, main] = self.seconds;
        let [kinetic, strain] = self.beginning;
        let numbers = [run, main, self.point_steps, kinetic, strain];
        put_words(&mut bytes, &numbers.map(f64::to_bits));
        for since in &self.since {
            put_words(&mut bytes, &since.words());
        }
        put_text(&mut bytes, &self.keys.to_text());
        put_text(&mut bytes, &self.warnings);
        put_words(&mut bytes, &[u64::from(self.compacted.is_some())]);
        if let Some(compacted) = &self.compacted {
            put_record(&mut bytes, compacted);
        }
        put_record(&mut bytes, &self.state);
        write_whole(path, &sealed::seal(bytes))
    }

    /// Read a checkpoint from the bytes of a file, and whether it belongs to a scene.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(bytes: &[u8], scene: &Scene) -> Result<(Self, Kinship), &'static str> {
        let (fingerprint, rest) = sealed::open(bytes)?;
        let saved = Self::read_content(rest).ok_or_else(|| unfit(bytes))?;
        let kinship = Kinship::of(scene, fingerprint, &saved.keys);
        Ok((saved, kinship))
    }

    fn read_content(mut rest: Reader) -> Option<Self> {
        let phase = rest.word()?;
        let samples = rest.word()?;
        let bytes = rest.array()?;
        let [run, main, point_steps, kinetic, strain] = rest.array()?.map(f64::from_bits);
        let mut since = || Some(Since::from_words(rest.array::<WORDS>()?));
        let since = [since()?, since()?];
        let keys = Keys::of_text(&rest.text()?);
        let warnings = rest.text()?;
        let compacted = match rest.word()? {
            0 => None,
            _ => Some(rest.record()?),
        };
        Some(Self {
            phase,
            samples,
            bytes,
            seconds: [run, main],
            point_steps,
            beginning: [kinetic, strain],
            since,
            warnings,
            keys,
            compacted,
            state: rest.record().filter(|_| rest.0.is_empty())?,
        })
    }
}

impl Saved<Scene> for Checkpoint {
    fn read(path: &Path, scene: &Scene) -> Result<(Self, Kinship), Error> {
        let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        Self::parse(&bytes, scene).map_err(|reason| refusal(path, reason))
    }

    fn keys(&self) -> &Keys {
        &self.keys
    }
}

/// Whether the content of a checkpoint is one of this model.
pub fn is_saved(content: Reader) -> bool {
    Checkpoint::read_content(content).is_some()
}
