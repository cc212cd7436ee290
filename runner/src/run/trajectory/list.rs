//! The list of frames and their times, which ParaView opens as one animation.

use crate::error::Error;
use crate::run::folder::write_whole;
use crate::scene::Scene;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::Path;

/// Name of the file.
pub const NAME: &str = "run.vtk.series";
/// End of the file, after the last entry.
const END: &str = "\n  ]\n}\n";

fn entry(scene: &Scene, sample: u64) -> String {
    let before = if sample == 0 { "\n" } else { ",\n" };
    let time = scene.sample_step(sample) as f64 * scene.step;
    format!("{before}    {{ \"name\": \"frame_{sample:06}.vtk\", \"time\": {time:?} }}")
}

/// Write the list of the first frames.
///
/// # Errors
/// Failures of the file system.
pub fn write(scene: &Scene, folder: &Path, samples: u64) -> Result<(), Error> {
    let mut text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [".to_owned();
    text.extend((0..samples).map(|sample| entry(scene, sample)));
    write_whole(&folder.join(NAME), (text + END).as_bytes())
}

/// Add the next frame.
///
/// # Errors
/// Failures of the file system.
pub fn append(scene: &Scene, folder: &Path, sample: u64) -> Result<(), Error> {
    let path = folder.join(NAME);
    let text = entry(scene, sample) + END;
    let add = || -> std::io::Result<()> {
        let mut file = File::options().write(true).open(&path)?;
        file.seek(SeekFrom::End(-(END.len() as i64)))?;
        file.write_all(text.as_bytes())
    };
    add().map_err(|error| Error::file("write", &path, error))
}
