//! The claims of the thesis, each with a rule that was fixed before the runs.

mod blocks;
mod dissipation;
mod friction;
mod sample;
mod variants;

use super::results::Results;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
pub use sample::Sample;
use std::path::Path;

/// What the runs say of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The rule is met.
    Holds,
    /// The opposite is shown.
    Refuted,
    /// The runs show neither.
    Undecided,
}

impl Verdict {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Refuted => "refuted",
            Self::Undecided => "undecided",
        }
    }

    /// Holds if the rule is met, refuted if its opposite is.
    fn of(is_met: bool, is_opposed: bool) -> Self {
        match (is_met, is_opposed) {
            (true, _) => Self::Holds,
            (false, true) => Self::Refuted,
            (false, false) => Self::Undecided,
        }
    }
}

/// A verdict with the numbers on which it rests.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The verdict.
    pub verdict: Verdict,
    /// The numbers, as a sentence.
    pub numbers: String,
}

impl Finding {
    fn new(verdict: Verdict, numbers: String) -> Self {
        Self { verdict, numbers }
    }
}

/// A claim, its rule, and how it is tested in a part of the study; none if the part lacks the runs for it.
struct Rule {
    statement: &'static str,
    rule: &'static str,
    test: fn(&Sample) -> Option<Finding>,
}

/// A claim with what each part of the study finds.
#[derive(Clone, Debug)]
pub struct Claim {
    /// What the thesis says.
    pub statement: &'static str,
    /// When it passes.
    pub rule: &'static str,
    /// Parts of the study and their findings.
    pub findings: Vec<(&'static str, Finding)>,
}

/// Parts in which claims are tested, the most telling first.
pub const PARTS: [&str; 5] = [
    "corrected-full",
    "corrected-small",
    "thesis-full",
    "thesis-small",
    "variants-small",
];

/// All claims with their findings.
pub fn all(results: &Results) -> Vec<Claim> {
    let rules = blocks::RULES.iter().chain(&friction::RULES);
    let rules = rules.chain(&dissipation::RULES).chain(&variants::RULES);
    let claim = |rule: &Rule| Claim {
        statement: rule.statement,
        rule: rule.rule,
        findings: PARTS
            .into_iter()
            .filter_map(|part| Some((part, (rule.test)(&Sample { results, part })?)))
            .collect(),
    };
    rules.map(claim).collect()
}

/// Write the verdicts: one row for each claim and part.
///
/// # Errors
/// Failures of the file system.
pub fn write(claims: &[Claim], path: &Path) -> Result<(), Error> {
    let failed = |error: csv::Error| Error::file("write", path, std::io::Error::other(error));
    let mut writer = csv::Writer::from_writer(Vec::new());
    let header = ["claim", "rule", "part", "verdict", "numbers"];
    writer.write_record(header).map_err(failed)?;
    for claim in claims {
        for (part, finding) in &claim.findings {
            let row = [
                claim.statement,
                claim.rule,
                part,
                finding.verdict.name(),
                &finding.numbers,
            ];
            writer.write_record(row).map_err(failed)?;
        }
    }
    let bytes = writer.into_inner();
    let bytes = bytes.map_err(|error| Error::file("write", path, error.into_error()))?;
    write_whole(path, &bytes)
}
