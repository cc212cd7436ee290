//! Pictures of final states, kept beside the tables of a study.

use super::results::{Results, Run};
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::path::{Path, PathBuf};

/// Folder of the pictures in that of a study.
const FOLDER: &str = "pictures";
/// Seed of the runs that are shown.
const SEED: &str = "0";

/// A picture of a run: of which part of the study, and of which values of some axes.
#[derive(Clone, Copy, Debug)]
pub struct Shown {
    /// Part of the study.
    pub part: &'static str,
    /// Axes and their values.
    pub axes: Axes,
    subject: &'static Subject,
}

/// What a picture shows.
#[derive(Debug)]
struct Subject {
    /// Its file in the folder of a run.
    file: &'static str,
    /// What it shows, at the beginning of a caption.
    caption: &'static str,
    /// End of the name of the picture that is kept.
    ending: &'static str,
}

const FINAL_STATE: Subject = Subject {
    file: "picture.svg",
    caption: "Final state",
    ending: ".svg",
};

const DIRECTIONS: Subject = Subject {
    file: "directions.svg",
    caption: "Contacts, forces and branch vectors by the direction of the normal (blue) and their expansions to first order \
        (orange)",
    ending: "-directions.svg",
};

/// Axes and their values.
pub type Axes = &'static [(&'static str, &'static str)];

impl Shown {
    /// The final state of a run.
    pub const fn final_state(part: &'static str, axes: Axes) -> Self {
        let subject = &FINAL_STATE;
        Self {
            part,
            axes,
            subject,
        }
    }

    /// The polar diagrams of a run of contact dynamics.
    pub const fn directions(part: &'static str, axes: Axes) -> Self {
        let subject = &DIRECTIONS;
        Self {
            part,
            axes,
            subject,
        }
    }

    fn path(&self, folder: &Path) -> PathBuf {
        let values = self
            .axes
            .iter()
            .map(|(_, value)| value.replace([' ', '/'], "-"));
        let name: Vec<String> = [self.part.to_owned()].into_iter().chain(values).collect();
        folder
            .join(FOLDER)
            .join(name.join("-") + self.subject.ending)
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
        let caption = self.subject.caption;
        format!("{caption}, {}{seed} ({}).", axes.join(", "), self.part)
    }
}

/// Where pictures of a study come from and where they are kept.
pub struct Kept<'a> {
    /// All runs.
    pub results: &'a Results,
    /// Folders of earlier studies.
    pub earlier: &'a [&'a Path],
    /// Folder of the study.
    pub out: &'a Path,
}

impl Kept<'_> {
    /// The picture of a state and its caption, copied to the pictures of the study: that of a run of the study, or the
    /// one that an earlier study kept; none without both.
    ///
    /// # Errors
    /// Failures of the file system.
    pub fn picture(&self, shown: &Shown) -> Result<Option<(String, String)>, Error> {
        let Some((bytes, caption)) = self.find(shown) else {
            return Ok(None);
        };
        let path = shown.path(self.out);
        let folder = path.parent().unwrap_or(self.out);
        std::fs::create_dir_all(folder).map_err(|error| Error::file("create", folder, error))?;
        write_whole(&path, &bytes)?;
        Ok(Some((
            String::from_utf8_lossy(&bytes).into_owned(),
            caption,
        )))
    }

    fn find(&self, shown: &Shown) -> Option<(Vec<u8>, String)> {
        let mut runs = self.results.runs().iter();
        let run = runs.find(|run| shown.is_of(run))?;
        let own = self.out.join(&run.part).join("runs").join(&run.name);
        let kept = self.earlier.iter().map(|folder| shown.path(folder));
        let mut places = [own.join(shown.subject.file)].into_iter().chain(kept);
        let bytes = places.find_map(|path| std::fs::read(path).ok())?;
        Some((bytes, shown.caption(run)))
    }
}
