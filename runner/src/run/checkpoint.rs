//! What `--resume` continues from: written whole or not at all, checked before it is used.

use super::plan::{Kind, model};
use crate::error::Error;
use crate::machine::equipped;
use crate::scene::{Place, Scene};
use gouge_dem::World;
use sha2::{Digest, Sha256};
use std::io::Write;
use std::path::Path;

/// First bytes of every checkpoint.
const MAGIC: &[u8; 16] = b"gouge checkpoint";
/// Version of the format, the first word after the fingerprint of the scene.
const VERSION: u64 = 3;

/// A moment of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// The phase.
    pub phase: u64,
    /// Samples written.
    pub samples: u64,
    /// Bytes of the series written.
    pub series_bytes: u64,
    /// Bonds at the beginning of the scene proper.
    pub bonds_initial: u64,
    /// Wall time so far in s, of the whole run and of the scene proper.
    pub seconds: [f64; 2],
    /// Link-steps of the scene proper so far.
    pub link_steps: f64,
    /// The state.
    pub world: Vec<u64>,
}

/// Fingerprint of everything in a scene that decides on the bits of a run.
pub fn fingerprint(scene: &Scene) -> [u8; 32] {
    let mut anonymous = Scene {
        file: String::new(),
        files: Vec::new(),
        title: String::new(),
        sha256: String::new(),
        ..scene.clone()
    };
    let nowhere = Place {
        file: String::new(),
        line: 0,
        key: String::new(),
    };
    for (_, place) in &mut anonymous.bonds {
        place.clone_from(&nowhere);
    }
    for (_, place) in &mut anonymous.contacts {
        place.clone_from(&nowhere);
    }
    let text = format!("{anonymous:?} {}", env!("CARGO_PKG_VERSION"));
    Sha256::digest(text.as_bytes()).into()
}

impl Checkpoint {
    /// Write to a file: beside it first, then in its place.
    ///
    /// # Errors
    /// Failures of the file system; the earlier checkpoint is then still there.
    pub fn write(&self, path: &Path, fingerprint: &[u8; 32]) -> Result<(), Error> {
        let mut bytes = MAGIC.to_vec();
        bytes.extend(fingerprint);
        let head = [
            VERSION,
            self.phase,
            self.samples,
            self.series_bytes,
            self.bonds_initial,
            self.seconds[0].to_bits(),
            self.seconds[1].to_bits(),
            self.link_steps.to_bits(),
        ];
        for word in head.iter().chain(&self.world) {
            bytes.extend(word.to_le_bytes());
        }
        let digest = Sha256::digest(&bytes);
        bytes.extend(digest);
        write_whole(path, &bytes)
    }

    /// Read from a file.
    ///
    /// # Errors
    /// Files that are damaged or belong to another scene.
    pub fn read(path: &Path, fingerprint: &[u8; 32]) -> Result<Self, Error> {
        let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        let wrong = |reason: &str| Error::Checkpoint {
            path: path.to_owned(),
            reason: reason.to_owned(),
        };
        if bytes.len() < 16 + 32 + 8 * 8 + 32 || &bytes[..16] != MAGIC {
            return Err(wrong("it is not a checkpoint, or its beginning is damaged"));
        }
        let (content, digest) = bytes.split_at(bytes.len() - 32);
        if Sha256::digest(content)[..] != *digest {
            return Err(wrong(
                "it is damaged: its checksum does not match its content",
            ));
        }
        if &content[16..48] != fingerprint {
            return Err(wrong(
                "it belongs to another scene, or to another version of the program",
            ));
        }
        let words = words_of(&content[48..]);
        if words[0] != VERSION {
            return Err(wrong("its format has another version"));
        }
        Ok(Self {
            phase: words[1],
            samples: words[2],
            series_bytes: words[3],
            bonds_initial: words[4],
            seconds: [f64::from_bits(words[5]), f64::from_bits(words[6])],
            link_steps: f64::from_bits(words[7]),
            world: words[8..].to_vec(),
        })
    }

    /// The state.
    ///
    /// # Errors
    /// Words that are no state of the scene in a phase of the kind.
    pub fn world(&self, path: &Path, scene: &Scene, kind: Kind) -> Result<World, Error> {
        recorded(scene, kind, &self.world).ok_or_else(|| Error::Checkpoint {
            path: path.to_owned(),
            reason: "its state does not fit the scene".to_owned(),
        })
    }
}

/// The words in bytes, the least significant byte of each first; bytes that fill no word are left out.
pub fn words_of(bytes: &[u8]) -> Vec<u64> {
    let (words, _) = bytes.as_chunks();
    words.iter().copied().map(u64::from_le_bytes).collect()
}

/// The world of a scene in a recorded state of a phase of the kind; nothing if the words are no such state.
pub fn recorded(scene: &Scene, kind: Kind, words: &[u64]) -> Option<World> {
    // The area of driving depends on the radii, which only the state knows.
    let bare = World::from_words(model(scene, kind, &[0.0]), words)?;
    let model = model(scene, kind, &bare.particles().radius);
    World::from_words(model, words).map(equipped)
}

/// Write a file so that it is there completely or as it was before.
///
/// # Errors
/// Failures of the file system.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let beside = path.with_extension("partial");
    let write = || -> std::io::Result<()> {
        let mut file = std::fs::File::create(&beside)?;
        file.write_all(bytes)?;
        file.sync_all()?;
        std::fs::rename(&beside, path)
    };
    write().map_err(|error| {
        let _ = std::fs::remove_file(&beside);
        Error::file("write", path, error)
    })
}
