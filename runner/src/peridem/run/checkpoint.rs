//! Checkpoints of runs of peridynamic grains.

use super::super::Scene;
use super::balance::Balance;
use crate::error::Error;
use crate::run::bytes::{Reader, put_record, put_text, put_words};
use crate::run::checkpoint::{refusal, unfit};
use crate::run::existing::Saved;
use crate::run::fingerprint::{Fingerprint, Kinship};
use crate::run::folder::{GRAINS, NODES, PICTURE, SERIES, write_whole};
use crate::run::sealed;
use crate::scene::Keys;
use gouge_common::record::Record;
use std::path::Path;

/// Progress and state of a run at one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Samples written.
    pub samples: u64,
    /// Bytes of the series and of the broken bonds written.
    pub bytes: [u64; 2],
    /// Wall time so far in s, of the whole run and of its steps.
    pub seconds: [f64; 2],
    /// Number of bonds, summed over all steps.
    pub bond_steps: f64,
    /// What the samples so far say about the balance of energy.
    pub balance: Balance,
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
        put_words(&mut bytes, &[self.samples]);
        put_words(&mut bytes, &self.bytes);
        let [run, main] = self.seconds;
        put_words(&mut bytes, &[run, main, self.bond_steps].map(f64::to_bits));
        self.balance.put(&mut bytes);
        put_text(&mut bytes, &self.keys.to_text());
        put_text(&mut bytes, &self.warnings);
        put_record(&mut bytes, &self.state);
        write_whole(path, &sealed::seal(bytes))
    }

    fn read_content(mut rest: Reader) -> Option<Self> {
        let samples = rest.word()?;
        let bytes = rest.array()?;
        let [run, main, bond_steps] = rest.array()?.map(f64::from_bits);
        Some(Self {
            samples,
            bytes,
            seconds: [run, main],
            bond_steps,
            balance: Balance::read(&mut rest)?,
            keys: Keys::of_text(&rest.text()?),
            warnings: rest.text()?,
            state: rest.record().filter(|_| rest.0.is_empty())?,
        })
    }
}

impl Saved<Scene> for Checkpoint {
    const RESULTS: &'static [&'static str] = &[SERIES, NODES, GRAINS, PICTURE];

    fn read(path: &Path, scene: &Scene) -> Result<(Self, Kinship), Error> {
        let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        let read = || {
            let (fingerprint, rest) = sealed::open(&bytes)?;
            let saved = Self::read_content(rest).ok_or_else(|| unfit(&bytes))?;
            let kinship = Kinship::of(scene, fingerprint, &saved.keys);
            Ok((saved, kinship))
        };
        read().map_err(|reason: &str| refusal(path, reason))
    }

    fn keys(&self) -> &Keys {
        &self.keys
    }
}

/// Whether the content of a checkpoint is one of this model.
pub fn is_saved(content: Reader) -> bool {
    Checkpoint::read_content(content).is_some()
}
