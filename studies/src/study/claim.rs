//! Claims, each with a rule that is fixed before the runs, and verdicts on them.

use super::results::Results;
use super::sample::Sample;
use crate::csv_table::csv_table;
use gouge_runner::error::Error;
use gouge_runner::run::write_whole;
use std::path::Path;

/// What the runs say of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The rule is met.
    Holds,
    /// The opposite is shown.
    Refuted,
    /// The printed numbers do not give the printed result.
    NotAsPrinted,
    /// The runs show neither.
    Undecided,
}

impl Verdict {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::Refuted => "refuted",
            Self::NotAsPrinted => "not reproducible as printed",
            Self::Undecided => "undecided",
        }
    }

    /// Holds if the rule is met, refuted if its opposite is.
    pub fn of(is_met: bool, is_opposed: bool) -> Self {
        match (is_met, is_opposed) {
            (true, _) => Self::Holds,
            (false, true) => Self::Refuted,
            (false, false) => Self::Undecided,
        }
    }
}

/// Whether an interval lies within a distance of zero, and whether it lies beyond that distance.
pub fn within_or_beyond([low, high]: [f64; 2], distance: f64) -> [bool; 2] {
    [
        low > -distance && high < distance,
        low > distance || high < -distance,
    ]
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
    /// A verdict and its numbers.
    pub fn new(verdict: Verdict, numbers: String) -> Self {
        Self { verdict, numbers }
    }
}

/// A claim, its rule, and how it is tested in a part of the study; none if the part lacks the runs for it.
pub struct Rule {
    /// The claim.
    pub statement: &'static str,
    /// When it passes.
    pub rule: &'static str,
    /// The test.
    pub test: fn(&Sample) -> Option<Finding>,
}

/// A claim with what each part of the study finds.
#[derive(Clone, Debug)]
pub struct Claim {
    /// The claim.
    pub statement: &'static str,
    /// When it passes.
    pub rule: &'static str,
    /// Parts of the study and their findings.
    pub findings: Vec<(&'static str, Finding)>,
}

impl Claim {
    /// What some parts of a study say of a claim.
    pub fn judged(rule: &Rule, parts: &[&'static str], results: &Results) -> Self {
        let finding = |&part: &&'static str| Some((part, (rule.test)(&Sample { results, part })?));
        Self {
            statement: rule.statement,
            rule: rule.rule,
            findings: parts.iter().filter_map(finding).collect(),
        }
    }
}

/// Write the verdicts: one row for each claim and part.
///
/// # Errors
/// Failures of the file system.
pub fn write(claims: &[Claim], path: &Path) -> Result<(), Error> {
    let header = ["claim", "rule", "part", "verdict", "numbers"];
    let mut rows = vec![header];
    for claim in claims {
        for (part, finding) in &claim.findings {
            let verdict = finding.verdict.name();
            rows.push([claim.statement, claim.rule, part, verdict, &finding.numbers]);
        }
    }
    let bytes = csv_table(path, rows)?;
    write_whole(path, &bytes)
}
