//! The list of frames and their times, which ParaView opens as one animation.

use crate::error::Error;
use crate::run::folder::write_whole;
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

fn entry((_, frame): List, (sample, time): (u64, f64)) -> String {
    let before = if sample == 0 { "\n" } else { ",\n" };
    format!("{before}    {{ \"name\": \"{frame}_{sample:06}.vtk\", \"time\": {time:?} }}")
}

/// Write the list of the first frames, at times in s.
///
/// # Errors
/// Failures of the file system.
pub fn write(list: List, folder: &Path, times: &[f64]) -> Result<(), Error> {
    let mut text = "{\n  \"file-series-version\": \"1.0\",\n  \"files\": [".to_owned();
    let samples = (0..).zip(times.iter().copied());
    text.extend(samples.map(|sample| entry(list, sample)));
    write_whole(&folder.join(list.0), (text + END).as_bytes())
}

/// Add the frame of the next sample, with its time in s.
///
/// # Errors
/// Failures of the file system.
pub fn append(list: List, folder: &Path, sample: (u64, f64)) -> Result<(), Error> {
    let path = folder.join(list.0);
    let text = entry(list, sample) + END;
    let add = || -> std::io::Result<()> {
        let mut file = File::options().write(true).open(&path)?;
        file.seek(SeekFrom::End(-(END.len() as i64)))?;
        file.write_all(text.as_bytes())
    };
    add().map_err(|error| Error::file("write", &path, error))
}
