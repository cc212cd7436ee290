//! Checkpoints, from which `--resume` continues: written completely or not at all, and checked before use.
//!
//! A checkpoint begins with the magic bytes, the fingerprint of the scene and the version of the format, and ends
//! with a checksum. Between them are the progress of the run and the state, as the tag of its model and named
//! columns. All numbers are words of eight bytes, the least significant byte first.

use super::folder::write_whole;
use super::phases::{PhaseKind, phase_model};
use crate::error::Error;
use crate::machine::with_chosen_execution;
use crate::scene::{Place, Scene};
use gouge_common::record::{Column, Record, Shape};
use gouge_dem::World;
use gouge_dem::particles::SPHERE_INERTIA_FACTOR;
use sha2::{Digest, Sha256};
use std::path::Path;

/// First bytes of every checkpoint.
const MAGIC: &[u8; 16] = b"gouge checkpoint";
/// Version of the format.
const VERSION: u64 = 4;
/// The version that stored the words of the state without names. It can be read, but is no longer written.
const UNNAMED: u64 = 3;
/// Bytes of a checksum or fingerprint.
const DIGEST: usize = 32;
/// Bytes before the version.
const PREFIX: usize = MAGIC.len() + DIGEST;
/// Number of words of the version and of the progress of the run.
const HEAD: usize = 8;

/// Fingerprint of everything in a scene that affects the bits of a run.
pub type Fingerprint = [u8; DIGEST];

/// Progress and state of a run at one step.
#[derive(Clone, Debug, PartialEq)]
pub struct Checkpoint {
    /// Position of the phase.
    pub phase: u64,
    /// Samples written.
    pub samples: u64,
    /// Bytes of the series written.
    pub series_bytes: u64,
    /// Bonds at the beginning of the scene proper.
    pub bonds_initial: u64,
    /// Wall time so far in s, of the whole run and of the scene proper.
    pub seconds: [f64; 2],
    /// Sum of the number of contacts and bonds over all steps of the scene proper so far.
    pub link_steps: f64,
    /// The state.
    pub state: Record,
}

/// The fingerprint of a scene.
pub fn fingerprint(scene: &Scene) -> Fingerprint {
    digest(&content(scene))
}

/// The fingerprint of a scene in version 3, which supported only spheres.
fn unnamed_fingerprint(scene: &Scene) -> Fingerprint {
    let material = format!("material: {:?}", scene.material);
    let density = format!("density: {:?}", scene.material.density);
    let inertia = format!(", inertia_factor: {SPHERE_INERTIA_FACTOR:?}");
    digest(
        &content(scene)
            .replace(&material, &density)
            .replace(&inertia, ""),
    )
}

fn digest(content: &str) -> Fingerprint {
    let text = format!("{content} {}", env!("CARGO_PKG_VERSION"));
    Sha256::digest(text.as_bytes()).into()
}

/// Everything in a scene that affects the bits of a run, as text.
fn content(scene: &Scene) -> String {
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
    format!("{anonymous:?}")
}

impl Checkpoint {
    /// Write to a temporary file, then rename it to the given path.
    ///
    /// # Errors
    /// Failures of the file system; the earlier checkpoint then still exists.
    pub fn write(&self, path: &Path, fingerprint: &Fingerprint) -> Result<(), Error> {
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
        put_words(&mut bytes, &head);
        put_record(&mut bytes, &self.state);
        let digest = Sha256::digest(&bytes);
        bytes.extend(digest);
        write_whole(path, &bytes)
    }

    /// Read the checkpoint of a scene from a file.
    ///
    /// # Errors
    /// A file that is damaged or belongs to another scene.
    pub fn read(path: &Path, scene: &Scene) -> Result<Self, Error> {
        let bytes = std::fs::read(path).map_err(|error| Error::file("read", path, error))?;
        Self::parse(&bytes, scene).map_err(|reason| refusal(path, reason))
    }

