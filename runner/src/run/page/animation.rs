//! What the page shows of every sample: a file that grows with the trajectory.

use crate::error::Error;
use crate::run::trajectory::FOLDER;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

/// The file, in the folder of the trajectory.
pub const NAME: &str = "animation.bin";
/// Bytes per grain and sample: position, angle, speed and pressure as single-precision numbers, and a colour.
const WIDTH: usize = 21;

/// Why a file is refused that lacks samples.
const TRUNCATED: &str = "it is shorter than when it was last written; remove it to continue without the motion on the page";

/// Colour of a single free grain; smaller numbers are those of fragments.
pub const SINGLE: u8 = 250;
/// Colour of a driven grain.
pub const DRIVEN: u8 = 251;
/// Colour of a fixed grain.
pub const FIXED: u8 = 252;

/// The file of a run in progress.
#[derive(Debug)]
pub struct Animation {
    path: PathBuf,
    file: File,
}

/// A grain at the time of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grain {
    /// Position in m, angle in rad, speed in m/s, pressure in Pa.
    pub numbers: [f32; 5],
    /// Number of its fragment, or one of the other colours.
    pub colour: u8,
}

impl Animation {
    /// Begin the file, or continue it after a number of samples; none if the earlier part of the run left none, as with
    /// `--data-only`.
    ///
    /// # Errors
    /// A file that lacks some of the samples, or failures of the file system.
    pub fn open(folder: &Path, samples: u64, particles: usize) -> Result<Option<Self>, Error> {
        let path = folder.join(FOLDER).join(NAME);
        let bytes = samples * (WIDTH * particles) as u64;
        if samples > 0 && !path.exists() {
            return Ok(None);
        }
        let open = || -> std::io::Result<File> {
            let mut file = File::options()
                .create(true)
                .truncate(false)
                .write(true)
                .open(&path)?;
            if file.metadata()?.len() < bytes {
                return Err(std::io::Error::other(TRUNCATED));
            }
            file.set_len(bytes)?;
            file.seek(SeekFrom::End(0))?;
            Ok(file)
        };
        let file = open().map_err(|error| Error::file("open", &path, error))?;
        Ok(Some(Self { path, file }))
    }

    /// Flush the appended samples to the disk.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn sync(&self) -> Result<(), Error> {
        let synced = self.file.sync_data();
        synced.map_err(|error| Error::file("write", &self.path, error))
    }

    /// Append a sample.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn write(&mut self, grains: &[Grain]) -> Result<(), Error> {
        let mut bytes = Vec::with_capacity(WIDTH * grains.len());
        for grain in grains {
            grain
                .numbers
                .iter()
                .for_each(|number| bytes.extend(number.to_le_bytes()));
            bytes.push(grain.colour);
        }
        let written = self.file.write_all(&bytes);
        written.map_err(|error| Error::file("write", &self.path, error))
    }
}

/// The samples of a run that ended.
pub struct Recording {
    bytes: Vec<u8>,
    particles: usize,
}

impl Recording {
    /// The samples in the folder of a run; a file that cannot be read has none.
    pub fn read(folder: &Path, particles: usize) -> Self {
        let bytes = std::fs::read(folder.join(FOLDER).join(NAME));
        Self {
            bytes: bytes.unwrap_or_default(),
            particles,
        }
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.bytes.len() / (WIDTH * self.particles.max(1))
    }

    /// All grains of a sample.
    pub fn sample(&self, sample: usize) -> impl Iterator<Item = Grain> + '_ {
        let size = WIDTH * self.particles;
        let rows = self.bytes[sample * size..(sample + 1) * size]
            .as_chunks::<WIDTH>()
            .0;
        rows.iter().map(|row| {
            let (words, _) = row.as_chunks::<4>();
            Grain {
                numbers: [0, 1, 2, 3, 4].map(|place| f32::from_le_bytes(words[place])),
                colour: row[WIDTH - 1],
            }
        })
    }
}
