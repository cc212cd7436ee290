//! What became of each site, on paper, so that a campaign can be interrupted.

use crate::Outcome;
use crate::gate::{Gate, Tests};
use crate::site::Site;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fmt;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What became of a site.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Fate {
    /// This test failed first.
    Caught(String),
    /// All tests that use it passed.
    Survived,
    /// No test uses it.
    Unused,
}

impl fmt::Display for Fate {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Caught(test) => write!(out, "caught by {test}"),
            Self::Survived => out.write_str("SURVIVED"),
            Self::Unused => out.write_str("SURVIVED, for no test uses it"),
        }
    }
}

#[derive(Serialize, Deserialize)]
struct Entry {
    site: Site,
    fate: Fate,
}

/// Results of this and earlier runs with the same gate.
pub struct Results {
    lines: PathBuf,
    tests: PathBuf,
    fates: HashMap<usize, Entry>,
}

impl Results {
    /// Take up the results in a folder; results of another gate or another kernel are dropped.
    ///
    /// # Errors
    /// Files that cannot be read or written.
    pub fn open(folder: &Path, gate: &Gate, sites: &[Site]) -> Outcome<Self> {
        let [lines, tests, mark] =
            ["results.jsonl", "tests.json", "gate"].map(|name| folder.join(name));
        let name = format!("{} {}", gate.name(), sites.len());
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
            fates.insert(entry.site.id, entry);
        }
        Ok(Self {
            lines,
            tests,
            fates,
        })
    }

    /// What the tests were found to use before.
    pub fn tests(&self) -> Option<Tests> {
        serde_json::from_slice(&fs::read(&self.tests).ok()?).ok()
    }

    /// Keep what the tests use.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn keep_tests(&self, tests: &Tests) -> Outcome<()> {
        Ok(fs::write(&self.tests, serde_json::to_vec(tests)?)?)
    }

    /// Drop those that survived.
    pub fn forget_survivors(&mut self) {
        self.fates
            .retain(|_, entry| matches!(entry.fate, Fate::Caught(_)));
    }

    /// Whether a site has been tried.
    pub fn has(&self, site: &Site) -> bool {
        self.fates.contains_key(&site.id)
    }

    /// What became of a site.
    pub fn fate(&self, site: &Site) -> Option<&Fate> {
        self.fates.get(&site.id).map(|entry| &entry.fate)
    }

    /// Note what became of a site.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn add(&mut self, site: &Site, fate: Fate) -> Outcome<()> {
        let entry = Entry {
            site: site.clone(),
            fate,
        };
        let mut file = fs::OpenOptions::new()
            .create(true)
            .append(true)
            .open(&self.lines)?;
        writeln!(file, "{}", serde_json::to_string(&entry)?)?;
        self.fates.insert(site.id, entry);
        Ok(())
    }
}
