//! The list of frames and their times, which ParaView opens as one animation.

use crate::error::Error;
use crate::run::folder::write_whole;
use crate::scene::Scene;
use std::fs::File;
use std::io::{Seek, SeekFrom, Write};
use std::path::Path;

/// Name of a list, and how the names of its frames begin.
pub type List = (&'static str, &'static str);

/// The list of the grains.
pub const GRAINS: List = ("run.vtk.series", "frame");
/// The list of the links.
pub const LINKS: List = ("links.vtk.series", "links");
/// End of the file, after the last entry.
const END: &str = "\n  ]\n}\n";

fn entry((_, frame): List, scene: &Scene, sample: u64) -> String {
    let before = if sample == 0 { "\n" } else { ",\n" };
    let time = scene.sample_step(sample) as f64 * scene.step;
    format!("{before}    {{ \"name\": \"{frame}_{sample:06}.vtk\", \"time\": {time:?} }}")
}

/// Write the list of the first frames.
///
/// # Errors
/// Failures of the file system.
pub fn write(list: List, scene: &Scene, folder: &Path, samples: u64) -> Result<(), Error> {
    let mut text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [".to_owned();
    text.extend((0..samples).map(|sample| entry(list, scene, sample)));
    write_whole(&folder.join(list.0), (text + END).as_bytes())
}

/// Add the next frame.
///
/// # Errors
/// Failures of the file system.
pub fn append(list: List, scene: &Scene, folder: &Path, sample: u64) -> Result<(), Error> {
    let path = folder.join(list.0);
    let text = entry(list, scene, sample) + END;
    let add = || -> std::io::Result<()> {
        let mut file = File::options().write(true).open(&path)?;
        file.seek(SeekFrom::End(-(END.len() as i64)))?;
        file.write_all(text.as_bytes())
    };
    add().map_err(|error| Error::file("write", &path, error))
}
