//! A folder holds the results of one calibration, which its file `plan` tells.

use super::calibration::Calibration;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::io::ErrorKind;
use std::path::Path;

/// The file that tells whose results a folder holds.
const PLAN: &str = "plan";
/// A result that sweeps leave, too.
const RUNS: &str = "runs.csv";

impl Calibration {
    /// Claim a folder for the results of this calibration, unless it holds those of another one: one of other parameters
    /// or tests. Other ranges, targets, seeds or designs make no other calibration; only what is new in them is run.
    ///
    /// # Errors
    /// A folder that holds other results, or a failure of the file system.
    pub(super) fn claim(&self, out: &Path) -> Result<(), Error> {
        let (path, own) = (out.join(PLAN), self.plan());
        let refusal = |what: &str| {
            let folder = out.display();
            Err(Error::Argument(format!(
                "{folder} holds the results of another study, because {what}: choose another folder, or remove this one"
            )))
        };
        match std::fs::read_to_string(&path) {
            Ok(text) if text == own => Ok(()),
            Ok(text) => {
                let first = |some: &str, others: &str| {
                    let is_other = |line: &&str| !others.lines().any(|other| other == *line);
                    some.lines().find(is_other).map(str::to_owned)
                };
                match (first(&text, &own), first(&own, &text)) {
                    (Some(line), _) => refusal(&format!("its plan has \"{line}\"")),
                    (None, Some(line)) => refusal(&format!("its plan lacks \"{line}\"")),
                    (None, None) => Ok(()),
                }
            }
            Err(error) if error.kind() != ErrorKind::NotFound => {
                Err(Error::file("read", &path, error))
            }
            Err(_) if out.join(RUNS).exists() => refusal(&format!("it has {RUNS} without a plan")),
            Err(_) => {
                std::fs::create_dir_all(out).map_err(|error| Error::file("create", out, error))?;
                write_whole(&path, own.as_bytes())
            }
        }
    }

    /// What tells this calibration from others.
    fn plan(&self) -> String {
        let mut text = String::new();
        for test in &self.tests {
            let scene = test.scene.file_name().unwrap_or_default().display();
            text += &format!("test {} with the scene {scene}\n", test.name);
            for parameter in &self.parameters {
                let (name, keys) = (&parameter.name, parameter.keys_in(&test.name).join(", "));
                text += &format!("parameter {name} of {}: {keys}\n", test.name);
            }
        }
        text
    }
}
