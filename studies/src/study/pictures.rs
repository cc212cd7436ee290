//! Pictures of final states, kept beside the tables of a study.

use super::Study;
use super::results::{Results, Run};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::path::{Path, PathBuf};

/// Folder of the pictures in that of a study.
const FOLDER: &str = "pictures";
/// Seed of the runs that are shown.
const SEED: &str = "0";

/// A run whose final state is shown: its part of the study, and its values of some axes.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Part of the study.
    pub part: &'static str,
    /// Axes and their values.
    pub axes: &'static [(&'static str, &'static str)],
}

impl Shown {
    fn path(&self, folder: &Path) -> PathBuf {
        let values = self.axes.iter().map(|(_, value)| value.replace(' ', "-"));
        let name: Vec<String> = [self.part.to_owned()].into_iter().chain(values).collect();
        folder.join(FOLDER).join(name.join("-") + ".svg")
    }

    fn is_of(&self, run: &Run) -> bool {
        let has = |(axis, value): &(&str, &str)| run.text(axis) == *value;
        run.part == self.part && self.axes.iter().all(has) && ["", SEED].contains(&run.seed())
    }

    fn caption(&self, run: &Run) -> String {
        let axes = self
            .axes
            .iter()
            .map(|(axis, value)| format!("{axis} {value}"));
        let axes: Vec<String> = axes.collect();
        let seed = match run.seed() {
            "" => String::new(),
            seed => format!(", seed {seed}"),
        };
        format!("Final state, {}{seed} ({}).", axes.join(", "), self.part)
    }

    /// The picture and its caption: that of a run below `out`, or the one that an earlier study kept.
    fn find(&self, results: &Results, earlier: &[&Path], out: &Path) -> Option<(Vec<u8>, String)> {
        let run = results.runs().iter().find(|run| self.is_of(run))?;
        let own = out.join(&run.part).join("runs").join(&run.name);
        let kept = earlier.iter().map(|folder| self.path(folder));
        let mut places = [own.join("picture.svg")].into_iter().chain(kept);
        let bytes = places.find_map(|path| std::fs::read(path).ok())?;
        Some((bytes, self.caption(run)))
    }
}

/// Copy the pictures of a study that exist; their captions and texts.
///
/// # Errors
/// Failures of the file system.
pub fn keep(
    study: &Study,
    results: &Results,
    earlier: &[&Path],
    out: &Path,
) -> Result<Vec<(String, String)>, Error> {
    let mut pictures = Vec::new();
    for shown in study.pictures {
        let Some((bytes, caption)) = shown.find(results, earlier, out) else {
            continue;
        };
        let path = shown.path(out);
        let folder = path.parent().unwrap_or(out);
        std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
        write_whole(&path, &bytes)?;
        pictures.push((caption, String::from_utf8_lossy(&bytes).into_owned()));
    }
    Ok(pictures)
}
