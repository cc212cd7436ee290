//! Stores the outcome of each fault in a file, so that a campaign can be interrupted.

use crate::Outcome;
use crate::gate::{Gate, Tests};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fmt;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Outcome of a fault.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// Detected; this test failed first.
    Caught(String),
    /// Detected; the tests did not end in time.
    Endless,
    /// Survived; all tests that meet its switch passed.
    Survived,
    /// Survived; no test meets its switch.
    Unused,
}

impl Fate {
    /// Whether the gate detected the fault.
    pub fn is_detected(&self) -> bool {
        matches!(self, Self::Caught(_) | Self::Endless)
    }
}

impl fmt::Display for Fate {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Caught(test) => write!(out, "caught by {test}"),
            Self::Endless => out.write_str("caught by the time limit"),
            Self::Survived => out.write_str("SURVIVED"),
            Self::Unused => out.write_str("SURVIVED, because no test uses it"),
        }
    }
}

/// A deliberate fault with its own switch. It is displayed as one line with its place and its change.
pub trait Fault: fmt::Display + Sync {
    /// Number of the switch.
    fn switch(&self) -> usize;
}

#[derive(Serialize, Deserialize)]
struct Entry {
    switch: usize,
    fault: String,
    fate: Fate,
}

/// Results of this and earlier runs with the same gate.
pub struct Results {
    lines: PathBuf,
    tests: PathBuf,
    fates: HashMap<usize, Fate>,
}

impl Results {
    /// Read the results in a folder; results of another gate are deleted.
    ///
    /// # Errors
    /// A file that cannot be read or written.
    pub fn open(folder: &Path, gate: &Gate, switches: usize) -> Outcome<Self> {
        let [lines, tests, mark] =
            ["results.jsonl", "tests.json", "gate"].map(|name| folder.join(name));
        let name = format!("{} {switches}", gate.name());
        if fs::read_to_string(&mark).ok().as_ref() != Some(&name) {
            for old in [&lines, &tests] {
                if old.exists() {
                    fs::remove_file(old)?;
                }
            }
            fs::write(&mark, name)?;
        }
        let text = fs::read_to_string(&lines).unwrap_or_default();
        let mut fates = HashMap::new();
        for line in text.lines() {
            let entry: Entry = serde_json::from_str(line)?;
            fates.insert(entry.switch, entry.fate);
        }
        Ok(Self {
            lines,
            tests,
            fates,
        })
    }

    /// The switches that tests meet, as recorded in an earlier run.
    pub fn tests(&self) -> Option<Tests> {
        serde_json::from_slice(&fs::read(&self.tests).ok()?).ok()
    }

    /// Store the switches that tests meet.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn keep_tests(&self, tests: &Tests) -> Outcome<()> {
        Ok(fs::write(&self.tests, serde_json::to_vec(tests)?)?)
    }

    /// Drop the results of faults that survived.
    pub fn forget_survivors(&mut self) {
        self.fates.retain(|_, fate| fate.is_detected());
    }

    /// Whether a fault has a result.
    pub fn has(&self, fault: &impl Fault) -> bool {
        self.fates.contains_key(&fault.switch())
    }

    /// Outcome of a fault.
    pub fn fate(&self, fault: &impl Fault) -> Option<&Fate> {
        self.fates.get(&fault.switch())
    }

    /// Store the outcome of a fault.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn add(&mut self, fault: &impl Fault, fate: Fate) -> Outcome<()> {
        let entry = Entry {
            switch: fault.switch(),
            fault: fault.to_string(),
            fate,
        };
        let mut file = fs::OpenOptions::new()
            .create(true)
            .append(true)
            .open(&self.lines)?;
        writeln!(file, "{}", serde_json::to_string(&entry)?)?;
        self.fates.insert(entry.switch, entry.fate);
        Ok(())
    }
}