    fn parse(bytes: &[u8], scene: &Scene) -> Result<Self, &'static str> {
        if bytes.len() < PREFIX + 8 * HEAD + DIGEST || !bytes.starts_with(MAGIC) {
            return Err("it is not a checkpoint, or its beginning is damaged");
        }
        let (content, digest) = bytes.split_at(bytes.len() - DIGEST);
        if Sha256::digest(content)[..] != *digest {
            return Err("it is damaged: its checksum does not match its content");
        }
        let mut rest = Reader(&content[PREFIX..]);
        let head = rest.words(HEAD as u64).unwrap_or_default();
        let [
            version,
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
        let expected = match version {
            UNNAMED => unnamed_fingerprint(scene),
            _ => fingerprint(scene),
        };
        if content[MAGIC.len()..PREFIX] != expected {
            return Err("it belongs to another scene, or to another version of the program");
        }
        let state = match version {
            VERSION => rest.record().filter(|_| rest.0.is_empty()),
            UNNAMED => World::record_of_words(scene.integrator, &words_of_bytes(rest.0)),
            _ => return Err("its format version is not supported"),
        };
        Ok(Self {
            phase,
            samples,
            series_bytes,
            bonds_initial,
            seconds: [whole, main].map(f64::from_bits),
            link_steps: f64::from_bits(link_steps),
            state: state.ok_or("its state does not fit the scene")?,
        })
    }

    /// The world in the stored state.
    ///
    /// # Errors
    /// Columns that are not a state of the scene in a phase of this kind.
    pub fn world(&self, path: &Path, scene: &Scene, kind: PhaseKind) -> Result<World, Error> {
        let world = world_of_record(scene, kind, &self.state);
        world.ok_or_else(|| refusal(path, "its state does not fit the scene"))
    }
}

fn refusal(path: &Path, reason: &str) -> Error {
    Error::Checkpoint {
        path: path.to_owned(),
        reason: reason.to_owned(),
    }
}

fn put_words(bytes: &mut Vec<u8>, words: &[u64]) {
    bytes.extend(words.iter().flat_map(|word| word.to_le_bytes()));
}

/// Append a string: its length, then its bytes.
fn put_text(bytes: &mut Vec<u8>, text: &str) {
    put_words(bytes, &[text.len() as u64]);
    bytes.extend(text.as_bytes());
}

/// Append a record: its model, the number of columns, then each column with name, shape, number of words and words.
fn put_record(bytes: &mut Vec<u8>, record: &Record) {
    put_text(bytes, &record.model);
    put_words(bytes, &[record.columns.len() as u64]);
    for column in &record.columns {
        put_text(bytes, &column.name);
        let (is_list, width) = match column.shape {
            Shape::Words(number) => (0, number),
            Shape::List(width) => (1, width),
        };
        put_words(bytes, &[is_list, width as u64, column.words.len() as u64]);
        put_words(bytes, &column.words);
    }
}

/// The bytes that are not read yet.
struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn bytes(&mut self, number: u64) -> Option<&'a [u8]> {
        let (read, rest) = self.0.split_at_checked(usize::try_from(number).ok()?)?;
        self.0 = rest;
        Some(read)
    }

    fn words(&mut self, number: u64) -> Option<Vec<u64>> {
        Some(words_of_bytes(self.bytes(number.checked_mul(8)?)?))
    }

    fn word(&mut self) -> Option<u64> {
        self.words(1)?.first().copied()
    }

    fn text(&mut self) -> Option<String> {
        let length = self.word()?;
        String::from_utf8(self.bytes(length)?.to_vec()).ok()
    }

    fn record(&mut self) -> Option<Record> {
        let model = self.text()?;
        let number = self.word()?;
        let columns = (0..number).map(|_| self.column()).collect::<Option<_>>()?;
        Some(Record { model, columns })
    }

    fn column(&mut self) -> Option<Column> {
        let name = self.text()?;
        let (kind, width) = (self.word()?, usize::try_from(self.word()?).ok()?);
        let shape = match kind {
            0 => Shape::Words(width),
            1 => Shape::List(width),
            _ => return None,
        };
        let number = self.word()?;
        let words = self.words(number)?;
        Some(Column { name, shape, words })
    }
}

/// Bytes as words, the least significant byte of each word first; trailing bytes that do not fill a word are ignored.
pub fn words_of_bytes(bytes: &[u8]) -> Vec<u64> {
    let (words, _) = bytes.as_chunks();
    words.iter().copied().map(u64::from_le_bytes).collect()
}

/// The world of a scene in a recorded state of a phase of this kind; none if the record is not such a state.
pub fn world_of_record(scene: &Scene, kind: PhaseKind, record: &Record) -> Option<World> {
    // The area of driving depends on the radii, which are known only from the state.
    let bare = World::from_record(phase_model(scene, kind, &[0.0]), record)?;
    let model = phase_model(scene, kind, &bare.particles().radius);
    World::from_record(model, record).map(with_chosen_execution)
}
